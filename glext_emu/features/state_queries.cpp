// SPDX-License-Identifier: MIT
// State queries: versions, extensions, the HP test's two names, and the error flag. One answer serves all
// five Gets.
#include "features/features.h"

#include <algorithm>
#include <limits>
#include <type_traits>
#include <utility>

namespace glext_emu::features {
namespace {

// Asks the driver, so that an error is the driver's own; false where it raised one.
template <class T>
bool driver_answers(GLenum pname, void (*real)(GLenum, T*)) {
    constexpr T kUntouched = static_cast<T>(-7);  // no count and no version
    T value = kUntouched;
    real(pname, &value);
    return value != kUntouched;
}

struct Answer {
    enum {
        kForward,  // the driver's
        kRefuse,   // INVALID_ENUM
        kOwn,      // state that the driver does not have
        kInstead,  // of what the driver says
    } kind = kForward;
    GLint64 value = 0;
};

// True for what <answer> may not leave to the driver; asked first, since an answer may have effects.
bool is_ours(const Context& ctx, GLenum pname) {
    switch (pname) {
        case GL_OCCLUSION_TEST_HP:
        case GL_OCCLUSION_TEST_RESULT_HP:
            return ctx.emulates_test;
        case GL_PIXEL_COUNTER_BITS_NV:
        case GL_CURRENT_OCCLUSION_QUERY_ID_NV:
            return ctx.emulates_nv_query;
        case GL_INSTRUMENT_MEASUREMENTS_SGIX:
            return ctx.known_instruments != 0;
        case kDepthPassCounters:
        case kDepthPassMax:
            return is_instrument(ctx, kDepthPassInstrument);
        case kVisibilityTest:
            return ctx.emulates_visibility_test;
        case GL_FAR_DEPTH_EMU:
            return ctx.emulates_regions || ctx.emulates_unit;
        case GL_MAX_DEPTH_REGIONS_EMU:
        case GL_DEPTH_REGION_PIXELS_READ_EMU:
            return ctx.emulates_regions;
        case GL_MAX_OCCLUSION_SHAPES_EMU:
        case GL_OCCLUSION_COUNTER_BITS_EMU:
            return ctx.emulates_unit;
        case GL_LIST_INDEX:
            return ctx.recording.name != 0;
        case GL_TIMESTAMP:
            return ctx.time != nullptr;
        case GL_MAJOR_VERSION:
        case GL_MINOR_VERSION:
        case GL_NUM_EXTENSIONS:
        case GL_CONTEXT_FLAGS:
        case GL_CONTEXT_PROFILE_MASK:
            return ctx.advertised->version_differs || ctx.advertised->extensions_differ;
        default:
            return false;
    }
}

Answer answer(Context& ctx, GLenum pname) {
    if (ctx.emulates_test) {
        if (pname == GL_OCCLUSION_TEST_HP) return {Answer::kOwn, ctx.slot.test_enabled};
        if (pname == GL_OCCLUSION_TEST_RESULT_HP) return {Answer::kOwn, read_test_result(ctx)};
    }
    if (ctx.emulates_nv_query) {
        if (pname == GL_PIXEL_COUNTER_BITS_NV) return {Answer::kOwn, counter_bits(ctx)};
        if (pname == GL_CURRENT_OCCLUSION_QUERY_ID_NV) {
            return {Answer::kOwn, ctx.slot.counts_samples() ? static_cast<GLint>(ctx.slot.app_query) : 0};
        }
    }
    const Advertised& advertised = *ctx.advertised;
    const bool is_before_3_0 = advertised.version_differs && advertised.version < GlVersion{3, 0};
    switch (pname) {
        case GL_INSTRUMENT_MEASUREMENTS_SGIX:
            return {Answer::kOwn, ctx.instruments.measurements};
        case kDepthPassCounters:
            return {Answer::kOwn, 1};
        case kDepthPassMax:
            return {Answer::kOwn, static_cast<GLint64>(depth_pass_max(ctx))};
        case GL_FAR_DEPTH_EMU:
            return {Answer::kOwn, ctx.proposed.far_end};
        case GL_MAX_DEPTH_REGIONS_EMU:
            return {Answer::kOwn, max_depth_regions()};
        case GL_DEPTH_REGION_PIXELS_READ_EMU:
            return {Answer::kOwn, static_cast<GLint64>(ctx.proposed.pixels_read)};
        case GL_MAX_OCCLUSION_SHAPES_EMU:
            return {Answer::kOwn, max_occlusion_shapes()};
        case GL_OCCLUSION_COUNTER_BITS_EMU:
            return {Answer::kOwn, unit_counter_bits()};
        case GL_MAJOR_VERSION:
        case GL_MINOR_VERSION:
            // These names, and the next three, came with OpenGL 3.0 and 3.2.
            if (is_before_3_0) return {Answer::kRefuse};
            if (!advertised.version_differs) return {};
            return {Answer::kInstead,
                    pname == GL_MAJOR_VERSION ? advertised.version.major : advertised.version.minor};
        case GL_NUM_EXTENSIONS:
            if (is_before_3_0) return {Answer::kRefuse};
            if (!advertised.extensions_differ) return {};
            return {Answer::kInstead, static_cast<GLint>(advertised.extensions.size())};
        case GL_TIMESTAMP:
            return {Answer::kInstead, static_cast<GLint64>(ctx.time->now_ns())};
        case GL_LIST_INDEX:
            // The driver's list may be a part of the program's.
            return ctx.recording.name != 0
                       ? Answer{Answer::kInstead, static_cast<GLint64>(ctx.recording.name)}
                       : Answer{};
        case GL_CONTEXT_FLAGS:
            return is_before_3_0 ? Answer{Answer::kRefuse} : Answer{};
        case GL_CONTEXT_PROFILE_MASK:
            return advertised.version_differs && advertised.version < GlVersion{3, 2}
                       ? Answer{Answer::kRefuse}
                       : Answer{};
        default:
            return {};
    }
}

template <class T>
void get(Context& ctx, GLenum pname, T* params, void (*real)(GLenum, T*)) {
    if (params == nullptr || !is_ours(ctx, pname) || ctx.is_between_begin_and_end())
        return real(pname, params);
    // Two values: HP's demonstration of 2001 gives the Get an array of two.
    if (pname == kVisibilityTest) {
        const bool has_all = read_visibility_tests(ctx);
        params[0] = static_cast<T>(ctx.visibility.is_enabled);
        params[1] = static_cast<T>(has_all);
        return;
    }
    const Answer found = answer(ctx, pname);
    if (found.kind == Answer::kForward) return real(pname, params);
    if (found.kind == Answer::kRefuse) return ctx.raise(GL_INVALID_ENUM);
    if (found.kind == Answer::kInstead && !driver_answers(pname, real)) return;
    if constexpr (std::is_same_v<T, GLboolean>) {
        *params = found.value != 0 ? GL_TRUE : GL_FALSE;
    } else {
        constexpr GLint64 kMost = std::is_same_v<T, GLint> ? std::numeric_limits<GLint>::max()
                                                           : std::numeric_limits<GLint64>::max();
        *params = static_cast<T>(std::min(found.value, kMost));
    }
}

const GLubyte* as_gl_string(const std::string& text) {
    return reinterpret_cast<const GLubyte*>(text.c_str());
}

}  // namespace

void get_booleanv(Context& ctx, GLenum pname, GLboolean* params) {
    get(ctx, pname, params, ctx.real->glGetBooleanv);
}

void get_integerv(Context& ctx, GLenum pname, GLint* params) {
    get(ctx, pname, params, ctx.real->glGetIntegerv);
}

void get_integer64v(Context& ctx, GLenum pname, GLint64* params) {
    get(ctx, pname, params, ctx.real->glGetInteger64v);
}

void get_floatv(Context& ctx, GLenum pname, GLfloat* params) {
    get(ctx, pname, params, ctx.real->glGetFloatv);
}

void get_doublev(Context& ctx, GLenum pname, GLdouble* params) {
    get(ctx, pname, params, ctx.real->glGetDoublev);
}

const GLubyte* get_string(Context& ctx, GLenum name) {
    const GLubyte* const driver_string = ctx.real->glGetString(name);
    if (driver_string == nullptr) return nullptr;  // in error
    const Advertised& advertised = *ctx.advertised;
    if (name == GL_VERSION && advertised.version_differs) return as_gl_string(advertised.version_string);
    if (name == GL_SHADING_LANGUAGE_VERSION && advertised.version_differs) {
        return as_gl_string(advertised.shading_language);
    }
    if (name == GL_EXTENSIONS && advertised.extensions_differ)
        return as_gl_string(advertised.extension_string);
    return driver_string;
}

const GLubyte* get_stringi(Context& ctx, GLenum name, GLuint index) {
    const Advertised& advertised = *ctx.advertised;
    if (name != GL_EXTENSIONS || !advertised.extensions_differ) return ctx.real->glGetStringi(name, index);
    if (ctx.real->glGetStringi(name, 0) == nullptr) return nullptr;  // in error
    // GL 4.6, 22.2: an index outside the list.
    if (index >= advertised.extensions.size()) {
        ctx.raise(GL_INVALID_VALUE);
        return nullptr;
    }
    return as_gl_string(advertised.extensions[index]);
}

GLenum get_error(Context& ctx) {
    if (ctx.pending_error == GL_NO_ERROR) return ctx.real->glGetError();
    // There is one flag: an error that came after the pending one was never recorded.
    ctx.real->glGetError();
    const GLenum code = std::exchange(ctx.pending_error, static_cast<GLenum>(GL_NO_ERROR));
    ctx.update_hot();
    return code;
}

}  // namespace glext_emu::features
