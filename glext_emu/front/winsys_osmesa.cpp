// SPDX-License-Identifier: MIT
// OSMesa: contexts that draw into the program's memory. There is no swap; the program must call glFinish
// before it looks at its image, so a frame ends there. Declarations are OSMesa's own (GL/osmesa.h), which is
// not Khronos'.
#include <GL/gl.h>

#include <array>

#include "context/contexts.h"
#include "front/winsys.h"

namespace glext_emu {
namespace {

using OsmesaContext = void*;
constexpr int kContextMajorVersion = 0x36;
constexpr int kContextMinorVersion = 0x37;

struct RealOsmesa {
    OsmesaContext (*create)(GLenum, OsmesaContext) = nullptr;
    OsmesaContext (*create_ext)(GLenum, GLint, GLint, GLint, OsmesaContext) = nullptr;
    OsmesaContext (*create_attribs)(const int*, OsmesaContext) = nullptr;
    void (*destroy)(OsmesaContext) = nullptr;
    GLboolean (*make_current)(OsmesaContext, void*, GLenum, GLsizei, GLsizei) = nullptr;
    Finish finish = nullptr;
};

constinit std::array<RealOsmesa, kMostDrivers> reals{};

template <int kDriver>
struct Hooks {
    static RealOsmesa& real() { return reals[kDriver]; }

    static OsmesaContext created(OsmesaContext context, OsmesaContext share) {
        if (context != nullptr) context_created("osmesa", real_gl_of(kDriver), context, share);
        return context;
    }
    static OsmesaContext create(GLenum format, OsmesaContext share) {
        return created(real().create(format, share), share);
    }
    static OsmesaContext create_ext(GLenum format, GLint depth_bits, GLint stencil_bits, GLint accum_bits,
                                    OsmesaContext share) {
        return created(real().create_ext(format, depth_bits, stencil_bits, accum_bits, share), share);
    }
    static OsmesaContext create_attribs(const int* attributes, OsmesaContext share) {
        const auto obedient = obey_device(attributes, 0, kContextMajorVersion, kContextMinorVersion);
        return created(real().create_attribs(obedient.data(), share), share);
    }
    // Unlike the others OSMesa ends a context at once, current or not.
    static void destroy(OsmesaContext context) {
        Context* const forgotten = forget_context(context);
        if (forgotten != nullptr && forgotten == current.context) {
            context_leaves_thread();
            context_made_current("osmesa", real_gl_of(kDriver), nullptr);
        }
        real().destroy(context);
        end_context(forgotten);
    }
    static GLboolean make_current(OsmesaContext context, void* buffer, GLenum type, GLsizei width,
                                  GLsizei height) {
        context_leaves_thread();
        const GLboolean done = real().make_current(context, buffer, type, width, height);
        if (!done) return done;
        context_made_current("osmesa", real_gl_of(kDriver), context);
        if (context != nullptr) current.context->draw_surface = {.exists = true, .size = {width, height}};
        return done;
    }
    static void finish() {
        real().finish();
        if (current.real == &real_gl_of(kDriver)) buffers_swapped();
    }

    static void* find(const char* name, void* real_function) {
        const auto is = [name](const char* other) { return std::strcmp(name, other) == 0; };
        if (is("OSMesaCreateContext")) return take(real().create, real_function, create);
        if (is("OSMesaCreateContextExt")) return take(real().create_ext, real_function, create_ext);
        if (is("OSMesaCreateContextAttribs")) {
            return take(real().create_attribs, real_function, create_attribs);
        }
        if (is("OSMesaDestroyContext")) return take(real().destroy, real_function, destroy);
        if (is("OSMesaMakeCurrent")) return take(real().make_current, real_function, make_current);
        return real_function;
    }
};

template <int... kDrivers>
constexpr auto make_finishes(std::integer_sequence<int, kDrivers...>) {
    return std::array{Hooks<kDrivers>::finish...};
}
constexpr auto kFinishes = make_finishes(std::make_integer_sequence<int, kMostDrivers>{});

}  // namespace

Finish end_osmesa_frames(int driver, Finish finish) {
    reals[static_cast<std::size_t>(driver)].finish = finish;
    return kFinishes[static_cast<std::size_t>(driver)];
}

void* osmesa_hook(int driver, const char* name, void* real) {
    return find_in<Hooks>(driver, name, real, std::make_integer_sequence<int, kMostDrivers>{});
}

}  // namespace glext_emu
