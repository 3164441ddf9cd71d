// SPDX-License-Identifier: MIT
// Front to back through the tree: of two children that a plane parts, the one on the eye's side first; no
// part of the other can hide a part of it.
#pragma once

#include <utility>

#include "apps/culling/culler.h"

namespace apps {

struct Children {
    NodeId near;
    NodeId far;
};

/// Least squared distance from the eye to the box; 0 inside.
inline float squared_distance(const Box& box, const glm::vec3& eye) {
    const glm::vec3 gap = glm::max(glm::max(box.min - eye, eye - box.max), glm::vec3(0));
    return glm::dot(gap, gap);
}

/// Of a node without a plane the nearer box first: then a part of the far one may hide one of the near.
inline Children children_of(const Tree& tree, NodeId parent, const glm::vec3& eye) {
    const Node& node = tree.nodes[parent];
    const NodeId lower = parent + 1;
    const bool is_lower_near = node.axis == Node::kNoPlane
                                   ? squared_distance(tree.nodes[lower].box, eye) <=
                                         squared_distance(tree.nodes[node.upper].box, eye)
                                   : eye[node.axis] <= node.split;
    return is_lower_near ? Children{lower, node.upper} : Children{node.upper, lower};
}

/// Visits nodes front to back; `enter(id)` says whether to go on into an interior node.
template <class Enter>
void traverse(const Tree& tree, const glm::vec3& eye, Enter&& enter) {
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
