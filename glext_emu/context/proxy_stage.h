// SPDX-License-Identifier: MIT
// The proxy path of the Occlusion Unit: nearest depth and screen box of what fixed function draws, from a
// fragment stage of the layer's own that runs after the early depth test and marks what it sees. The vertex
// stage stays the program's, so the fragments are its fragments; what fixed function makes of their colours
// does not matter.
#pragma once

#include <GL/gl.h>
#include <GL/glext.h>

#include <vector>

#include "context/fragment_tests.h"
#include "context/unit_run.h"
#include "context/unit_stages.h"

namespace glext_emu {

// The marks of one query, over all its draws.
class ProxyMarks final : public DriverMarks {
  public:
    // <registers>: NEAREST_DEPTH_BIT_EMU, SCREEN_BOX_BIT_EMU; others are ignored.
    ProxyMarks(GLbitfield registers, occlusion_unit::FarEnd far_end);

    // True where a draw of points, lines or polygons with the program's present state can be marked exactly:
    // made beforehand with writes to colour, depth and stencil switched off, or, where it writes nothing, as
    // it is. Not for pixel rectangles and bitmaps.
    static bool serves(Context& ctx, GLbitfield registers, occlusion_unit::FarEnd far_end,
                       const FragmentTests& tests);
    // True where a draw changes neither colour nor depth nor stencil.
    static bool writes_nothing(Context& ctx, const FragmentTests& tests);

    // Before begin_draw, while nothing is counted for this draw: takes memory for marks of the draw
    // framebuffer.
    void aim(Context& ctx);
    // That it has a depth buffer.
    bool has_depth() const { return sheets_.back().precision.bits != 0; }
    // Around one call of the driver's that draws and writes nothing, not between Begin and End; only where
    // serves. Binds the stage and the marks, and undoes it.
    void begin_draw(Context& ctx);
    void end_draw(Context& ctx);

    bool is_ready(Context& ctx) override;
    occlusion_unit::Record drain(Context& ctx) override;
    void drop(Context& ctx) override;

  private:
    // Marks in one buffer of the driver's: a key of the depth, then a word for each column and each row of
    // pixels.
    struct Sheet {
        ResultBuffers::Buffer buffer;
        GLint size = 0;  // columns, and rows: of the larger
        DepthPrecision precision;
    };

    occlusion_unit::Record read(Context& ctx, const Sheet& sheet) const;

    GLbitfield registers_;
    occlusion_unit::FarEnd far_end_;
    std::vector<Sheet> sheets_;  // a further one where the framebuffer has grown, or has another format
    ResultBinding binding_;
    GLsync fence_ = nullptr;
};

}  // namespace glext_emu
