// SPDX-License-Identifier: MIT
// Coherent Hierarchical Culling: J. Bittner, M. Wimmer, H. Piringer, W. Purgathofer, Coherent Hierarchical
// Culling: Hardware Occlusion Queries Made Useful, Eurographics 2004, Figure 2 and section 5.
//
// Queries go to the nodes where the last frame's traversal ended. A leaf that was visible is drawn without
// waiting for its answer, which decides about the next frame; a hidden node is opened when its answer says
// so. Between two nodes the oldest answers are taken if they are there; the CPU waits when nothing is left to
// visit.
//
// Where Figure 2 is wrong or silent: a visible leaf is drawn once (its lines 33 and 13 both draw it), pulling
// up ends at the root, a leaf that is drawn without a query is pulled up too (line 25 would let its parents
// collapse), a box that a test may misjudge is visible (proxy_of), an interior node's own objects are a leaf.
#include <deque>

#include "apps/culling/chc_counts.h"
#include "apps/culling/chc_patience.h"

namespace apps {
namespace {

const Statistic kSpeculated{"speculated_nodes", "nodes drawn before their answer came"};
const Statistic kSpeculatedTriangles{"speculated_triangles", "triangles drawn before their answer came"};

struct Settings {
    float growth_pixels;
    bool is_by_distance;
    Patience patience;
    std::uint32_t most_hidden_pixels;
    std::uint64_t speculation_triangles;
};

struct Pending {
    QueryId query;
    PartId part;
    bool was_visible;
    bool is_drawn;
};

/// One frame.
class Traversal {
  public:
    Traversal(Frame& frame, Memory& memory, const Settings& settings)
        : frame_(frame),
          memory_(memory),
          settings_(settings),
          parts_(frame.scene, frame.tree),
          frontier_(parts_, frame.view.eye, settings.is_by_distance) {}

    void run() {
        frontier_.push(0);
        while (!frontier_.is_empty() || !queue_.empty()) {
            take_answers();
            if (!frontier_.is_empty()) visit(frontier_.pop());
        }
        frame_.tally.add(kLongestQueue, longest_queue_);
    }

  private:
    // Part 1 of Figure 2.
    void take_answers() {
        while (!queue_.empty()) {
            const bool is_answered = frame_.canvas.is_answered(queue_.front().query);
            if (!is_answered && !frontier_.is_empty()) return;
            if (!is_answered && speculate()) continue;
            const Pending front = queue_.front();
            queue_.pop_front();
            take(front, frame_.canvas.samples(front.query));
        }
    }

    void take(const Pending& asked, std::uint32_t samples) {
        NodeClass& of_node = frame_.classes[parts_.node_of(asked.part)];
        if (samples <= settings_.most_hidden_pixels) {
            memory_.found_hidden(asked.part);
            if (!asked.was_visible) of_node = NodeClass::kOccluded;
            return;
        }
        of_node = NodeClass::kVisible;
        frame_.tally.add(kPullDowns, !asked.was_visible && !parts_.is_leaf(asked.part));
        memory_.pull_up(parts_, asked.part, frame_.tally);
        if (parts_.is_leaf(asked.part))
            memory_.found_visible(asked.part, settings_.patience.frames(
                                                  asked.part, parts_.box_of(asked.part),
                                                  memory_.visible_answers(asked.part) + 1, memory_.frame()));
        traverse(asked.part);
    }

    // Part 2 of Figure 2.
    void visit(PartId part) {
        if (parts_.is_leaf(part) && parts_.objects_of(part).empty()) return;
        frame_.tally.add(kNodesVisited);
        NodeClass& of_node = frame_.classes[parts_.node_of(part)];
        const Box box = parts_.box_of(part);
        if (is_outside(frame_.view, box)) {
            if (parts_.node_of(part) == part) of_node = NodeClass::kOutside;
            return;
        }
        const bool was_visible = memory_.visit(part);
        if (was_visible) of_node = NodeClass::kVisible;
        const bool is_opened = was_visible && !parts_.is_leaf(part);
        if (!is_opened && !ask(part, box, was_visible)) {
            of_node = NodeClass::kVisible;
            memory_.pull_up(parts_, part, frame_.tally);
            return traverse(part);
        }
        if (was_visible) traverse(part);
    }

    /// False where no question is due: the part is visible.
    bool ask(PartId part, const Box& box, bool was_visible) {
        if (was_visible && !memory_.is_to_ask(part)) {
            frame_.tally.add(kAssumed);
            return false;
        }
        const std::optional<Box> proxy = proxy_of(frame_.view, box, settings_.growth_pixels);
        if (!proxy) {
            frame_.tally.add(kUnaskable);
            return false;
        }
        frame_.tally.add(was_visible ? kVisibleQueries : kHiddenQueries);
        queue_.push_back({frame_.canvas.ask({&*proxy, 1}), part, was_visible, was_visible});
        longest_queue_ = std::max<std::uint64_t>(longest_queue_, queue_.size());
        return true;
    }

    void traverse(PartId part) {
        if (parts_.is_leaf(part))
            frame_.draw(parts_.objects_of(part));
        else
            frontier_.push_children(part);
    }

    /// Section 5.3: with nothing else to do, draws what is cheapest of what was asked about; false where that
    /// is too dear.
    bool speculate() {
        Pending* cheapest = nullptr;
        std::uint64_t least = settings_.speculation_triangles;
        for (Pending& pending : queue_) {
            if (pending.is_drawn) continue;
            const std::uint64_t triangles = undrawn_triangles(pending.part, least);
            if (triangles >= least) continue;
            least = triangles;
            cheapest = &pending;
        }
        if (!cheapest) return false;
        cheapest->is_drawn = true;
        frame_.tally.add(kSpeculated);
        frame_.tally.add(kSpeculatedTriangles, least);
        std::vector<ObjectId> all;
        parts_.for_subtree(cheapest->part, [&](std::span<const ObjectId> objects) {
            all.insert(all.end(), objects.begin(), objects.end());
        });
        frame_.draw(all);
        return true;
    }

    /// Of the subtree, at most `limit`.
    std::uint64_t undrawn_triangles(PartId part, std::uint64_t limit) const {
        std::uint64_t triangles = 0;
        parts_.for_subtree(part, [&](std::span<const ObjectId> objects) {
            if (triangles >= limit) return;
            for (const ObjectId id : objects)
                if (!frame_.is_drawn[id]) triangles += frame_.scene.objects[id].triangle_count();
        });
        return std::min(triangles, limit);
    }

    Frame& frame_;
    Memory& memory_;
    const Settings& settings_;
    Parts parts_;
    Frontier frontier_;
    std::deque<Pending> queue_;
    std::uint64_t longest_queue_ = 0;
};

class Chc final : public Culler {
  public:
    explicit Chc(const Settings& settings) : settings_(settings) {}

    void restart() override {
        memory_.forget();
        settings_.patience.forget();
    }

    void draw(Frame& frame) override {
        memory_.start_frame({frame.scene, frame.tree});
        settings_.patience.start_frame(frame.view);
        Traversal(frame, memory_, settings_).run();
    }

  private:
    Settings settings_;
    Memory memory_;
};

constexpr Knob kKnobs[] = {
    {"traversal", 0, 0, 1, "0 depth first, 1 by distance with a priority queue"},
    {"t_av", 0, 0, 8, "frames for which a leaf found visible is not asked about"},
    {"t_av_mode", 0, 0, 3,
     "t_av is 0 constant, 1 at first random, 2 by its answers, 3 by the camera's speed"},
    {"n_vp", 0, 0, 10'000, "a node of at most so many visible pixels is left out", true},
    {"speculate", 0, 0, 1e6, "triangles below which a node is drawn rather than waited for"},
    kProxyGrowthKnob,
};

std::uint32_t whole(const KnobValues& knobs, std::string_view name) {
    return static_cast<std::uint32_t>(knobs.find(name)->second);
}

}  // namespace

extern const CullerRecipe kChc;
const CullerRecipe kChc = {
    "chc", true, Needs::kQueries, kKnobs, [](const KnobValues& knobs) -> std::unique_ptr<Culler> {
        return std::make_unique<Chc>(
            Settings{static_cast<float>(knobs.at("proxy_growth")), whole(knobs, "traversal") == 1,
                     Patience(whole(knobs, "t_av"), static_cast<PatienceRule>(whole(knobs, "t_av_mode"))),
                     whole(knobs, "n_vp"), whole(knobs, "speculate")});
    }};

}  // namespace apps
