// SPDX-License-Identifier: MIT
// Culling that the GPU does by itself: what a node encloses is drawn on condition that its box's query counts
// something (NV_conditional_render, 2007; OpenGL 3.0), so that no answer travels to the CPU and nothing waits
// for one. The CPU sends what it would send without culling.
//
// Coherent: leaves that were visible in the last frame are drawn first, without condition, and asked about
// when everything is; a node that was hidden is one query and one condition for all below it (the cut of
// CHC, Figure 2 of J. Bittner et al., 2004), and is opened in the next frame where it was not hidden. Of what
// the last frame did not visit, each leaf is asked about. The answers are read when the frame's time has been
// taken, as a program would read them during the next.
//
// Not coherent: each leaf of the frustum, front to back, its query just before it.
#include "apps/culling/chc_counts.h"
#include "apps/culling/chc_memory.h"

namespace apps {
namespace {

const Statistic kConditionalTriangles{"conditional_triangles", "triangles sent on condition"};

struct Settings {
    float growth_pixels;
    Condition condition;
    bool is_coherent;
    bool is_hierarchical;
};

class Conditional final : public Culler {
  public:
    explicit Conditional(const Settings& settings) : settings_(settings) {}

    void restart() override {
        memory_.forget();
        asked_.clear();
    }

    void draw(Frame& frame) override {
        const Parts parts(frame.scene, frame.tree);
        memory_.start_frame(parts);
        asked_.clear();
        Frontier frontier(parts, frame.view.eye, false);
        Findings found;
        frontier.push(0);
        while (!frontier.is_empty()) visit(frame, parts, frontier.pop(), frontier, found);
        if (!settings_.is_coherent) return;
        frame.draw(in_runs(found.visible_objects));
        for (const PartId part : found.hidden) draw_on_condition(frame, parts, part);
        for (const PartId part : found.visible) {
            frame.tally.add(kVisibleQueries);
            ask(frame, parts, part);
        }
    }

    /// What a no-wait condition drew in vain the program cannot know: an object counts as drawn where its
    /// query counted something, as with a condition that waits.
    void settle(Frame& frame) override {
        const Parts parts(frame.scene, frame.tree);
        for (const Asked& asked : asked_) {
            frame.canvas.is_answered(asked.query);
            const bool is_visible = frame.canvas.samples(asked.query) != 0;
            NodeClass& of_node = frame.classes[parts.node_of(asked.part)];
            if (!is_visible) {
                if (!asked.objects.empty()) of_node = NodeClass::kOccluded;
                continue;
            }
            of_node = NodeClass::kVisible;
            memory_.pull_up(parts, asked.part, frame.tally);
            for (const ObjectId id : asked.objects) {
                if (frame.is_drawn[id]) continue;
                frame.is_drawn[id] = 1;
                frame.drawn.push_back(id);
            }
        }
        asked_.clear();
    }

  private:
    struct Findings {
        std::vector<ObjectId> visible_objects;  // of leaves that are drawn without condition
        std::vector<PartId> visible;            // those of them that can be asked about
        std::vector<PartId> hidden;             // parts to be drawn on condition
    };
    struct Asked {
        QueryId query;
        PartId part;
        std::vector<ObjectId> objects;  // drawn on condition; none where drawn without
    };

    void visit(Frame& frame, const Parts& parts, PartId part, Frontier& frontier, Findings& found) {
        if (parts.is_leaf(part) && parts.objects_of(part).empty()) return;
        frame.tally.add(kNodesVisited);
        const Box box = parts.box_of(part);
        if (is_outside(frame.view, box)) {
            if (parts.node_of(part) == part) frame.classes[part] = NodeClass::kOutside;
            return;
        }
        const bool is_known = memory_.was_visited_before(part);
        const bool was_visible = memory_.visit(part) && settings_.is_coherent;
        const bool is_askable = proxy_of(frame.view, box, settings_.growth_pixels).has_value();
        if (!parts.is_leaf(part)) {
            const bool is_one =
                is_known && !was_visible && is_askable && settings_.is_coherent && settings_.is_hierarchical;
            if (is_one) return found.hidden.push_back(part);
            frame.classes[part] = NodeClass::kVisible;
            return frontier.push_children(part);
        }
        if (!is_askable || was_visible) {
            if (!is_askable) {
                frame.tally.add(kUnaskable);
                memory_.pull_up(parts, part, frame.tally);
            } else {
                found.visible.push_back(part);
            }
            frame.classes[parts.node_of(part)] = NodeClass::kVisible;
            const std::span<const ObjectId> objects = parts.objects_of(part);
            if (!settings_.is_coherent) return frame.draw(objects);
            found.visible_objects.insert(found.visible_objects.end(), objects.begin(), objects.end());
        } else if (settings_.is_coherent) {
            found.hidden.push_back(part);
        } else {
            draw_on_condition(frame, parts, part);
        }
    }

    /// The part may be asked about.
    Asked& ask(Frame& frame, const Parts& parts, PartId part) {
        const std::optional<Box> proxy = proxy_of(frame.view, parts.box_of(part), settings_.growth_pixels);
        asked_.push_back({frame.canvas.ask({&*proxy, 1}), part, {}});
        return asked_.back();
    }

    void draw_on_condition(Frame& frame, const Parts& parts, PartId part) {
        std::vector<ObjectId> objects;
        parts.for_subtree(part, [&](std::span<const ObjectId> hanging) {
            for (const ObjectId id : hanging)
                if (!frame.is_drawn[id] && !is_outside(frame.view, frame.scene.objects[id].box))
                    objects.push_back(id);
        });
        if (objects.empty()) return;
        objects = in_runs(objects);
        frame.tally.add(kHiddenQueries);
        frame.tally.add(kConditionalTriangles, triangles_of(frame.scene, objects));
        Asked& asked = ask(frame, parts, part);
        frame.canvas.draw_on_condition(asked.query, settings_.condition, objects);
        asked.objects = std::move(objects);
    }

    Settings settings_;
    Memory memory_;
    std::vector<Asked> asked_;
};

constexpr Knob kKnobs[] = {
    {"mode", 0, 0, 3, "the GPU: 0 waits for the answer, 1 does not, 2 and 3 the same by region"},
    {"coherent", 1, 0, 1, "1: what was visible in the last frame is drawn first, without condition"},
    {"hierarchical", 1, 0, 1, "1: what was hidden together is one condition, where coherent"},
    kProxyGrowthKnob,
};

}  // namespace

extern const CullerRecipe kConditional;
const CullerRecipe kConditional = {
    "conditional", true, Needs::kCondition, kKnobs, [](const KnobValues& knobs) -> std::unique_ptr<Culler> {
        return std::make_unique<Conditional>(Settings{
            .growth_pixels = static_cast<float>(knobs.at("proxy_growth")),
            .condition = static_cast<Condition>(static_cast<int>(knobs.at("mode"))),
            .is_coherent = knobs.at("coherent") >= 1,
            .is_hierarchical = knobs.at("hierarchical") >= 1,
        });
    }};

}  // namespace apps
