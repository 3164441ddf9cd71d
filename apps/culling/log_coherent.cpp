// SPDX-License-Identifier: MIT
// The zfar version of the lazy occlusion grid with what Hey et al. 2001 name as future work (section 6):
// "utilization of temporal coherence and support of parallel pixel-level occlusion queries".
//
// Coherence: what was visible in the last frame is drawn first, front to back and untested; the tests of the
// frame, of what it drew and of what it did not, then find most occluders in place, and nodes that were
// passed by then are passed by again. Whatever was drawn untested is tested too, and leaves the visible set
// when it is hidden; a node whose children all are becomes one box again. Nothing depends on last frame's
// answers but what is drawn too much: every box left out was found hidden in this frame, by depths of this
// frame.
//
// Parallel: the boxes of the last frame's cut through the tree are tested together, in two calls; those that
// are new are taken from a front-to-back queue some at a time, as one may hide another.
#include <queue>

#include "apps/culling/occlusion_grid.h"
#include "apps/culling/traversal.h"
#include "apps/culling/two_lists.h"

namespace apps {
namespace {

const Statistic kDrawnUntested{"drawn_untested", "objects drawn because they were visible in the last frame"};
const Statistic kFoundHidden{"found_hidden", "nodes drawn untested that turned out hidden"};

enum class Memory : std::uint8_t { kNone, kHidden, kVisible };  // of a node, from the last frame

class LogCoherent final : public Culler {
  public:
    explicit LogCoherent(const KnobValues& knobs)
        : grid_(static_cast<int>(knobs.at("tile")), true),
          batch_(static_cast<std::size_t>(knobs.at("batch"))),
          retest_(static_cast<std::uint64_t>(knobs.at("retest"))) {}

    void restart() override {
        memory_.clear();
        frames_ = 0;
    }

    void draw(Frame& frame) override {
        memory_.resize(frame.tree.nodes.size(), Memory::kNone);
        grid_.clear(frame.view);
        next_ = 0;
        ++frames_;
        std::vector<Entry> cut;
        find_cut(frame, cut);
        draw_known(frame, cut);
        std::erase_if(cut, [&](const Entry& entry) { return is_trusted(frame, entry.node); });
        test(frame, cut);
        while (!queue_.empty()) {
            std::vector<Entry> nearest;
            for (; !queue_.empty() && nearest.size() < batch_; queue_.pop()) nearest.push_back(queue_.top());
            test(frame, nearest);
        }
        remember(frame);
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

    Entry entry_of(const Frame& frame, NodeId id) {
        return {screen_box(frame.view, frame.tree.nodes[id].box), next_++, id};
    }

    /// Sorts the nodes that the last frame ended at into `cut`, and others on the way into the queue.
    void find_cut(Frame& frame, std::vector<Entry>& cut) {
        traverse(frame.tree, frame.view.eye, [&](NodeId id) {
            const Node& node = frame.tree.nodes[id];
            frame.classes[id] = NodeClass::kOutside;
            if (is_outside(frame.view, node.box)) return false;
            frame.classes[id] = NodeClass::kVisible;
            if (memory_[id] == Memory::kNone)
                queue_.push(entry_of(frame, id));
            else if (memory_[id] == Memory::kHidden || node.is_leaf)
                cut.push_back(entry_of(frame, id));
            else
                passed_.push_back(id);
            return memory_[id] == Memory::kVisible;
        });
    }

    void draw_known(Frame& frame, std::vector<Entry>& cut) {
        std::vector<Entry> known;
        for (const Entry& entry : cut)
            if (memory_[entry.node] == Memory::kVisible) known.push_back(entry);
        for (const NodeId id : passed_)
            if (frame.tree.nodes[id].count > 0) known.push_back(entry_of(frame, id));
        passed_.clear();
        std::sort(known.begin(), known.end(), [](const Entry& a, const Entry& b) { return b > a; });
        std::vector<ObjectId> objects;
        for (const Entry& entry : known) {
            const Node& node = frame.tree.nodes[entry.node];
            const auto own = frame.tree.objects_of(node);
            objects.insert(objects.end(), own.begin(), own.end());
            outdate(frame, node);
        }
        frame.draw(objects);
        frame.tally.add(kDrawnUntested, frame.drawn.size());
    }

    void outdate(Frame& frame, const Node& node) {
        const Box extent = undrawn_extent(frame, node);
        if (!extent.is_empty()) grid_.outdate(screen_box(frame.view, extent));
    }

    /// Tests nodes together, draws those that are visible front to back, and queues their children.
    void test(Frame& frame, const std::vector<Entry>& entries) {
        std::vector<ScreenBox> boxes;
        for (const Entry& entry : entries)
            if (entry.box.is_known) boxes.push_back(entry.box);
        frame.tally.add(kBoxesTested, boxes.size());
        const std::vector<std::uint8_t> answers = grid_.are_occluded(frame, boxes);
        std::size_t next = 0;
        for (const Entry& entry : entries) {
            const bool is_hidden = entry.box.is_known && answers[next++];
            frame.classes[entry.node] = is_hidden ? NodeClass::kOccluded : NodeClass::kVisible;
            if (is_hidden)
                frame.tally.add(kFoundHidden, memory_[entry.node] == Memory::kVisible);
            else
                open(frame, entry.node);
        }
    }

    /// A leaf that was drawn untested is tested in one of `retest` frames only, not all of them in the same.
    bool is_trusted(const Frame& frame, NodeId id) const {
        return memory_[id] == Memory::kVisible && frame.tree.nodes[id].is_leaf &&
               (frames_ + id) % retest_ != 0;
    }

    void open(Frame& frame, NodeId id) {
        const Node& node = frame.tree.nodes[id];
        outdate(frame, node);
        frame.draw(frame.tree.objects_of(node));
        if (node.is_leaf) return;
        const Children children = children_of(frame.tree, id, frame.view.eye);
        for (const NodeId child : {children.near, children.far}) {
            frame.classes[child] = NodeClass::kOutside;
            if (!is_outside(frame.view, frame.tree.nodes[child].box)) queue_.push(entry_of(frame, child));
        }
    }

    /// An interior node is remembered as visible if a child is, else as what its own test said, or hidden.
    void remember(const Frame& frame) {
        for (auto id = static_cast<NodeId>(memory_.size()); id-- > 0;) {
            const Node& node = frame.tree.nodes[id];
            switch (frame.classes[id]) {
                case NodeClass::kOccluded:
                    memory_[id] = Memory::kHidden;
                    break;
                case NodeClass::kVisible: {
                    const bool is_seen = node.is_leaf || memory_[id + 1] == Memory::kVisible ||
                                         memory_[node.upper] == Memory::kVisible;
                    memory_[id] = is_seen ? Memory::kVisible : Memory::kHidden;
                    break;
                }
                default:
                    memory_[id] = Memory::kNone;
            }
        }
    }

    ZfarGrid grid_;
    std::size_t batch_;
    std::uint64_t retest_;
    std::uint64_t frames_ = 0;
    std::vector<Memory> memory_;
    std::vector<NodeId> passed_;  // interior nodes that were visible in the last frame
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue_;
    std::uint64_t next_ = 0;
};

constexpr Knob kKnobs[] = {
    kTileKnob,
    {"batch", 4, 1, 1024, "boxes without a past that are tested together, at most"},
    {"retest", 1, 1, 64, "frames after which a visible leaf is tested again"},
};

}  // namespace

extern const CullerRecipe kLogCoherent;
const CullerRecipe kLogCoherent = {
    "log-coherent", true, Needs::kDepths, kKnobs,
    [](const KnobValues& knobs) -> std::unique_ptr<Culler> { return std::make_unique<LogCoherent>(knobs); }};

}  // namespace apps
