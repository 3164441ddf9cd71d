// SPDX-License-Identifier: MIT
// Which of the per-fragment tests a counted fragment has to pass: all up to and with the depth test (HP-42 to
// HP-51).
//
// Every result stands beside the colour buffer: what counted was also drawn.
#include <functional>

#include "hp_occlusion_test/hp_test.h"

namespace conformance {
namespace {

class FragmentTests : public HpTest {
  protected:
    // Draws with the test enabled into a cleared colour buffer, and expects so many pixels and the matching
    // result.
    static void expect_pixels(int pixels, const std::function<void()>& draw) {
        glClear(GL_COLOR_BUFFER_BIT);
        EXPECT_EQ(result_of(draw), pixels > 0);
        EXPECT_EQ(drawn_pixels(), pixels);
    }
};

// HP-42. HP, Overview: the test "is accurate with regard to non-visibility": no single fragment may be
// overlooked.
TEST_F(FragmentTests, a_single_fragment_anywhere_is_seen) {
    for (const int x : {0, kSurfaceSize / 2, kSurfaceSize - 1}) {
        for (const int y : {0, kSurfaceSize / 2, kSurfaceSize - 1}) {
            expect_pixels(1, [&] { draw_point(x, y, kMiddle); });
            expect_pixels(1, [&] { draw_rect({x, y, 1, 1}, kMiddle); });
        }
    }
    expect_pixels(kSurfaceSize, [] { draw_rect({0, 17, kSurfaceSize, 1}, kMiddle); });
}

// HP-43. NV 4.1.6A: "Whenever a fragment reaches this stage ... the occlusion test result is set to TRUE",
// and not else.
TEST_F(FragmentTests, nothing_visible_is_never_taken_for_visible) {
    draw_occluder();
    for (int size = 1; size <= kSurfaceSize; size *= 2) {
        expect_pixels(0, [&] { draw_rect({0, 0, size, size}, kFar); });
        expect_pixels(0, [&] {
            draw_rect({kSurfaceSize - size, 0, size, size}, kMiddle);
        });  // LESS: equal fails
    }
}

// HP-43. One hole of one pixel decides.
TEST_F(FragmentTests, a_hole_of_one_pixel_in_the_occluder_decides) {
    const Rect hole = {37, 21, 1, 1};
    draw_occluder();
    glEnable(GL_SCISSOR_TEST);
    glScissor(hole.x, hole.y, hole.width, hole.height);
    glClear(GL_DEPTH_BUFFER_BIT);
    glDisable(GL_SCISSOR_TEST);
    glDepthMask(GL_FALSE);
    expect_pixels(1, [] { draw_rect(kWhole, kFar); });
    expect_pixels(0, [&] { draw_rect({0, 0, hole.x, kSurfaceSize}, kFar); });
    expect_pixels(0, [&] { draw_rect({hole.x + 1, 0, kSurfaceSize - hole.x - 1, kSurfaceSize}, kFar); });
}

// HP-44. HP, Overview: "To prevent updating the depth/color buffers the application must disable updates to
// these buffers": the result does not depend on it.
TEST_F(FragmentTests, write_masks_do_not_change_the_result) {
    for (const bool visible : {true, false}) {
        draw_occluder();
        const auto depths = read_depths();
        glDepthMask(GL_FALSE);
        glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
        EXPECT_EQ(result_of([&] { draw_rect(kWhole, visible ? kNear : kFar); }), visible);
        glDepthMask(GL_TRUE);
        glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
        EXPECT_EQ(drawn_pixels(), 0);
        EXPECT_EQ(read_depths(), depths);
    }
}

// HP-45. HP, Overview: "Occlusion culling operates independently of the current rendering state (ie. when
// occlusion culling is enabled fragments are generated and the depth and/or color buffer may be updated)."
TEST_F(FragmentTests, the_image_is_the_one_without_the_test) {
    const auto draw = [] {
        draw_occluder();
        glBegin(GL_TRIANGLES);  // slanted, so that no two pixels have the same depth
        for (const auto& [x, y, z] :
             {std::array{3.2f, 1.7f, 0.1f}, {60.9f, 9.1f, 0.9f}, {22.4f, 62.3f, 0.6f}}) {
            glColor3f(x / 64.0f, y / 64.0f, z);
            glVertex3f(x, y, z);
        }
        glEnd();
    };
    draw();
    const auto colours = read_colours();
    const auto depths = read_depths();
    EXPECT_TRUE(result_of(draw));
    EXPECT_EQ(read_colours(), colours);
    EXPECT_EQ(read_depths(), depths);
}

// HP-46. GL 4.5, 17.3.4: with DEPTH_TEST disabled the depth comparison is bypassed and the fragment goes on.
TEST_F(FragmentTests, without_depth_test_a_fragment_passes) {
    draw_occluder();
    glDisable(GL_DEPTH_TEST);
    expect_pixels(kWhole.area(), [] { draw_rect(kWhole, kFar); });
}

// HP-47. GL 4.5, 17.3.4: "If there is no depth buffer, it is as if the depth buffer test always passes."
TEST_F(FragmentTests, without_depth_buffer_a_fragment_passes) {
    const Surface flat({.depth_bits = 0, .stencil_bits = 0});
    if (!flat) GTEST_SKIP() << "no surface without a depth buffer";
    come_back(flat);
    ASSERT_EQ(get_integer(GL_DEPTH_BITS), 0);
    clear();
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_NEVER);
    expect_pixels(kWhole.area(), [] { draw_rect(kWhole, kFar); });
    come_back();
}

// HP-48, HP-49. NV, issues: "We are counting immediately after _both_ the depth and stencil tests, i.e.,
// pixels that pass both."
TEST_F(FragmentTests, a_fragment_has_to_pass_stencil_and_depth_test) {
    draw_occluder();
    glDepthMask(GL_FALSE);
    glEnable(GL_STENCIL_TEST);
    glStencilFunc(GL_EQUAL, 1, 0xFF);  // the buffer holds 0
    expect_pixels(0, [] { draw_rect(kWhole, kNear); });
    glStencilFunc(GL_EQUAL, 0, 0xFF);
    expect_pixels(kWhole.area(), [] { draw_rect(kWhole, kNear); });
    expect_pixels(0, [] { draw_rect(kWhole, kFar); });
}

// HP-50. GL compatibility, per-fragment operations: the alpha test stands before stencil and depth test.
TEST_F(FragmentTests, a_fragment_has_to_pass_the_alpha_test) {
    glEnable(GL_ALPHA_TEST);
    glAlphaFunc(GL_NEVER, 0.0f);
    expect_pixels(0, [] { draw_rect(kWhole, kMiddle); });
    glAlphaFunc(GL_GREATER, 0.5f);
    expect_pixels(kWhole.area(), [] { draw_rect(kWhole, kMiddle); });
    glColor4f(1.0f, 1.0f, 1.0f, 0.25f);
    expect_pixels(0, [] { draw_rect(kWhole, kMiddle); });
}

// HP-51. The scissor test stands before the depth test.
TEST_F(FragmentTests, a_fragment_has_to_lie_in_the_scissor_box) {
    glEnable(GL_SCISSOR_TEST);
    glScissor(8, 8, 16, 16);
    const auto count_whole = [](int pixels, const Rect& rect) {
        glDisable(GL_SCISSOR_TEST);
        glClear(GL_COLOR_BUFFER_BIT);
        glEnable(GL_SCISSOR_TEST);
        EXPECT_EQ(result_of([&] { draw_rect(rect, kMiddle); }), pixels > 0);
        EXPECT_EQ(drawn_pixels(), pixels);
    };
    count_whole(16 * 16, kWhole);
    count_whole(0, {24, 8, 16, 16});
    count_whole(1, {23, 23, 4, 4});
    glScissor(8, 8, 0, 16);
    count_whole(0, kWhole);
}

// HP-51. What is clipped, culled or has no area makes no fragment.
TEST_F(FragmentTests, what_makes_no_fragment_does_not_count) {
    expect_pixels(0, [] { draw_rect({kSurfaceSize, 0, 8, 8}, kMiddle); });  // beside the view volume
    expect_pixels(0, [] { draw_rect(kWhole, 1.5f); });                      // behind it
    expect_pixels(0, [] { draw_rect(kWhole, -0.5f); });                     // before it
    expect_pixels(0, [] { draw_rect({8, 8, 0, 16}, kMiddle); });            // no area
    expect_pixels(8 * 8, [] { draw_rect({-8, -8, 16, 16}, kMiddle); });     // a quarter inside

    const GLdouble right_half[] = {1.0, 0.0, 0.0, -kSurfaceSize / 2.0};
    glClipPlane(GL_CLIP_PLANE0, right_half);
    glEnable(GL_CLIP_PLANE0);
    expect_pixels(0, [] { draw_rect({0, 0, kSurfaceSize / 2, kSurfaceSize}, kMiddle); });
    expect_pixels(kWhole.area() / 2, [] { draw_rect(kWhole, kMiddle); });
    glDisable(GL_CLIP_PLANE0);

    glEnable(GL_CULL_FACE);  // rectangles are drawn counter-clockwise
    glCullFace(GL_FRONT);
    expect_pixels(0, [] { draw_rect(kWhole, kMiddle); });
    glCullFace(GL_BACK);
    expect_pixels(kWhole.area(), [] { draw_rect(kWhole, kMiddle); });
    glCullFace(GL_FRONT_AND_BACK);
    expect_pixels(0, [] { draw_rect(kWhole, kMiddle); });
}

// HP-51, of the viewport: it moves and scales, and what falls beside it is clipped.
TEST_F(FragmentTests, the_viewport_bounds_what_counts) {
    glViewport(0, 0, kSurfaceSize / 2, kSurfaceSize / 2);
    expect_pixels(kWhole.area() / 4, [] { draw_rect(kWhole, kMiddle); });
    glViewport(kSurfaceSize, 0, kSurfaceSize, kSurfaceSize);  // beside the window
    expect_pixels(0, [] { draw_rect(kWhole, kMiddle); });
}

}  // namespace
}  // namespace conformance
