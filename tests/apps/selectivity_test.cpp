// SPDX-License-Identifier: MIT
// The generated city and its walk cull as the paper's do: time depends on these shares more than on the
// total.
#include "gl_fixture.h"

#include "apps/culling/culler.h"
#include "apps/hierarchy/world.h"

namespace {

using apps_test::Stage;

TEST(City, has_the_shares_of_the_paper_in_the_frustum_and_in_view) {
    constexpr int kFrames = 30;
    const auto [scene, tree] = apps::make_world("chc-city", 1, 1);
    Stage stage(scene, 640, 480);
    double frustum = 0;
    double drawn = 0;
    for (int index = 0; index < kFrames; ++index) {
        const apps::View view(stage.scene.path.frame(index, kFrames), 640, 480);
        stage.start(view);
        apps::Frame all(index, stage.scene, tree, view, stage.canvas);
        apps::make_culler("frustum")->draw(all);
        stage.start(view);
        apps::Frame seen(index, stage.scene, tree, view, stage.canvas);
        apps::make_culler("stop-and-wait")->draw(seen);
        frustum += static_cast<double>(apps::triangles_of(stage.scene, all.drawn));
        drawn += static_cast<double>(apps::triangles_of(stage.scene, seen.drawn));
    }
    const double total = kFrames * 1'036'146.0;
    std::printf(
        "frustum %.1f %% of the city, drawn %.1f %% of the frustum, %.2f %% of the city; the paper: 15.1, "
        "19.5, 2.95\n",
        100 * frustum / total, 100 * drawn / frustum, 100 * drawn / total);
    // CHC paper, table 1: 156,521 triangles in the frustum and 30,594 drawn. A sixth of it: 30 frames are a
    // sample.
    EXPECT_NEAR(frustum / kFrames, 156'521, 156'521 / 6.0);
    EXPECT_NEAR(drawn / kFrames, 30'594, 30'594 / 6.0);
}

}  // namespace
