// SPDX-License-Identifier: MIT
// What all trees share: parents, and scenes in the order of their leaves.
#include "apps/hierarchy/tree.h"

#include <algorithm>
#include <tuple>

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
    // Parts of one placed mesh next to one another, as they lie in the mesh: they are one draw call.
    for (const Node& node : tree.nodes)
        std::sort(tree.objects.begin() + node.first, tree.objects.begin() + node.first + node.count,
                  [&](ObjectId a, ObjectId b) {
                      const Object& one = scene.objects[a];
                      const Object& other = scene.objects[b];
                      return std::tie(one.placement, one.first_index, a) <
                             std::tie(other.placement, other.first_index, b);
                  });
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
    for (const Node& node : tree.nodes)
        std::sort(tree.objects.begin() + node.first, tree.objects.begin() + node.first + node.count);
    return reordered(scene, order);
}

}  // namespace apps
