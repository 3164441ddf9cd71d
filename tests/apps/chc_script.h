// SPDX-License-Identifier: MIT
// A machine whose answers are written down beforehand: which objects are visible, and after how many calls a
// query's answer is there. And small worlds for it.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "apps/culling/culler.h"
#include "apps/scene/mesh_builder.h"

namespace apps_test {

inline constexpr std::uint64_t kNeverUnlessWaitedFor = ~std::uint64_t{0};

/// Counts as a query's samples the visible objects whose centre lies in one of its boxes.
class ScriptedCanvas final : public apps::Canvas {
  public:
    explicit ScriptedCanvas(const apps::Scene& scene) : scene_(scene) {}

    std::set<apps::ObjectId> visible;
    std::uint64_t latency_calls = 0;

    struct Event {
        enum Kind { kDraw, kAsk, kTake, kDrawOnCondition } kind;
        std::vector<apps::ObjectId> objects;  // drawn; or those whose centre is in the boxes asked about
        std::size_t boxes = 0;
    };
    std::vector<Event> events;
    std::uint64_t polls = 0;
    std::uint64_t waits = 0;

    void draw(std::span<const apps::ObjectId> objects) override {
        ++calls_;
        events.push_back({Event::kDraw, {objects.begin(), objects.end()}});
    }
    apps::QueryId ask(std::span<const apps::Box> proxies) override {
        ++calls_;
        Event event{Event::kAsk, {}, proxies.size()};
        for (apps::ObjectId id = 0; id < scene_.objects.size(); ++id)
            if (std::any_of(proxies.begin(), proxies.end(), [&](const apps::Box& box) {
                    return box.contains(scene_.objects[id].box.centre());
                }))
                event.objects.push_back(id);
        events.push_back(event);
        queries_.push_back({samples_of(event.objects), calls_, false});
        return static_cast<apps::QueryId>(queries_.size() - 1);
    }
    bool is_answered(apps::QueryId query) override {
        ++calls_;
        ++polls;
        Query& asked = queries_.at(query);
        EXPECT_FALSE(asked.is_taken);
        if (latency_calls != kNeverUnlessWaitedFor && calls_ - asked.call > latency_calls) is_known_ = query;
        return is_known_ == query;
    }
    std::uint32_t samples(apps::QueryId query) override {
        ++calls_;
        Query& asked = queries_.at(query);
        EXPECT_FALSE(asked.is_taken) << "an answer is taken once";
        asked.is_taken = true;
        waits += is_known_ != query;
        events.push_back({Event::kTake, {}});
        return asked.samples;
    }
    void draw_on_condition(apps::QueryId, apps::Condition, std::span<const apps::ObjectId> objects) override {
        ++calls_;
        events.push_back({Event::kDrawOnCondition, {objects.begin(), objects.end()}});
    }

    std::size_t count(Event::Kind kind) const {
        return static_cast<std::size_t>(
            std::count_if(events.begin(), events.end(), [&](const Event& e) { return e.kind == kind; }));
    }

    /// Objects drawn without condition, in order; an object drawn twice stands there twice.
    std::vector<apps::ObjectId> drawn() const {
        std::vector<apps::ObjectId> all;
        for (const Event& event : events)
            if (event.kind == Event::kDraw) all.insert(all.end(), event.objects.begin(), event.objects.end());
        return all;
    }

    /// Of single questions, the objects that they were about.
    std::vector<std::vector<apps::ObjectId>> asked() const {
        std::vector<std::vector<apps::ObjectId>> all;
        for (const Event& event : events)
            if (event.kind == Event::kAsk) all.push_back(event.objects);
        return all;
    }

    void start_frame() {
        events.clear();
        polls = waits = 0;
    }

  private:
    struct Query {
        std::uint32_t samples;
        std::uint64_t call;
        bool is_taken;
    };
    std::uint32_t samples_of(const std::vector<apps::ObjectId>& objects) const {
        return static_cast<std::uint32_t>(std::count_if(
            objects.begin(), objects.end(), [&](apps::ObjectId id) { return visible.contains(id); }));
    }

    const apps::Scene& scene_;
    std::vector<Query> queries_;
    std::uint64_t calls_ = 0;
    std::optional<apps::QueryId> is_known_;
};

/// Boxes of an edge of 0.8 m, a metre apart along y, 80 m before an eye at the origin that looks along x;
/// and so much farther each as `step_metres` says.
inline apps::Scene row_of_boxes(int count, float step_metres = 0) {
    apps::Scene scene;
    apps::MeshBuilder mesh(scene);
    for (int i = 0; i < count; ++i) {
        const auto k = static_cast<float>(i);
        const glm::vec3 centre(80 + step_metres * k, k - 0.5F * static_cast<float>(count - 1), 0);
        mesh.triangle(centre - 0.4F, centre + 0.4F, centre + glm::vec3(0.4F, -0.4F, 0), {1, 1, 1});
        mesh.finish();
    }
    return scene;
}

/// The complete binary tree over objects first..end, a power of two, a leaf each.
inline void add_complete(apps::Tree& tree, const apps::Scene& scene, apps::ObjectId first,
                         apps::ObjectId end) {
    const auto id = static_cast<apps::NodeId>(tree.nodes.size());
    tree.nodes.emplace_back();
    apps::Box box;
    for (apps::ObjectId object = first; object < end; ++object) box.add(scene.objects[object].box);
    tree.nodes[id].box = box;
    if (end - first == 1) {
        tree.nodes[id].first = static_cast<std::uint32_t>(tree.objects.size());
        tree.nodes[id].count = 1;
        tree.objects.push_back(first);
        return;
    }
    tree.nodes[id].is_leaf = false;
    const apps::ObjectId middle = (first + end) / 2;
    add_complete(tree, scene, first, middle);
    tree.nodes[id].upper = static_cast<apps::NodeId>(tree.nodes.size());
    add_complete(tree, scene, middle, end);
}

inline apps::Tree complete_tree(const apps::Scene& scene) {
    apps::Tree tree;
    add_complete(tree, scene, 0, static_cast<apps::ObjectId>(scene.objects.size()));
    tree.link_parents();
    return tree;
}

/// Object 0 hangs in the root itself, 1 and 2 in its leaves.
inline apps::Tree two_leaves_and_a_root(const apps::Scene& scene) {
    apps::Tree tree;
    tree.nodes.resize(3);
    tree.objects = {0, 1, 2};
    for (std::uint32_t i = 0; i < 3; ++i) {
        tree.nodes[i].first = i;
        tree.nodes[i].count = 1;
        tree.nodes[i].box = scene.objects[i].box;
    }
    tree.nodes[0].box.add(tree.nodes[1].box);
    tree.nodes[0].box.add(tree.nodes[2].box);
    tree.nodes[0].is_leaf = false;
    tree.nodes[0].upper = 2;
    tree.link_parents();
    return tree;
}

/// A culler on a scripted canvas, frame by frame.
struct Play {
    Play(apps::Scene the_scene, apps::Tree the_tree, std::string_view culler_name,
         const apps::KnobValues& settings = {})
        : scene(std::move(the_scene)),
          tree(std::move(the_tree)),
          canvas(scene),
          culler(apps::make_culler(culler_name, settings)) {}

    Play(int boxes, std::string_view culler_name, const apps::KnobValues& settings = {})
        : Play(row_of_boxes(boxes), complete_tree(row_of_boxes(boxes)), culler_name, settings) {}

    /// The drawn set of one frame.
    std::set<apps::ObjectId> frame() {
        canvas.start_frame();
        const apps::View view({eye, {1, 0, 0}, {}}, 640, 480);
        apps::Frame frame(number++, scene, tree, view, canvas);
        culler->draw(frame);
        calls_of_frame = canvas.events;
        culler->settle(frame);
        tally = frame.tally;
        return {frame.drawn.begin(), frame.drawn.end()};
    }
    std::set<apps::ObjectId> frames(int count) {
        std::set<apps::ObjectId> last;
        for (int i = 0; i < count; ++i) last = frame();
        return last;
    }
    std::size_t queries() const { return canvas.count(ScriptedCanvas::Event::kAsk); }

    /// Of a statistic by name; fails where there is none.
    std::uint64_t count_of(std::string_view name) const {
        for (const apps::Statistic* each : apps::Statistic::all())
            if (each->name() == name) return tally.of(*each);
        ADD_FAILURE() << "no statistic " << name;
        return 0;
    }

    apps::Scene scene;
    apps::Tree tree;
    ScriptedCanvas canvas;
    std::unique_ptr<apps::Culler> culler;
    glm::vec3 eye{0};
    int number = 0;
    apps::Tally tally;
    std::vector<ScriptedCanvas::Event> calls_of_frame;
};

}  // namespace apps_test
