// SPDX-License-Identifier: MIT
// What all trees share: parents, and scenes in the order of their leaves.
#include "apps/hierarchy/tree.h"

#include <algorithm>

namespace apps {

NodeId Tree::end_of(NodeId id) const {
    while (!nodes[id].is_leaf) id = nodes[id].upper;
    return id + 1;
}

void Tree::link_parents() {
    for (NodeId id = 0; id < nodes.size(); ++id)
        if (!nodes[id].is_leaf) nodes[id + 1].parent = nodes[nodes[id].upper].parent = id;
}

Scene in_leaf_order(const Scene& scene, Tree& tree) {
    constexpr ObjectId kUnnamed = ~ObjectId{0};
    std::vector<ObjectId> order;
    std::vector<ObjectId> new_id(scene.objects.size(), kUnnamed);
    for (ObjectId& object : tree.objects) {
        if (new_id[object] == kUnnamed) {
            new_id[object] = static_cast<ObjectId>(order.size());
            order.push_back(object);
        }
        object = new_id[object];
    }
    for (Node& node : tree.nodes)
        std::sort(tree.objects.begin() + node.first, tree.objects.begin() + node.first + node.count);
    return reordered(scene, order);
}

}  // namespace apps
