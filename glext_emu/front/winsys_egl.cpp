// SPDX-License-Identifier: MIT
// EGL below GLVND: contexts made, made current and destroyed, and buffers swapped.
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <array>

#include "context/contexts.h"
#include "front/winsys.h"

namespace glext_emu {
namespace {

struct RealEgl {
    EGLContext (*create)(EGLDisplay, EGLConfig, EGLContext, const EGLint*) = nullptr;
    EGLBoolean (*destroy)(EGLDisplay, EGLContext) = nullptr;
    EGLBoolean (*make_current)(EGLDisplay, EGLSurface, EGLSurface, EGLContext) = nullptr;
    EGLBoolean (*release_thread)() = nullptr;
    EGLBoolean (*swap)(EGLDisplay, EGLSurface) = nullptr;
    EGLBoolean (*swap_with_damage)(EGLDisplay, EGLSurface, const EGLint*, EGLint) = nullptr;
};

constinit std::array<RealEgl, kMostDrivers> reals{};

template <int kDriver>
struct Hooks {
    static RealEgl& real() { return reals[kDriver]; }

    static EGLContext create(EGLDisplay display, EGLConfig config, EGLContext share,
                             const EGLint* attributes) {
        const auto query_api = reinterpret_cast<EGLenum (*)()>(driver_function(kDriver, "eglQueryAPI"));
        const bool is_desktop = query_api != nullptr && query_api() == EGL_OPENGL_API;
        const auto obedient =
            obey_device<EGLint>(attributes, EGL_NONE, EGL_CONTEXT_MAJOR_VERSION, EGL_CONTEXT_MINOR_VERSION);
        EGLContext context = real().create(display, config, share, is_desktop ? obedient.data() : attributes);
        if (context != EGL_NO_CONTEXT) context_created("egl", real_gl_of(kDriver), context, share);
        return context;
    }
    static EGLBoolean destroy(EGLDisplay display, EGLContext context) {
        Context* const forgotten = forget_context(context);
        const EGLBoolean done = real().destroy(display, context);
        if (done) {
            end_context(forgotten);
        } else {
            restore_context(context, forgotten);
        }
        return done;
    }
    static EGLBoolean make_current(EGLDisplay display, EGLSurface draw, EGLSurface read, EGLContext context) {
        context_leaves_thread();
        const EGLBoolean done = real().make_current(display, draw, read, context);
        if (!done) return done;
        context_made_current("egl", real_gl_of(kDriver), context);
        if (context == EGL_NO_CONTEXT) return done;
        current.context->draw_surface = {.ask_size = surface_size,
                                         .display = display,
                                         .name = reinterpret_cast<std::uintptr_t>(draw),
                                         .exists = draw != EGL_NO_SURFACE};
        return done;
    }
    static DrawSurface::Size surface_size(const DrawSurface& drawn) {
        const auto ask = reinterpret_cast<EGLBoolean (*)(EGLDisplay, EGLSurface, EGLint, EGLint*)>(
            driver_function(kDriver, "eglQuerySurface"));
        const auto surface = reinterpret_cast<EGLSurface>(drawn.name);
        EGLint width = 0;
        EGLint height = 0;
        ask(drawn.display, surface, EGL_WIDTH, &width);
        ask(drawn.display, surface, EGL_HEIGHT, &height);
        return {width, height};
    }
    static EGLBoolean release_thread() {
        context_leaves_thread();
        const EGLBoolean done = real().release_thread();
        if (done) context_made_current("egl", real_gl_of(kDriver), nullptr);
        return done;
    }
    static EGLBoolean swap(EGLDisplay display, EGLSurface surface) {
        const EGLBoolean done = real().swap(display, surface);
        if (done) buffers_swapped();
        return done;
    }
    static EGLBoolean swap_with_damage(EGLDisplay display, EGLSurface surface, const EGLint* rectangles,
                                       EGLint count) {
        const EGLBoolean done = real().swap_with_damage(display, surface, rectangles, count);
        if (done) buffers_swapped();
        return done;
    }

    static void* find(const char* name, void* driver_function) {
        const auto is = [name](const char* other) { return std::strcmp(name, other) == 0; };
        if (is("eglCreateContext")) return take(real().create, driver_function, create);
        if (is("eglDestroyContext")) return take(real().destroy, driver_function, destroy);
        if (is("eglMakeCurrent")) return take(real().make_current, driver_function, make_current);
        if (is("eglReleaseThread")) return take(real().release_thread, driver_function, release_thread);
        if (is("eglSwapBuffers")) return take(real().swap, driver_function, swap);
        if (is("eglSwapBuffersWithDamageKHR") || is("eglSwapBuffersWithDamageEXT")) {
            return take(real().swap_with_damage, driver_function, swap_with_damage);
        }
        return driver_function;
    }
};

}  // namespace

void* egl_hook(int driver, const char* name, void* real) {
    return find_in<Hooks>(driver, name, real, std::make_integer_sequence<int, kMostDrivers>{});
}

}  // namespace glext_emu
