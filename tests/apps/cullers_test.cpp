// SPDX-License-Identifier: MIT
// Every culler of the list on a small city, against the exact visible set; and the judge itself, judged.
#include "gl_fixture.h"

#include <algorithm>

#include "apps/culling/culler.h"
#include "apps/hierarchy/world.h"

namespace {

using apps::ObjectId;
using apps::View;
using apps_test::Stage;

constexpr int kFrames = 10;
constexpr int kWidth = 320;
constexpr int kHeight = 240;

struct Cullers : testing::Test {
    static void SetUpTestSuite() {
        apps::World world = apps::make_world("chc-city", 0.1, 2);
        tree = new apps::Tree(std::move(world.tree));
        stage = new Stage(std::move(world.scene), kWidth, kHeight);
    }
    static void TearDownTestSuite() {
        delete stage;
        delete tree;
        stage = nullptr;
        tree = nullptr;
    }

    static View view(int index) { return {stage->scene.path.frame(index, kFrames), kWidth, kHeight}; }

    /// The drawn set of each frame, in the order of drawing.
    static std::vector<std::vector<ObjectId>> run(const apps::CullerRecipe& recipe) {
        const auto culler = apps::make_culler(recipe.name);
        std::vector<std::vector<ObjectId>> sets;
        for (int index = 0; index < kFrames; ++index) {
            const View v = view(index);
            stage->start(v);
            apps::Frame preparation(index, stage->scene, *tree, v, stage->canvas);
            culler->prepare(preparation);
        }
        for (int index = 0; index < kFrames; ++index) {
            const View v = view(index);
            stage->start(v);
            apps::Frame frame(index, stage->scene, *tree, v, stage->canvas);
            culler->draw(frame);
            stage->renderer.finish();
            culler->settle(frame);
            sets.push_back(frame.drawn);
        }
        return sets;
    }
    static std::vector<std::vector<ObjectId>> run(std::string_view name) {
        return run(*apps::find_culler(name));
    }

    static Stage* stage;
    static apps::Tree* tree;
};
Stage* Cullers::stage = nullptr;
apps::Tree* Cullers::tree = nullptr;

TEST_F(Cullers, that_are_conservative_leave_out_no_object_that_owns_a_sample) {
    for (const apps::CullerRecipe* each : apps::cullers()) {
        const apps::CullerRecipe& recipe = *each;
        if (!recipe.is_conservative) continue;
        const auto sets = run(recipe);
        std::size_t at_stake = 0;
        for (int index = 0; index < kFrames; ++index) {
            const apps::Truth truth = stage->oracle.look(view(index));
            at_stake += truth.visible.size();
            const apps::Verdict verdict =
                stage->oracle.judge(view(index), truth, sets[static_cast<std::size_t>(index)]);
            EXPECT_EQ(verdict.false_culls, 0U) << recipe.name << " in frame " << index;
            EXPECT_EQ(verdict.wrong_pixels, 0U) << recipe.name << " in frame " << index;
        }
        EXPECT_GT(at_stake, 1000U);
    }
}

TEST_F(Cullers, draw_less_and_less_from_none_to_frustum_to_stop_and_wait) {
    const auto none = run("none");
    const auto frustum = run("frustum");
    const auto waiting = run("stop-and-wait");
    std::size_t sums[2] = {};
    for (std::size_t index = 0; index < kFrames; ++index) {
        EXPECT_EQ(none[index].size(), stage->scene.objects.size());
        std::vector<ObjectId> outer = frustum[index];
        std::vector<ObjectId> inner = waiting[index];
        std::sort(outer.begin(), outer.end());
        std::sort(inner.begin(), inner.end());
        EXPECT_TRUE(std::includes(outer.begin(), outer.end(), inner.begin(), inner.end()));
        sums[0] += outer.size();
        sums[1] += inner.size();
    }
    EXPECT_LT(sums[0], stage->scene.objects.size() * kFrames / 2);
    EXPECT_LT(sums[1], sums[0] / 2);
}

TEST_F(Cullers, called_ideal_draw_what_stop_and_wait_draws_in_its_order) {
    EXPECT_EQ(run("ideal"), run("stop-and-wait"));
}

TEST_F(Cullers, called_ideal_ask_nothing_while_they_are_timed) {
    const auto ideal = apps::make_culler("ideal");
    const View v = view(0);
    stage->start(v);
    apps::GlCanvas recording(stage->renderer, stage->machine);
    apps::Frame preparation(0, stage->scene, *tree, v, recording);
    ideal->prepare(preparation);
    EXPECT_GT(recording.counters().queries, 20U);
    apps::Machine without_tests;
    apps::GlCanvas timed(stage->renderer, without_tests);  // asking would throw
    apps::Frame frame(0, stage->scene, *tree, v, timed);
    ideal->draw(frame);
    EXPECT_EQ(timed.counters().queries, 0U);
}

TEST_F(Cullers, are_convicted_by_the_oracle_when_they_leave_out_something_visible) {
    const View v = view(3);
    const apps::Truth truth = stage->oracle.look(v);
    const apps::Verdict whole = stage->oracle.judge(v, truth, truth.visible);
    EXPECT_EQ(whole.false_culls, 0U);
    EXPECT_EQ(whole.wrong_pixels, 0U);
    for (std::size_t missing = 0; missing < truth.visible.size(); missing += 17) {
        std::vector<ObjectId> set = truth.visible;
        set.erase(set.begin() + static_cast<std::ptrdiff_t>(missing));
        const apps::Verdict verdict = stage->oracle.judge(v, truth, set);
        EXPECT_EQ(verdict.false_culls, 1U);
        EXPECT_GE(verdict.wrong_pixels, 1U);
    }
}

/// The same context, but all that it says of itself is GL 1.1.
struct OldMachine final : apps::Platform {
    explicit OldMachine(apps::Platform& real) : real_(real) { describe("old", "1.1 ancient", ""); }
    Function function(const char* name) override { return real_.function(name); }
    void swap_buffers() override { real_.swap_buffers(); }

  private:
    apps::Platform& real_;
};

TEST_F(Cullers, draw_the_same_picture_without_buffer_objects) {
    const View v = view(2);
    const auto everything = run("none")[2];
    const auto picture = [&](apps::Platform& platform) {
        apps::Renderer renderer(platform, stage->scene);
        EXPECT_EQ(renderer.has_buffer_objects(), &platform == stage->platform.get());
        renderer.use_paint(apps::Renderer::kBaked, false);
        renderer.set_matrices(v.modelview, v.projection, kWidth, kHeight);
        renderer.clear({0, 0, 0, 1});
        renderer.draw(everything);
        return renderer.read_pixels();
    };
    OldMachine old(*stage->platform);
    EXPECT_EQ(apps::choose_occlusion_test(old), nullptr);
    const auto now = picture(*stage->platform);
    stage->renderer.use_paint(apps::Renderer::kBaked, false);
    EXPECT_EQ(now, picture(old));
    EXPECT_GT(std::count_if(now.begin(), now.end(), [](std::uint32_t p) { return (p & 0xFFFFFF) != 0; }),
              kWidth * kHeight / 4);
}

}  // namespace
