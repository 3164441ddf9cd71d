// SPDX-License-Identifier: MIT
// The generated city: its exact size, its sameness to the bit, and a path that walks through no wall.
#include <gtest/gtest.h>

#include <cmath>

#include "apps/scene/scenes.h"

namespace {

using apps::build_chc_city;
using apps::Scene;

TEST(City, has_exactly_the_triangles_of_the_paper_at_scale_one) {
    EXPECT_EQ(build_chc_city(1, 1).triangle_count(), 1'036'146U);  // CHC paper, table 1
    EXPECT_EQ(build_chc_city(1, 7).triangle_count(), 1'036'146U);
}

TEST(City, has_exactly_its_share_of_triangles_at_every_scale) {
    for (const double scale : {0.01, 0.0199, 0.035, 0.036, 0.05, 0.1, 0.333})
        for (const std::uint64_t seed : {1U, 2U, 3U})
            EXPECT_EQ(build_chc_city(scale, seed).triangle_count(), std::lround(scale * 1'036'146))
                << scale << ' ' << seed;
}

TEST(City, is_the_same_bits_for_the_same_seed) {
    EXPECT_EQ(hash_of(build_chc_city(0.05, 3)), hash_of(build_chc_city(0.05, 3)));
    EXPECT_NE(hash_of(build_chc_city(0.05, 3)), hash_of(build_chc_city(0.05, 4)));
}

TEST(City, keeps_the_fingerprint_that_results_were_published_with) {
    // Only + - * / and sqrt make it: another compiler or build type must not change a bit. Change the number
    // when the city is changed on purpose.
    EXPECT_EQ(hash_of(build_chc_city(0.05, 1)), 0x9E181351258B384CULL);
}

TEST(City, has_small_objects_that_hold_consecutive_ranges) {
    const Scene city = build_chc_city(0.1, 1);
    std::uint32_t index = 0;
    std::uint32_t vertex = 0;
    for (const apps::Object& object : city.objects) {
        EXPECT_EQ(object.first_index, index);
        EXPECT_EQ(object.first_vertex, vertex);
        EXPECT_GE(object.triangle_count(), 1U);
        EXPECT_LE(object.triangle_count(), 120U);
        for (std::uint32_t i = 0; i < object.index_count; ++i) {
            const std::uint32_t v = city.indices[index + i];
            ASSERT_TRUE(v >= vertex && v < vertex + object.vertex_count);
            ASSERT_TRUE(object.box.contains(city.positions[v]));
        }
        index += object.index_count;
        vertex += object.vertex_count;
    }
    EXPECT_EQ(index, city.indices.size());
    EXPECT_EQ(vertex, city.positions.size());
}

TEST(Path, never_brings_the_near_plane_into_an_object) {
    for (const double scale : {0.01, 0.05, 1.0}) {
        const Scene city = build_chc_city(scale, 1);
        for (int frame = 0; frame < 400; ++frame) {
            const apps::Camera camera = city.path.frame(frame, 400);
            const apps::Box around{camera.eye - 0.4F,
                                   camera.eye + 0.4F};  // the near rectangle's corners are 0.36 m away
            for (const apps::Object& object : city.objects)
                ASSERT_TRUE(apps::intersection(around, object.box).is_empty()) << scale << ' ' << frame;
        }
    }
}

TEST(Path, goes_above_the_roofs_for_about_a_third_of_its_frames_and_stays_low_else) {
    const Scene city = build_chc_city(1, 1);
    int high = 0;
    int low = 0;
    for (int frame = 0; frame < 1000; ++frame) {
        const float height = city.path.frame(frame, 1000).eye.z;
        high += height > city.bounds.max.z;
        low += height < 2;
    }
    EXPECT_GT(high, 100);
    EXPECT_GT(low, 650);
}

}  // namespace
