// SPDX-License-Identifier: MIT
// Builds a world.
#include "apps/hierarchy/world.h"

#include "apps/hierarchy/bvh.h"
#include "apps/hierarchy/kd_tree.h"

namespace apps {

World make_world(const Scene& scene, TreeKind kind, std::size_t leaves) {
    World world;
    world.tree = kind == TreeKind::kBvh ? build_bvh(scene, {.leaves = leaves}) : build_kd_tree(scene, leaves);
    world.scene = in_leaf_order(scene, world.tree);
    return world;
}

World make_world(std::string_view scene_name, double scale, std::uint64_t seed) {
    const SceneRecipe& recipe = *find_scene(scene_name);
    const Scene scene = recipe.build(scale, seed);
    return make_world(scene, recipe.tree, leaf_count(recipe, scene));
}

}  // namespace apps
