// SPDX-License-Identifier: MIT
// Two priority queues. Most frames hold some thousands of boxes.
#include "apps/culling/two_lists.h"

#include <queue>

#include "apps/culling/traversal.h"

namespace apps {

const Statistic kBoxesTested{"boxes_tested", "boxes of nodes whose occlusion was asked about"};

namespace {

struct Entry {
    DepthSteps depth;     // the list is sorted by it
    std::uint64_t order;  // of insertion
    NodeId node;
    ScreenBox box;

    bool operator>(const Entry& other) const {
        return depth != other.depth ? depth > other.depth : order > other.order;
    }
};

using List = std::priority_queue<Entry, std::vector<Entry>, std::greater<>>;

class TwoLists {
  public:
    TwoLists(Frame& frame, OcclusionMap& map) : frame_(frame), map_(map) {}

    void run() {
        add_to_test_list(0);
        while (!test_list_.empty() || !draw_list_.empty()) {
            const bool draws = !draw_list_.empty() &&
                               (test_list_.empty() || draw_list_.top().depth < test_list_.top().depth);
            if (draws)
                draw(take(draw_list_));
            else
                test(take(test_list_));
        }
    }

  private:
    static Entry take(List& list) {
        const Entry entry = list.top();
        list.pop();
        return entry;
    }

    void add_to_test_list(NodeId id) {
        const Box& box = frame_.tree.nodes[id].box;
        if (is_outside(frame_.view, box)) {
            frame_.classes[id] = NodeClass::kOutside;
            return;
        }
        const ScreenBox on_screen = screen_box(frame_.view, box);
        test_list_.push({on_screen.znear, next_++, id, on_screen});
    }

    void test(const Entry& entry) {
        if (entry.box.is_known) {
            frame_.tally.add(kBoxesTested);
            if (map_.is_occluded(frame_, entry.box)) {
                frame_.classes[entry.node] = NodeClass::kOccluded;
                return;
            }
        }
        frame_.classes[entry.node] = NodeClass::kVisible;
        const Node& node = frame_.tree.nodes[entry.node];
        if (!node.is_leaf) {
            const Children children = children_of(frame_.tree, entry.node, frame_.view.eye);
            add_to_test_list(children.near);
            add_to_test_list(children.far);
        }
        const Box extent = undrawn_extent(frame_, node);
        if (extent.is_empty()) return;
        const ScreenBox on_screen = screen_box(frame_.view, extent);
        draw_list_.push({on_screen.zfar, next_++, entry.node, on_screen});
    }

    void draw(const Entry& entry) {
        const Node& node = frame_.tree.nodes[entry.node];
        if (undrawn_extent(frame_, node).is_empty()) return;  // drawn by way of other nodes since
        frame_.draw(frame_.tree.objects_of(node));
        map_.was_drawn(frame_, entry.box);
    }

    Frame& frame_;
    OcclusionMap& map_;
    List test_list_;  // by znear
    List draw_list_;  // by zfar
    std::uint64_t next_ = 0;
};

}  // namespace

Box undrawn_extent(const Frame& frame, const Node& node) {
    Box extent;
    for (const ObjectId id : frame.tree.objects_of(node))
        if (!frame.is_drawn[id]) extent.add(frame.scene.objects[id].box);
    return extent;
}

void draw_in_two_lists(Frame& frame, OcclusionMap& map) {
    map.begin(frame.view);
    TwoLists(frame, map).run();
}

}  // namespace apps
