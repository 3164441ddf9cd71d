// SPDX-License-Identifier: MIT
// What a region query answers, on the default framebuffer: state, furthest, nearest; which pixels a rectangle
// holds.
#include "emu_depth_region_query/region_test.h"

namespace conformance {
namespace {

using RegionValues = RegionTest;

// "REGION_OCCLUDED_EMU: one if every depth in the region lies strictly nearer than the far value, zero
// otherwise"
TEST_F(RegionValues, a_region_is_occluded_when_every_depth_is_nearer_than_far) {
    put_depth({8, 8, 16, 16}, kThreeFifths);
    EXPECT_EQ(occluded({8, 8, 16, 16}), 1.0f);
    EXPECT_EQ(occluded({10, 11, 3, 2}), 1.0f);
}

// As above.
TEST_F(RegionValues, one_pixel_at_the_far_value_leaves_a_region_open) {
    put_depth(kWhole, kThreeFifths);
    for (const Rect& hole : {Rect{0, 0, 1, 1}, Rect{63, 63, 1, 1}, Rect{17, 40, 1, 1}}) {
        put_depth(hole, 1.0f);
        EXPECT_EQ(occluded(kWhole), 0.0f) << hole.x << ", " << hole.y;
        put_depth(hole, kFifth);
        EXPECT_EQ(occluded(kWhole), 1.0f) << hole.x << ", " << hole.y;
    }
}

// As above: the last value that a 24-bit buffer holds before the far one is nearer.
TEST_F(RegionValues, the_smallest_step_before_far_is_nearer) {
    put_depth(kWhole, 1.0f - 1.5f / 16777216.0f);
    ASSERT_LT(read_depths().front(), 1.0f);
    EXPECT_EQ(occluded(kWhole), 1.0f);
}

// "FURTHEST_DEPTH_EMU: the furthest depth in the region"; "NEAREST_DEPTH_EMU: the nearest"
TEST_F(RegionValues, furthest_and_nearest_are_those_of_the_region_alone) {
    put_depth({0, 0, 32, 64}, kTwoFifths);
    put_depth({4, 4, 1, 1}, kFifth);
    put_depth({9, 60, 1, 1}, kFourFifths);
    EXPECT_NEAR(furthest({0, 0, 32, 64}), kFourFifths, kLittle);
    EXPECT_NEAR(nearest({0, 0, 32, 64}), kFifth, kLittle);
    EXPECT_NEAR(furthest({0, 0, 32, 60}), kTwoFifths, kLittle);
    EXPECT_NEAR(nearest({0, 5, 32, 59}), kTwoFifths, kLittle);
    EXPECT_EQ(furthest(kWhole), 1.0f);
}

// "the pixels (i, j) with x <= i < x + width and y <= j < y + height"
TEST_F(RegionValues, a_rectangle_holds_its_own_pixels_and_no_others) {
    put_depth(kWhole, kTwoFifths);
    const Rect rect = {20, 24, 9, 5};
    put_depth(rect, kThreeFifths);
    EXPECT_NEAR(nearest(rect), kThreeFifths, kLittle);
    EXPECT_NEAR(furthest({0, 0, 20, 64}), kTwoFifths, kLittle);
    EXPECT_NEAR(furthest({29, 0, 35, 64}), kTwoFifths, kLittle);
    EXPECT_NEAR(furthest({0, 0, 64, 24}), kTwoFifths, kLittle);
    EXPECT_NEAR(furthest({0, 29, 64, 35}), kTwoFifths, kLittle);
    EXPECT_NEAR(furthest({28, 28, 1, 1}), kThreeFifths, kLittle);
}

// "FAR_DEPTH_EMU of ZERO: 0 is the far value, and the larger of two depths is the nearer"
TEST_F(RegionValues, a_far_end_of_zero_turns_the_order_round) {
    glClearDepth(0.0);
    glClear(GL_DEPTH_BUFFER_BIT);
    put_depth({0, 0, 32, 64}, kTwoFifths);
    put_depth({4, 4, 1, 1}, kFifth);
    put_depth({5, 5, 1, 1}, 1.0f);
    far_depth(GL_ZERO);
    EXPECT_EQ(occluded({0, 0, 32, 64}), 1.0f);
    EXPECT_EQ(occluded({0, 0, 33, 64}), 0.0f);
    EXPECT_NEAR(furthest({0, 0, 32, 64}), kFifth, kLittle);
    EXPECT_EQ(nearest({0, 0, 32, 64}), 1.0f);
    far_depth(GL_ONE);
    EXPECT_EQ(occluded({0, 0, 32, 64}), 0.0f);
    EXPECT_EQ(occluded({32, 0, 32, 64}), 1.0f);
    EXPECT_NEAR(nearest({0, 0, 32, 64}), kFifth, kLittle);
}

// "What of the rectangle lies outside the framebuffer holds no pixels"
TEST_F(RegionValues, rectangles_are_clipped_to_the_framebuffer) {
    put_depth(kWhole, kTwoFifths);
    put_depth({0, 0, 1, 1}, kFifth);
    put_depth({63, 63, 1, 1}, kFourFifths);
    EXPECT_EQ(occluded({-100, -100, 264, 264}), 1.0f);
    EXPECT_NEAR(nearest({-5, -5, 6, 6}), kFifth, kLittle);
    EXPECT_NEAR(furthest({-5, -5, 6, 6}), kFifth, kLittle);
    EXPECT_NEAR(furthest({63, 63, 1000, 1000}), kFourFifths, kLittle);
    EXPECT_NEAR(furthest({60, 60, 3, 1000}), kTwoFifths, kLittle);
}

// As above, of coordinates whose sum an int does not hold.
TEST_F(RegionValues, coordinates_may_be_as_large_as_an_int_holds) {
    constexpr GLint kMost = 0x7FFFFFFF;
    put_depth(kWhole, kTwoFifths);
    EXPECT_NEAR(furthest({0, 0, kMost, kMost}), kTwoFifths, kLittle);
    EXPECT_NEAR(furthest({63, 63, kMost, kMost}), kTwoFifths, kLittle);
    EXPECT_NEAR(furthest({-kMost - 1, 0, kMost, 64}), 0.0f, 0.0f);
    EXPECT_NEAR(furthest({-kMost + 1, 0, kMost, 64}), kTwoFifths, kLittle);
    EXPECT_EQ(furthest({kMost, kMost, kMost, kMost}), 0.0f);
}

// "A region that holds no pixel is occluded; its furthest depth is the near value, its nearest depth the far
// value"
TEST_F(RegionValues, a_region_without_pixels_is_occluded) {
    for (const Rect& rect : {Rect{8, 8, 0, 8}, Rect{8, 8, 8, 0}, Rect{64, 0, 8, 8}, Rect{0, -8, 8, 8}}) {
        far_depth(GL_ONE);
        EXPECT_EQ(occluded(rect), 1.0f);
        EXPECT_EQ(furthest(rect), 0.0f);
        EXPECT_EQ(nearest(rect), 1.0f);
        far_depth(GL_ZERO);
        EXPECT_EQ(occluded(rect), 1.0f);
        EXPECT_EQ(furthest(rect), 1.0f);
        EXPECT_EQ(nearest(rect), 0.0f);
    }
}

// "The query sees the depths that all earlier commands leave, and none of a later one"
TEST_F(RegionValues, a_query_sees_the_draws_before_it) {
    glEnable(GL_DEPTH_TEST);
    for (int i = 0; i < 16; ++i) {
        draw_rect({4 * i, 0, 4, 64}, kTwoFifths);
        EXPECT_EQ(occluded({0, 0, 4 * (i + 1), 64}), 1.0f) << i;
        EXPECT_EQ(occluded({4 * i, 0, 5, 64}), i == 15 ? 1.0f : 0.0f) << i;
    }
}

}  // namespace
}  // namespace conformance
