// SPDX-License-Identifier: MIT
// A GL context with something to draw on, and what it says of itself. Everything above asks it for entry
// points.
#pragma once

#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>

namespace apps {

/// Why there is no context, as one sentence.
struct PlatformError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

class Platform {
  public:
    virtual ~Platform() = default;

    /// The entry point of that name. Never a sign that it works: GL hands out names that it does not know.
    using Function = void (*)();
    virtual Function function(const char* name) = 0;

    /// Ends a frame that glFinish has finished. OSMesa has no swap: its frames end with glFinish itself.
    virtual void swap_buffers() = 0;

    bool has_extension(std::string_view name) const;
    bool is_at_least(int major, int minor) const;

    const std::string& renderer() const { return renderer_; }
    const std::string& version() const { return version_; }

  protected:
    /// Called by the makers once the context is current: fetches GL's commands and takes what it says.
    void read_strings();
    void describe(std::string renderer, std::string version, const std::string& extensions);

  private:
    std::string renderer_, version_, extensions_;
};

/// 24 bit depth, 8 bits of red, green, blue and alpha; "egl": a surfaceless display and a pbuffer; "glx": a
/// window; "osmesa": memory of the program's.
std::unique_ptr<Platform> open_platform(std::string_view name, int width, int height);

std::unique_ptr<Platform> open_egl(int width, int height);
std::unique_ptr<Platform> open_glx(int width, int height);
std::unique_ptr<Platform> open_osmesa(int width, int height);

}  // namespace apps
