// SPDX-License-Identifier: MIT
// Front to back through the tree: of two children, the one on the eye's side of the plane first. No part of
// the other can hide a part of it.
#pragma once

#include <utility>

#include "apps/culling/culler.h"

namespace apps {

struct Children {
    NodeId near;
    NodeId far;
};

inline Children children_of(const KdTree& tree, NodeId parent, const glm::vec3& eye) {
    const KdNode& node = tree.nodes[parent];
    const NodeId lower = parent + 1;
    return eye[node.axis] <= node.split ? Children{lower, node.upper} : Children{node.upper, lower};
}

/// Visits nodes front to back; `enter(id)` says whether to go on into an interior node.
template <class Enter>
void traverse(const KdTree& tree, const glm::vec3& eye, Enter&& enter) {
    std::vector<NodeId> stack{0};
    while (!stack.empty()) {
        const NodeId id = stack.back();
        stack.pop_back();
        if (!enter(id) || tree.nodes[id].is_leaf) continue;
        const Children children = children_of(tree, id, eye);
        stack.push_back(children.far);
        stack.push_back(children.near);
    }
}

}  // namespace apps
