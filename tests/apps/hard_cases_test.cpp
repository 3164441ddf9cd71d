// SPDX-License-Identifier: MIT
// The cases in which an occlusion test by hardware tends to lie, each judged by the item buffer: nothing that
// owns a sample may be culled. Numbers as in the project's list of hard cases: 1 near plane, 2 eye in the
// box.
#include "gl_fixture.h"

#include "apps/scene/random.h"

namespace {

using apps::Camera;
using apps::Lens;
using apps::Scene;
using apps::View;
using apps_test::Stage;

/// False culls of stop-and-wait over the two leaves, and whether the second object was visible at all.
struct Outcome {
    std::uint32_t false_culls;
    bool is_visible;
};

Outcome walk(Stage& stage, const apps::KdTree& tree, const View& view) {
    stage.start(view);
    apps::Frame frame(0, stage.scene, tree, view, stage.canvas);
    apps::make_stop_and_wait({{"proxy_growth", apps::kSafeGrowthPixels}})->draw(frame);
    const apps::Truth truth = stage.oracle.look(view);
    const bool is_visible = std::find(truth.visible.begin(), truth.visible.end(), 1U) != truth.visible.end();
    return {stage.oracle.judge(view, truth, frame.drawn).false_culls, is_visible};
}

/// A screen just beyond the near plane, and a long box that reaches from before it to far behind it: once the
/// near plane has cut the box's front away, all that is left of the box is hidden, but not what is in it.
Scene screen_and_long_box(float near_metres) {
    Scene scene;
    apps::MeshBuilder mesh(scene);
    apps_test::add_screen(mesh, near_metres * 1.1F, 4, 4);
    mesh.standing_box({0, -0.02F, -0.02F}, {4, 0.02F, 0.02F}, {1, 1, 1});
    mesh.finish();
    return scene;
}

TEST(Case1, a_box_that_slides_through_the_near_plane_loses_nothing) {
    constexpr float kNear = 1;
    Stage stage(screen_and_long_box(kNear), 64, 48);
    const apps::KdTree tree = apps_test::two_leaves(stage.scene);
    int visible = 0;
    for (int step = 0; step <= 1024; ++step) {
        // The near plane goes from 0.5 m before the box to 0.5 m into it, off axis by a little.
        const float back = kNear + 0.5F - static_cast<float>(step) / 1024;
        const View view({{-back, 0.013F, 0.007F}, {1, 0, 0}, Lens{60, kNear, 100}}, 64, 48);
        const Outcome outcome = walk(stage, tree, view);
        ASSERT_EQ(outcome.false_culls, 0U) << "eye at " << -back;
        visible += outcome.is_visible;
    }
    EXPECT_GT(visible, 500) << "hardly anything was at stake";
}

TEST(Case1, the_same_box_would_be_lost_if_it_were_asked_about_once_it_is_cut) {
    constexpr float kNear = 1;
    Stage stage(screen_and_long_box(kNear), 64, 48);
    const View view({{-0.95F, 0, 0}, {1, 0, 0}, Lens{60, kNear, 100}}, 64, 48);
    stage.start(view);
    const apps::ObjectId screen = 0;
    stage.canvas.draw({&screen, 1});
    EXPECT_FALSE(apps::proxy_of(view, stage.scene.objects[1].box, 0.5F));
    const apps::Truth truth = stage.oracle.look(view);
    EXPECT_EQ(truth.visible.size(), 2U);
}

TEST(Case2, an_eye_in_or_near_a_box_loses_nothing) {
    constexpr float kNear = 0.5F;
    Scene scene;
    apps::MeshBuilder mesh(scene);
    apps_test::add_screen(mesh, 9, 0.5F, 0.5F);
    for (const float side : {-1.0F, 1.0F}) {  // a room: two walls of quads that face each other
        mesh.quad({-2, side * 2, -2}, {2, side * 2, -2}, {2, side * 2, 2}, {-2, side * 2, 2}, {1, 1, 1});
        mesh.quad({side * 2, -2, -2}, {side * 2, 2, -2}, {side * 2, 2, 2}, {side * 2, -2, 2}, {1, 1, 1});
        mesh.quad({-2, -2, side * 2}, {2, -2, side * 2}, {2, 2, side * 2}, {-2, 2, side * 2}, {1, 1, 1});
    }
    mesh.finish();
    Stage stage(std::move(scene), 64, 36);
    const apps::KdTree tree = apps_test::two_leaves(stage.scene);
    int visible = 0;
    for (const float k :
         {-4.0F, 0.0F, 1.0F, 1.22F, 1.54F, 2.27F})  // near distances outside a face; -4: the centre
        for (int axis = 0; axis < 3; ++axis)
            for (const float sign : {-1.0F, 1.0F})
                for (int turn = 0; turn < 8; ++turn) {
                    glm::vec3 eye(0.01F);
                    eye[axis] = sign * (2 + k * kNear);
                    const float angle = static_cast<float>(turn) * 0.785398F;
                    const glm::vec3 forward = glm::normalize(
                        glm::vec3(std::cos(angle), std::sin(angle), 0.3F - 0.1F * static_cast<float>(turn)));
                    const View view({eye, forward, Lens{90, kNear, 100}}, 64, 36);
                    const Outcome outcome = walk(stage, tree, view);
                    EXPECT_EQ(outcome.false_culls, 0U) << "k " << k << " axis " << axis << " turn " << turn;
                    visible += outcome.is_visible;
                }
    EXPECT_GT(visible, 150);
}

}  // namespace
