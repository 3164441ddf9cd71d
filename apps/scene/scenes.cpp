// SPDX-License-Identifier: MIT
// The one list of scenes.
#include "apps/scene/scenes.h"

#include <algorithm>
#include <cmath>

namespace apps {

std::span<const SceneRecipe> scenes() {
    static constexpr SceneRecipe kScenes[] = {
        // Leaves: 33,195 nodes in the paper's table 1.
        {"chc-city", kChcCityTriangles, 54'428, 7'790, TreeKind::kKdTree,
         "Bittner, Wimmer, Piringer, Purgathofer: Coherent Hierarchical Culling, 2004", 0.01, 16,
         build_chc_city},
        // Leaves: 21,639 nodes.
        {"chc-teapots", kChcTeapotsTriangles, 10'000, 10'820, TreeKind::kKdTree,
         "Bittner, Wimmer, Piringer, Purgathofer: Coherent Hierarchical Culling, 2004", 0.001, 4,
         build_chc_teapots},
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
