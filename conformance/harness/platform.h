// SPDX-License-Identifier: MIT
// Contexts and surfaces on a window system: EGL without a display (default), GLX on a display, or Mesa's
// off-screen library OSMesa.
//
// A Surface is a default framebuffer of kSurfaceSize x kSurfaceSize pixels with RGBA8 colour; a Context is
// any API and version. Both are handed out by the one Platform that --platform chose, and go when their owner
// goes.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

namespace conformance {

inline constexpr int kSurfaceSize = 64;  // pixels, both ways

// kEs2 is OpenGL ES from 2 on, as EGL's OPENGL_ES2_BIT is.
enum class Api { kCompatibility, kCore, kEs2 };

struct ContextWish {
    Api api = Api::kCompatibility;
    int major = 0;  // 0: whatever the driver gives; of ES at least 2
    int minor = 0;
    // With a flag the context is one of GL 3.2 or later; a platform that does not have it refuses.
    bool debug = false;
    bool robust = false;    // ARB_robustness: asks for GetGraphicsResetStatus to tell
    bool no_error = false;  // KHR_no_error
};

struct SurfaceWish {
    int depth_bits = 24;
    int stencil_bits = 8;
    int accumulation_bits = 0;
};

class Platform {
  public:
    using Handle = std::uintptr_t;  // 0 is none

    virtual ~Platform() = default;

    // 0 where the driver refuses, or the platform has no such thing.
    virtual Handle create_context(const ContextWish& wish, Handle share) = 0;
    virtual Handle create_surface(const SurfaceWish& wish) = 0;
    virtual void destroy_context(Handle context) = 0;
    virtual void destroy_surface(Handle surface) = 0;
    virtual bool make_current(Handle surface, Handle context) = 0;
    virtual void swap(Handle surface) = 0;
    virtual void* get_proc_address(const char* name) = 0;
};

std::unique_ptr<Platform> open_egl_platform();
std::unique_ptr<Platform> open_glx_platform();
std::unique_ptr<Platform> open_osmesa_platform();

// OSMesa brings its own gl functions, and a program that is linked with libGL reaches them by a preload:
// starts the program anew with the library preloaded, or returns false where there is no such library. Called
// before all else.
bool preload_osmesa(char* const* argv);

// Called once by main; false where the platform has no display to open, or has no such name.
bool open_platform(const std::string& name);
void close_platform();
Platform& platform();

class Surface {
  public:
    explicit Surface(const SurfaceWish& wish = {}) : handle_(platform().create_surface(wish)) {}
    ~Surface();
    Surface(const Surface&) = delete;
    Surface& operator=(const Surface&) = delete;

    explicit operator bool() const { return handle_ != 0; }
    void swap() const { platform().swap(handle_); }

  private:
    friend class Context;
    Platform::Handle handle_;
};

class Context {
  public:
    explicit Context(const ContextWish& wish = {}, const Context* share = nullptr)
        : handle_(platform().create_context(wish, share ? share->handle_ : 0)) {}
    ~Context();
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;

    explicit operator bool() const { return handle_ != 0; }
    bool make_current(const Surface& surface) const {
        return platform().make_current(surface.handle_, handle_);
    }
    static void release_current() { platform().make_current(0, 0); }

  private:
    Platform::Handle handle_;
};

}  // namespace conformance
