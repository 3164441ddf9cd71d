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

Outcome walk(Stage& stage, const apps::Tree& tree, const View& view) {
    stage.start(view);
    apps::Frame frame(0, stage.scene, tree, view, stage.canvas);
    apps::make_culler("stop-and-wait")->draw(frame);
    const apps::Truth truth = stage.oracle.look(view);
    const bool is_visible = std::find(truth.visible.begin(), truth.visible.end(), 1U) != truth.visible.end();
    return {stage.oracle.judge(view, truth, frame.drawn).false_culls, is_visible};
}

/// Two specks that make `box` the box of an object, and nothing to see.
void span(apps::MeshBuilder& mesh, const apps::Box& box) {
    constexpr float kSpeck = 1e-3F;
    for (const float inwards : {kSpeck, -kSpeck}) {
        const glm::vec3& corner = inwards > 0 ? box.min : box.max;
        mesh.triangle(corner, corner + glm::vec3(inwards, 0, 0), corner + glm::vec3(0, inwards, 0),
                      {1, 1, 1});
    }
}

/// A quad across `forward`, `half` metres to each side.
void face(apps::MeshBuilder& mesh, const glm::vec3& centre, const glm::vec3& forward, float half) {
    const glm::vec3 right = glm::normalize(glm::cross(forward, glm::vec3(0, 0, 1))) * half;
    const glm::vec3 up = glm::normalize(glm::cross(right, forward)) * half;
    mesh.quad(centre - right - up, centre + right - up, centre + right + up, centre - right + up, {1, 1, 1});
}

/// A screen at 1.1 m; a quad before it at 0.6 m, in an object whose box is wider than the view and ends
/// behind the screen: once the near plane has cut the box's front away, all that is left of the box is
/// hidden, but not the quad.
Scene screen_and_quad() {
    Scene scene;
    apps::MeshBuilder mesh(scene);
    apps_test::add_screen(mesh, 1.1F, 4, 4);
    span(mesh, {{0, -3, -3}, {4, 3, 3}});
    face(mesh, {0.6F, 0, 0}, {1, 0, 0}, 0.05F);
    mesh.finish();
    return scene;
}

TEST(Case1, a_box_that_slides_through_the_near_plane_loses_nothing) {
    constexpr float kNear = 1;
    Stage stage(screen_and_quad(), 64, 48);
    const apps::Tree tree = apps_test::two_leaves(stage.scene);
    int visible = 0;
    for (int step = 0; step <= 1024; ++step) {
        // The near plane goes from 0.44 m before the box to 0.56 m into it; the eye is off axis by a little.
        const float back = kNear + 0.44F - static_cast<float>(step) / 1024;
        const View view({{-back, 0.013F, 0.007F}, {1, 0, 0}, Lens{60, kNear, 100}}, 64, 48);
        const Outcome outcome = walk(stage, tree, view);
        ASSERT_EQ(outcome.false_culls, 0U) << "eye at " << -back;
        visible += outcome.is_visible;
    }
    EXPECT_EQ(visible, 1025) << "the quad is before the screen and beyond the near plane all the way";
}

TEST(Case1, the_machine_would_lie_about_that_box_once_it_is_cut) {
    Stage stage(screen_and_quad(), 64, 48);
    const View view({{-0.8F, 0.013F, 0.007F}, {1, 0, 0}, Lens{60, 1, 100}}, 64, 48);
    stage.start(view);
    const apps::ObjectId screen = 0;
    stage.canvas.draw({&screen, 1});
    EXPECT_FALSE(stage.canvas.is_visible(stage.scene.objects[1].box));
    EXPECT_FALSE(apps::proxy_of(view, stage.scene.objects[1].box, apps::kSafeGrowthPixels));
    EXPECT_EQ(stage.oracle.look(view).visible.size(), 2U);
}

TEST(Case2, an_eye_in_or_near_a_box_loses_nothing) {
    constexpr float kNear = 0.5F;
    const apps::Box box{glm::vec3(-2), glm::vec3(2)};
    int at_stake = 0;
    for (const float k :
         {-4.0F, 0.0F, 1.0F, 1.22F, 1.54F, 2.27F})  // near distances before a face; -4: the centre
        for (int side = 0; side < 6; ++side)
            for (int turn = 0; turn < 8; ++turn) {
                glm::vec3 eye(0.01F);
                eye[side / 2] = (side % 2 ? 1.0F : -1.0F) * (2 + k * kNear);
                const float angle = static_cast<float>(turn) * 0.785398F;
                const glm::vec3 forward = glm::normalize(
                    glm::vec3(std::cos(angle), std::sin(angle), 0.4F - 0.1F * static_cast<float>(turn)));
                // The nearest point straight ahead that is in the box, beyond the near plane; a screen just
                // behind it.
                float ahead = kNear * 1.05F;
                while (ahead < 5 && !box.grown(-0.03F).contains(eye + ahead * forward)) ahead += 0.02F;
                if (ahead >= 5) continue;
                Scene scene;
                apps::MeshBuilder mesh(scene);
                face(mesh, eye + (ahead + 0.05F) * forward, forward, 8);
                mesh.finish();
                span(mesh, box);
                face(mesh, eye + ahead * forward, forward, 0.02F);
                mesh.finish();
                Stage stage(std::move(scene), 64, 36);
                const Outcome outcome = walk(stage, apps_test::two_leaves(stage.scene),
                                             {{eye, forward, Lens{90, kNear, 100}}, 64, 36});
                EXPECT_EQ(outcome.false_culls, 0U) << "k " << k << " side " << side << " turn " << turn;
                at_stake += outcome.is_visible;
            }
    EXPECT_GT(at_stake, 60);
}

}  // namespace
