// SPDX-License-Identifier: MIT
// The forest and the city of the LOG paper: exact sizes, sameness to the bit, placed meshes inside their
// boxes, leaves no larger than the paper's, the same walk however large the city, and the shares of the
// triangles that are in the frustum and drawn, at full scale.
#include <cmath>
#include <set>

#include "apps/culling/traversal.h"
#include "apps/hierarchy/world.h"
#include "gl_fixture.h"

namespace {

using apps::Scene;
using apps_test::Stage;

/// Table 1 of the paper, at 640x480.
struct Row {
    const char* name;
    std::uint64_t triangles;
    double frustum;
    double drawn;
    double tiles_a_box;
    std::uint64_t fingerprint;  // of the scene at scale 0.02
};

constexpr Row kForest{"log-forest", 1'694'426, 147'969, 7'009, 14.6, 0xF1CACE1D0915F6C7ULL};
constexpr Row kCity{"log-city", 34'034'176, 1'964'918, 11'981, 17.7, 0xB86AD040B67AF4E4ULL};

Scene build(const Row& row, double scale, std::uint64_t seed = 1) {
    return apps::find_scene(row.name)->build(scale, seed);
}

/// One test of each kind for both scenes.
class LogScenes : public testing::TestWithParam<Row> {};

INSTANTIATE_TEST_SUITE_P(, LogScenes, testing::Values(kForest, kCity),
                         [](const auto& row) { return std::string(row.param.name).substr(4); });

TEST_P(LogScenes, have_the_triangles_of_the_paper_and_the_objects_of_the_list) {
    const Scene scene = build(GetParam(), 1);
    EXPECT_EQ(scene.triangle_count(), GetParam().triangles);
    EXPECT_EQ(scene.objects.size(), apps::find_scene(GetParam().name)->objects);
    EXPECT_LT(scene.indices.size(), 3U * 100'000) << "meshes are stored once";
}

TEST_P(LogScenes, are_the_same_bits_for_the_same_seed) {
    EXPECT_EQ(hash_of(build(GetParam(), 0.02, 3)), hash_of(build(GetParam(), 0.02, 3)));
    EXPECT_NE(hash_of(build(GetParam(), 0.02, 3)), hash_of(build(GetParam(), 0.02, 4)));
}

TEST_P(LogScenes, keep_the_fingerprint_that_results_were_published_with) {
    // Only + - * / and sqrt make them: another compiler or build type must not change a bit. Change the
    // number when a scene is changed on purpose.
    EXPECT_EQ(hash_of(build(GetParam(), 0.02)), GetParam().fingerprint);
}

TEST_P(LogScenes, place_every_vertex_inside_the_objects_box) {
    const Scene scene = build(GetParam(), 0.05);
    for (std::size_t id = 0; id < scene.objects.size(); id += 7) {
        const apps::Object& object = scene.objects[id];
        const glm::mat4& placement = scene.placements[object.placement];
        ASSERT_TRUE(scene.bounds.contains(object.box));
        for (std::uint32_t i = 0; i < object.index_count; ++i) {
            const std::uint32_t v = scene.indices[object.first_index + i];
            ASSERT_TRUE(v >= object.first_vertex && v < object.first_vertex + object.vertex_count);
            ASSERT_TRUE(object.box.contains(glm::vec3(placement * glm::vec4(scene.positions[v], 1))));
        }
    }
}

TEST_P(LogScenes, are_walked_without_the_near_plane_in_a_triangle) {
    const Scene scene = build(GetParam(), 1);
    for (int frame = 0; frame < 100; ++frame) {
        const apps::Camera camera = scene.path.frame(frame, 100);
        const float reach = 2 * camera.lens.near_metres;  // the near rectangle's corners are nearer
        const apps::Box around{camera.eye - reach, camera.eye + reach};
        for (const apps::Object& object : scene.objects) {
            if (apps::intersection(around, object.box).is_empty()) continue;
            for (std::uint32_t i = 0; i < object.index_count; i += 3) {
                apps::Box triangle;
                for (std::uint32_t corner = 0; corner < 3; ++corner) {
                    const glm::vec3& p = scene.positions[scene.indices[object.first_index + i + corner]];
                    triangle.add(glm::vec3(scene.placements[object.placement] * glm::vec4(p, 1)));
                }
                ASSERT_TRUE(apps::intersection(around, triangle).is_empty()) << frame;
            }
        }
    }
}

TEST(LogForest, has_exactly_its_share_of_triangles_at_every_scale) {
    for (const double scale : {0.01, 0.0199, 0.05, 0.1337, 0.5, 2.0})
        EXPECT_EQ(build(kForest, scale).triangle_count(),
                  static_cast<std::uint64_t>(std::lround(scale * static_cast<double>(kForest.triangles))))
            << scale;
}

TEST(LogCity, is_of_whole_blocks_and_of_leaves_no_larger_than_the_papers) {
    for (const double scale : {1.0 / 512, 0.01, 1.0 / 32, 0.5})
        EXPECT_EQ(build(kCity, scale).triangle_count(),
                  static_cast<std::uint64_t>(std::lround(scale * 512)) * 66'473)
            << scale;
    for (const apps::Object& object : build(kCity, 1.0 / 512).objects) {
        EXPECT_LE(object.triangle_count(), 1'500U);
        EXPECT_GE(object.triangle_count(), 1U);
    }
}

TEST(LogCity, grows_behind_the_walk_and_not_around_it) {
    const Scene small = build(kCity, 1.0 / 32);
    const Scene large = build(kCity, 1.0 / 8);
    ASSERT_LT(small.objects.size(), large.objects.size());
    for (std::size_t id = 0; id < small.objects.size(); ++id) {
        EXPECT_EQ(small.objects[id].box.min, large.objects[id].box.min);
        EXPECT_EQ(small.objects[id].first_index, large.objects[id].first_index);
    }
    for (int frame = 0; frame < 50; ++frame)
        EXPECT_EQ(small.path.frame(frame, 50).eye, large.path.frame(frame, 50).eye);
}

TEST_P(LogScenes, have_the_shares_of_the_paper_in_the_frustum_and_drawn) {
    constexpr int kFrames = 48;
    const Row& row = GetParam();
    const apps::World world = apps::make_world(row.name, 1, 1);
    Stage stage(world.scene, 640, 480);
    const auto frustum_culler = apps::make_culler("frustum");
    const auto grid = apps::make_culler("log-state");
    double frustum = 0;
    double drawn = 0;
    double tiles = 0;
    double boxes = 0;
    struct Nothing final : apps::Canvas {
        void draw(std::span<const apps::ObjectId>) override {}
    } nothing;
    for (int index = 0; index < kFrames; ++index) {
        const apps::View view(stage.scene.path.frame(index, kFrames), 640, 480);
        apps::Frame all(index, stage.scene, world.tree, view, nothing);
        frustum_culler->draw(all);
        stage.start(view);
        apps::Frame seen(index, stage.scene, world.tree, view, stage.canvas);
        grid->draw(seen);
        frustum += static_cast<double>(apps::triangles_of(stage.scene, all.drawn)) / kFrames;
        drawn += static_cast<double>(apps::triangles_of(stage.scene, seen.drawn)) / kFrames;
        for (const apps::Statistic* statistic : apps::Statistic::all()) {
            if (statistic->name() == "tiles_tested") tiles += static_cast<double>(seen.tally.of(*statistic));
            if (statistic->name() == "boxes_tested") boxes += static_cast<double>(seen.tally.of(*statistic));
        }
    }
    const auto total = static_cast<double>(row.triangles);
    std::printf(
        "%s: frustum %.1f %% of all, drawn %.2f %% of that, %.3f %% of all, %.1f tiles a box; the paper: "
        "%.1f, %.2f, %.3f, %.1f\n",
        row.name, 100 * frustum / total, 100 * drawn / frustum, 100 * drawn / total, tiles / boxes,
        100 * row.frustum / total, 100 * row.drawn / row.frustum, 100 * row.drawn / total, row.tiles_a_box);
    // A sixth of it, as for the other scenes.
    EXPECT_NEAR(frustum, row.frustum, row.frustum / 6);
    EXPECT_NEAR(drawn, row.drawn, row.drawn / 6);
}

}  // namespace
