// SPDX-License-Identifier: MIT
// GLX below GLVND: contexts made, made current and destroyed, and buffers swapped.
#include <GL/glx.h>
#include <GL/glxext.h>

#include <array>

#include "context/contexts.h"
#include "front/winsys.h"

namespace glext_emu {
namespace {

struct RealGlx {
    GLXContext (*create)(Display*, XVisualInfo*, GLXContext, Bool) = nullptr;
    GLXContext (*create_new)(Display*, GLXFBConfig, int, GLXContext, Bool) = nullptr;
    GLXContext (*create_sgix)(Display*, GLXFBConfig, int, GLXContext, Bool) = nullptr;
    GLXContext (*create_attribs)(Display*, GLXFBConfig, GLXContext, Bool, const int*) = nullptr;
    void (*destroy)(Display*, GLXContext) = nullptr;
    void (*copy)(Display*, GLXContext, GLXContext, unsigned long) = nullptr;
    Bool (*make_current)(Display*, GLXDrawable, GLXContext) = nullptr;
    Bool (*make_context_current)(Display*, GLXDrawable, GLXDrawable, GLXContext) = nullptr;
    void (*swap)(Display*, GLXDrawable) = nullptr;
    int64_t (*swap_msc)(Display*, GLXDrawable, int64_t, int64_t, int64_t) = nullptr;
};

constinit std::array<RealGlx, kMostDrivers> reals{};

bool asks_for_es(const int* attributes) {
    for (const int* a = attributes; a != nullptr && *a != 0; a += 2) {
        if (a[0] == GLX_CONTEXT_PROFILE_MASK_ARB) return (a[1] & GLX_CONTEXT_ES2_PROFILE_BIT_EXT) != 0;
    }
    return false;
}

template <int kDriver>
struct Hooks {
    static RealGlx& real() { return reals[kDriver]; }

    // An indirect context renders in the X server, out of reach.
    static bool is_direct(Display* display, GLXContext context) {
        const auto ask =
            reinterpret_cast<Bool (*)(Display*, GLXContext)>(driver_function(kDriver, "glXIsDirect"));
        return ask == nullptr || ask(display, context);
    }
    static GLXContext created(Display* display, GLXContext context, GLXContext share) {
        if (context != nullptr && is_direct(display, context)) {
            context_created("glx", real_gl_of(kDriver), context, share);
        }
        return context;
    }
    static void made_current(Display* display, GLXDrawable draw, GLXContext context) {
        const bool is_reached = context != nullptr && is_direct(display, context);
        context_made_current("glx", real_gl_of(kDriver), is_reached ? context : nullptr);
        if (!is_reached) return;
        current.context->draw_surface = {
            .ask_size = surface_size, .display = display, .name = draw, .exists = draw != None};
    }
    static DrawSurface::Size surface_size(const DrawSurface& drawn) {
        const auto ask = reinterpret_cast<void (*)(Display*, GLXDrawable, int, unsigned*)>(
            driver_function(kDriver, "glXQueryDrawable"));
        auto* const display = static_cast<Display*>(drawn.display);
        unsigned width = 0;
        unsigned height = 0;
        ask(display, drawn.name, GLX_WIDTH, &width);
        ask(display, drawn.name, GLX_HEIGHT, &height);
        return {static_cast<GLsizei>(width), static_cast<GLsizei>(height)};
    }

    static GLXContext create(Display* display, XVisualInfo* visual, GLXContext share, Bool direct) {
        return created(display, real().create(display, visual, share, direct), share);
    }
    static GLXContext create_new(Display* display, GLXFBConfig config, int type, GLXContext share,
                                 Bool direct) {
        return created(display, real().create_new(display, config, type, share, direct), share);
    }
    static GLXContext create_sgix(Display* display, GLXFBConfig config, int type, GLXContext share,
                                  Bool direct) {
        return created(display, real().create_sgix(display, config, type, share, direct), share);
    }
    static GLXContext create_attribs(Display* display, GLXFBConfig config, GLXContext share, Bool direct,
                                     const int* attributes) {
        if (asks_for_es(attributes)) {
            return created(display, real().create_attribs(display, config, share, direct, attributes), share);
        }
        const auto obedient =
            obey_device(attributes, 0, GLX_CONTEXT_MAJOR_VERSION_ARB, GLX_CONTEXT_MINOR_VERSION_ARB);
        return created(display, real().create_attribs(display, config, share, direct, obedient.data()),
                       share);
    }
    static void destroy(Display* display, GLXContext context) {
        Context* const forgotten = forget_context(context);
        real().destroy(display, context);
        end_context(forgotten);
    }
    static void copy(Display* display, GLXContext from, GLXContext to, unsigned long mask) {
        real().copy(display, from, to, mask);
        context_copied(from, to, static_cast<GLbitfield>(mask));
    }
    static Bool make_current(Display* display, GLXDrawable drawable, GLXContext context) {
        context_leaves_thread();
        const Bool done = real().make_current(display, drawable, context);
        if (done) made_current(display, drawable, context);
        return done;
    }
    static Bool make_context_current(Display* display, GLXDrawable draw, GLXDrawable read,
                                     GLXContext context) {
        context_leaves_thread();
        const Bool done = real().make_context_current(display, draw, read, context);
        if (done) made_current(display, draw, context);
        return done;
    }
    static void swap(Display* display, GLXDrawable drawable) {
        real().swap(display, drawable);
        buffers_swapped();
    }
    static int64_t swap_msc(Display* display, GLXDrawable drawable, int64_t target, int64_t divisor,
                            int64_t remainder) {
        const int64_t count = real().swap_msc(display, drawable, target, divisor, remainder);
        if (count >= 0) buffers_swapped();
        return count;
    }

    static void* find(const char* name, void* real_function) {
        const auto is = [name](const char* other) { return std::strcmp(name, other) == 0; };
        if (is("glXCreateContext")) return take(real().create, real_function, create);
        if (is("glXCreateNewContext")) return take(real().create_new, real_function, create_new);
        if (is("glXCreateContextWithConfigSGIX")) return take(real().create_sgix, real_function, create_sgix);
        if (is("glXCreateContextAttribsARB"))
            return take(real().create_attribs, real_function, create_attribs);
        if (is("glXDestroyContext")) return take(real().destroy, real_function, destroy);
        if (is("glXCopyContext")) return take(real().copy, real_function, copy);
        if (is("glXMakeCurrent")) return take(real().make_current, real_function, make_current);
        if (is("glXMakeContextCurrent") || is("glXMakeCurrentReadSGI")) {
            return take(real().make_context_current, real_function, make_context_current);
        }
        if (is("glXSwapBuffers")) return take(real().swap, real_function, swap);
        if (is("glXSwapBuffersMscOML")) return take(real().swap_msc, real_function, swap_msc);
        return real_function;
    }
};

}  // namespace

void* glx_hook(int driver, const char* name, void* real) {
    return find_in<Hooks>(driver, name, real, std::make_integer_sequence<int, kMostDrivers>{});
}

}  // namespace glext_emu
