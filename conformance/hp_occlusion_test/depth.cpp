// SPDX-License-Identifier: MIT
// Depth comparisons and everything that shifts a fragment's depth, and shaders that discard (HP-52 to HP-55).
#include <functional>

#include "harness/objects.h"
#include "hp_occlusion_test/hp_test.h"

namespace conformance {
namespace {

class Depth : public HpTest {
  protected:
    // Over a fresh occluder at kMiddle; the drawing does not write depth.
    static void expect_visible(bool visible, const std::function<void()>& draw) {
        glClear(GL_COLOR_BUFFER_BIT);
        EXPECT_EQ(result_of(draw), visible);
        EXPECT_EQ(drawn_pixels(), visible ? kWhole.area() : 0);
    }
};

// HP-53. NV 4.1.6A counts what passes "the depth test": the comparison of DepthFunc with the stored value.
TEST_F(Depth, every_depth_function_decides_as_it_compares) {
    struct Row {
        GLenum function;
        bool near_passes, equal_passes, far_passes;
    };
    const Row rows[] = {{GL_NEVER, false, false, false},  {GL_LESS, true, false, false},
                        {GL_EQUAL, false, true, false},   {GL_LEQUAL, true, true, false},
                        {GL_GREATER, false, false, true}, {GL_NOTEQUAL, true, false, true},
                        {GL_GEQUAL, false, true, true},   {GL_ALWAYS, true, true, true}};
    draw_occluder();
    glDepthMask(GL_FALSE);
    for (const Row& row : rows) {
        SCOPED_TRACE(row.function);
        glDepthFunc(row.function);
        expect_visible(row.near_passes, [] { draw_rect(kWhole, kNear); });
        expect_visible(row.equal_passes, [] { draw_rect(kWhole, kMiddle); });
        expect_visible(row.far_passes, [] { draw_rect(kWhole, kFar); });
    }
}

// HP-54. NV, issues: an implementation's rendering is invariant under an active test, or boxes could not be
// trusted.
TEST_F(Depth, the_same_geometry_again_is_equal_to_itself) {
    clear();
    glEnable(GL_DEPTH_TEST);
    const auto draw = [] {
        glBegin(GL_TRIANGLES);
        glVertex3f(3.2f, 1.7f, 0.1f);
        glVertex3f(60.9f, 9.1f, 0.9f);
        glVertex3f(22.4f, 62.3f, 0.6f);
        glEnd();
    };
    draw();
    const int pixels = drawn_pixels();
    ASSERT_GT(pixels, 0);
    for (const GLenum function : {GL_EQUAL, GL_LEQUAL}) {
        glDepthFunc(function);
        glClear(GL_COLOR_BUFFER_BIT);
        EXPECT_TRUE(result_of(draw));
        EXPECT_EQ(drawn_pixels(), pixels);
    }
    for (const GLenum function : {GL_LESS, GL_NOTEQUAL}) {
        glDepthFunc(function);
        EXPECT_FALSE(result_of(draw));
    }
}

// HP-55. The offset is added before the depth test.
TEST_F(Depth, polygon_offset_takes_part) {
    draw_occluder();
    glDepthMask(GL_FALSE);
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(0.0f, -4.0f);  // a flat polygon: only the units count
    expect_visible(true, [] { draw_rect(kWhole, kMiddle); });
    glPolygonOffset(0.0f, 4.0f);
    expect_visible(false, [] { draw_rect(kWhole, kMiddle); });
}

// HP-55. DepthRange maps the depth before the test.
TEST_F(Depth, the_depth_range_takes_part) {
    draw_occluder();
    glDepthMask(GL_FALSE);
    glDepthRange(0.0, 0.25);
    expect_visible(true, [] { draw_rect(kWhole, kFar); });
    glDepthRange(0.75, 1.0);
    expect_visible(false, [] { draw_rect(kWhole, kNear); });
    glDepthRange(1.0, 0.0);
    expect_visible(false, [] { draw_rect(kWhole, kNear); });
    expect_visible(true, [] { draw_rect(kWhole, kFar); });
}

// HP-55. With DEPTH_CLAMP the near and far planes clip nothing and the depth is clamped.
TEST_F(Depth, depth_clamp_takes_part) {
    if (const auto why = lacks(32, "GL_ARB_depth_clamp")) GTEST_SKIP() << *why;
    draw_occluder();
    glDepthMask(GL_FALSE);
    expect_visible(false, [] { draw_rect(kWhole, -0.5f); });
    glEnable(GL_DEPTH_CLAMP);
    expect_visible(true, [] { draw_rect(kWhole, -0.5f); });
    expect_visible(false, [] { draw_rect(kWhole, 1.5f); });
}

// HP-55. The depth that a fragment shader writes is the one tested.
TEST_F(Depth, the_shaders_depth_takes_part) {
    if (const auto why = lacks(20)) GTEST_SKIP() << *why;
    draw_occluder();
    glDepthMask(GL_FALSE);
    const Program program({.vertex = kFixedVertexSource,
                           .fragment = "#version 120\n"
                                       "uniform float depth;\n"
                                       "void main() { gl_FragColor = vec4(1.0); gl_FragDepth = depth; }\n"});
    const GLint depth = glGetUniformLocation(program.name(), "depth");
    glUniform1f(depth, kNear);
    expect_visible(true, [] { draw_rect(kWhole, kFar); });
    glUniform1f(depth, kFar);
    expect_visible(false, [] { draw_rect(kWhole, kNear); });
}

// HP-52. A discarded fragment does not reach the depth test.
TEST_F(Depth, a_discarded_fragment_does_not_count) {
    if (const auto why = lacks(20)) GTEST_SKIP() << *why;
    const Program program(
        {.vertex = kFixedVertexSource,
         .fragment = "#version 120\n"
                     "uniform float limit;\n"
                     "void main() { if (gl_FragCoord.x > limit) discard; gl_FragColor = vec4(1.0); }\n"});
    const GLint limit = glGetUniformLocation(program.name(), "limit");
    glUniform1f(limit, 0.0f);
    expect_visible(false, [] { draw_rect(kWhole, kMiddle); });
    glUniform1f(limit, kSurfaceSize);
    expect_visible(true, [] { draw_rect(kWhole, kMiddle); });
    glUniform1f(limit, 1.0f);  // one column
    EXPECT_TRUE(result_of([] { draw_rect(kWhole, kMiddle); }));
}

// HP-52. GL 4.5, 14.9.4: with early_fragment_tests the samples are counted before the shader runs, so a
// discard comes too late. The test of an emulated HP on a driver that counts late inherits the driver's
// departure.
TEST_F(Depth, with_early_fragment_tests_a_discarded_fragment_counts) {
    if (const auto why = lacks(42)) GTEST_SKIP() << *why;
    const Program program(
        {.vertex = "#version 420 compatibility\nvoid main() { gl_Position = ftransform(); }\n",
         .fragment = "#version 420 compatibility\n"
                     "layout(early_fragment_tests) in;\n"
                     "void main() { discard; }\n"});
    EXPECT_TRUE(result_of([] { draw_rect(kWhole, kMiddle); }));
    EXPECT_EQ(drawn_pixels(), 0);
}

}  // namespace
}  // namespace conformance
