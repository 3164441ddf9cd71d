// SPDX-License-Identifier: MIT
// The two lists: Hey et al. 2001, section 3 and figure 2. Nothing that reaches behind a box is drawn before
// the box is tested.
#include "apps/culling/two_lists.h"

#include <functional>

#include "apps/hierarchy/world.h"
#include "apps/scene/mesh_builder.h"
#include "apps/scene/random.h"
#include "log_fixture.h"

namespace {

using apps::Box;
using apps::Camera;
using apps::DepthSteps;
using apps::kFarStep;
using apps::Lens;
using apps::NodeId;
using apps::Scene;
using apps::ScreenBox;
using apps::Tree;
using apps::View;
using apps_test::FakeDepths;

/// Finds hidden what it is told to; keeps the order of events, and what was behind all that was drawn.
struct Recorder final : apps::OcclusionMap {
    enum class What { kTest, kDraw };
    struct Event {
        What what;
        DepthSteps depth;  // znear of what is tested, zfar of what is drawn
    };

    void begin(const View&) override { events.clear(); }
    bool is_occluded(apps::Frame&, const ScreenBox& box) override {
        events.push_back({What::kTest, box.znear});
        return hides(box);
    }
    void was_drawn(apps::Frame& frame, const ScreenBox& box) override {
        events.push_back({What::kDraw, box.zfar});
        // The true reach of what this draw added, objects whole.
        for (; seen < frame.drawn.size(); ++seen)
            furthest = std::max(
                furthest, apps::screen_box(frame.view, frame.scene.objects[frame.drawn[seen]].box).zfar);
    }

    std::function<bool(const ScreenBox&)> hides = [](const ScreenBox&) { return false; };
    std::vector<Event> events;
    std::size_t seen = 0;
    DepthSteps furthest = 0;
};

const View kView({Camera{{0, 0, 0}, {1, 0, 0}, Lens{90, 0.5F, 1000}}, 160, 120});

/// A scene of objects that fill their boxes.
Scene scene_of(std::initializer_list<Box> boxes) {
    Scene scene;
    apps::MeshBuilder mesh(scene);
    for (const Box& box : boxes) {
        mesh.hanging_box(box.min, box.max, {1, 1, 1});
        mesh.finish();
    }
    return scene;
}

/// A tree of one root over leaves, by hand: leaf i holds object i.
Tree two_leaf_tree(const Scene& scene) {
    Tree tree;
    tree.nodes.resize(3);
    tree.objects = {0, 1};
    for (std::uint32_t leaf : {0U, 1U}) {
        tree.nodes[leaf + 1].box = scene.objects[leaf].box;
        tree.nodes[leaf + 1].first = leaf;
        tree.nodes[leaf + 1].count = 1;
        tree.nodes[0].box.add(scene.objects[leaf].box);
    }
    tree.nodes[0].is_leaf = false;
    tree.nodes[0].upper = 2;
    tree.link_parents();
    return tree;
}

struct TwoLists : testing::Test {
    void run(const Scene& scene, const Tree& tree, const View& view = kView) {
        FakeDepths canvas(view.width, view.height);
        apps::Frame frame(0, scene, tree, view, canvas);
        draw_in_two_lists(frame, map);
        drawn = frame.drawn;
        classes = frame.classes;
    }
    std::string order() const {
        std::string result;
        for (const auto& event : map.events) result += event.what == Recorder::What::kTest ? 't' : 'd';
        return result;
    }

    Recorder map;
    std::vector<apps::ObjectId> drawn;
    std::vector<apps::NodeClass> classes;
};

TEST_F(TwoLists, draw_what_lies_before_the_next_box_and_drain_in_the_end) {
    const Scene scene = scene_of({Box{{5, -1, -1}, {6, 1, 1}}, Box{{8, -1, -1}, {9, 1, 1}}});
    run(scene, two_leaf_tree(scene));
    EXPECT_EQ(order(), "ttdtd")
        << "root and first box tested, drawn before the second is tested; then drained";
    EXPECT_EQ(drawn, (std::vector<apps::ObjectId>{0, 1}));
}

TEST_F(TwoLists, test_boxes_that_reach_past_each_other_before_either_is_drawn) {
    const Scene scene = scene_of({Box{{5, -1, -1}, {8.5F, 1, 1}}, Box{{8, -1, -1}, {8.2F, 1, 1}}});
    run(scene, two_leaf_tree(scene));
    EXPECT_EQ(order(), "tttdd");
    EXPECT_EQ(drawn, (std::vector<apps::ObjectId>{1, 0})) << "drawn by their far ends";
}

// Case 21. A box whose near face lies in the plane of another's far face is tested first too.
TEST_F(TwoLists, test_ties_first_and_keep_the_order_of_equals) {
    for (const float gap : {0.0F, 1e-6F}) {
        const Scene scene = scene_of({Box{{5, -1, -1}, {6, 1, 1}}, Box{{6 + gap, -1, -1}, {7, 1, 1}}});
        run(scene, two_leaf_tree(scene));
        EXPECT_EQ(order(), "tttdd") << gap;
    }
    const Box sheet{{5, -1, -1}, {5, 1, 1}};
    const Scene flat = scene_of({sheet, sheet});
    run(flat, two_leaf_tree(flat));
    EXPECT_EQ(order(), "tttdd");
    EXPECT_EQ(drawn, (std::vector<apps::ObjectId>{0, 1}));
}

TEST_F(TwoLists, hold_a_node_with_objects_and_children_both) {
    const Scene scene =
        scene_of({Box{{5, -1, -1}, {6, 1, 1}}, Box{{8, -1, -1}, {9, 1, 1}}, Box{{20, -1, -1}, {21, 1, 1}}});
    Tree tree = two_leaf_tree(scene);
    tree.objects = {0, 1, 2};
    tree.nodes[0].first = 2;
    tree.nodes[0].count = 1;
    tree.nodes[0].box.add(scene.objects[2].box);
    run(scene, tree);
    EXPECT_EQ(drawn, (std::vector<apps::ObjectId>{0, 1, 2})) << "the root's own, far away, comes last";
    EXPECT_EQ(order(), "ttdtdd");
}

TEST_F(TwoLists, leave_a_hidden_subtree_untested_and_undrawn) {
    const Scene scene = scene_of({Box{{5, -1, -1}, {6, 1, 1}}, Box{{8, -1, -1}, {9, 1, 1}}});
    map.hides = [](const ScreenBox&) { return true; };
    run(scene, two_leaf_tree(scene));
    EXPECT_EQ(order(), "t");
    EXPECT_TRUE(drawn.empty());
    EXPECT_EQ(classes[0], apps::NodeClass::kOccluded);
    EXPECT_EQ(classes[1], apps::NodeClass::kUnvisited);
}

TEST_F(TwoLists, take_a_box_at_the_near_plane_as_visible_and_leave_one_outside_alone) {
    const Scene scene = scene_of({Box{{-1, -1, -1}, {6, 1, 1}}, Box{{-9, -1, -1}, {-8, 1, 1}}});
    map.hides = [](const ScreenBox&) { return true; };
    run(scene, two_leaf_tree(scene));
    EXPECT_EQ(order(), "d") << "root and first leaf hold the eye: nobody asks";
    EXPECT_EQ(drawn, std::vector<apps::ObjectId>{0});
    EXPECT_EQ(classes[2], apps::NodeClass::kOutside);
}

// The guarantee itself, on random boxes, from many places, with some of them hidden. In a kD-tree an object
// reaches out of the leaf that draws it: the guarantee is about the whole object.
TEST_F(TwoLists, never_draw_what_reaches_behind_a_box_that_is_still_to_be_tested) {
    apps::Random random(3);
    for (const apps::TreeKind kind : {apps::TreeKind::kKdTree, apps::TreeKind::kBvh}) {
        Scene scene;
        apps::MeshBuilder mesh(scene);
        for (int k = 0; k < 300; ++k) {
            const glm::vec3 at{random.between(0, 60), random.between(-30, 30), random.between(-9, 9)};
            const glm::vec3 size{random.between(0, 9), random.between(0, 9), random.between(0, 2)};
            mesh.hanging_box(at, at + size, {1, 1, 1});
            mesh.finish();
        }
        const apps::World world = make_world(scene, kind, 200);
        std::size_t tests = 0;
        std::size_t after_draws = 0;
        for (int round = 0; round < 20; ++round) {
            const glm::vec3 eye{random.between(-20, 60), random.between(-40, 40), random.between(-9, 9)};
            const glm::vec3 forward = glm::normalize(glm::vec3(30, 0, 0) - eye);
            const View view({Camera{eye, forward, Lens{60, 0.5F, 1000}}, 160, 120});
            map.seen = 0;
            map.furthest = 0;
            map.hides = [&](const ScreenBox& box) {
                EXPECT_GT(box.znear, map.furthest);
                ++tests;
                after_draws += map.furthest > 0;
                return random.below(9) == 0;
            };
            run(world.scene, world.tree, view);
            EXPECT_EQ(map.seen, drawn.size());
        }
        EXPECT_GT(tests, 1000U);
        EXPECT_GT(after_draws, 300U);
    }
}

}  // namespace
