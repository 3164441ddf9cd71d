// SPDX-License-Identifier: MIT
// What a coherent culler asks about: the nodes of a tree, and what hangs in an interior node itself as a leaf
// of its own beside the children. The papers' trees have objects in leaves only; with this reading of the
// others all their rules hold as they stand.
#pragma once

#include <array>
#include <queue>
#include <vector>

#include "apps/culling/traversal.h"

namespace apps {

/// A node; or, from the number of nodes on, what hangs in interior node `part - nodes` itself.
using PartId = std::uint32_t;

class Parts {
  public:
    Parts(const Scene& scene, const Tree& tree) : scene_(scene), tree_(tree) {}

    std::size_t size() const { return 2 * tree_.nodes.size(); }
    NodeId node_of(PartId part) const { return is_own(part) ? part - nodes() : part; }

    /// True where there is nothing to open.
    bool is_leaf(PartId part) const { return is_own(part) || tree_.nodes[part].is_leaf; }

    /// What a leaf draws.
    std::span<const ObjectId> objects_of(PartId part) const {
        return tree_.objects_of(tree_.nodes[node_of(part)]);
    }

    Box box_of(PartId part) const;

    /// kNoNode of the root.
    PartId parent_of(PartId part) const { return is_own(part) ? part - nodes() : tree_.nodes[part].parent; }

    /// Those of an opened part: the lower and the upper child and, where anything hangs in it, its own.
    template <class Each>
    void for_children(PartId part, Each&& each) const {
        each(part + 1);
        each(tree_.nodes[part].upper);
        if (tree_.nodes[part].count != 0) each(part + nodes());
    }

    /// The same, front to back; what hangs in the node first.
    template <class Each>
    void for_children_by_depth(PartId part, const glm::vec3& eye, Each&& each) const {
        if (tree_.nodes[part].count != 0) each(part + nodes());
        const Children children = children_of(tree_, part, eye);
        each(children.near);
        each(children.far);
    }

    /// Whatever the subtree lists, in the order of its nodes.
    template <class Each>
    void for_subtree(PartId part, Each&& each) const {
        if (is_own(part)) return each(objects_of(part));
        for (NodeId id = part; id < tree_.end_of(part); ++id) each(tree_.objects_of(tree_.nodes[id]));
    }

  private:
    PartId nodes() const { return static_cast<PartId>(tree_.nodes.size()); }
    bool is_own(PartId part) const { return part >= nodes(); }

    const Scene& scene_;
    const Tree& tree_;
};

/// The objects, each once, in the order in which a renderer makes fewest calls of them: those that follow one
/// another in the scene stand together, such runs in the order of their first object here.
std::vector<ObjectId> in_runs(std::span<const ObjectId> objects);

/// Parts still to visit. Depth first: the near child of what was opened last (section 4.4's first way, and
/// Figure 2's stack: the far child is pushed first). Else by least distance between eye and box, of equals
/// the one pushed first (its second way, for any hierarchy).
class Frontier {
  public:
    Frontier(const Parts& parts, const glm::vec3& eye, bool is_by_distance)
        : parts_(parts), eye_(eye), is_by_distance_(is_by_distance) {}

    bool is_empty() const { return is_by_distance_ ? heap_.empty() : stack_.empty(); }
    void push(PartId part);
    void push_children(PartId part);
    PartId pop();

  private:
    struct Entry {
        float squared_distance;
        std::uint32_t turn;
        PartId part;
        bool operator<(const Entry& other) const {
            return squared_distance != other.squared_distance ? squared_distance > other.squared_distance
                                                              : turn > other.turn;
        }
    };
    const Parts& parts_;
    glm::vec3 eye_;
    bool is_by_distance_;
    std::vector<PartId> stack_;
    std::priority_queue<Entry> heap_;
    std::uint32_t turn_ = 0;
};

}  // namespace apps
