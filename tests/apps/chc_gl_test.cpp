// SPDX-License-Identifier: MIT
// Coherent cullers on GL, in every variant, where coherence fails: cuts from view to view, an eye inside of
// things; and the variants that may leave something out, by how much.
#include "gl_fixture.h"

#include <algorithm>

#include "apps/hierarchy/bvh.h"
#include "apps/hierarchy/kd_tree.h"
#include "apps/scene/random.h"
#include "apps/scene/scenes.h"

namespace {

using apps::KnobValues;
using apps::ObjectId;
using apps::View;
using apps_test::Stage;

constexpr int kWidth = 320;
constexpr int kHeight = 240;
constexpr int kViews = 7;

struct Variant {
    std::string_view culler;
    KnobValues knobs;
};

const Variant kVariants[] = {
    {"chc", {}},
    {"chc", {{"traversal", 1}}},
    {"chc", {{"t_av", 2}}},
    {"chc", {{"t_av", 8}, {"t_av_mode", 1}}},
    {"chc", {{"t_av", 8}, {"t_av_mode", 2}, {"traversal", 1}}},
    {"chc", {{"t_av", 8}, {"t_av_mode", 3}}},
    {"chc", {{"speculate", 1000}}},
    {"chc++", {}},
    {"chc++", {{"t_av", 0}, {"batch", 1}, {"tight_depth", 0}}},
    {"chc++", {{"t_av_mode", 3}, {"tight_depth", 6}, {"tight_area", 4}, {"many_cost", 3}}},
    {"conditional", {}},
    {"conditional", {{"mode", 1}, {"hierarchical", 0}}},
    {"conditional", {{"mode", 2}, {"coherent", 0}}},
    {"conditional", {{"mode", 3}}},
};

std::string name_of(const Variant& variant) {
    std::string name(variant.culler);
    for (const auto& [knob, value] : variant.knobs) name += " " + knob + "=" + std::to_string(value);
    return name;
}

/// Two trees over one city.
struct CoherentCullers : testing::Test {
    static void SetUpTestSuite() {
        apps::Scene scene = apps::build_chc_city(0.05, 3);
        trees = new std::vector{apps::build_kd_tree(scene, 400), apps::build_bvh(scene, {.leaves = 400})};
        stage = new Stage(std::move(scene), kWidth, kHeight);
    }
    static void TearDownTestSuite() {
        delete stage;
        delete trees;
        stage = nullptr;
        trees = nullptr;
    }

    static View on_path(int index) { return {stage->scene.path.frame(index, kViews), kWidth, kHeight}; }

    static std::vector<ObjectId> draw(apps::Culler& culler, const apps::Tree& tree, const View& view) {
        stage->start(view);
        apps::Frame frame(0, stage->scene, tree, view, stage->canvas);
        culler.draw(frame);
        stage->renderer.finish();
        culler.settle(frame);
        std::vector<ObjectId> drawn = frame.drawn;
        std::sort(drawn.begin(), drawn.end());
        EXPECT_EQ(std::adjacent_find(drawn.begin(), drawn.end()), drawn.end()) << "drawn twice";
        return drawn;
    }

    static Stage* stage;
    static std::vector<apps::Tree>* trees;
};
Stage* CoherentCullers::stage = nullptr;
std::vector<apps::Tree>* CoherentCullers::trees = nullptr;

/// Case 15: what the last frame found is worth nothing after a cut.
TEST_F(CoherentCullers, leave_out_nothing_visible_after_a_cut_nor_between_two) {
    std::vector<apps::Truth> truths;
    for (int index = 0; index < kViews; ++index) truths.push_back(stage->oracle.look(on_path(index)));
    // Cuts to and fro, in a row and with some frames between: back to what was seen, on to what was not.
    constexpr int kCuts[] = {0, 3, 0, 0, 5, 5, 5, 1, 6, 6, 2, 4, 4, 0};
    for (const apps::Tree& tree : *trees)
        for (const Variant& variant : kVariants) {
            const auto culler = apps::make_culler(variant.culler, variant.knobs);
            std::size_t drawn_objects = 0;
            std::size_t visible = 0;
            for (const int index : kCuts) {
                const std::vector<ObjectId> drawn = draw(*culler, tree, on_path(index));
                const apps::Truth& truth = truths[static_cast<std::size_t>(index)];
                const apps::Verdict verdict = stage->oracle.judge(on_path(index), truth, drawn);
                ASSERT_EQ(verdict.false_culls, 0U) << name_of(variant) << ", view " << index;
                ASSERT_EQ(verdict.wrong_pixels, 0U) << name_of(variant) << ", view " << index;
                drawn_objects += drawn.size();
                visible += truth.visible.size();
            }
            EXPECT_GT(visible, 500U);
            EXPECT_LT(drawn_objects, 14 * stage->scene.objects.size() / 4) << "it culls at all";
        }
}

/// Cases 1 and 2: from one eye to the next inside of things, each looked out of twice.
TEST_F(CoherentCullers, leave_out_nothing_visible_from_inside_of_things) {
    std::vector<View> views;
    std::vector<apps::Truth> truths;
    apps::Random random(11);
    while (views.size() < 8) {
        const apps::Object& object = stage->scene.objects[static_cast<std::size_t>(
            random.below(static_cast<int>(stage->scene.objects.size())))];
        const glm::vec3 size = object.box.max - object.box.min;
        const glm::vec3 eye = object.box.min + size * glm::vec3(random.unit(), random.unit(), random.unit());
        const glm::vec3 forward = glm::normalize(
            glm::vec3(random.between(-1, 1), random.between(-1, 1), random.between(-0.3F, 0.3F)));
        const View view({eye, forward, stage->scene.path.camera(0).lens}, kWidth, kHeight);
        const apps::Truth truth = stage->oracle.look(view);
        if (truth.visible.size() < 5) continue;  // in the ground
        views.push_back(view);
        truths.push_back(truth);
    }
    for (const Variant& variant : kVariants) {
        const auto culler = apps::make_culler(variant.culler, variant.knobs);
        for (std::size_t i = 0; i < views.size(); ++i)
            for (int again = 0; again < 2; ++again) {
                const std::vector<ObjectId> drawn = draw(*culler, trees->front(), views[i]);
                const apps::Verdict verdict = stage->oracle.judge(views[i], truths[i], drawn);
                ASSERT_EQ(verdict.false_culls, 0U) << name_of(variant) << ", view " << i;
            }
    }
}

/// The paper's section 4.3: "In a static scenario, we achieve exactly the same visibility classification".
TEST_F(CoherentCullers, called_chc_draw_what_stop_and_wait_draws_where_nothing_moves) {
    for (const int index : {1, 4})
        for (const apps::Tree& tree : *trees) {
            const auto waiting = apps::make_culler("stop-and-wait");
            const std::vector<ObjectId> expected = draw(*waiting, tree, on_path(index));
            const auto chc = apps::make_culler("chc");
            for (int frame = 0; frame < 4; ++frame) {
                const std::vector<ObjectId> drawn = draw(*chc, tree, on_path(index));
                if (frame >= 2) {
                    EXPECT_EQ(drawn, expected) << "view " << index << ", frame " << frame;
                }
            }
        }
}

/// Section 5.2: a node that is left out has at most n_vp visible pixels, an object at most those of the
/// leaves that list it. More pixels need not be lost where more may be: what is left out hides nothing.
TEST_F(CoherentCullers, lose_no_more_pixels_than_n_vp_allows) {
    const apps::Tree& tree = trees->front();
    std::vector<std::uint32_t> leaves(stage->scene.objects.size(), 0);
    for (const ObjectId id : tree.objects) ++leaves[id];
    for (const std::string_view name : {"chc", "chc++"}) {
        std::uint32_t at_most = 0;  // where n_vp is largest
        for (const double n_vp : {0, 5, 50, 500}) {
            const auto culler = apps::make_culler(name, {{"n_vp", n_vp}});
            std::uint32_t wrong = 0;
            for (int index = 0; index < kViews; ++index) {
                const apps::Truth truth = stage->oracle.look(on_path(index));
                const std::vector<ObjectId> drawn = draw(*culler, tree, on_path(index));
                std::vector<ObjectId> lost;
                std::set_difference(truth.visible.begin(), truth.visible.end(), drawn.begin(), drawn.end(),
                                    std::back_inserter(lost));
                double allowed = 0;
                for (const ObjectId id : lost) allowed += n_vp * leaves[id];
                const std::uint32_t pixels = stage->oracle.judge(on_path(index), truth, drawn).wrong_pixels;
                EXPECT_LE(pixels, allowed) << name << ", n_vp " << n_vp << ", view " << index;
                wrong += pixels;
            }
            if (n_vp == 0) {
                EXPECT_EQ(wrong, 0U) << name;
            }
            at_most = wrong;
        }
        EXPECT_GT(at_most, 100U) << name << " at the largest n_vp";
    }
}

}  // namespace
