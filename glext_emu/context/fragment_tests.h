// SPDX-License-Identifier: MIT
// The state of the driver's per-fragment tests, as far as a repeated draw depends on it.
#pragma once

#include <GL/gl.h>
#include <GL/glext.h>

namespace glext_emu {

struct Context;

// Of one side of a polygon.
struct StencilSide {
    GLenum func = GL_ALWAYS;
    GLenum fail = GL_KEEP;
    GLenum depth_fail = GL_KEEP;
    GLenum depth_pass = GL_KEEP;
    GLuint write_mask = ~0u;

    bool can_fail() const { return func != GL_ALWAYS; }
    bool writes() const {
        return write_mask != 0 && !(fail == GL_KEEP && depth_fail == GL_KEEP && depth_pass == GL_KEEP);
    }
};

struct FragmentTests {
    bool depth_test = false;
    GLenum depth_func = GL_LESS;
    bool depth_writes = true;  // as DEPTH_WRITEMASK says; without a depth test nothing is written
    bool stencil_test = false;
    StencilSide front;
    StencilSide back;

    bool depth_can_fail() const { return depth_test && depth_func != GL_ALWAYS; }
    bool stencil_writes() const { return stencil_test && (front.writes() || back.writes()); }
    // True where the outcome of a fragment's stencil test may depend on what earlier fragments of the same
    // draw have written.
    bool stencil_feeds_back() const { return stencil_writes() && (front.can_fail() || back.can_fail()); }
};

FragmentTests read_fragment_tests(Context& ctx);

// The depth function that passes where <func>, one of GL's eight, fails.
GLenum opposite_depth_func(GLenum func);

}  // namespace glext_emu
