// SPDX-License-Identifier: MIT
// The proxy path of the Occlusion Unit: nearest depth and screen box of what fixed function draws, from a
// fragment stage of the layer's own that runs after the early depth test and marks what it sees. The vertex
// stage stays the program's, so the fragments are its fragments; what fixed function makes of their colours
// does not matter.
#pragma once

#include <GL/gl.h>
#include <GL/glext.h>

#include <vector>

#include "context/unit_run.h"
#include "occlusion_unit/record_arithmetic.h"

namespace glext_emu {

// The marks of one query, over all its draws.
class ProxyMarks final : public DriverMarks {
  public:
    // <registers>: NEAREST_DEPTH_BIT_EMU, SCREEN_BOX_BIT_EMU; others are ignored.
    ProxyMarks(GLbitfield registers, occlusion_unit::FarEnd far_end);

    // True where a draw of points, lines or polygons with the program's present state can be marked exactly:
    // drawn beforehand with writes switched off, or, where writes_nothing, drawn once. Not for pixel
    // rectangles and bitmaps.
    static bool serves(Context& ctx, GLbitfield registers, occlusion_unit::FarEnd far_end);
    // True where a draw changes neither colour nor depth nor stencil, so that it can itself be the marked
    // one.
    static bool writes_nothing(Context& ctx);

    // Around one call of the driver's that draws, which is not between Begin and End: binds the stage and the
    // marks, switches off writes to colour, depth and stencil, and undoes all that. Only where serves.
    void begin_draw(Context& ctx);
    void end_draw(Context& ctx);

    bool is_ready(Context& ctx) override;
    occlusion_unit::Record drain(Context& ctx) override;
    void drop(Context& ctx) override;

  private:
    // Marks in one buffer of the driver's: a key of the depth, a word for each column and each row of pixels.
    struct Sheet {
        GLuint buffer = 0;
        GLsizeiptr bytes = 0;
        GLint columns = 0;
        GLint rows = 0;
        GLint depth_bits = 0;  // 0: no depth buffer
        bool has_float_depth = false;
    };
    // Words before those of the first column.
    static constexpr GLint kHeaderWords = 4;

    Sheet& sheet_for(Context& ctx);

    GLbitfield registers_;
    occlusion_unit::FarEnd far_end_;
    std::vector<Sheet> sheets_;  // a new one where the framebuffer has grown, or has another format
    GLsync fence_ = nullptr;
    // What begin_draw has changed.
    bool masks_are_off_ = false;
    GLint max_draw_buffers_ = 0;
    GLboolean color_masks_[8][4] = {};
    GLboolean depth_mask_ = GL_FALSE;
    GLint stencil_masks_[2] = {};
};

}  // namespace glext_emu
