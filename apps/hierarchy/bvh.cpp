// SPDX-License-Identifier: MIT
// Requirements: the same bits for any number of threads; 34 million triangles in memory of 4 GiB; single
// objects and leaves of a thousand triangles alike. Algorithm: a range of items is cut where the surface area
// heuristic is cheapest among 31 planes on each axis, and the items change places so that both halves are
// ranges again. Sums of boxes and counts do not depend on the order of adding, so large ranges are summed in
// parts; halves are divided by different threads. Which leaves are kept is decided afterwards, best first.
#include "apps/hierarchy/bvh.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <array>
#include <memory>
#include <numeric>
#include <queue>

namespace apps {
namespace {

/// What is divided: 32 bytes.
struct Item {
    Box box;
    std::uint32_t id;
    std::uint32_t triangles;

    float middle(int axis) const { return 0.5F * box.min[axis] + 0.5F * box.max[axis]; }
};

/// Minus zero becomes zero: then the least of two numbers has the same bits in either order.
Box with_one_zero(const Box& box) {
    return {box.min + 0.0F, box.max + 0.0F};
}

/// A node costs about as much to visit as this many triangles to draw.
constexpr double kVisitTriangles = 4;
constexpr int kBins = 32;
constexpr std::size_t kManyItems = 1 << 15;  // worth more than one thread
constexpr std::size_t kSomeItems = 1 << 10;  // worth a task

struct Bin {
    Box box;
    std::uint64_t triangles = 0;

    void add(const Bin& other) {
        box.add(other.box);
        triangles += other.triangles;
    }
};

/// A range of items, and where it is best cut.
struct Draft {
    std::size_t first = 0;
    std::size_t end = 0;
    Bin sum;
    double gain = 0;  // square metres times triangles; may be negative
    std::unique_ptr<Draft> lower, upper;
    bool is_kept_whole = true;  // a leaf of the finished tree

    std::size_t size() const { return end - first; }
};

/// Sums `add(sum, item)` over a range, by several threads where it is long.
template <class Sum, class Add>
Sum summed(std::span<const Item> items, Sum sum, Add&& add) {
    const auto serial = [&](std::span<const Item> part, Sum whole) {
        for (const Item& item : part) add(whole, item);
        return whole;
    };
    if (items.size() < kManyItems) return serial(items, std::move(sum));
    return tbb::parallel_reduce(
        tbb::blocked_range<std::size_t>(0, items.size(), kManyItems / 4), sum,
        [&](const auto& range, Sum whole) {
            return serial(items.subspan(range.begin(), range.size()), std::move(whole));
        },
        [](Sum a, const Sum& b) {
            a.add(b);
            return a;
        });
}

/// Of the middles of a range's boxes: on each axis, which of the bins a middle falls into.
struct Grid {
    glm::vec3 low{0};
    glm::vec3 bins_per_metre{0};  // 0 where all middles are at one place

    explicit Grid(const Box& middles) {
        if (middles.is_empty()) return;
        low = middles.min;
        for (int axis = 0; axis < 3; ++axis) {
            const float extent = middles.max[axis] - middles.min[axis];
            const float scale = kBins / extent;
            if (extent > 0 && scale < std::numeric_limits<float>::max()) bins_per_metre[axis] = scale;
        }
    }

    int bin(const Item& item, int axis) const {
        const float at = (item.middle(axis) - low[axis]) * bins_per_metre[axis];
        return at < kBins - 1 ? static_cast<int>(at) : kBins - 1;
    }
};

struct Bins {
    std::array<std::array<Bin, kBins>, 3> axes;

    void add(const Bins& other) {
        for (std::size_t axis = 0; axis < 3; ++axis)
            for (std::size_t bin = 0; bin < kBins; ++bin) axes[axis][bin].add(other.axes[axis][bin]);
    }
};

struct Cut {
    double gain = std::numeric_limits<double>::lowest();
    int axis = -1;  // none
    int bin = 0;    // the first above
};

double cost_of(const Bin& bin) {
    return bin.box.surface_area() * (static_cast<double>(bin.triangles) + kVisitTriangles);
}

/// What cutting lowers the expected cost by.
double gain_of(const Bin& whole, double cost_of_parts) {
    return whole.box.surface_area() * static_cast<double>(whole.triangles) - cost_of_parts;
}

Cut best_cut(const Bin& whole, const Bins& bins, const Grid& grid) {
    Cut best;
    for (int axis = 0; axis < 3; ++axis) {
        if (grid.bins_per_metre[axis] == 0) continue;
        const auto& row = bins.axes[static_cast<std::size_t>(axis)];
        std::array<double, kBins> cost_above{};
        Bin above;
        for (std::size_t bin = kBins - 1; bin > 0; --bin) {
            above.add(row[bin]);
            cost_above[bin] = above.triangles > 0 ? cost_of(above) : std::numeric_limits<double>::max();
        }
        Bin below;
        for (std::size_t bin = 1; bin < kBins; ++bin) {
            below.add(row[bin - 1]);
            if (below.triangles == 0) continue;
            const double gain = gain_of(whole, cost_of(below) + cost_above[bin]);
            if (gain > best.gain) best = {gain, axis, static_cast<int>(bin)};
        }
    }
    return best;
}

class Grower {
  public:
    Grower(std::span<Item> items, const BvhLimits& limits) : items_(items), limits_(limits) {}

    std::unique_ptr<Draft> grow(std::size_t first, std::size_t end) const {
        auto draft = std::make_unique<Draft>();
        draft->first = first;
        draft->end = end;
        const std::span<Item> items = items_.subspan(first, end - first);
        struct Extent : Bin {
            Box middles;
            void add(const Extent& other) {
                Bin::add(other);
                middles.add(other.middles);
            }
        };
        const Extent extent = summed(items, Extent{}, [](Extent& sum, const Item& item) {
            sum.box.add(item.box);
            sum.triangles += item.triangles;
            sum.middles.add(glm::vec3(item.middle(0), item.middle(1), item.middle(2)));
        });
        draft->sum = extent;
        const bool is_small = limits_.leaves <= 1 && extent.triangles <= limits_.leaf_triangles;
        if (items.size() < 2 || is_small) return draft;

        const std::size_t middle = first + cut(items, *draft, Grid(extent.middles));
        const auto lower = [&] { draft->lower = grow(first, middle); };
        const auto upper = [&] { draft->upper = grow(middle, end); };
        if (items.size() < kSomeItems) {
            lower();
            upper();
        } else {
            tbb::parallel_invoke(lower, upper);
        }
        return draft;
    }

  private:
    /// Cuts a range in two, neither of them empty: the number of items that are below.
    static std::size_t cut(std::span<Item> items, Draft& draft, const Grid& grid) {
        const Bins bins = summed(items, Bins{}, [&](Bins& sum, const Item& item) {
            for (int axis = 0; axis < 3; ++axis) {
                Bin& bin =
                    sum.axes[static_cast<std::size_t>(axis)][static_cast<std::size_t>(grid.bin(item, axis))];
                bin.box.add(item.box);
                bin.triangles += item.triangles;
            }
        });
        const Cut best = best_cut(draft.sum, bins, grid);
        if (best.axis < 0) {  // all in one place: there is nothing to choose
            draft.gain = gain_of(draft.sum, 2 * cost_of(draft.sum));
            return items.size() / 2;
        }
        draft.gain = best.gain;
        const auto above = std::partition(items.begin(), items.end(), [&](const Item& item) {
            return grid.bin(item, best.axis) < best.bin;
        });
        return static_cast<std::size_t>(above - items.begin());
    }

    std::span<Item> items_;
    BvhLimits limits_;
};

/// Divides what is too large for a leaf, then what gains most, until there are enough leaves.
std::size_t choose_leaves(Draft& root, const BvhLimits& limits) {
    std::size_t leaves = 1;
    std::size_t order = 0;  // of equal gains the older first
    struct Candidate {
        bool is_too_large;
        double gain;
        std::size_t order;
        Draft* draft;

        bool operator<(const Candidate& other) const {
            if (is_too_large != other.is_too_large) return other.is_too_large;
            if (gain != other.gain) return gain < other.gain;
            return order > other.order;
        }
    };
    std::priority_queue<Candidate> open;
    const auto consider = [&](Draft& draft) {
        if (draft.lower)
            open.push({draft.sum.triangles > limits.leaf_triangles, draft.gain, order++, &draft});
    };
    consider(root);
    while (!open.empty() && (open.top().is_too_large || leaves < limits.leaves)) {
        Draft& draft = *open.top().draft;
        open.pop();
        draft.is_kept_whole = false;
        ++leaves;
        consider(*draft.lower);
        consider(*draft.upper);
    }
    return leaves;
}

NodeId lay_out(Tree& tree, const Draft& draft) {
    const auto id = static_cast<NodeId>(tree.nodes.size());
    Node& node = tree.nodes.emplace_back();
    node.box = draft.sum.box;
    node.is_leaf = draft.is_kept_whole;
    if (node.is_leaf) {
        node.first = static_cast<std::uint32_t>(draft.first);
        node.count = static_cast<std::uint32_t>(draft.size());
        return id;
    }
    lay_out(tree, *draft.lower);
    const NodeId upper = lay_out(tree, *draft.upper);
    tree.nodes[id].upper = upper;
    return id;
}

Tree tree_of(std::vector<Item> items, const BvhLimits& limits) {
    const std::unique_ptr<Draft> root = Grower(items, limits).grow(0, items.size());
    Tree tree;
    tree.nodes.reserve(2 * choose_leaves(*root, limits) - 1);
    lay_out(tree, *root);
    tree.objects.resize(items.size());
    for (std::size_t i = 0; i < items.size(); ++i) tree.objects[i] = items[i].id;
    for (const Node& node : tree.nodes)
        std::sort(tree.objects.begin() + node.first, tree.objects.begin() + node.first + node.count);
    tree.link_parents();
    return tree;
}

Box fitted(const Tree& tree, const Scene& scene, NodeId id) {
    const Node& node = tree.nodes[id];
    Box box;
    for (const ObjectId object : tree.objects_of(node)) box.add(with_one_zero(scene.objects[object].box));
    if (!node.is_leaf) {
        box.add(tree.nodes[id + 1].box);
        box.add(tree.nodes[node.upper].box);
    }
    return box;
}

}  // namespace

Tree build_bvh(const Scene& scene, const BvhLimits& limits) {
    std::vector<Item> items;
    items.reserve(scene.objects.size());
    for (ObjectId id = 0; id < scene.objects.size(); ++id)
        items.push_back({with_one_zero(scene.objects[id].box), id, scene.objects[id].triangle_count()});
    return tree_of(std::move(items), limits);
}

std::vector<SoupTriangle> flattened(const Scene& scene) {
    std::vector<std::size_t> starts;
    std::size_t count = 0;
    for (const Object& object : scene.objects) {
        starts.push_back(count);
        count += object.triangle_count();
    }
    std::vector<SoupTriangle> soup(count);
    tbb::parallel_for(std::size_t{0}, scene.objects.size(), [&](std::size_t id) {
        const Object& object = scene.objects[id];
        const glm::mat4& placement = scene.placements[object.placement];
        for (std::uint32_t i = 0; i < object.index_count; ++i)
            soup[starts[id] + i / 3].corners[i % 3] =
                glm::vec3(placement * glm::vec4(scene.positions[scene.indices[object.first_index + i]], 1));
    });
    return soup;
}

Tree build_bvh(std::span<const SoupTriangle> soup, const BvhLimits& limits) {
    std::vector<Item> items(soup.size());
    tbb::parallel_for(std::size_t{0}, soup.size(), [&](std::size_t i) {
        Box box;
        for (const glm::vec3& corner : soup[i].corners) box.add(corner);
        items[i] = {with_one_zero(box), static_cast<std::uint32_t>(i), 1};
    });
    return tree_of(std::move(items), limits);
}

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
    touched_.clear();
    for (const ObjectId object : moved)
        for (NodeId id = node_of_[object]; id != kNoNode && !is_touched_[id]; id = tree.nodes[id].parent) {
            is_touched_[id] = 1;
            touched_.push_back(id);
        }
    // Children have larger numbers than their parents.
    std::sort(touched_.begin(), touched_.end(), std::greater<>());
    for (const NodeId id : touched_) {
        tree.nodes[id].box = fitted(tree, scene, id);
        is_touched_[id] = 0;
    }
}

}  // namespace apps
