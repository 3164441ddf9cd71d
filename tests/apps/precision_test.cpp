// SPDX-License-Identifier: MIT
// Cases 4, 5 and 6: boxes smaller than a pixel, geometry on the faces of its box, and depths a step apart.
#include "gl_fixture.h"

#include "apps/scene/random.h"

namespace {

using apps::Box;
using apps::Lens;
using apps::ObjectId;
using apps::Scene;
using apps::View;
using apps_test::Stage;

const View& front_view() {
    static const View view({{0, 0, 0}, {1, 0, 0}, Lens{45, 0.3F, 2000}}, 320, 240);
    return view;
}

/// 10,000 boxes of 0.05 to 2 pixels, spread over the view at 10 to 300 m.
Scene field_of_boxes() {
    Scene scene;
    apps::MeshBuilder mesh(scene);
    apps::Random random(4);
    const View& view = front_view();
    for (int i = 0; i < 10'000; ++i) {
        const float x = random.between(10, 300);
        const float pixel = static_cast<float>(view.pixel_slope) * x;
        const float size = pixel * (0.05F + 1.95F * static_cast<float>(i) / 10'000);
        const glm::vec3 at = x * glm::vec3(1, random.between(-0.5F, 0.5F), random.between(-0.38F, 0.38F));
        mesh.standing_box(at, at + size * glm::vec3(0.2F, 1, 1), {1, 1, 1});
        mesh.finish();
    }
    return scene;
}

/// Boxes that own a sample and whose proxy, in front of nothing, reports none; by size in half pixels.
std::array<int, 4> lost_boxes(Stage& stage, const std::vector<ObjectId>& visible, float growth_pixels) {
    std::array<int, 4> lost{};
    stage.start(front_view());
    for (const ObjectId id : visible) {
        const auto proxy = apps::proxy_of(front_view(), stage.scene.objects[id].box, growth_pixels);
        if (proxy && !stage.canvas.is_visible(*proxy)) ++lost[id / 2500];
    }
    return lost;
}

TEST(Case4, boxes_below_a_pixel_keep_their_samples_when_their_proxies_are_grown) {
    Stage stage(field_of_boxes(), 320, 240);
    // One at a time: what counts is whether the box alone would own a sample.
    std::vector<ObjectId> visible = stage.oracle.look(front_view()).visible;
    ASSERT_GT(visible.size(), 2000U);
    EXPECT_LT(visible.front(), 2500U) << "no box below half a pixel is at stake";
    EXPECT_EQ(lost_boxes(stage, visible, apps::kSafeGrowthPixels), (std::array<int, 4>{}));
}

TEST(Case5, a_cube_that_is_already_drawn_does_not_hide_its_own_box) {
    for (int axis = 0; axis < 3; ++axis)
        for (const float sign : {-1.0F, 1.0F})
            for (const float distance : {3.0F, 30.0F, 300.0F}) {
                Scene scene;
                apps::MeshBuilder mesh(scene);
                mesh.hanging_box({-1, -1, -1}, {1, 1, 1}, {1, 1, 1});
                mesh.finish();
                Stage stage(std::move(scene), 256, 256);
                glm::vec3 eye(0.03F, 0.02F, 0.01F);
                eye[axis] += sign * distance;
                glm::vec3 forward = -eye;
                forward.x += 1e-3F;  // never straight up or down
                const View view({eye, glm::normalize(forward), Lens{45, 0.3F, 2000}}, 256, 256);
                stage.start(view);
                const ObjectId cube = 0;
                stage.canvas.draw({&cube, 1});
                for (const float growth :
                     {0.0F, apps::kSafeGrowthPixels}) {  // 0: by LEQUAL and the offset alone
                    const auto proxy = apps::proxy_of(view, stage.scene.objects[0].box, growth);
                    ASSERT_TRUE(proxy);
                    EXPECT_TRUE(stage.canvas.is_visible(*proxy))
                        << "axis " << axis << " from " << sign * distance;
                }
            }
}

TEST(Case6, a_quad_within_steps_of_depth_of_what_is_drawn_keeps_its_samples) {
    int at_stake = 0;
    for (const float x : {5.0F, 50.0F, 500.0F}) {
        // 24 bit: one step is x^2 / (near * 2^24) metres, where near << x << far.
        const float step = x * x / (0.3F * 16'777'216);
        for (const float steps : {-4.0F, -2.0F, -1.0F, -0.5F, -0.25F, 0.0F, 0.25F, 0.5F, 1.0F, 2.0F, 4.0F}) {
            Scene scene;
            apps::MeshBuilder mesh(scene);
            // Turned against each other, so that the two are triangulated differently and round differently.
            apps_test::add_screen(mesh, x, 0.2F * x, 0.2F * x);
            const float near = x - steps * step;
            mesh.quad({near, 0.1F * x, -0.1F * x}, {near, 0.11F * x, 0.1F * x}, {near, -0.1F * x, 0.1F * x},
                      {near, -0.1F * x, -0.11F * x}, {1, 1, 1});
            mesh.finish();
            Stage stage(std::move(scene), 320, 240);
            const auto truth = stage.oracle.look(front_view());
            const bool is_visible =
                std::find(truth.visible.begin(), truth.visible.end(), 1U) != truth.visible.end();
            at_stake += is_visible;
            stage.start(front_view());
            const ObjectId screen = 0;
            stage.canvas.draw({&screen, 1});
            for (const float growth : {0.0F, apps::kSafeGrowthPixels}) {
                const auto proxy = apps::proxy_of(front_view(), stage.scene.objects[1].box, growth);
                ASSERT_TRUE(proxy);
                EXPECT_TRUE(stage.canvas.is_visible(*proxy) || !is_visible)
                    << x << " m, " << steps << " steps";
            }
        }
    }
    EXPECT_GE(at_stake, 12) << "nothing nearer than the screen was visible";
}

}  // namespace
