// SPDX-License-Identifier: MIT
// The lazy occlusion grid and its rivals on GL: judged by the oracle where the camera jumps, on a screen that
// is a multiple of no tile, over both kinds of tree; and against each other.
#include "gl_fixture.h"

#include <algorithm>
#include <map>

#include "apps/hierarchy/bvh.h"
#include "apps/hierarchy/kd_tree.h"
#include "apps/scene/random.h"
#include "apps/scene/scenes.h"

namespace {

using apps::KnobValues;
using apps::ObjectId;
using apps::View;
using apps_test::Stage;

struct Size {
    int width, height;
};
constexpr Size kSizes[] = {{320, 240}, {333, 241}};

struct Variant {
    std::string_view culler;
    KnobValues knobs;
};
const Variant kVariants[] = {
    {"log-state", {}},
    {"log-state", {{"tile", 8}, {"parallel", 1}}},
    {"log-state", {{"tile", 128}}},
    {"log-zfar", {}},
    {"log-zfar", {{"tile", 8}}},
    {"log-zfar", {{"tile", 50}, {"parallel", 1}}},
    {"log-coherent", {}},
    {"log-coherent", {{"batch", 1}, {"retest", 3}}},
    {"log-coherent", {{"tile", 8}, {"batch", 1024}}},
    {"bog", {}},
    {"bog", {{"tile", 21}, {"parallel", 1}}},
    {"hzb", {}},
    {"pq", {}},
};

std::string name_of(const Variant& variant) {
    std::string name(variant.culler);
    for (const auto& [knob, value] : variant.knobs) name += " " + knob + "=" + std::to_string(value);
    return name;
}

struct Drawn {
    std::vector<ObjectId> objects;  // in the order of drawing
    apps::Counters counters;
    std::uint64_t hidden_pixels;  // of pq
};

Drawn draw(Stage& stage, apps::Machine& machine, apps::Culler& culler, const apps::Tree& tree,
           const View& view) {
    stage.start(view);
    apps::GlCanvas canvas(stage.renderer, machine);
    apps::Frame frame(0, stage.scene, tree, view, canvas);
    culler.draw(frame);
    stage.renderer.finish();
    culler.settle(frame);
    std::uint64_t hidden_pixels = 0;
    for (const apps::Statistic* statistic : apps::Statistic::all())
        if (statistic->name() == "hidden_pixels") hidden_pixels = frame.tally.of(*statistic);
    return {frame.drawn, canvas.counters(), hidden_pixels};
}
Drawn draw(Stage& stage, apps::Culler& culler, const apps::Tree& tree, const View& view) {
    return draw(stage, stage.machine, culler, tree, view);
}

/// A city under two trees, looked at in jumps along its path, from a stop, and from among the houses, where
/// no path leads.
struct City {
    City() {
        for (const int frame : {0, 5, 1, 1, 6, 2}) cameras.push_back(scene.path.frame(frame, 7));
        apps::Random random(11);
        for (int k = 0; k < 5; ++k) {
            const auto house = static_cast<std::size_t>(random.below(static_cast<int>(scene.objects.size())));
            apps::Camera camera = cameras.front();
            camera.eye = scene.objects[house].box.max + glm::vec3(0.3F, 0.2F, 0);
            camera.forward = glm::normalize(glm::vec3{random.between(-1, 1), random.between(-1, 1), 0.05F});
            cameras.push_back(camera);
        }
    }
    std::vector<View> views(const Size& size) const {
        std::vector<View> result;
        for (const apps::Camera& camera : cameras) result.emplace_back(camera, size.width, size.height);
        return result;
    }

    apps::Scene scene = apps::build_chc_city(0.05, 5);
    std::vector<apps::Tree> trees{apps::build_kd_tree(scene, 500), apps::build_bvh(scene, {.leaves = 500})};
    std::vector<apps::Camera> cameras;
};

const City& city() {
    static const City kCity;
    return kCity;
}

TEST(OcclusionGrids, leave_out_nothing_visible_wherever_the_camera_jumps) {
    for (const Size& size : kSizes) {
        Stage stage(city().scene, size.width, size.height);
        const std::vector<View> views = city().views(size);
        std::vector<apps::Truth> truths;
        for (const View& view : views) truths.push_back(stage.oracle.look(view));
        for (const apps::Tree& tree : city().trees)
            for (const Variant& variant : kVariants) {
                const auto culler = apps::make_culler(variant.culler, variant.knobs);
                std::size_t drawn = 0;
                std::size_t visible = 0;
                for (std::size_t i = 0; i < views.size(); ++i) {
                    const Drawn frame = draw(stage, *culler, tree, views[i]);
                    const apps::Verdict verdict = stage.oracle.judge(views[i], truths[i], frame.objects);
                    ASSERT_EQ(verdict.false_culls, 0U) << name_of(variant) << ", view " << i;
                    ASSERT_EQ(verdict.wrong_pixels, 0U) << name_of(variant) << ", view " << i;
                    drawn += frame.objects.size();
                    visible += truths[i].visible.size();
                }
                EXPECT_GT(visible, 500U);
                EXPECT_LT(drawn, views.size() * city().scene.objects.size() / 4) << "it culls at all";
            }
    }
}

/// The paper's table 1: one number of triangles in every row. Here, one order of objects.
TEST(OcclusionGrids, of_the_state_version_draw_what_the_pyramid_and_pixel_queries_draw_and_read_less) {
    for (const Size& size : kSizes) {
        Stage stage(city().scene, size.width, size.height);
        for (const apps::Tree& tree : city().trees) {
            std::map<std::string, std::uint64_t> pixels;
            std::uint64_t hidden_pixels = 0;
            for (const View& view : city().views(size)) {
                const auto reference = draw(stage, *apps::make_culler("log-state"), tree, view).objects;
                EXPECT_GT(reference.size(), 10U);
                for (const Variant& variant : kVariants) {
                    if (variant.culler == "log-zfar" || variant.culler == "log-coherent") continue;
                    const Drawn frame =
                        draw(stage, *apps::make_culler(variant.culler, variant.knobs), tree, view);
                    EXPECT_EQ(frame.objects, reference) << name_of(variant);
                    pixels[name_of(variant)] += frame.counters.pixels_read;
                    hidden_pixels += frame.hidden_pixels;
                }
            }
            EXPECT_GT(hidden_pixels, 0U);
            for (const auto& [name, count] : pixels) EXPECT_GE(count, hidden_pixels) << name;
            for (const char* rival : {"bog", "hzb", "pq"})
                EXPECT_LT(2 * pixels.at("log-state"), pixels.at(rival)) << rival;
        }
    }
}

TEST(OcclusionGrids, of_the_zfar_version_draw_no_more_than_those_of_the_state_version) {
    Stage stage(city().scene, 320, 240);
    std::size_t state = 0;
    std::size_t zfar = 0;
    for (const View& view : city().views({320, 240})) {
        state += draw(stage, *apps::make_culler("log-state"), city().trees.front(), view).objects.size();
        zfar += draw(stage, *apps::make_culler("log-zfar"), city().trees.front(), view).objects.size();
    }
    EXPECT_LE(zfar, state);
}

/// A wall, and a post behind it that shows from the side.
TEST(CoherentGrid, draws_what_was_visible_once_more_and_then_leaves_it_out) {
    apps::Scene scene;
    apps::MeshBuilder mesh(scene);
    apps_test::add_screen(mesh, 5, 4, 4);
    apps_test::add_screen(mesh, 9, 0.5F, 0.5F);
    Stage stage(std::move(scene), 96, 64);
    const apps::Tree tree = apps_test::two_leaves(stage.scene);
    const View ahead({apps::Camera{{0, 0, 0}, {1, 0, 0}, apps::Lens{70, 0.3F, 100}}, 96, 64});
    const View aside({apps::Camera{{7, 12, 0}, {0, -1, 0}, apps::Lens{70, 0.3F, 100}}, 96, 64});
    ASSERT_EQ(stage.oracle.look(ahead).visible, std::vector<ObjectId>{0});
    ASSERT_EQ(stage.oracle.look(aside).visible.size(), 2U);
    const auto culler = apps::make_culler("log-coherent", {{"batch", 1}});
    const auto count = [&](const View& view) { return draw(stage, *culler, tree, view).objects.size(); };
    EXPECT_EQ(count(ahead), 1U) << "the first frame goes front to back";
    EXPECT_EQ(count(aside), 2U);
    EXPECT_EQ(count(ahead), 2U) << "visible in the last frame: drawn untested";
    EXPECT_EQ(count(ahead), 1U) << "but tested then";
    EXPECT_EQ(count(aside), 2U);
    culler->restart();
    EXPECT_EQ(count(ahead), 1U) << "nothing is remembered over a restart";
}

/// Run on a machine that has GL_EMU_depth_region_query and answers about many regions in a call.
TEST(RegionQueries, cull_as_depths_read_back_do_and_wait_once_for_many_tiles) {
    constexpr Size kSize{333, 241};
    constexpr int kFrames = 6;
    Stage stage(city().scene, kSize.width, kSize.height);
    apps::Machine queries{nullptr, nullptr,
                          choose_depth_regions(*stage.platform, "GL_EMU_depth_region_query"), nullptr};
    apps::Machine reading{nullptr, nullptr, choose_depth_regions(*stage.platform, "glReadPixels"), nullptr};
    ASSERT_TRUE(queries.regions) << "run it under the emulator";
    std::map<std::string, apps::Counters> sums;
    for (const Variant& variant : kVariants) {
        const auto culler = apps::make_culler(variant.culler, variant.knobs);
        const auto same = apps::make_culler(variant.culler, variant.knobs);
        apps::Counters& sum = sums[name_of(variant)];
        for (int frame = 0; frame < kFrames; ++frame) {
            const View view(city().scene.path.frame(40 + frame, 200), kSize.width, kSize.height);
            const Drawn asked = draw(stage, queries, *culler, city().trees.front(), view);
            const Drawn read = draw(stage, reading, *same, city().trees.front(), view);
            EXPECT_EQ(asked.objects, read.objects) << name_of(variant);
            EXPECT_EQ(asked.counters.pixels_read, read.counters.pixels_read) << name_of(variant);
            sum.region_waits += asked.counters.region_waits;
            sum.pixels_read += asked.counters.pixels_read;
        }
    }
    EXPECT_LT(4 * sums.at("log-coherent").region_waits, sums.at("log-state").region_waits);
}

}  // namespace
