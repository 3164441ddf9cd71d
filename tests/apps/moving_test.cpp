// SPDX-License-Identifier: MIT
// Every culler of the list while half of a small city's objects move: the oracle judges each frame with the
// objects where they were.
#include "gl_fixture.h"

#include "apps/hierarchy/refit.h"
#include "apps/hierarchy/world.h"
#include "apps/scene/motion.h"

namespace {

using apps::View;
using apps_test::Stage;

constexpr int kFrames = 8;
constexpr int kStride = 23;  // frames of the motion from one to the next
constexpr int kWidth = 320;
constexpr int kHeight = 240;

struct Moving : testing::Test {
    static void SetUpTestSuite() {
        const apps::Scene city = apps::build_chc_city(0.06, 2);
        apps::World world = apps::make_world(city, apps::TreeKind::kBvh, 1000);
        tree = new apps::Tree(std::move(world.tree));
        motion = new apps::Motion(world.scene, 0.5, 3);
        stage = new Stage(std::move(world.scene), kWidth, kHeight);
    }
    static void TearDownTestSuite() {
        delete stage;
        delete motion;
        delete tree;
        stage = nullptr;
        motion = nullptr;
        tree = nullptr;
    }

    static View view(int index) { return {stage->scene.path.frame(index, kFrames), kWidth, kHeight}; }

    static void place(int index, bool refitted) {
        motion->place(stage->scene, kStride * (index + 1));
        if (refitted) refit(*tree, stage->scene);
    }

    struct Sum {
        std::uint32_t visible = 0;
        std::uint32_t false_culls = 0;
        std::uint32_t wrong_pixels = 0;
    };
    static Sum walk(const apps::CullerRecipe& recipe, bool refitted) {
        const auto culler = apps::make_culler(recipe.name);
        const auto begin = [&](int index) {
            place(index, refitted);
            stage->start(view(index));
        };
        for (int index = 0; index < kFrames; ++index) {
            const View v = view(index);
            begin(index);
            apps::Frame preparation(index, stage->scene, *tree, v, stage->canvas);
            culler->prepare(preparation);
        }
        Sum sum;
        for (int index = 0; index < kFrames; ++index) {
            const View v = view(index);
            begin(index);
            apps::Frame frame(index, stage->scene, *tree, v, stage->canvas);
            culler->draw(frame);
            stage->renderer.finish();
            culler->settle(frame);
            const apps::Truth truth = stage->oracle.look(v);
            const apps::Verdict verdict = stage->oracle.judge(v, truth, frame.drawn);
            sum.visible += verdict.visible_objects;
            sum.false_culls += verdict.false_culls;
            sum.wrong_pixels += verdict.wrong_pixels;
        }
        return sum;
    }

    static Stage* stage;
    static apps::Motion* motion;
    static apps::Tree* tree;
};
Stage* Moving::stage = nullptr;
apps::Motion* Moving::motion = nullptr;
apps::Tree* Moving::tree = nullptr;

TEST_F(Moving, scenes_lose_nothing_visible_by_any_conservative_culler) {
    for (const apps::CullerRecipe* recipe : apps::cullers()) {
        if (!recipe->is_conservative) continue;
        const Sum sum = walk(*recipe, true);
        EXPECT_GT(sum.visible, 500U);
        EXPECT_EQ(sum.false_culls, 0U) << recipe->name;
        EXPECT_EQ(sum.wrong_pixels, 0U) << recipe->name;
    }
}

TEST_F(Moving, scenes_lose_something_visible_under_a_tree_that_is_not_refitted) {
    motion->place(stage->scene, 0);
    refit(*tree, stage->scene);
    EXPECT_GT(walk(*apps::find_culler("stop-and-wait"), false).false_culls, 0U);
}

}  // namespace
