// SPDX-License-Identifier: MIT
// A scene and the tree over it, objects in the order of the tree: what a walk needs to know of the world.
#pragma once

#include "apps/hierarchy/tree.h"
#include "apps/scene/scenes.h"

namespace apps {

struct World {
    Scene scene;
    Tree tree;
};

/// A tree of at most `leaves` leaves over the scene.
World make_world(const Scene& scene, TreeKind kind, std::size_t leaves);

/// A scene of the list under the tree of its paper.
World make_world(std::string_view scene_name, double scale, std::uint64_t seed);

}  // namespace apps
