// SPDX-License-Identifier: MIT
// From the leaves up: the linear layout has children behind their parents, so once backwards through the
// nodes.
#include "apps/hierarchy/refit.h"

namespace apps {
namespace {

Box fitted(const Tree& tree, const Scene& scene, NodeId id) {
    const Node& node = tree.nodes[id];
    Box box;
    for (const ObjectId object : tree.objects_of(node)) box.add(scene.objects[object].box);
    if (!node.is_leaf) {
        box.add(tree.nodes[id + 1].box);
        box.add(tree.nodes[node.upper].box);
    }
    return {box.min + 0.0F, box.max + 0.0F};  // as the builder has it
}

}  // namespace

void refit(Tree& tree, const Scene& scene) {
    for (NodeId id = static_cast<NodeId>(tree.nodes.size()); id-- > 0;)
        tree.nodes[id].box = fitted(tree, scene, id);
}

Refitter::Refitter(const Tree& tree, std::size_t objects)
    : node_of_(objects, kNoNode), is_touched_(tree.nodes.size(), 0) {
    for (NodeId id = 0; id < tree.nodes.size(); ++id)
        for (const ObjectId object : tree.objects_of(tree.nodes[id])) node_of_[object] = id;
}

void Refitter::refit(Tree& tree, const Scene& scene, std::span<const ObjectId> moved) {
    for (const ObjectId object : moved)
        for (NodeId id = node_of_[object]; id != kNoNode && !is_touched_[id]; id = tree.nodes[id].parent)
            is_touched_[id] = 1;
    // Children have larger numbers than their parents.
    for (auto id = static_cast<NodeId>(tree.nodes.size()); id-- > 0;) {
        if (!is_touched_[id]) continue;
        tree.nodes[id].box = fitted(tree, scene, id);
        is_touched_[id] = 0;
    }
}

}  // namespace apps
