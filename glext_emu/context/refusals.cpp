// SPDX-License-Identifier: MIT
#include "context/refusals.h"

#include "context/settings.h"

namespace glext_emu {
namespace {

bool is_absent(const Context& ctx, std::string_view extension, GlVersion core_since) {
    return ctx.kind.is_compatibility() && settings().device.hides(extension) &&
           ctx.advertised->version < core_since;
}

}  // namespace

bool refuses_target(const Context& ctx, GLenum target) {
    switch (target) {
        case GL_SAMPLES_PASSED:
            return is_absent(ctx, "GL_ARB_occlusion_query", {1, 5});
        case GL_ANY_SAMPLES_PASSED:
            return is_absent(ctx, "GL_ARB_occlusion_query2", {3, 3});
        case GL_ANY_SAMPLES_PASSED_CONSERVATIVE:
            return is_absent(ctx, "GL_ARB_ES3_compatibility", {4, 3});
        default:
            return false;
    }
}

bool refuses_conditional_render(const Context& ctx) {
    return is_absent(ctx, "GL_NV_conditional_render", {3, 0});
}

bool refuses_conditional_mode(const Context& ctx, GLenum mode) {
    const bool is_inverted = mode >= GL_QUERY_WAIT_INVERTED && mode <= GL_QUERY_BY_REGION_NO_WAIT_INVERTED;
    return is_inverted && is_absent(ctx, "GL_ARB_conditional_render_inverted", {4, 5});
}

bool refuses_query_buffers(const Context& ctx) {
    return is_absent(ctx, "GL_ARB_query_buffer_object", {4, 4});
}

}  // namespace glext_emu
