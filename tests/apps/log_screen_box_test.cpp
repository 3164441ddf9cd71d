// SPDX-License-Identifier: MIT
// Boxes on the screen: whatever is in one must be drawn inside its rectangle and its range of depth, by a
// driver that multiplies in float.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "apps/culling/screen_box.h"
#include "apps/scene/random.h"

namespace {

using apps::Box;
using apps::Camera;
using apps::DepthSteps;
using apps::kDepthMarginSteps;
using apps::kFarStep;
using apps::Lens;
using apps::Rectangle;
using apps::screen_box;
using apps::ScreenBox;
using apps::View;

View looking_along_x(int width = 333, int height = 241) {
    return {Camera{{0, 0, 0}, {1, 0, 0}, Lens{60, 0.5F, 1000}}, width, height};
}

/// The step of a depth at so many metres straight ahead of looking_along_x.
double step_at(double metres) {
    const double ndc = (1000.5 - 2 * 1000 * 0.5 / metres) / 999.5;
    return (ndc * 0.5 + 0.5) * kFarStep;
}

// As a driver transforms: one matrix in float, points in float, to window coordinates in float.
glm::vec3 window_of(const View& view, const glm::vec3& point) {
    const glm::mat4 matrix = view.projection * view.modelview;
    const glm::vec4 clip = matrix * glm::vec4(point, 1);
    return (glm::vec3(clip) / clip.w * 0.5F + 0.5F) *
           glm::vec3(static_cast<float>(view.width), static_cast<float>(view.height), 1);
}

TEST(ScreenBox, holds_every_pixel_and_depth_that_a_float_driver_can_draw_in_the_box) {
    apps::Random random(7);
    int known = 0;
    for (const float shift : {0.0F, 1e3F, 1e5F})  // case 12: large world coordinates
        for (int round = 0; round < 1000; ++round) {
            const glm::vec3 eye =
                glm::vec3(shift, -shift, 0) +
                glm::vec3{random.between(-9, 9), random.between(-9, 9), random.between(0, 9)};
            const glm::vec3 forward = glm::normalize(
                glm::vec3{random.between(-1, 1), random.between(-1, 1), random.between(-0.5F, 0.5F)});
            const View view({eye, forward, Lens{60, 0.5F, 1000}}, 333, 241);
            Box box;
            const glm::vec3 centre = eye + forward * random.between(2, 200);
            box.add(centre);
            box.add(centre + glm::vec3{random.between(-5, 5), random.between(-5, 5), random.between(-5, 5)});
            const ScreenBox on_screen = screen_box(view, box);
            if (!on_screen.is_known) continue;
            ++known;
            const Rectangle& r = on_screen.pixels;
            for (int k = 0; k < 20; ++k) {
                glm::vec3 point;
                for (int axis = 0; axis < 3; ++axis)
                    point[axis] = k < 8 ? box.corner(k)[axis] : random.between(box.min[axis], box.max[axis]);
                const glm::vec3 window = window_of(view, point);
                const double step = static_cast<double>(window.z) * kFarStep;
                ASSERT_GE(step, on_screen.znear) << shift << ' ' << round;
                ASSERT_LE(step, on_screen.zfar) << shift << ' ' << round;
                // A sample is taken at a pixel's centre: half a pixel may be lost, no more.
                if (window.x > 0.5F && window.x < 332.5F) {
                    ASSERT_GE(window.x, static_cast<float>(r.x)) << shift << ' ' << round;
                    ASSERT_LE(window.x, static_cast<float>(r.x + r.width)) << shift << ' ' << round;
                }
                if (window.y > 0.5F && window.y < 240.5F) {
                    ASSERT_GE(window.y, static_cast<float>(r.y)) << shift << ' ' << round;
                    ASSERT_LE(window.y, static_cast<float>(r.y + r.height)) << shift << ' ' << round;
                }
            }
        }
    EXPECT_GT(known, 2000);
}

TEST(ScreenBox, is_the_nearest_and_the_furthest_corner_in_steps_of_the_buffer_and_a_margin) {
    const View view = looking_along_x();
    for (const float x : {1.0F, 3.0F, 20.0F, 500.0F}) {
        const ScreenBox box = screen_box(view, {{x, -0.1F, -0.1F}, {x * 1.5F, 0.1F, 0.1F}});
        ASSERT_TRUE(box.is_known);
        EXPECT_NEAR(box.znear, step_at(x) - kDepthMarginSteps, 4) << x;
        EXPECT_LE(box.znear, step_at(x) - kDepthMarginSteps + 2) << x;
        EXPECT_NEAR(box.zfar, step_at(static_cast<double>(x) * 1.5) + kDepthMarginSteps, 4) << x;
    }
}

// Case 10: by distance to the eye the second box is the nearer one, by depth the first is.
TEST(ScreenBox, goes_by_depth_and_not_by_distance) {
    const View view = looking_along_x();
    const Box off_axis{{10, 5, -1}, {11, 6, 1}};
    const Box ahead{{10.5F, -1, -1}, {12, 1, 1}};
    EXPECT_GT(std::hypot(10.0, 5.0), 10.5);
    EXPECT_LT(screen_box(view, off_axis).znear, screen_box(view, ahead).znear);
}

TEST(ScreenBox, covers_exactly_the_pixels_that_it_touches) {
    const View view({Camera{{0, 0, 0}, {1, 0, 0}, Lens{90, 0.5F, 1000}}, 200, 200});
    // At 1 m a pixel is a hundredth of a metre; y runs to the left.
    const ScreenBox box = screen_box(view, {{1, -0.205F, 0.305F}, {1.0001F, 0.105F, 0.405F}});
    EXPECT_EQ(box.pixels, (Rectangle{89, 130, 32, 11}));
    const ScreenBox cut = screen_box(view, {{1, -9, 0.305F}, {1.0001F, 9, 9}});
    EXPECT_EQ(cut.pixels, (Rectangle{0, 130, 200, 70}));
    const ScreenBox speck = screen_box(view, {{1, 0.0049F, 0.0049F}, {1, 0.0051F, 0.0051F}});
    EXPECT_EQ(speck.pixels, (Rectangle{99, 100, 1, 1})) << "a box smaller than a pixel";
    const ScreenBox beside = screen_box(view, {{1, 1.5F, 0}, {1.1F, 2, 1}});
    EXPECT_TRUE(beside.is_known);
    EXPECT_EQ(beside.pixels.pixels(), 0U);
}

TEST(ScreenBox, is_not_known_where_the_near_plane_cuts_it_but_how_far_it_reaches_is) {
    const View view = looking_along_x();
    for (int step = -200; step <= 60; ++step) {
        const float x = static_cast<float>(step) / 100;
        const ScreenBox box = screen_box(view, {{x, -0.1F, -0.1F}, {x + 2, 0.1F, 0.1F}});
        if (x > 0.5F * 1.002F) {
            EXPECT_TRUE(box.is_known) << x;
            continue;
        }
        EXPECT_FALSE(box.is_known) << x;
        EXPECT_EQ(box.znear, 0);
        EXPECT_EQ(box.pixels, (Rectangle{0, 0, 333, 241}));
        if (x + 2 > 0.6F) {
            EXPECT_GE(box.zfar, step_at(x + 2.0)) << x;
            EXPECT_LE(box.zfar, step_at(x + 2.0) + 12) << x;
        }
    }
    EXPECT_FALSE(screen_box(view, {glm::vec3(-1), glm::vec3(1)}).is_known) << "the eye is in it";
    EXPECT_FALSE(screen_box(view, {{0, -1, -1}, {9, 1, 1}}).is_known) << "w is 0 in four corners";
}

TEST(ScreenBox, with_a_corner_that_is_no_number_is_not_known_and_reaches_to_the_end) {
    const View view = looking_along_x();
    for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
                            -std::numeric_limits<float>::infinity()})
        for (int axis = 0; axis < 3; ++axis)
            for (const bool in_min : {true, false}) {
                Box box{{5, -1, -1}, {6, 1, 1}};
                (in_min ? box.min : box.max)[axis] = bad;
                const ScreenBox on_screen = screen_box(view, box);
                EXPECT_FALSE(on_screen.is_known) << bad << ' ' << axis << ' ' << in_min;
                EXPECT_EQ(on_screen.znear, 0);
                EXPECT_EQ(on_screen.zfar, kFarStep);
            }
}

TEST(ScreenBox, is_compared_with_exactly_the_steps_that_gl_told) {
    for (DepthSteps step = 0; step <= kFarStep; step += 1 + step / 9999) {
        const auto told = static_cast<float>(static_cast<double>(step) / kFarStep);
        EXPECT_EQ(apps::steps_of(told), step);
    }
    EXPECT_EQ(apps::steps_of(1), kFarStep);
    EXPECT_EQ(apps::steps_of(0), 0);
    EXPECT_EQ(apps::steps_of(std::numeric_limits<float>::quiet_NaN()), kFarStep);
    EXPECT_TRUE((ScreenBox{true, {}, 5000, 6000}.is_behind(4999)));
    EXPECT_FALSE((ScreenBox{true, {}, 5000, 6000}.is_behind(5000)));
}

}  // namespace
