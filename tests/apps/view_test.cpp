// SPDX-License-Identifier: MIT
// The two conservative answers without any GL: what must never be asked, and what must never be called
// outside.
#include <gtest/gtest.h>

#include <limits>

#include "apps/culling/view.h"
#include "apps/scene/random.h"

namespace {

using apps::Box;
using apps::Camera;
using apps::Lens;
using apps::proxy_of;
using apps::View;

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

View looking_along_x(float degrees = 60, float near_metres = 0.5F, int width = 640, int height = 480) {
    return {Camera{{0, 0, 0}, {1, 0, 0}, Lens{degrees, near_metres, 1000}}, width, height};
}

TEST(Proxy, is_refused_at_every_step_at_which_the_near_plane_cuts_the_box) {
    const View view = looking_along_x();
    int refused = 0;
    for (int step = -1024; step <= 4096; ++step) {
        const float x = static_cast<float>(step) / 1024;
        const Box box{{x, -0.2F, -0.2F}, {x + 0.3F, 0.2F, 0.2F}};
        const auto proxy = proxy_of(view, box, 0.5F);
        EXPECT_FALSE(proxy && box.min.x <= view.near_metres) << x;
        if (proxy) {
            EXPECT_GT(proxy->min.x, view.near_metres);
        }
        refused += !proxy;
    }
    EXPECT_GT(refused, 1024);
    EXPECT_LT(refused, 1024 * (1 + view.near_corner_metres) + 16) << "boxes clear of the eye are refused";
}

TEST(Proxy, is_refused_where_the_eye_is_nearer_to_the_box_than_a_corner_of_the_near_rectangle) {
    // n * sqrt(1 + tx^2 + ty^2) is 1.22 n at 45 degrees and 4:3, 1.54 n at 60 and 16:9, 2.27 n at 90 and
    // 16:9.
    const struct {
        float degrees;
        int width, height;
        float factor;
    } lenses[] = {{45, 640, 480, 1.22F}, {60, 1280, 720, 1.54F}, {90, 1280, 720, 2.27F}};
    for (const auto& lens : lenses) {
        const View view = looking_along_x(lens.degrees, 0.5F, lens.width, lens.height);
        EXPECT_NEAR(view.near_corner_metres / view.near_metres, lens.factor, 0.006);
        for (int axis = 0; axis < 3; ++axis)
            for (const float sign : {-1.0F, 1.0F})
                for (const float k : {0.0F, 0.5F, 0.999F}) {
                    glm::vec3 centre(0);
                    centre[axis] = sign * (static_cast<float>(view.near_corner_metres) * k + 3);
                    EXPECT_FALSE(proxy_of(view, {centre - 3.0F, centre + 3.0F}, 0.5F))
                        << axis << ' ' << sign << ' ' << k;
                }
    }
}

TEST(Proxy, is_refused_for_corners_that_are_no_numbers) {
    const View view = looking_along_x();
    ASSERT_TRUE(proxy_of(view, {{5, -1, -1}, {7, 1, 1}}, 0.5F));
    for (const float bad : {kNaN, kInfinity, -kInfinity})
        for (int axis = 0; axis < 3; ++axis) {
            Box low{{5, -1, -1}, {7, 1, 1}};
            Box high = low;
            low.min[axis] = bad;
            high.max[axis] = bad;
            EXPECT_FALSE(proxy_of(view, low, 0.5F)) << bad << ' ' << axis;
            EXPECT_FALSE(proxy_of(view, high, 0.5F)) << bad << ' ' << axis;
        }
}

TEST(Proxy, is_larger_than_its_box_by_the_pixels_asked_for_at_the_far_end_of_the_box) {
    const View view = looking_along_x();
    const Box box{{10, -1, -1}, {40, 1, 1}};
    for (const float pixels : {0.5F, 1.0F, 4.0F}) {
        const auto proxy = proxy_of(view, box, pixels);
        ASSERT_TRUE(proxy);
        const double per_pixel_at_40 = 40 * 2 * std::tan(glm::radians(30.0)) / 480;
        EXPECT_GE(box.min.z - proxy->min.z, 0.999 * pixels * per_pixel_at_40);
        EXPECT_GE(proxy->max.y - box.max.y, 0.999 * pixels * per_pixel_at_40);
    }
}

TEST(Outside, is_never_said_of_a_box_that_holds_a_point_of_the_frustum) {
    apps::Random random(11);
    const auto direction = [&] {
        return glm::vec3(random.between(-1, 1), random.between(-1, 1), random.between(-0.6F, 0.6F));
    };
    int outside = 0;
    for (int trial = 0; trial < 20'000; ++trial) {
        const View view(
            {{random.between(-500, 500), 3, 2}, glm::normalize(direction() + 1e-3F), Lens{50, 0.3F, 800}},
            640, 480);
        const glm::vec3 ndc{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
        const glm::dvec4 p = glm::inverse(view.clip) * glm::dvec4(ndc, 1);
        const glm::vec3 point(glm::dvec3(p) / p.w);
        const glm::vec3 size(random.unit() * 20, random.unit() * 20, random.unit());
        const Box holding{point - size * random.unit(), point + size * random.unit()};
        EXPECT_FALSE(apps::is_outside(view, holding));
        const glm::vec3 elsewhere = direction() * 800.0F;
        outside += apps::is_outside(view, {elsewhere, elsewhere + size});
    }
    EXPECT_GT(outside, 10'000) << "the test is never true";
}

}  // namespace
