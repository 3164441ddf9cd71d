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

/// Askew to all axes: the edges of boxes are never rows or columns of pixels.
const View& skew_view() {
    static const View view({{0, 0, 0}, glm::normalize(glm::vec3(1, 0.7F, 0.5F)), Lens{45, 0.3F, 2000}}, 320,
                           240);
    return view;
}

/// 10,000 flat octagons of 0.05 to 2 pixels, spread over the view at 10 to 300 m. Their long edges lie on the
/// edges of their boxes, but end elsewhere: once corners are rounded to sub-pixels, an edge can leave the
/// box's silhouette.
Scene field_of_octagons() {
    Scene scene;
    apps::MeshBuilder mesh(scene);
    apps::Random random(4);
    const glm::dmat4 to_world = glm::inverse(skew_view().clip);
    for (int i = 0; i < 10'000; ++i) {
        const float distance = random.between(10, 300);
        const glm::dvec4 far = to_world * glm::dvec4(random.between(-1, 1), random.between(-1, 1), 1, 1);
        const glm::vec3 at = distance * glm::normalize(glm::vec3(glm::dvec3(far) / far.w));
        const float size = static_cast<float>(skew_view().pixel_slope) * distance *
                           (0.05F + 1.95F * static_cast<float>(i) / 10'000);
        const float cut = random.between(0.02F, 0.3F);
        const glm::vec2 corners[] = {{cut, 0},     {1 - cut, 0}, {1, cut},     {1, 1 - cut},
                                     {1 - cut, 1}, {cut, 1},     {0, 1 - cut}, {0, cut}};
        const auto corner = [&](int k) { return at + size * glm::vec3(0, corners[k].x, corners[k].y); };
        for (int k = 1; k < 7; ++k) mesh.triangle(corner(0), corner(k), corner(k + 1), {1, 1, 1});
        mesh.finish();
    }
    return scene;
}

/// Objects that own a sample and whose proxy, in front of nothing, reports none; by size in half pixels.
std::array<int, 4> lost_boxes(Stage& stage, const std::vector<ObjectId>& visible, float growth_pixels) {
    std::array<int, 4> lost{};
    stage.start(skew_view());
    for (const ObjectId id : visible) {
        const auto proxy = apps::proxy_of(skew_view(), stage.scene.objects[id].box, growth_pixels);
        if (proxy && !stage.canvas.is_visible(*proxy)) ++lost[id / 2500];
    }
    return lost;
}

TEST(Case4, objects_below_a_pixel_keep_their_samples_because_their_proxies_are_grown) {
    Stage stage(field_of_octagons(), 320, 240);
    const std::vector<ObjectId> visible = stage.oracle.look(skew_view()).visible;
    ASSERT_GT(visible.size(), 2000U);
    EXPECT_LT(visible.front(), 2500U) << "no box below half a pixel is at stake";
    EXPECT_EQ(lost_boxes(stage, visible, apps::kSafeGrowthPixels), (std::array<int, 4>{}));
    const std::array<int, 4> without = lost_boxes(stage, visible, 0);
    EXPECT_GT(without[0] + without[1] + without[2] + without[3], 0) << "the rule was not needed here";
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

/// A wall seen at a flat angle, and diamonds of 1 to 3 pixels on it, `steps` steps of depth before it.
Scene wall_with_diamonds(const View& view, float steps) {
    Scene scene;
    apps::MeshBuilder mesh(scene);
    apps::Random random(9);
    mesh.quad({1, 3, -60}, {900, 3, -60}, {900, 3, 60}, {1, 3, 60}, {0.5F, 0.5F, 0.5F});
    mesh.finish();
    for (int i = 0; i < 300; ++i) {
        const float x = random.between(6, 40);
        const glm::vec3 at(x, 3, random.between(-0.3F, 0.3F) * x);
        // 24 bit: one step is x^2 / (near * 2^24) metres of depth, where near << x << far; the wall's depth
        // falls by x / 3 for every metre towards the eye.
        const float step = x * x / (view.near_metres * 16'777'216);
        const float towards = steps * step * 3 / x;
        const float size = static_cast<float>(view.pixel_slope) * x * random.between(0.5F, 1.5F);
        const glm::vec3 u(size * x / 3, 0, 0);
        const glm::vec3 v(0, 0, size);
        const glm::vec3 middle = at - glm::vec3(0, towards, 0);
        mesh.quad(middle - u, middle - v, middle + u, middle + v, {1, 1, 1});
        mesh.finish();
    }
    return scene;
}

/// Diamonds that own a sample and whose box, as it is, is said to be hidden by the wall; and how many own
/// one.
std::pair<int, int> lost_diamonds(float steps, float growth_pixels) {
    const View view({{0, 0, 0}, glm::normalize(glm::vec3(1, 0.2F, 0)), Lens{45, 0.3F, 2000}}, 320, 240);
    Stage stage(wall_with_diamonds(view, steps), 320, 240);
    const std::vector<ObjectId> visible = stage.oracle.look(view).visible;
    stage.start(view);
    const ObjectId wall = 0;
    stage.canvas.draw({&wall, 1});
    std::pair<int, int> result{0, 0};
    for (const ObjectId id : visible) {
        if (id == wall) continue;
        const auto proxy = apps::proxy_of(view, stage.scene.objects[id].box, growth_pixels);
        result.first += proxy && !stage.canvas.is_visible(*proxy);
        ++result.second;
    }
    return result;
}

TEST(Case6, small_quads_within_steps_of_depth_of_a_wall_keep_their_samples) {
    int at_stake = 0;
    for (const float steps : {-4.0F, -2.0F, -1.0F, -0.5F, -0.25F, 0.0F, 0.25F, 0.5F, 1.0F, 2.0F, 4.0F})
        for (const float growth : {0.0F, apps::kSafeGrowthPixels}) {  // 0: by LEQUAL and the offset alone
            const auto [lost, visible] = lost_diamonds(steps, growth);
            EXPECT_EQ(lost, 0) << "of " << visible << ", " << steps << " steps before the wall, grown by "
                               << growth;
            at_stake += visible;
        }
    EXPECT_GT(at_stake, 1000);
}

}  // namespace
