// SPDX-License-Identifier: MIT
// Requirements: the tree is the same bits for the same scene; boxes lose nothing; any number of leaves.
// Algorithm: best first. Each open leaf knows its best split; the one that lowers the expected cost of the
// whole tree most (surface area times triangles, before less after) is split next. Candidates are all faces
// of all boxes.
#include "apps/hierarchy/kd_tree.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <queue>

namespace apps {
namespace {

struct Item {
    ObjectId object;
    Box box;  // of the object, cut to the cell
};

struct Split {
    double gain = 0;  // square metres times triangles
    int axis = 0;
    float at = 0;
};

/// A node while the tree grows; children are indices into the list of these.
struct Draft {
    Box box;
    std::vector<Item> items;
    Split split;
    std::size_t lower = 0;
    std::size_t upper = 0;

    bool is_leaf() const { return lower == 0; }
};

/// A node costs about as much to visit as this many triangles to draw.
constexpr double kVisitTriangles = 4;

/// The cell's own box is cut, not the objects': its halves bound the cost well enough to choose.
Split best_split_on(const Scene& scene, const Draft& node, int axis) {
    struct Edge {
        float at;
        std::uint32_t triangles;
    };
    std::vector<Edge> starts;
    std::vector<Edge> ends;
    double total = 0;
    for (const Item& item : node.items) {
        const std::uint32_t triangles = scene.objects[item.object].triangle_count();
        starts.push_back({item.box.min[axis], triangles});
        ends.push_back({item.box.max[axis], triangles});
        total += triangles;
    }
    const auto by_place = [](const Edge& a, const Edge& b) { return a.at < b.at; };
    std::sort(starts.begin(), starts.end(), by_place);
    std::sort(ends.begin(), ends.end(), by_place);

    Split best;
    best.axis = axis;
    const double cost_whole = node.box.surface_area() * total;
    double below = 0;
    double above = total;
    std::size_t s = 0;
    std::size_t e = 0;
    while (e < ends.size()) {
        const float at = s < starts.size() ? std::min(starts[s].at, ends[e].at) : ends[e].at;
        // At the plane itself: what starts before it lies below, what ends after it lies above.
        for (; e < ends.size() && ends[e].at <= at; ++e) above -= ends[e].triangles;
        if (at > node.box.min[axis] && at < node.box.max[axis]) {
            Box low = node.box;
            Box high = node.box;
            low.max[axis] = high.min[axis] = at;
            const double cost = low.surface_area() * (below + kVisitTriangles) +
                                high.surface_area() * (above + kVisitTriangles);
            if (cost_whole - cost > best.gain) best = {cost_whole - cost, axis, at};
        }
        for (; s < starts.size() && starts[s].at <= at; ++s) below += starts[s].triangles;
    }
    return best;
}

Draft draft_of(const Scene& scene, std::vector<Item> items) {
    Draft node;
    node.items = std::move(items);
    for (const Item& item : node.items) node.box.add(item.box);
    for (int axis = 0; axis < 3; ++axis) {
        const Split split = best_split_on(scene, node, axis);
        if (split.gain > node.split.gain) node.split = split;
    }
    return node;
}

/// The items below and above the plane; one that straddles it is cut in two, one that lies in it goes below.
void divide(const std::vector<Item>& items, const Split& split, std::vector<Item>& below,
            std::vector<Item>& above) {
    for (const Item& item : items) {
        const bool reaches_above = item.box.max[split.axis] > split.at;
        const bool reaches_below = item.box.min[split.axis] < split.at || !reaches_above;
        Item low = item;
        Item high = item;
        if (reaches_above) low.box.max[split.axis] = std::min(low.box.max[split.axis], split.at);
        if (reaches_below) high.box.min[split.axis] = std::max(high.box.min[split.axis], split.at);
        if (reaches_below) below.push_back(low);
        if (reaches_above) above.push_back(high);
    }
}

NodeId lay_out(Tree& tree, const std::vector<Draft>& drafts, std::size_t index) {
    const Draft& draft = drafts[index];
    const auto id = static_cast<NodeId>(tree.nodes.size());
    Node& node = tree.nodes.emplace_back();
    node.box = draft.box;
    node.is_leaf = draft.is_leaf();
    if (node.is_leaf) {
        node.first = static_cast<std::uint32_t>(tree.objects.size());
        node.count = static_cast<std::uint32_t>(draft.items.size());
        for (const Item& item : draft.items) tree.objects.push_back(item.object);
        return id;
    }
    node.axis = static_cast<std::uint8_t>(draft.split.axis);
    node.split = draft.split.at;
    lay_out(tree, drafts, draft.lower);
    const NodeId upper = lay_out(tree, drafts, draft.upper);
    tree.nodes[id].upper = upper;
    return id;
}

}  // namespace

Tree build_kd_tree(const Scene& scene, std::size_t leaves) {
    std::vector<Item> all;
    for (ObjectId id = 0; id < scene.objects.size(); ++id) all.push_back({id, scene.objects[id].box});
    std::vector<Draft> drafts;
    drafts.push_back(draft_of(scene, std::move(all)));

    using Candidate = std::pair<double, std::size_t>;  // gain, draft
    std::priority_queue<Candidate> open;
    open.push({drafts[0].split.gain, 0});
    for (std::size_t count = 1; count < leaves && !open.empty() && open.top().first > 0; ++count) {
        const std::size_t index = open.top().second;
        open.pop();
        std::vector<Item> below;
        std::vector<Item> above;
        divide(drafts[index].items, drafts[index].split, below, above);
        drafts[index].items = {};
        for (std::vector<Item>* half : {&below, &above}) {
            const std::size_t child = drafts.size();
            (half == &below ? drafts[index].lower : drafts[index].upper) = child;
            drafts.push_back(draft_of(scene, std::move(*half)));
            open.push({drafts[child].split.gain, child});
        }
    }
    Tree tree;
    lay_out(tree, drafts, 0);
    tree.link_parents();
    return tree;
}

}  // namespace apps
