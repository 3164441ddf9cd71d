// SPDX-License-Identifier: MIT
// Pictures of objects that share a mesh, turned and moved, are those of the same objects each stored where it
// is; and a mesh of a Debian package is walked by every culler under the oracle.
#include <filesystem>

#include "apps/hierarchy/world.h"
#include "apps/scene/model.h"
#include "apps/walkthrough/lighting.h"
#include "gl_fixture.h"

namespace {

using apps::ObjectId;
using apps::Scene;
using apps_test::Stage;

constexpr int kWidth = 160;
constexpr int kHeight = 120;

/// A tower with a roof, and the same tower turned by quarters and moved by whole metres.
Scene towers() {
    Scene scene;
    apps::MeshBuilder mesh(scene);
    mesh.standing_box({0, 0, 0}, {2, 4, 6}, {0.8F, 0.3F, 0.2F});
    mesh.cone({1, 2, 6}, 2, 3, 8, {0.3F, 0.4F, 0.8F});
    mesh.finish();
    mesh.quad({-30, -30, 0}, {60, -30, 0}, {60, 30, 0}, {-30, 30, 0}, {0.5F, 0.6F, 0.4F});
    mesh.finish();
    for (int i = 1; i < 4; ++i) {
        const float c = i == 2 ? -1.0F : 0.0F;
        const float s = i == 1 ? 1.0F : i == 3 ? -1.0F : 0.0F;
        glm::mat4 placement(1);
        placement[0] = {c, s, 0, 0};
        placement[1] = {-s, c, 0, 0};
        placement[3] = {5.0F * static_cast<float>(i), 3.0F * static_cast<float>(i % 2), 0, 1};
        scene.placements.push_back(placement);
        apps::Object object = scene.objects[0];
        object.placement = static_cast<std::uint32_t>(i);
        object.box = placed_box(scene, object, placement);
        scene.objects.push_back(object);
    }
    return scene;
}

/// Each object with vertices of its own, where they are in the world.
Scene stored_apart(const Scene& placed) {
    Scene scene;
    for (apps::Object object : placed.objects) {
        const auto first = static_cast<std::uint32_t>(scene.positions.size());
        const auto first_index = static_cast<std::uint32_t>(scene.indices.size());
        for (std::uint32_t v = object.first_vertex; v < object.first_vertex + object.vertex_count; ++v) {
            scene.positions.emplace_back(placed.placements[object.placement] *
                                         glm::vec4(placed.positions[v], 1));
            scene.colours.push_back(placed.colours[v]);
        }
        for (std::uint32_t i = 0; i < object.index_count; ++i)
            scene.indices.push_back(placed.indices[object.first_index + i] - object.first_vertex + first);
        object.first_vertex = first;
        object.first_index = first_index;
        object.placement = 0;
        scene.objects.push_back(object);
    }
    return scene;
}

std::vector<apps::Lit> lit(Stage& stage) {
    const apps::World world = apps::make_world(stage.scene, apps::TreeKind::kBvh, 1);
    const apps::View view({{8, -22, 9}, glm::normalize(glm::vec3(0, 22, -5)), {}}, kWidth, kHeight);
    apps::Lighting lighting(stage.renderer, stage.scene, world.tree);
    std::vector<ObjectId> all(stage.scene.objects.size());
    for (ObjectId id = 0; id < all.size(); ++id) all[id] = id;
    return lighting.light({view.modelview, view.projection}, kWidth, kHeight, all, 0);
}

TEST(Placed, objects_are_lit_in_pictures_as_if_each_were_stored_where_it_is) {
    Stage placed(towers(), kWidth, kHeight);
    const std::vector<apps::Lit> one = lit(placed);
    Stage apart(stored_apart(placed.scene), kWidth, kHeight);
    const std::vector<apps::Lit> other = lit(apart);
    std::size_t different = 0;
    std::vector<std::size_t> pixels_of(placed.scene.objects.size(), 0);
    for (std::size_t i = 0; i < one.size(); ++i) {
        if (!one[i].is_sky()) ++pixels_of[one[i].object];
        different += one[i].object != other[i].object ||
                     glm::length(one[i].normal - other[i].normal) > 1e-3F ||
                     std::abs(one[i].distance - other[i].distance) > 1e-2F ||
                     glm::length(one[i].light - other[i].light) > 0.1F;
    }
    for (const std::size_t pixels : pixels_of) EXPECT_GT(pixels, 100U) << "an object is not in the picture";
    EXPECT_LT(different, one.size() / 200) << "rounding may move an edge or a shadow by a pixel";
}

TEST(Placed, models_of_a_debian_package_lose_nothing_visible_by_any_conservative_culler) {
    const std::filesystem::path bunny = "/usr/share/glmark2/models/bunny.obj";
    if (!std::filesystem::exists(bunny)) GTEST_SKIP() << "glmark2-data is not here";
    const Scene raw = apps::load_model(bunny, {apps::ModelSplit::By::kObject, 600});
    apps::World world = apps::make_world(raw, apps::TreeKind::kBvh, raw.objects.size());
    Stage stage(std::move(world.scene), kWidth, kHeight);
    for (const apps::CullerRecipe* recipe : apps::cullers()) {
        if (!recipe->is_conservative) continue;
        const auto culler = apps::make_culler(recipe->name);
        for (int index = 0; index < 3; ++index) {
            const apps::View view(stage.scene.path.frame(index, 3), kWidth, kHeight);
            stage.start(view);
            apps::Frame preparation(index, stage.scene, world.tree, view, stage.canvas);
            culler->prepare(preparation);
            stage.start(view);
            apps::Frame frame(index, stage.scene, world.tree, view, stage.canvas);
            culler->draw(frame);
            stage.renderer.finish();
            culler->settle(frame);
            const apps::Truth truth = stage.oracle.look(view);
            EXPECT_GT(truth.visible.size(), 20U);
            const apps::Verdict verdict = stage.oracle.judge(view, truth, frame.drawn);
            EXPECT_EQ(verdict.false_culls, 0U) << recipe->name;
            EXPECT_EQ(verdict.wrong_pixels, 0U) << recipe->name;
        }
    }
}

}  // namespace
