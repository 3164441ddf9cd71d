// SPDX-License-Identifier: MIT
// The one list of scenes.
#include "apps/scene/scenes.h"

#include <algorithm>

namespace apps {

std::span<const SceneRecipe> scenes() {
    static constexpr SceneRecipe kScenes[] = {
        {"chc-city", kChcCityTriangles,
         "Bittner, Wimmer, Piringer, Purgathofer: Coherent Hierarchical Culling, 2004", 0.01, build_chc_city},
    };
    return kScenes;
}

const SceneRecipe* find_scene(std::string_view name) {
    const auto all = scenes();
    const auto it =
        std::find_if(all.begin(), all.end(), [&](const SceneRecipe& s) { return s.name == name; });
    return it == all.end() ? nullptr : &*it;
}

}  // namespace apps
