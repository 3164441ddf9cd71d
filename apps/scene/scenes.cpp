// SPDX-License-Identifier: MIT
// The one list of scenes.
#include "apps/scene/scenes.h"

#include <algorithm>
#include <cmath>

namespace apps {

std::span<const SceneRecipe> scenes() {
    static constexpr SceneRecipe kScenes[] = {
        // "In the forest scene each tree is an object with an own bounding box."
        {"log-forest", kLogForestTriangles, 8'185, 0, TreeKind::kBvh,
         "Hey, Tobler, Purgathofer: Real-Time Occlusion Culling with a Lazy Occlusion Grid, 2001", 0.01, 4,
         build_log_forest},
        // "until each bounding box contains no more than 1500 triangles": so does each object.
        {"log-city", kLogCityTriangles, 36'864, 0, TreeKind::kBvh,
         "Hey, Tobler, Purgathofer: Real-Time Occlusion Culling with a Lazy Occlusion Grid, 2001", 1.0 / 512,
         2, build_log_city},
        // Leaves of the CHC scenes: the paper's table 1 tells nodes, of which leaves of empty space are a
        // part; ours have none. Leaves with something in them follow from table 2: asked about in every
        // third frame, visible ones save two thirds of their queries, so 1.5 x (345 - 192) of them hold the
        // 31,034 triangles drawn of the city, 135 each; of the plant 1,936 each. The teapots, close together,
        // get all 21,639 nodes: stop-and-wait then asks about as often as in table 1.
        {"chc-city", kChcCityTriangles, 54'428, 7'662, TreeKind::kKdTree,
         "Bittner, Wimmer, Piringer, Purgathofer: Coherent Hierarchical Culling, 2004", 0.01, 16,
         build_chc_city},
        {"chc-teapots", kChcTeapotsTriangles, 20'000, 10'820, TreeKind::kKdTree,
         "Bittner, Wimmer, Piringer, Purgathofer: Coherent Hierarchical Culling, 2004", 0.003, 4,
         build_chc_teapots},
        {"chc-plant", kChcPlantTriangles, 23'723, 6'585, TreeKind::kKdTree,
         "proxy of the UNC power plant of Bittner, Wimmer, Piringer, Purgathofer: Coherent Hierarchical "
         "Culling, 2004",
         0.003, 4, build_chc_plant},
    };
    return kScenes;
}

const SceneRecipe* find_scene(std::string_view name) {
    const auto all = scenes();
    const auto it =
        std::find_if(all.begin(), all.end(), [&](const SceneRecipe& s) { return s.name == name; });
    return it == all.end() ? nullptr : &*it;
}

std::size_t leaf_count(const SceneRecipe& recipe, const Scene& scene) {
    if (recipe.leaves == 0) return std::max<std::size_t>(1, scene.objects.size());
    const double leaves =
        static_cast<double>(scene.triangle_count()) * recipe.leaves / static_cast<double>(recipe.triangles);
    return std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(leaves)));
}

}  // namespace apps
