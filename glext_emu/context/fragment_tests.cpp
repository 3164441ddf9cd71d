// SPDX-License-Identifier: MIT
#include "context/fragment_tests.h"

#include "context/context.h"

namespace glext_emu {
namespace {

GLuint get(Context& ctx, GLenum name) {
    GLint value = 0;
    ctx.real->glGetIntegerv(name, &value);
    return static_cast<GLuint>(value);
}

}  // namespace

FragmentTests read_fragment_tests(Context& ctx) {
    FragmentTests tests;
    tests.depth_test = ctx.real->glIsEnabled(GL_DEPTH_TEST) != GL_FALSE;
    if (tests.depth_test) {
        tests.depth_func = get(ctx, GL_DEPTH_FUNC);
        tests.depth_writes = get(ctx, GL_DEPTH_WRITEMASK) != 0;
    }
    tests.stencil_test = ctx.real->glIsEnabled(GL_STENCIL_TEST) != GL_FALSE;
    if (tests.stencil_test) {
        tests.front = {get(ctx, GL_STENCIL_FUNC), get(ctx, GL_STENCIL_FAIL),
                       get(ctx, GL_STENCIL_PASS_DEPTH_FAIL), get(ctx, GL_STENCIL_PASS_DEPTH_PASS),
                       get(ctx, GL_STENCIL_WRITEMASK)};
        tests.back = {get(ctx, GL_STENCIL_BACK_FUNC), get(ctx, GL_STENCIL_BACK_FAIL),
                      get(ctx, GL_STENCIL_BACK_PASS_DEPTH_FAIL), get(ctx, GL_STENCIL_BACK_PASS_DEPTH_PASS),
                      get(ctx, GL_STENCIL_BACK_WRITEMASK)};
    }
    return tests;
}

GLenum opposite_depth_func(GLenum func) {
    switch (func) {
        case GL_NEVER:
            return GL_ALWAYS;
        case GL_LESS:
            return GL_GEQUAL;
        case GL_EQUAL:
            return GL_NOTEQUAL;
        case GL_LEQUAL:
            return GL_GREATER;
        case GL_GREATER:
            return GL_LEQUAL;
        case GL_NOTEQUAL:
            return GL_EQUAL;
        case GL_GEQUAL:
            return GL_LESS;
        default:
            return GL_NEVER;  // of ALWAYS
    }
}

}  // namespace glext_emu
