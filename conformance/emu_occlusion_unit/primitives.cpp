// SPDX-License-Identifier: MIT
// 17.3.5.1: "Primitives, pixel rectangles and bitmaps step the unit alike. Clears and blits do not, nor does
// the drawing of stencil indices, nor feedback and selection."
#include "emu_occlusion_unit/unit_test.h"

namespace conformance {
namespace {

class UnitPrimitives : public UnitTest {
  protected:
    void SetUp() override {
        ASSERT_NO_FATAL_FAILURE(UnitTest::SetUp());
        if (!IsSkipped()) draw_left_occluder();
    }
};

using Corners = std::vector<std::array<GLfloat, 2>>;

void draw_corners(GLenum mode, const Corners& corners) {
    glBegin(mode);
    for (const auto& [x, y] : corners) glVertex3f(x, y, kFar);
    glEnd();
}

// The rectangle of draw_half_hidden, in the order of each kind of primitive.
TEST_F(UnitPrimitives, each_kind_of_polygon_is_seen) {
    const std::array<std::pair<GLenum, Corners>, 6> kinds = {{
        {GL_TRIANGLES, {{8, 8}, {56, 8}, {56, 24}, {8, 8}, {56, 24}, {8, 24}}},
        {GL_TRIANGLE_STRIP, {{8, 8}, {56, 8}, {8, 24}, {56, 24}}},
        {GL_TRIANGLE_FAN, {{8, 8}, {56, 8}, {56, 24}, {8, 24}}},
        {GL_QUADS, {{8, 8}, {56, 8}, {56, 24}, {8, 24}}},
        {GL_QUAD_STRIP, {{8, 8}, {8, 24}, {56, 8}, {56, 24}}},
        {GL_POLYGON, {{8, 8}, {56, 8}, {56, 24}, {8, 24}}},
    }};
    glDepthMask(GL_FALSE);
    for (const auto& [mode, corners] : kinds) {
        SCOPED_TRACE(mode);
        expect_seen(kHalfHidden, [&] { draw_corners(mode, corners); });
    }
    if (!lacks(32)) {
        SCOPED_TRACE("adjacency");
        expect_seen(kHalfHidden, [] {
            draw_corners(GL_TRIANGLES_ADJACENCY, {{8, 8},
                                                  {0, 0},
                                                  {56, 8},
                                                  {0, 0},
                                                  {56, 24},
                                                  {0, 0},
                                                  {8, 8},
                                                  {0, 0},
                                                  {56, 24},
                                                  {0, 0},
                                                  {8, 24},
                                                  {0, 0}});
        });
    }
    glDepthMask(GL_TRUE);
}

// 16 pixels along row 10, the last eight before the occluder.
TEST_F(UnitPrimitives, lines_and_points_are_seen) {
    glDepthMask(GL_FALSE);
    const Seen row = seen(16, {kHalf, 10, 8, 1}, kFar);
    expect_seen(row, [] { draw_corners(GL_LINES, {{24.5f, 10.5f}, {40.5f, 10.5f}}); });
    expect_seen(row, [] { draw_corners(GL_LINE_STRIP, {{24.5f, 10.5f}, {30.5f, 10.5f}, {40.5f, 10.5f}}); });
    // There and back again, each edge without its last pixel.
    expect_seen({.projected = 32, .visible = 17, .nearest = kFar, .box = {kHalf, 10, 40, 10}}, [] {
        draw_corners(GL_LINE_LOOP, {{24.5f, 10.5f}, {40.5f, 10.5f}});
    });
    expect_seen({.projected = 3, .visible = 2, .nearest = kFar, .box = {kHalf, 10, 50, 20}}, [] {
        draw_corners(GL_POINTS, {{4.5f, 4.5f}, {32.5f, 10.5f}, {50.5f, 20.5f}});
    });
    glPointSize(4.0f);
    expect_seen(seen(16, {kHalf, 8, 2, 4}, kFar), [] { draw_corners(GL_POINTS, {{32.0f, 10.0f}}); });
    glPointSize(1.0f);
    glLineWidth(3.0f);
    expect_seen(seen(48, {kHalf, 9, 8, 3}, kFar), [] {
        draw_corners(GL_LINES, {{24.5f, 10.5f}, {40.5f, 10.5f}});
    });
    glLineWidth(1.0f);
    glDepthMask(GL_TRUE);
}

TEST_F(UnitPrimitives, an_outlined_polygon_shows_its_outline) {
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    const Corners square = {{40.5f, 8.5f}, {56.5f, 8.5f}, {56.5f, 24.5f}, {40.5f, 24.5f}};
    expect_seen({.projected = 64, .visible = 64, .nearest = kFar, .box = {40, 8, 56, 24}},
                [&] { draw_corners(GL_QUADS, square); });
    draw_left_occluder();
    glPolygonMode(GL_FRONT_AND_BACK, GL_POINT);
    expect_seen({.projected = 4, .visible = 4, .nearest = kFar, .box = {40, 8, 56, 24}},
                [&] { draw_corners(GL_QUADS, square); });
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
}

TEST_F(UnitPrimitives, rect_is_a_polygon) {
    glTranslatef(0.0f, 0.0f, kFar);
    expect_seen(kHalfHidden, [] { glRecti(8, 8, 56, 24); });
    glLoadIdentity();
    draw_left_occluder();
    glTranslatef(0.0f, 0.0f, kFar);
    expect_seen(kHalfHidden, [] {
        const std::array<GLfloat, 2> one = {56.0f, 24.0f};
        const std::array<GLfloat, 2> other = {8.0f, 8.0f};
        glRectfv(one.data(), other.data());
    });
    glLoadIdentity();
}

TEST_F(UnitPrimitives, drawn_pixels_are_seen) {
    const std::vector<GLubyte> white(4 * 24 * 8, 0xFF);
    glRasterPos3f(16.0f, 8.0f, kFar);
    glPixelZoom(2.0f, 2.0f);
    expect_seen(seen(48 * 16, {kHalf, 8, 32, 16}, kFar),
                [&] { glDrawPixels(24, 8, GL_RGBA, GL_UNSIGNED_BYTE, white.data()); });
    glPixelZoom(1.0f, 1.0f);
    draw_left_occluder();
    expect_seen(seen(24 * 8, {kHalf, 8, 8, 8}, kFar),
                [&] { glDrawPixels(24, 8, GL_RGBA, GL_UNSIGNED_BYTE, white.data()); });
}

// Depths that are drawn as pixels are depths of samples.
TEST_F(UnitPrimitives, drawn_depths_are_seen) {
    std::vector<GLfloat> depths(24 * 8, 0.875f);
    depths.back() = 0.625f;  // the upper right pixel
    glRasterPos3f(16.0f, 8.0f, kNear);
    expect_seen(seen(24 * 8, {kHalf, 8, 8, 8}, 0.625f),
                [&] { glDrawPixels(24, 8, GL_DEPTH_COMPONENT, GL_FLOAT, depths.data()); });
    EXPECT_NEAR(read_depths({39, 15, 1, 1}).front(), 0.625f, kDepthStep24);
    EXPECT_NEAR(read_depths({16, 8, 1, 1}).front(), kMiddle, kDepthStep24);
}

TEST_F(UnitPrimitives, the_bits_of_a_bitmap_are_seen) {
    const std::array<GLubyte, 4> bits = {0x80, 0x00, 0x18, 0x03};  // columns 0; none; 3, 4; 6, 7: from below
    glRasterPos3f(28.0f, 8.0f, kFar);
    GLfloat moved[4] = {};
    expect_seen({.projected = 5, .visible = 3, .nearest = kFar, .box = {kHalf, 10, 35, 11}},
                [&] { glBitmap(8, 4, 0.0f, 0.0f, 3.0f, 0.0f, bits.data()); });
    glGetFloatv(GL_CURRENT_RASTER_POSITION, moved);
    EXPECT_EQ(moved[0], 31.0f) << "moved once";
}

TEST_F(UnitPrimitives, copied_pixels_are_seen) {
    glRasterPos3f(16.0f, 8.0f, kFar);
    expect_seen(seen(24 * 8, {kHalf, 8, 8, 8}, kFar), [] { glCopyPixels(0, 40, 24, 8, GL_COLOR); });
}

TEST_F(UnitPrimitives, stencil_indices_are_not_seen) {
    glRasterPos3f(16.0f, 8.0f, kNear);
    const std::vector<GLubyte> ones(24 * 8, 1);
    expect_seen({}, [&] { glDrawPixels(24, 8, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, ones.data()); });
    GLubyte stencil = 0;
    glReadPixels(16, 8, 1, 1, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, &stencil);
    EXPECT_EQ(stencil, 1);
}

TEST_F(UnitPrimitives, clears_and_blits_are_not_seen) {
    const Framebuffer framebuffer({});
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer.name());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    expect_seen({}, [] {
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
        glBlitFramebuffer(0, 0, kSize, kSize, 0, 0, kSize, kSize, GL_COLOR_BUFFER_BIT, GL_NEAREST);
        const std::array<GLfloat, 4> black{};
        glClearBufferfv(GL_COLOR, 0, black.data());
    });
}

TEST_F(UnitPrimitives, feedback_and_selection_are_not_seen) {
    std::array<GLfloat, 64> values{};
    glFeedbackBuffer(64, GL_3D, values.data());
    const auto told = [] {
        glRenderMode(GL_FEEDBACK);
        draw_half_hidden();
        return glRenderMode(GL_RENDER);
    };
    const GLint without = told();
    EXPECT_GE(without, 2 + 4 * 3) << "a polygon of four corners, or what the driver makes of it";
    expect_seen({}, [&] { EXPECT_EQ(told(), without) << "once"; });
    std::array<GLuint, 64> hits{};
    glSelectBuffer(64, hits.data());
    expect_seen(kHalfHidden, [] {
        glRenderMode(GL_SELECT);
        glInitNames();
        glPushName(7);
        draw_half_hidden();
        EXPECT_EQ(glRenderMode(GL_RENDER), 1);
        draw_half_hidden();
    });
}

// An evaluator's mesh over the rectangle.
TEST_F(UnitPrimitives, an_evaluated_mesh_is_seen) {
    const std::array<GLfloat, 12> corners = {8, 8, kFar, 56, 8, kFar, 8, 24, kFar, 56, 24, kFar};
    glMap2f(GL_MAP2_VERTEX_3, 0.0f, 1.0f, 3, 2, 0.0f, 1.0f, 6, 2, corners.data());
    glEnable(GL_MAP2_VERTEX_3);
    glMapGrid2f(4, 0.0f, 1.0f, 2, 0.0f, 1.0f);
    expect_seen(kHalfHidden, [] { glEvalMesh2(GL_FILL, 0, 4, 0, 2); });
    const std::array<GLfloat, 6> line = {24.5f, 10.5f, kFar, 40.5f, 10.5f, kFar};
    draw_left_occluder();
    glMap1f(GL_MAP1_VERTEX_3, 0.0f, 1.0f, 3, 2, line.data());
    glEnable(GL_MAP1_VERTEX_3);
    glMapGrid1f(2, 0.0f, 1.0f);
    expect_seen(seen(16, {kHalf, 10, 8, 1}, kFar), [] { glEvalMesh1(GL_LINE, 0, 2); });
}

}  // namespace
}  // namespace conformance
