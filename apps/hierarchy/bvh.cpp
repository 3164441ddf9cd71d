// SPDX-License-Identifier: MIT
// Requirements: the same bits for any number of threads; 34 million triangles in memory of 4 GiB.
// Algorithm: a range of items is cut where the surface area heuristic is cheapest among 31 planes on each
// axis, and the items change places so that both halves are ranges again. Sums of boxes and counts do not
// depend on the order of adding, so large ranges are summed in parts; halves are divided by different
// threads. Which leaves are kept is decided afterwards, best first.
#include "apps/hierarchy/bvh.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <array>
#include <bit>
#include <memory>
#include <numeric>
#include <queue>

namespace apps {
namespace {

using Floats [[gnu::vector_size(16)]] = float;
using Words [[gnu::vector_size(16)]] = std::uint32_t;
using Numbers [[gnu::vector_size(16)]] = std::int32_t;

/// A box in vector registers; what the fourth lanes hold has no meaning.
struct Bounds {
    Floats low = Floats{} + std::numeric_limits<float>::max();
    Floats high = Floats{} - std::numeric_limits<float>::max();

    void add(const Bounds& other) {
        low = other.low < low ? other.low : low;
        high = other.high > high ? other.high : high;
    }
    Box box() const { return {{low[0], low[1], low[2]}, {high[0], high[1], high[2]}}; }
};

/// What is divided: a box, with its number and its triangles in the fourth lanes. 32 bytes.
struct Item {
    Bounds bounds;

    Item() = default;
    /// Minus zero becomes zero: then the least of two numbers has the same bits in either order.
    Item(const Box& box, std::uint32_t id, std::uint32_t triangles)
        : bounds{Floats{box.min.x, box.min.y, box.min.z, 0} + 0.0F,
                 Floats{box.max.x, box.max.y, box.max.z, 0} + 0.0F} {
        bounds.low[3] = std::bit_cast<float>(id);
        bounds.high[3] = std::bit_cast<float>(triangles);
    }

    std::uint32_t id() const { return std::bit_cast<Words>(bounds.low)[3]; }
    std::uint32_t triangles() const { return std::bit_cast<Words>(bounds.high)[3]; }

    /// The fourth lane is 0: as a number it would be one that processors are slow at.
    Floats middle() const {
        constexpr Words kThree = {~0U, ~0U, ~0U, 0};
        const auto first = std::bit_cast<Floats>(std::bit_cast<Words>(bounds.low) & kThree);
        const auto second = std::bit_cast<Floats>(std::bit_cast<Words>(bounds.high) & kThree);
        return 0.5F * first + 0.5F * second;
    }
};

/// A node costs about as much to visit as this many triangles to draw.
constexpr double kVisitTriangles = 4;
constexpr int kBins = 32;
constexpr std::size_t kManyItems = 1 << 15;  // worth more than one thread
constexpr std::size_t kSomeItems = 1 << 10;  // worth a task

struct Bin {
    Bounds bounds;
    std::uint64_t triangles = 0;

    void add(const Bin& other) {
        bounds.add(other.bounds);
        triangles += other.triangles;
    }
    void add(const Item& item) {
        bounds.add(item.bounds);
        triangles += item.triangles();
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
    Floats low{};
    Floats bins_per_metre{};  // 0 where all middles are at one place

    explicit Grid(const Bounds& middles) : low(middles.low) {
        for (int axis = 0; axis < 3; ++axis) {
            const float extent = middles.high[axis] - middles.low[axis];
            const float scale = kBins / extent;
            if (extent > 0 && scale < std::numeric_limits<float>::max()) bins_per_metre[axis] = scale;
        }
    }

    Numbers bins(const Item& item) const {
        constexpr auto kLast = static_cast<float>(kBins - 1);
        const Floats at = (item.middle() - low) * bins_per_metre;
        return __builtin_convertvector(at < kLast ? at : Floats{} + kLast, Numbers);
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
    return bin.bounds.box().surface_area() * (static_cast<double>(bin.triangles) + kVisitTriangles);
}

/// What cutting lowers the expected cost by.
double gain_of(const Bin& whole, double cost_of_parts) {
    return whole.bounds.box().surface_area() * static_cast<double>(whole.triangles) - cost_of_parts;
}

Cut best_cut(const Bin& whole, const Bins& bins, const Grid& grid) {
    Cut best;
    for (int axis = 0; axis < 3; ++axis) {
        if (!(grid.bins_per_metre[axis] > 0)) continue;
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
        struct Extent {
            Bin all;
            Bounds middles;
            void add(const Extent& other) {
                all.add(other.all);
                middles.add(other.middles);
            }
        };
        const Extent extent = summed(items, Extent{}, [](Extent& sum, const Item& item) {
            sum.all.add(item);
            sum.middles.add({item.middle(), item.middle()});
        });
        draft->sum = extent.all;
        const bool is_small = limits_.leaves <= 1 && extent.all.triangles <= limits_.leaf_triangles;
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
            const Numbers bin = grid.bins(item);
            for (int axis = 0; axis < 3; ++axis)
                sum.axes[static_cast<std::size_t>(axis)][static_cast<std::size_t>(bin[axis])].add(item);
        });
        const Cut best = best_cut(draft.sum, bins, grid);
        if (best.axis < 0) {  // all in one place: there is nothing to choose
            draft.gain = gain_of(draft.sum, 2 * cost_of(draft.sum));
            return items.size() / 2;
        }
        draft.gain = best.gain;
        const auto above = std::partition(items.begin(), items.end(), [&](const Item& item) {
            return grid.bins(item)[best.axis] < best.bin;
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
    node.box = draft.sum.bounds.box();
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
    for (std::size_t i = 0; i < items.size(); ++i) tree.objects[i] = items[i].id();
    for (const Node& node : tree.nodes)
        std::sort(tree.objects.begin() + node.first, tree.objects.begin() + node.first + node.count);
    tree.link_parents();
    return tree;
}

}  // namespace

Tree build_bvh(const Scene& scene, const BvhLimits& limits) {
    std::vector<Item> items;
    items.reserve(scene.objects.size());
    for (ObjectId id = 0; id < scene.objects.size(); ++id)
        items.emplace_back(scene.objects[id].box, id, scene.objects[id].triangle_count());
    return tree_of(std::move(items), limits);
}

Tree build_bvh(std::span<const SoupTriangle> soup, const BvhLimits& limits) {
    std::vector<Item> items(soup.size());
    tbb::parallel_for(std::size_t{0}, soup.size(), [&](std::size_t i) {
        Box box;
        for (const glm::vec3& corner : soup[i].corners) box.add(corner);
        items[i] = {box, static_cast<std::uint32_t>(i), 1};
    });
    return tree_of(std::move(items), limits);
}

}  // namespace apps
