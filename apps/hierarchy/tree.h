// SPDX-License-Identifier: MIT
// What contains what: a binary tree of boxes over the objects of a scene, whichever builder made it. Linear
// layout: a node's lower child follows it, so a node's subtree is a run of nodes. A node's box encloses every
// part of every object that its subtree answers for.
//
// Of a kD-tree the children of a node lie on the two sides of a plane, an object that straddles it is listed
// on both sides, cut by both boxes: whoever draws stamps what is drawn. Of a bounding volume hierarchy each
// object is listed once and boxes may overlap.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "apps/scene/scene.h"

namespace apps {

using NodeId = std::uint32_t;  // index into Tree::nodes; the root is 0
inline constexpr NodeId kNoNode = ~NodeId{0};

struct Node {
    static constexpr std::uint8_t kNoPlane = 3;

    Box box;
    float split = 0;               // metres on the axis; children: coordinates <= split, coordinates >= split
    std::uint8_t axis = kNoPlane;  // 0..2 where a plane parts the children
    bool is_leaf = true;
    NodeId upper = 0;         // interior: the other child; the lower one is the next node
    NodeId parent = kNoNode;  // none of the root
    std::uint32_t first = 0;  // range in Tree::objects: what hangs in this node itself
    std::uint32_t count = 0;  // an interior node may have objects beside its children
};

struct Tree {
    std::vector<Node> nodes;
    std::vector<ObjectId> objects;

    std::span<const ObjectId> objects_of(const Node& node) const {
        return std::span(objects).subspan(node.first, node.count);
    }
    std::size_t leaf_count() const { return (nodes.size() + 1) / 2; }

    /// One past the last node of the subtree of `id`.
    NodeId end_of(NodeId id) const;

    /// Fills in Node::parent everywhere; builders call it last.
    void link_parents();
};

/// The scene with its objects in the order of the nodes, so that a leaf is mostly one draw call; renames in
/// `tree`.
Scene in_leaf_order(const Scene& scene, Tree& tree);

}  // namespace apps
