// SPDX-License-Identifier: MIT
// OSMesa, Mesa's off-screen library: a surface is memory of ours, and a context's depth and stencil are its
// own.
//
// Found at run time, so that neither building nor running needs it elsewhere: OSMesa left Mesa with
// version 25.1.
#include <dlfcn.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <string>
#include <vector>

#include "harness/gl.h"
#include "harness/platform.h"

namespace conformance {

namespace {

constexpr const char* kLibrary = "libOSMesa.so.8";

// Of GL/osmesa.h, which is not Khronos': the attributes of a context.
constexpr int kFormat = 0x22;
constexpr int kDepthBits = 0x30;
constexpr int kStencilBits = 0x31;
constexpr int kProfile = 0x33;
constexpr int kCoreProfile = 0x34;
constexpr int kCompatibilityProfile = 0x35;
constexpr int kContextMajorVersion = 0x36;
constexpr int kContextMinorVersion = 0x37;

using OsContext = void*;

template <typename Function>
Function find(const char* name) {
    return reinterpret_cast<Function>(dlsym(RTLD_DEFAULT, name));
}

class OsmesaPlatform final : public Platform {
  public:
    explicit OsmesaPlatform(OsContext (*create)(const int*, OsContext)) : create_(create) {}

    Handle create_context(const ContextWish& wish, Handle share) override {
        if (wish.api == Api::kEs2 || wish.debug || wish.robust || wish.no_error) return 0;
        std::vector<int> attributes = {
            kFormat,      GL_RGBA, kDepthBits, 24,
            kStencilBits, 8,       kProfile,   wish.api == Api::kCore ? kCoreProfile : kCompatibilityProfile};
        if (wish.major > 0) {
            attributes.insert(attributes.end(),
                              {kContextMajorVersion, wish.major, kContextMinorVersion, wish.minor});
        }
        attributes.push_back(0);
        return reinterpret_cast<Handle>(create_(attributes.data(), reinterpret_cast<OsContext>(share)));
    }

    Handle create_surface(const SurfaceWish& wish) override {
        // Depth and stencil belong to the context here, and it has them.
        if (wish.depth_bits != 24 || wish.stencil_bits != 8 || wish.accumulation_bits != 0) return 0;
        return reinterpret_cast<Handle>(new Pixels{});
    }

    void destroy_context(Handle context) override { destroy_(reinterpret_cast<OsContext>(context)); }
    void destroy_surface(Handle surface) override { delete reinterpret_cast<Pixels*>(surface); }

    bool make_current(Handle surface, Handle context) override {
        const int size = surface ? kSurfaceSize : 0;
        return make_current_(reinterpret_cast<OsContext>(context), reinterpret_cast<Pixels*>(surface),
                             GL_UNSIGNED_BYTE, size, size) == GL_TRUE;
    }

    void swap(Handle) override { glFinish(); }  // what brings the image into the memory

    void* get_proc_address(const char* name) override {
        return reinterpret_cast<void*>(get_proc_address_(name));
    }

  private:
    using Pixels = std::array<GLubyte, static_cast<std::size_t>(kSurfaceSize) * kSurfaceSize * 4>;  // RGBA

    OsContext (*create_)(const int*, OsContext);
    void (*destroy_)(OsContext) = find<void (*)(OsContext)>("OSMesaDestroyContext");
    GLboolean (*make_current_)(OsContext, void*, GLenum, GLsizei, GLsizei) =
        find<GLboolean (*)(OsContext, void*, GLenum, GLsizei, GLsizei)>("OSMesaMakeCurrent");
    void (*(*get_proc_address_)(const char*))() = find<void (*(*)(const char*))()>("OSMesaGetProcAddress");
};

}  // namespace

bool preload_osmesa(char* const* argv) {
    const char* preloaded = std::getenv("LD_PRELOAD");
    std::string preload = preloaded ? preloaded : "";
    if (preload.find(kLibrary) != std::string::npos) return true;
    // Looked for before it is preloaded: the loader only warns of a preload that it does not find.
    if (!dlopen(kLibrary, RTLD_LAZY | RTLD_LOCAL)) return false;
    if (!preload.empty())
        preload += ':';  // behind a layer that is preloaded, which has to see the calls first
    setenv("LD_PRELOAD", (preload + kLibrary).c_str(), 1);
    execv("/proc/self/exe", argv);
    return false;
}

std::unique_ptr<Platform> open_osmesa_platform() {
    const auto create = find<OsContext (*)(const int*, OsContext)>("OSMesaCreateContextAttribs");
    if (!create) return nullptr;
    return std::make_unique<OsmesaPlatform>(create);
}

}  // namespace conformance
