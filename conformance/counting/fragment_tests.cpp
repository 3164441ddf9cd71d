// SPDX-License-Identifier: MIT
// Stencil, alpha and scissor tests each take their share (CNT-08 to CNT-11), and so do those of extensions
// (CNT-51 to CNT-53).
#include <array>

#include "counting/counters.h"

namespace conformance {
namespace {

class StencilCounts : public CountingTest {};
class TestsCount : public CountingTest {};

COUNT_WITH_EACH(StencilCounts);
COUNT_WITH_EACH(TestsCount);

// Stencil 1 on the left half, 0 on the right.
void draw_left_stencil() {
    glEnable(GL_STENCIL_TEST);
    glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
    glStencilFunc(GL_ALWAYS, 1, 0xFF);
    draw_rect(kLeft, kNear);
    glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
    glStencilFunc(GL_EQUAL, 1, 0xFF);
}

// CNT-08. ARB, issues: "We are counting immediately after _both_ the depth and stencil tests, i.e., samples
// that pass both."
TEST_P(StencilCounts, what_fails_the_stencil_or_the_depth_test_does_not_count) {
    draw_left_stencil();
    expect_count(kAll / 2, draw_whole);
    expect_count(kAll / 2, [] { draw_rect(kLeft, kMiddle); });
    expect_count(0, [] { draw_rect(kRight, kMiddle); });
    glDisable(GL_STENCIL_TEST);
    draw_occluder();
    glEnable(GL_STENCIL_TEST);
    glStencilFunc(GL_EQUAL, 0, 0xFF);
    expect_count(0, [] { draw_rect(kWhole, kFar); });
    expect_count(kAll, [] { draw_rect(kWhole, kNear); });
}

// CNT-09. A query watches the tests and is no part of them.
TEST_P(StencilCounts, stencil_operations_are_the_same_inside_a_query) {
    const auto draw = [] {
        draw_rect({0, 0, kSize, 16}, kNear);  // passes: incremented
        draw_rect({0, 8, kSize, 16}, kFar);   // fails in depth: inverted
        glStencilFunc(GL_NEVER, 5, 0xFF);
        draw_rect({0, 40, kSize, 8}, kNear);  // fails: replaced by 5
    };
    const auto stencil_after = [&](bool inside) {
        draw_occluder();
        glEnable(GL_STENCIL_TEST);
        glStencilFunc(GL_ALWAYS, 5, 0xFF);
        glStencilOp(GL_REPLACE, GL_INVERT, GL_INCR);
        if (inside) {
            expect_count(16 * kSize, draw);
        } else {
            draw();
        }
        glDisable(GL_STENCIL_TEST);
        std::vector<GLubyte> stencil(kAll);
        glReadPixels(0, 0, kSize, kSize, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, stencil.data());
        return stencil;
    };
    const auto inside = stencil_after(true);
    EXPECT_EQ(inside, stencil_after(false));
    const auto row = [&](int y) { return int{inside[static_cast<std::size_t>(y * kSize)]}; };
    EXPECT_EQ(row(0), 1);
    EXPECT_EQ(row(8), 0xFE);
    EXPECT_EQ(row(16), 0xFF);
    EXPECT_EQ(row(40), 5);
    EXPECT_EQ(row(63), 0);
}

// CNT-10. GL 4.5 compatibility, 17.3.4: the alpha test discards; it comes before the stencil and depth tests.
TEST_P(TestsCount, what_fails_the_alpha_test_does_not_count) {
    const auto opaque_left = [] {
        draw_rect(kLeft, kMiddle);
        glColor4f(1.0f, 1.0f, 1.0f, 0.25f);
        draw_rect(kRight, kMiddle);
        glColor4f(1.0f, 1.0f, 1.0f, 1.0f);
    };
    glEnable(GL_ALPHA_TEST);
    glAlphaFunc(GL_GREATER, 0.5f);
    expect_count(kAll / 2, opaque_left);
    glAlphaFunc(GL_ALWAYS, 0.5f);
    expect_count(kAll, opaque_left);
    glAlphaFunc(GL_NEVER, 0.5f);
    expect_count(0, opaque_left);
}

// CNT-11. GL 4.5, 17.3.2: fragments outside the scissor rectangle are discarded.
TEST_P(TestsCount, what_is_outside_the_scissor_rectangle_does_not_count) {
    glEnable(GL_SCISSOR_TEST);
    glScissor(16, 16, kHalf, kHalf);
    expect_count(kAll / 4, draw_whole);
    expect_count(0, [] { draw_rect({0, 0, 16, kSize}, kMiddle); });
    glScissor(16, 16, 0, 0);
    expect_count(0, draw_whole);
    glDisable(GL_SCISSOR_TEST);
    expect_count(kAll, draw_whole);
}

// CNT-11. ARB_viewport_array: a rectangle and an enable for each viewport; fixed function draws to viewport
// 0.
TEST_P(TestsCount, of_the_scissor_rectangles_the_first_one_holds) {
    if (const auto why = lacks(41, "GL_ARB_viewport_array")) GTEST_SKIP() << *why;
    const std::array<GLint, 8> rectangles = {0, 0, 10, 20, 0, 0, 0, 0};
    glScissorArrayv(0, 2, rectangles.data());
    glEnablei(GL_SCISSOR_TEST, 1);
    expect_count(kAll, draw_whole);
    glEnablei(GL_SCISSOR_TEST, 0);
    expect_count(10 * 20, draw_whole);
}

// CNT-51. EXT_depth_bounds_test: tests the stored depth, before the stencil test.
TEST_P(TestsCount, what_fails_the_depth_bounds_test_does_not_count) {
    if (const auto why = lacks("GL_EXT_depth_bounds_test")) GTEST_SKIP() << *why;
    const auto bounds = function<PFNGLDEPTHBOUNDSEXTPROC>("glDepthBoundsEXT");
    draw_occluder();  // stored: kMiddle
    glEnable(GL_DEPTH_BOUNDS_TEST_EXT);
    bounds(kFar, 1.0);
    expect_count(0, [] { draw_rect(kWhole, kNear); });
    bounds(kNear, kFar);
    expect_count(kAll, [] { draw_rect(kWhole, kNear); });
    glDisable(GL_DEPTH_BOUNDS_TEST_EXT);
}

// CNT-52. EXT_window_rectangles, 17.3.2A: before the stencil and depth tests; only framebuffer objects have
// it.
TEST_P(TestsCount, what_window_rectangles_exclude_does_not_count) {
    if (const auto why = lacks("GL_EXT_window_rectangles")) GTEST_SKIP() << *why;
    const auto rectangles = function<PFNGLWINDOWRECTANGLESEXTPROC>("glWindowRectanglesEXT");
    const Framebuffer framebuffer({});
    const std::array<GLint, 4> quarter = {0, 0, kHalf, kHalf};
    rectangles(GL_EXCLUSIVE_EXT, 1, quarter.data());
    expect_count(kAll * 3 / 4, draw_whole);
    expect_count(0, [] { draw_rect(kQuarter, kMiddle); });
    rectangles(GL_INCLUSIVE_EXT, 1, quarter.data());
    expect_count(kAll / 4, draw_whole);
}

// CNT-53. NV_representative_fragment_test lets one fragment stand for a whole primitive: then a count is
// none.
TEST_P(TestsCount, no_representative_fragment_stands_for_others) {
    if (!has_extension("GL_NV_representative_fragment_test")) return expect_count(kAll, draw_whole);
    EXPECT_FALSE(glIsEnabled(GL_REPRESENTATIVE_FRAGMENT_TEST_NV));
    expect_count(kAll, draw_whole);
}

}  // namespace
}  // namespace conformance
