// SPDX-License-Identifier: MIT
// A kD-tree over the objects of a scene, built by the surface-area heuristic (MacDonald, Booth: Heuristics
// for ray tracing using space subdivision, 1990), as the CHC paper uses it. Linear layout: a node's lower
// child follows it. An object that straddles a plane is listed in the leaves on both sides: whoever draws
// stamps what is drawn. A node's box is the union of (object's box, cut to the cell): every part of every
// object within the cell is inside.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "apps/scene/scene.h"

namespace apps {

using NodeId = std::uint32_t;  // index into KdTree::nodes; the root is 0

struct KdNode {
    Box box;
    float split = 0;        // metres on the axis; children: coordinates <= split, coordinates >= split
    std::uint8_t axis = 0;  // 0..2
    bool is_leaf = true;
    NodeId upper = 0;         // interior: the child above the plane; the one below is the next node
    std::uint32_t first = 0;  // leaf: range in KdTree::leaf_objects
    std::uint32_t count = 0;
};

struct KdTree {
    std::vector<KdNode> nodes;
    std::vector<ObjectId> leaf_objects;

    std::span<const ObjectId> objects_of(const KdNode& leaf) const {
        return std::span(leaf_objects).subspan(leaf.first, leaf.count);
    }
    std::size_t leaf_count() const { return (nodes.size() + 1) / 2; }
};

/// Splits the leaf that gains most until `leaves` leaves exist or none gains. A scene without objects gives
/// one leaf.
KdTree build_kd_tree(const Scene& scene, std::size_t leaves);

/// The leaves that the paper's tree has for so many triangles: 33,195 nodes for 1,036,146, about 62 in a
/// leaf.
std::size_t paper_leaf_count(std::uint64_t triangles);

/// The scene with its objects in the order of the leaves, so that a leaf is mostly one draw call; renames in
/// `tree`.
Scene in_leaf_order(const Scene& scene, KdTree& tree);

}  // namespace apps
