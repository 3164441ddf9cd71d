// SPDX-License-Identifier: MIT
// The Occlusion Unit's parallel form over a driver: all shapes in one draw, by a program of the layer's own
// whose fragment stage runs after the early depth test and notes for each shape what it sees; a second draw
// counts what the depth test hides.
#pragma once

#include <GL/gl.h>
#include <GL/glext.h>

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "context/fragment_tests.h"
#include "context/framebuffer_info.h"
#include "context/shape_geometry.h"
#include "context/unit_run.h"
#include "context/unit_stages.h"

namespace glext_emu {

// What is asked about, in the program's form.
struct Shapes {
    GLbitfield registers = 0;
    GLenum kind = 0;  // BOX_EMU, HEXAHEDRON_EMU or QUAD_EMU
    GLsizei count = 0;
    const GLfloat* vertices = nullptr;
    const GLfloat* matrix = nullptr;  // 16, column-major, to clip coordinates
    occlusion_unit::FarEnd far_end = occlusion_unit::FarEnd::kOne;
};

// The layer's own vertex array object, with <vertices> of shapes of <kind> and the indices of as many as a
// draw may have.
GLuint shape_arrays(Context& ctx, GLenum kind, const std::vector<ShapeVertex>& vertices);
// Draws shapes and notes nothing: for a driver that cannot do better than to draw one after the other.
GLuint plain_shape_program(Context& ctx);

class ShapeRun final : public PendingRecords {
  public:
    // True where this driver can tell <registers> in the present draw framebuffer. Not the depth of samples:
    // one that a fragment stage sees is not to the last bit the one that is tested.
    static bool serves(Context& ctx, GLbitfield registers, const FramebufferInfo& framebuffer);

    explicit ShapeRun(const Shapes& shapes);
    // Draws; the records are there later.
    void draw(Context& ctx, const Shapes& shapes, const FramebufferInfo& framebuffer);

    bool is_ready(Context& ctx) override;
    void drain(Context& ctx, std::vector<occlusion_unit::Record>& records) override;
    void drop(Context& ctx) override;

  private:
    // What one draw noted: of each shape a header, and a word for each column and row of pixels that it may
    // touch.
    struct Sheet {
        ResultBuffers::Buffer buffer;
        GLsizei first = 0;  // shape
        GLsizei count = 0;
        std::vector<GLint> places;  // of the shapes' columns
        std::vector<PixelBounds> bounds;
        GLint words = 0;
        bool is_whole = true;     // nothing of any shape is clipped
        bool counts_all = false;  // the second count is of visible hits too
        bool has_halves = false;  // and of one side of the faces
    };

    GLsizei lay_out(Context& ctx, const Shapes& shapes, GLsizei first, const WindowMap& window,
                    std::vector<ShapeVertex>& vertices);
    void draw_sheet(Context& ctx, const Shapes& shapes, const std::vector<ShapeVertex>& vertices,
                    const FragmentTests& tests);
    void read(Context& ctx, Sheet& sheet);

    GLbitfield registers_;
    occlusion_unit::FarEnd far_end_;
    std::vector<occlusion_unit::Record> records_;
    std::vector<Sheet> sheets_;  // not read yet
    DepthPrecision precision_;
    // Where depths are clamped, which is after the fragment stage has looked at them.
    std::array<float, 2> depth_range_ = {0, 1};
    bool is_per_sample_ = false;
    bool sides_are_alike_ = false;  // a closed shape's front and back faces have as many hits
    // False where no fragment passes: softpipe runs the fragment stage for such ones all the same.
    bool has_visible_ = true;
    bool hits_tell_projected_ = false;  // every fragment passes the depth test
    GLuint samples_per_fragment_ = 1;
    GLsync fence_ = nullptr;
};

}  // namespace glext_emu
