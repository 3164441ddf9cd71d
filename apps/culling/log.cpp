// SPDX-License-Identifier: MIT
// The lazy occlusion grid: H. Hey, R. F. Tobler, W. Purgathofer, Real-Time Occlusion Culling With A Lazy
// Occlusion Grid, 2001. A tile's occlusion is looked at only when a box asks and the tile has been drawn into
// since. Deviations: the paper says only of its busy grid that a full tile is left alone; it holds here too.
// It does not say how the zfar version treats border tiles and outdated depths: see ZfarGrid. A box that the
// near plane cuts is visible, and drawing it outdates every tile.
#include <queue>

#include "apps/culling/occlusion_grid.h"
#include "apps/culling/traversal.h"
#include "apps/culling/two_lists.h"

namespace apps {
namespace {

class StateMap final : public OcclusionMap {
  public:
    StateMap(int tile_pixels, bool asks_together) : grid_(tile_pixels, asks_together) {}

    void begin(const View& view) override { grid_.clear(view); }
    bool is_occluded(Frame& frame, const ScreenBox& box) override { return grid_.is_occluded(frame, box); }
    void was_drawn(Frame&, const ScreenBox& box) override { grid_.outdate(box); }

  private:
    StateGrid grid_;
};

class LogState final : public Culler {
  public:
    explicit LogState(const KnobValues& knobs)
        : map_(static_cast<int>(knobs.at("tile")), knobs.at("parallel") != 0) {}

    void draw(Frame& frame) override { draw_in_two_lists(frame, map_); }

  private:
    StateMap map_;
};

/// "Any approximative front-to-back traversal can be used": one list, by znear; what is visible is drawn at
/// once.
class LogZfar final : public Culler {
  public:
    explicit LogZfar(const KnobValues& knobs)
        : grid_(static_cast<int>(knobs.at("tile")), knobs.at("parallel") != 0) {}

    void draw(Frame& frame) override {
        grid_.clear(frame.view);
        next_ = 0;
        add(frame, 0);
        while (!list_.empty()) {
            const Entry entry = list_.top();
            list_.pop();
            test(frame, entry);
        }
    }

  private:
    struct Entry {
        ScreenBox box;
        std::uint64_t order;
        NodeId node;
        bool operator>(const Entry& other) const {
            return box.znear != other.box.znear ? box.znear > other.box.znear : order > other.order;
        }
    };

    void add(Frame& frame, NodeId id) {
        const Box& box = frame.tree.nodes[id].box;
        frame.classes[id] = NodeClass::kOutside;
        if (!is_outside(frame.view, box)) list_.push({screen_box(frame.view, box), next_++, id});
    }

    void test(Frame& frame, const Entry& entry) {
        if (entry.box.is_known) {
            frame.tally.add(kBoxesTested);
            frame.classes[entry.node] = NodeClass::kOccluded;
            if (grid_.is_occluded(frame, entry.box)) return;
        }
        frame.classes[entry.node] = NodeClass::kVisible;
        const Node& node = frame.tree.nodes[entry.node];
        const Box extent = undrawn_extent(frame, node);
        if (!extent.is_empty()) {
            frame.draw(frame.tree.objects_of(node));
            grid_.outdate(screen_box(frame.view, extent));
        }
        if (node.is_leaf) return;
        const Children children = children_of(frame.tree, entry.node, frame.view.eye);
        add(frame, children.near);
        add(frame, children.far);
    }

    ZfarGrid grid_;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> list_;
    std::uint64_t next_ = 0;
};

constexpr Knob kKnobs[] = {kTileKnob, kParallelKnob};

}  // namespace

extern const CullerRecipe kLogState, kLogZfar;
const CullerRecipe kLogState = {
    "log-state", true, Needs::kDepths, kKnobs,
    [](const KnobValues& knobs) -> std::unique_ptr<Culler> { return std::make_unique<LogState>(knobs); }};
const CullerRecipe kLogZfar = {
    "log-zfar", true, Needs::kDepths, kKnobs,
    [](const KnobValues& knobs) -> std::unique_ptr<Culler> { return std::make_unique<LogZfar>(knobs); }};

}  // namespace apps
