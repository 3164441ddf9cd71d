// SPDX-License-Identifier: MIT
// What the viewport, clipping and culling leave of a primitive (CNT-12 to CNT-15).
#include <array>

#include "counting/counters.h"

namespace conformance {
namespace {

class ClippingCounts : public CountingTest {};

COUNT_WITH_EACH(ClippingCounts);

// CNT-12. GL 4.5, 13.6.1: the viewport says where normalised device coordinates come to lie.
TEST_P(ClippingCounts, the_viewport_bounds_what_counts) {
    glViewport(0, 0, kHalf, kHalf);
    expect_count(kAll / 4, draw_whole);
    glViewport(kSize, 0, kSize, kSize);
    expect_count(0, draw_whole);
}

// CNT-13. GL 4.5, 13.5: "Primitives are clipped to the clip volume"; with DEPTH_CLAMP the near and far planes
// are none of it, and depths are clamped.
TEST_P(ClippingCounts, what_is_outside_the_view_volume_does_not_count) {
    constexpr float kBeyond = 1.5f;
    const auto beyond_the_far_plane = [] { draw_rect(kWhole, kBeyond); };
    const auto beside = [] { draw_rect({-kSize, 0, kSize, kSize}, kMiddle); };
    expect_count(0, beyond_the_far_plane);
    expect_count(0, beside);
    expect_count(kAll, [] { draw_rect({-kSize, 0, 3 * kSize, kSize}, kMiddle); });
    if (const auto why = lacks(32, "GL_ARB_depth_clamp")) return;
    glEnable(GL_DEPTH_CLAMP);
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_FALSE);
    expect_count(0, beyond_the_far_plane);
    glDepthFunc(GL_LEQUAL);
    expect_count(kAll, beyond_the_far_plane);
    expect_count(0, beside);
}

// CNT-14. GL 4.5 compatibility, 13.5: the user's half spaces are part of the clip volume.
TEST_P(ClippingCounts, what_a_clip_plane_cuts_off_does_not_count) {
    const std::array<GLdouble, 4> right_half = {1.0, 0.0, 0.0, -kHalf};
    glClipPlane(GL_CLIP_PLANE0, right_half.data());
    glEnable(GL_CLIP_PLANE0);
    expect_count(kAll / 2, draw_whole);
    expect_count(0, [] { draw_rect(kLeft, kMiddle); });
}

// CNT-14. GLSL 1.30, 7.1: gl_ClipDistance.
TEST_P(ClippingCounts, what_a_clip_distance_cuts_off_does_not_count) {
    if (const auto why = lacks(30)) GTEST_SKIP() << *why;
    const Program program({.vertex = "#version 130\n"
                                     "out float gl_ClipDistance[1];\n"
                                     "void main() {\n"
                                     "    gl_Position = ftransform();\n"
                                     "    gl_FrontColor = gl_Color;\n"
                                     "    gl_ClipDistance[0] = gl_Vertex.x - 32.0;\n"
                                     "}\n"});
    glEnable(GL_CLIP_DISTANCE0);
    expect_count(kAll / 2, draw_whole);
    expect_count(0, [] { draw_rect(kLeft, kMiddle); });
}

// CNT-15. GL 4.5, 14.6.1: culled polygons are not rasterized; points are no polygons.
TEST_P(ClippingCounts, what_is_culled_does_not_count) {
    glEnable(GL_CULL_FACE);
    for (const bool front : {true, false}) {
        glFrontFace(front ? GL_CCW : GL_CW);
        glCullFace(GL_FRONT);
        expect_count(front ? 0 : kAll, draw_whole);
        glCullFace(GL_BACK);
        expect_count(front ? kAll : 0, draw_whole);
        glCullFace(GL_FRONT_AND_BACK);
        expect_count(0, draw_whole);
        expect_count(1, [] { draw_point(5, 5, kMiddle); });
    }
}

}  // namespace
}  // namespace conformance
