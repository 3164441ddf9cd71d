// SPDX-License-Identifier: MIT
// EGL without a window system: pbuffers on the surfaceless platform of Mesa.
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <algorithm>
#include <array>
#include <vector>

#include "harness/platform.h"

namespace conformance {

namespace {

Platform::Handle to_handle(void* pointer) {
    return reinterpret_cast<Platform::Handle>(pointer);
}

class EglPlatform final : public Platform {
  public:
    explicit EglPlatform(EGLDisplay display) : display_(display) {}

    ~EglPlatform() override { eglTerminate(display_); }

    Handle create_context(const ContextWish& wish, Handle share) override {
        eglBindAPI(wish.api == Api::kEs2 ? EGL_OPENGL_ES_API : EGL_OPENGL_API);
        std::vector<EGLint> attributes;
        if (wish.api == Api::kEs2) {
            attributes = {EGL_CONTEXT_MAJOR_VERSION, std::max(wish.major, 2), EGL_CONTEXT_MINOR_VERSION,
                          wish.minor};
        }
        if (wish.api != Api::kEs2 && wish.major > 0) {
            attributes = {EGL_CONTEXT_MAJOR_VERSION, wish.major, EGL_CONTEXT_MINOR_VERSION, wish.minor};
            // The attribute has no meaning below 3.2 and some drivers refuse it there.
            if (wish.major * 10 + wish.minor >= 32) {
                attributes.push_back(EGL_CONTEXT_OPENGL_PROFILE_MASK);
                attributes.push_back(wish.api == Api::kCore ? EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT
                                                            : EGL_CONTEXT_OPENGL_COMPATIBILITY_PROFILE_BIT);
            }
        }
        if (wish.debug) attributes.insert(attributes.end(), {EGL_CONTEXT_OPENGL_DEBUG, EGL_TRUE});
        if (wish.robust) attributes.insert(attributes.end(), {EGL_CONTEXT_OPENGL_ROBUST_ACCESS, EGL_TRUE});
        if (wish.no_error) {
            attributes.insert(attributes.end(), {EGL_CONTEXT_OPENGL_NO_ERROR_KHR, EGL_TRUE});
        }
        attributes.push_back(EGL_NONE);
        return to_handle(eglCreateContext(display_, EGL_NO_CONFIG_KHR, reinterpret_cast<EGLContext>(share),
                                          attributes.data()));
    }

    Handle create_surface(const SurfaceWish& wish) override {
        if (wish.accumulation_bits > 0) return 0;  // EGL configurations have no accumulation buffer
        const std::array<EGLint, 15> wanted = {EGL_SURFACE_TYPE,
                                               EGL_PBUFFER_BIT,
                                               EGL_RED_SIZE,
                                               8,
                                               EGL_ALPHA_SIZE,
                                               8,
                                               EGL_DEPTH_SIZE,
                                               wish.depth_bits,
                                               EGL_STENCIL_SIZE,
                                               wish.stencil_bits,
                                               EGL_RENDERABLE_TYPE,
                                               EGL_OPENGL_BIT,
                                               EGL_SAMPLES,
                                               0,
                                               EGL_NONE};
        EGLint count = 0;
        eglChooseConfig(display_, wanted.data(), nullptr, 0, &count);
        std::vector<EGLConfig> configs(static_cast<std::size_t>(count));
        eglChooseConfig(display_, wanted.data(), configs.data(), count, &count);
        for (EGLConfig config : configs) {
            // The sizes are minimums to eglChooseConfig; a surface without depth has to be exactly that.
            if (!has(config, EGL_DEPTH_SIZE, wish.depth_bits) ||
                !has(config, EGL_STENCIL_SIZE, wish.stencil_bits) || !has(config, EGL_RED_SIZE, 8)) {
                continue;
            }
            const std::array<EGLint, 5> size = {EGL_WIDTH, kSurfaceSize, EGL_HEIGHT, kSurfaceSize, EGL_NONE};
            return to_handle(eglCreatePbufferSurface(display_, config, size.data()));
        }
        return 0;
    }

    void destroy_context(Handle context) override {
        eglDestroyContext(display_, reinterpret_cast<EGLContext>(context));
    }
    void destroy_surface(Handle surface) override {
        eglDestroySurface(display_, reinterpret_cast<EGLSurface>(surface));
    }

    bool make_current(Handle surface, Handle context) override {
        auto* drawable = reinterpret_cast<EGLSurface>(surface);
        return eglMakeCurrent(display_, drawable, drawable, reinterpret_cast<EGLContext>(context)) ==
               EGL_TRUE;
    }

    void swap(Handle surface) override { eglSwapBuffers(display_, reinterpret_cast<EGLSurface>(surface)); }

    void* get_proc_address(const char* name) override {
        return reinterpret_cast<void*>(eglGetProcAddress(name));
    }

  private:
    bool has(EGLConfig config, EGLint attribute, EGLint wanted) const {
        EGLint value = -1;
        eglGetConfigAttrib(display_, config, attribute, &value);
        return value == wanted;
    }

    EGLDisplay display_;
};

}  // namespace

std::unique_ptr<Platform> open_egl_platform() {
    EGLDisplay display = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr)) return nullptr;
    return std::make_unique<EglPlatform>(display);
}

}  // namespace conformance
