// SPDX-License-Identifier: MIT
// State of the program's that a draw of the layer's own changes, and gets back when the scope ends. Each
// function changes one piece, if it has to, and remembers what it was.
#pragma once

#include <GL/gl.h>
#include <GL/glext.h>

#include <functional>
#include <vector>

#include "context/context.h"

namespace glext_emu {

class SavedState {
  public:
    explicit SavedState(Context& ctx) : ctx_(ctx) {}
    ~SavedState();
    SavedState(const SavedState&) = delete;
    SavedState& operator=(const SavedState&) = delete;

    // Of the first viewport, where each has its own.
    void set(GLenum cap, bool is_on);
    // What would discard or record a draw, or tell the program of it: conditional rendering, transform
    // feedback, rasterizer discard, debug output.
    void draw_unconditionally();
    // What follows the vertex stage and is not among the per-fragment tests: clip distances, stipple,
    // smoothing, polygon mode, alpha test, alpha to coverage, sample shading, primitive restart.
    void draw_plain_polygons();
    // No draw writes colour, depth or stencil.
    void write_nothing();
    // Every draw sets all bits of colour attachment 0, whatever colour it has.
    void set_all_bits();
    // Stencil does after a failed depth test what it does after a passed one.
    void ignore_depth_in_stencil();
    void depth_mask(bool is_on);
    void depth_func(GLenum func);
    // 0: none of the program's.
    void use_program(GLuint program);
    void bind_vertex_array(GLuint array);
    // To draw to, and to read from; or one of the two.
    void bind_framebuffer(GLuint framebuffer);
    void bind_draw_framebuffer(GLuint framebuffer);
    void bind_read_framebuffer(GLuint framebuffer);
    void viewport(GLsizei width, GLsizei height);
    // ReadPixels writes rows from the lowest, without a gap, to client memory, depths and reds as they are.
    // Only inside OwnCalls.
    void read_plainly();

  private:
    GLint get(GLenum name) const;
    void undo(std::function<void()> step) { undo_.push_back(std::move(step)); }

    Context& ctx_;
    std::vector<std::function<void()>> undo_;
};

}  // namespace glext_emu
