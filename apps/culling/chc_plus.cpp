// SPDX-License-Identifier: MIT
// CHC++: O. Mattausch, J. Bittner, M. Wimmer, CHC++: Coherent Hierarchical Culling Revisited, Eurographics
// 2008. What it adds to chc.cpp:
//  - hidden nodes are asked about in batches, so that the GPU changes its state seldom, and what is visible
//  is
//    drawn just before a batch, all that has come together at once;
//  - hidden nodes that have been hidden for long share a query, and are asked about each where it fails;
//  - visible leaves are asked about while the CPU would wait, or at the end; their answers are for the next
//    frame, which takes them when it begins;
//  - a visible leaf is not asked again for t_av frames, the first time any number up to that;
//  - a query of a node draws the tighter boxes of its children.
//
// Ours: what is drawn together is in runs of neighbours, a call each, and the runs front to back. While
// answers are on their way the tree is traversed, then the batch is issued, then visible leaves are asked
// about; only then does the CPU wait (a published implementation spins instead). A leaf that was asked often
// and always visible is asked more and more seldom.
#include <algorithm>
#include <deque>

#include "apps/culling/chc_counts.h"
#include "apps/culling/chc_groups.h"
#include "apps/culling/chc_patience.h"

namespace apps {
namespace {

const Statistic kMultiQueries{"multi_queries", "queries of several hidden nodes at once"};
const Statistic kMultiQueryNodes{"multi_query_nodes", "hidden nodes that shared a query"};
const Statistic kFailedNodes{"multi_query_failed_nodes",
                             "of them those asked again, one of theirs being visible"};
const Statistic kBatches{"query_batches", "batches of queries of hidden nodes"};
const Statistic kLateAnswers{"late_answers", "answers about visible leaves taken a frame later"};

// Drawn at once: more would keep a GPU of some tens of millions of triangles a second waiting for the first.
constexpr std::uint64_t kMostCollected = 30'000;

struct Settings {
    float growth_pixels;
    Patience patience;
    double query_triangles;
    std::uint32_t most_hidden_pixels;
    std::size_t batch;
    double many_cost;
    double box_cost;
    int tight_depth;
    double tight_area;
};

struct HiddenQuery {
    QueryId query;
    std::vector<PartId> parts;
};

struct VisibleQuery {
    QueryId query;
    PartId leaf;
    std::uint32_t frame;
};

/// One frame.
class Traversal {
  public:
    Traversal(Frame& frame, Memory& memory, const Settings& settings, std::deque<VisibleQuery>& visible_asked)
        : frame_(frame),
          canvas_(frame.canvas),
          memory_(memory),
          settings_(settings),
          visible_asked_(visible_asked),
          parts_(frame.scene, frame.tree),
          frontier_(parts_, frame.view.eye, true) {}

    void run() {
        take_late_answers();
        frontier_.push(0);
        while (!frontier_.is_empty() || !hidden_.empty() || !hidden_asked_.empty()) {
            take_answers();
            if (!frontier_.is_empty())
                visit(frontier_.pop());
            else if (!hidden_.empty())
                ask_hidden();
        }
        draw_collected();
        while (ask_visible()) {
        }
        // No answer is more than a frame late.
        while (!visible_asked_.empty() && visible_asked_.front().frame != memory_.frame()) take_visible();
        frame_.tally.add(kLongestQueue, longest_queue_);
    }

  private:
    void take_late_answers() {
        while (!visible_asked_.empty() && canvas_.is_answered(visible_asked_.front().query)) {
            frame_.tally.add(kLateAnswers);
            take_visible();
        }
    }

    void take_visible() {
        const VisibleQuery asked = visible_asked_.front();
        visible_asked_.pop_front();
        if (canvas_.samples(asked.query) > settings_.most_hidden_pixels)
            memory_.found_visible(asked.leaf, frames_to_skip(asked.leaf));
        else
            memory_.pull_down(parts_, asked.leaf);
    }

    std::uint32_t frames_to_skip(PartId leaf) const {
        const std::uint32_t answers = memory_.visible_answers(leaf) + 1;
        const std::uint32_t frames =
            settings_.patience.frames(leaf, parts_.box_of(leaf), answers, memory_.frame());
        const auto triangles = static_cast<double>(triangles_of(frame_.scene, parts_.objects_of(leaf)));
        if (triangles <= settings_.query_triangles) return frames;
        return static_cast<std::uint32_t>(frames * (settings_.query_triangles / triangles));
    }

    void take_answers() {
        while (!hidden_asked_.empty()) {
            if (!canvas_.is_answered(hidden_asked_.front().query)) {
                if (!frontier_.is_empty() || !hidden_.empty()) return;
                draw_collected();
                if (ask_visible()) continue;
            }
            const HiddenQuery asked = std::move(hidden_asked_.front());
            hidden_asked_.pop_front();
            const bool is_hidden = canvas_.samples(asked.query) <= settings_.most_hidden_pixels;
            for (const PartId part : asked.parts) take(part, is_hidden, asked.parts.size());
        }
    }

    void take(PartId part, bool is_hidden, std::size_t together) {
        if (is_hidden) {
            memory_.found_hidden(part);
            frame_.classes[parts_.node_of(part)] = NodeClass::kOccluded;
        } else if (together > 1) {
            frame_.tally.add(kFailedNodes);
            ask({part});
        } else {
            frame_.tally.add(kPullDowns, !parts_.is_leaf(part));
            if (parts_.is_leaf(part)) memory_.found_visible(part, frames_to_skip(part));
            open(part);
        }
    }

    void visit(PartId part) {
        if (parts_.is_leaf(part) && parts_.objects_of(part).empty()) return;
        frame_.tally.add(kNodesVisited);
        const Box box = parts_.box_of(part);
        if (is_outside(frame_.view, box)) {
            if (parts_.node_of(part) == part) frame_.classes[part] = NodeClass::kOutside;
            return;
        }
        const bool was_visible = memory_.visit(part);
        if (was_visible && !parts_.is_leaf(part)) {
            frame_.classes[part] = NodeClass::kVisible;
            frontier_.push_children(part);
        } else if (was_visible) {
            open(part);
            if (memory_.is_to_ask(part))
                visible_.push_back(part);
            else
                frame_.tally.add(kAssumed);
        } else if (!proxy_of(frame_.view, box, settings_.growth_pixels)) {
            frame_.tally.add(kUnaskable);
            open(part);
        } else {
            hidden_.push_back(part);
            if (hidden_.size() >= settings_.batch) ask_hidden();
        }
    }

    /// The part is visible: its objects are to be drawn, or its children to be visited.
    void open(PartId part) {
        frame_.classes[parts_.node_of(part)] = NodeClass::kVisible;
        memory_.pull_up(parts_, part, frame_.tally);
        if (!parts_.is_leaf(part)) return frontier_.push_children(part);
        const std::span<const ObjectId> objects = parts_.objects_of(part);
        collected_.insert(collected_.end(), objects.begin(), objects.end());
        collected_triangles_ += triangles_of(frame_.scene, objects);
        if (collected_triangles_ > kMostCollected) draw_collected();
    }

    /// With it go the questions about leaves that the time before drew: not all at the end, where the GPU
    /// would have nothing else to do.
    void draw_collected() {
        if (collected_.empty()) return;
        frame_.draw(in_runs(collected_));
        collected_.clear();
        collected_triangles_ = 0;
        while (next_visible_ < drawn_visible_) ask_visible();
        drawn_visible_ = visible_.size();
    }

    /// Issues the batch: those hidden for longest first, so that they share queries with their like.
    void ask_hidden() {
        frame_.tally.add(kBatches);
        std::stable_sort(hidden_.begin(), hidden_.end(), [&](PartId a, PartId b) {
            return memory_.hidden_frames(a) > memory_.hidden_frames(b);
        });
        std::vector<double> probabilities;
        for (const PartId part : hidden_)
            probabilities.push_back(probability_to_stay_hidden(memory_.hidden_frames(part)));
        const std::span<const PartId> all(hidden_);
        draw_collected();
        for (std::size_t first = 0; first < all.size();) {
            const std::size_t count =
                best_group(std::span(probabilities).subspan(first), settings_.many_cost, settings_.box_cost);
            ask(all.subspan(first, count));
            first += count;
        }
        hidden_.clear();
    }

    void ask(std::span<const PartId> parts) {
        std::vector<Box> proxies;
        for (const PartId part : parts) add_proxies(part, proxies);
        if (parts.size() > 1) {
            frame_.tally.add(kMultiQueries);
            frame_.tally.add(kMultiQueryNodes, parts.size());
        }
        frame_.tally.add(kHiddenQueries);
        hidden_asked_.push_back({canvas_.ask(proxies), {parts.begin(), parts.end()}});
        note_queue();
    }
    void ask(std::initializer_list<PartId> parts) { ask(std::span(parts.begin(), parts.size())); }

    /// The node's own box may be asked about, or it would not be here; tight ones are, unless one may not.
    void add_proxies(PartId part, std::vector<Box>& proxies) const {
        const std::size_t first = proxies.size();
        for (const Box& box : tight_boxes(parts_, part, settings_.tight_depth, settings_.tight_area)) {
            const std::optional<Box> proxy = proxy_of(frame_.view, box, settings_.growth_pixels);
            if (proxy) {
                proxies.push_back(*proxy);
                continue;
            }
            proxies.resize(first);
            proxies.push_back(*proxy_of(frame_.view, parts_.box_of(part), settings_.growth_pixels));
            return;
        }
    }

    /// Asks about one visible leaf; false where there is none left.
    bool ask_visible() {
        while (next_visible_ < visible_.size()) {
            const PartId leaf = visible_[next_visible_++];
            const std::optional<Box> proxy =
                proxy_of(frame_.view, parts_.box_of(leaf), settings_.growth_pixels);
            if (!proxy) {
                frame_.tally.add(kUnaskable);
                continue;
            }
            frame_.tally.add(kVisibleQueries);
            memory_.await_answer(leaf);
            visible_asked_.push_back({canvas_.ask({&*proxy, 1}), leaf, memory_.frame()});
            note_queue();
            return true;
        }
        return false;
    }

    void note_queue() {
        longest_queue_ =
            std::max<std::uint64_t>(longest_queue_, hidden_asked_.size() + visible_asked_.size());
    }

    Frame& frame_;
    Canvas& canvas_;
    Memory& memory_;
    const Settings& settings_;
    std::deque<VisibleQuery>& visible_asked_;
    Parts parts_;
    Frontier frontier_;
    std::vector<ObjectId> collected_;
    std::uint64_t collected_triangles_ = 0;
    std::vector<PartId> hidden_;  // of the batch that is not issued yet: the i-queue
    std::deque<HiddenQuery> hidden_asked_;
    std::vector<PartId> visible_;  // leaves whose query is due: the v-queue
    std::size_t next_visible_ = 0;
    std::size_t drawn_visible_ = 0;  // so many of them were collected before what was drawn last
    std::uint64_t longest_queue_ = 0;
};

class ChcPlus final : public Culler {
  public:
    explicit ChcPlus(const Settings& settings) : settings_(settings) {}

    void restart() override {
        memory_.forget();
        settings_.patience.forget();
        visible_asked_.clear();  // never fetched: their ids are not used again
    }

    void draw(Frame& frame) override {
        if (memory_.start_frame({frame.scene, frame.tree})) visible_asked_.clear();
        settings_.patience.start_frame(frame.view);
        Traversal(frame, memory_, settings_, visible_asked_).run();
    }

  private:
    Settings settings_;
    Memory memory_;
    std::deque<VisibleQuery> visible_asked_;
};

constexpr Knob kKnobs[] = {
    {"t_av", 10, 0, 60, "frames for which a leaf found visible is not asked about"},
    {"t_av_mode", 4, 0, 4,
     "t_av is 0 constant, 1 at first random, 2 by its answers, 3 by the camera's speed, 4 as 2, at random"},
    {"query_triangles", 360, 1, 1e6, "a leaf of more triangles is asked about the sooner"},
    {"n_vp", 0, 0, 10'000, "a node of at most so many visible pixels is left out", true},
    {"batch", 50, 1, 1000, "hidden nodes in a batch of queries"},
    {"many_cost", 1, 1, 100, "what a query of several nodes costs beside one of one, for choosing how many"},
    {"box_cost", 0, 0, 10, "what each of its boxes costs beside"},
    {"tight_depth", 0, 0, 6, "levels below a node whose boxes may stand for its own"},
    {"tight_area", 1.4, 1, 4, "most surface of these boxes, by the node's own"},
    kProxyGrowthKnob,
};

std::uint32_t whole(const KnobValues& knobs, std::string_view name) {
    return static_cast<std::uint32_t>(knobs.find(name)->second);
}

}  // namespace

extern const CullerRecipe kChcPlus;
const CullerRecipe kChcPlus = {
    "chc++", true, Needs::kQueries, kKnobs, [](const KnobValues& knobs) -> std::unique_ptr<Culler> {
        return std::make_unique<ChcPlus>(Settings{
            .growth_pixels = static_cast<float>(knobs.at("proxy_growth")),
            .patience = Patience(whole(knobs, "t_av"), static_cast<PatienceRule>(whole(knobs, "t_av_mode"))),
            .query_triangles = knobs.at("query_triangles"),
            .most_hidden_pixels = whole(knobs, "n_vp"),
            .batch = whole(knobs, "batch"),
            .many_cost = knobs.at("many_cost"),
            .box_cost = knobs.at("box_cost"),
            .tight_depth = static_cast<int>(knobs.at("tight_depth")),
            .tight_area = knobs.at("tight_area"),
        });
    }};

}  // namespace apps
