// SPDX-License-Identifier: MIT
// Mesa's off-screen library, which draws into memory of the program's. It is fetched when it is asked for: it
// left Mesa with version 25.1. It has no swap: a frame ends with glFinish, since the image is there only
// then.
#include <GL/gl.h>
#include <dlfcn.h>

#include <cstdint>
#include <vector>

#include "apps/platform/platform.h"

namespace apps {
namespace {

constexpr const char* kLibrary = "libOSMesa.so.8";
// Its own header, GL/osmesa.h, is not Khronos'.
using Context = void*;
using CreateContextExt = Context (*)(GLenum format, GLint depth_bits, GLint stencil_bits, GLint accum_bits,
                                     Context share);
using MakeCurrent = GLboolean (*)(Context context, void* buffer, GLenum type, GLsizei width, GLsizei height);
using DestroyContext = void (*)(Context context);
using GetProcAddress = Platform::Function (*)(const char* name);

class Osmesa final : public Platform {
  public:
    Osmesa(int width, int height) {
        // Never closed: the layer, and Mesa's own threads, may still be in it.
        library_ = dlopen(kLibrary, RTLD_NOW | RTLD_LOCAL);
        if (!library_)
            throw PlatformError(std::string("--platform osmesa needs ") + kLibrary +
                                " (Debian's libosmesa6), and it cannot be loaded");
        find(make_current_, "OSMesaMakeCurrent");
        find(destroy_, "OSMesaDestroyContext");
        find(get_proc_address_, "OSMesaGetProcAddress");
        CreateContextExt create = nullptr;
        find(create, "OSMesaCreateContextExt");
        constexpr int kBytesPerPixel = 4;
        image_.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * kBytesPerPixel);
        context_ = create(GL_RGBA, 24, 0, 0, nullptr);
        if (!context_ || !make_current_(context_, image_.data(), GL_UNSIGNED_BYTE, width, height))
            throw PlatformError("OSMesa cannot make a context current");
        read_strings();
    }

    Osmesa(const Osmesa&) = delete;
    Osmesa& operator=(const Osmesa&) = delete;
    ~Osmesa() override { destroy_(context_); }

    Function function(const char* name) override { return get_proc_address_(name); }
    void swap_buffers() override {}

  private:
    template <class F>
    void find(F& function, const char* name) {
        function = reinterpret_cast<F>(dlsym(library_, name));
        if (!function) throw PlatformError(std::string(kLibrary) + " has no " + name);
    }

    void* library_ = nullptr;
    MakeCurrent make_current_ = nullptr;
    DestroyContext destroy_ = nullptr;
    GetProcAddress get_proc_address_ = nullptr;
    std::vector<std::uint8_t> image_;  // that the context draws into
    Context context_ = nullptr;
};

}  // namespace

std::unique_ptr<Platform> open_osmesa(int width, int height) {
    return std::make_unique<Osmesa>(width, height);
}

}  // namespace apps
