// SPDX-License-Identifier: MIT
// The kD-tree loses nothing: what is not in a leaf's box cannot be found visible by testing it.
#include <gtest/gtest.h>

#include <algorithm>

#include "apps/culling/culler.h"
#include "apps/hierarchy/kd_tree.h"
#include "apps/scene/random.h"
#include "apps/scene/scenes.h"

namespace {

using apps::Box;
using apps::Node;
using apps::NodeId;
using apps::ObjectId;
using apps::Scene;
using apps::Tree;

struct CityTree : testing::Test {
    CityTree() {
        const Scene raw = apps::build_chc_city(0.03, 5);
        tree = apps::build_kd_tree(raw, apps::leaf_count(*apps::find_scene("chc-city"), raw));
        city = apps::in_leaf_order(raw, tree);
    }

    Scene city;
    Tree tree;
};

TEST(KdTree, has_the_leaves_that_the_paper_has_something_in) {
    const Scene city = apps::build_chc_city(1, 1);
    const Tree tree = apps::build_kd_tree(city, apps::leaf_count(*apps::find_scene("chc-city"), city));
    EXPECT_EQ(tree.leaf_count(), 7'662U);  // scenes.cpp tells how they follow from the paper
    EXPECT_EQ(tree.nodes.size(), 2 * 7'662U - 1);
}

TEST(KdTree, of_an_empty_scene_is_one_leaf) {
    const Tree tree = apps::build_kd_tree({}, 100);
    ASSERT_EQ(tree.nodes.size(), 1U);
    EXPECT_TRUE(tree.nodes[0].is_leaf);
    EXPECT_TRUE(tree.nodes[0].box.is_empty());
}

TEST_F(CityTree, covers_every_point_of_every_triangle_by_a_leaf_that_lists_its_object) {
    std::vector<std::vector<NodeId>> leaves_of(city.objects.size());
    for (NodeId id = 0; id < tree.nodes.size(); ++id)
        if (tree.nodes[id].is_leaf)
            for (const ObjectId object : tree.objects_of(tree.nodes[id])) leaves_of[object].push_back(id);

    apps::Random random(1);
    for (ObjectId id = 0; id < city.objects.size(); ++id) {
        ASSERT_FALSE(leaves_of[id].empty()) << "object " << id << " is in no leaf";
        const apps::Object& object = city.objects[id];
        for (std::uint32_t i = 0; i < object.index_count; i += 3) {
            const glm::vec3& a = city.positions[city.indices[object.first_index + i]];
            const glm::vec3& b = city.positions[city.indices[object.first_index + i + 1]];
            const glm::vec3& c = city.positions[city.indices[object.first_index + i + 2]];
            for (int sample = 0; sample < 8; ++sample) {
                const float u = sample < 3 ? static_cast<float>(sample == 1) : random.unit();
                const float v = sample < 3 ? static_cast<float>(sample == 2) : random.unit() * (1 - u);
                const glm::vec3 point =
                    glm::clamp(a + u * (b - a) + v * (c - a), object.box.min, object.box.max);
                EXPECT_TRUE(std::any_of(leaves_of[id].begin(), leaves_of[id].end(),
                                        [&](NodeId leaf) { return tree.nodes[leaf].box.contains(point); }));
            }
        }
    }
}

TEST_F(CityTree, keeps_children_inside_their_parents_and_on_their_sides_of_the_plane) {
    std::vector<int> times_reached(tree.nodes.size(), 0);
    times_reached[0] = 1;
    for (NodeId id = 0; id < tree.nodes.size(); ++id) {
        const Node& node = tree.nodes[id];
        if (node.is_leaf) continue;
        const Box& low = tree.nodes[id + 1].box;
        const Box& high = tree.nodes[node.upper].box;
        ++times_reached[id + 1];
        ++times_reached[node.upper];
        EXPECT_TRUE(node.box.contains(low));
        EXPECT_TRUE(node.box.contains(high));
        EXPECT_LE(low.max[node.axis], node.split);
        EXPECT_GE(high.min[node.axis], node.split);
    }
    EXPECT_EQ(std::count(times_reached.begin(), times_reached.end(), 1), std::ssize(tree.nodes));
}

TEST_F(CityTree, has_leaf_boxes_no_larger_than_what_they_hold) {
    for (const Node& node : tree.nodes) {
        if (!node.is_leaf) continue;
        Box all;
        for (const ObjectId id : tree.objects_of(node)) all.add(city.objects[id].box);
        EXPECT_TRUE(all.contains(node.box));
    }
}

TEST_F(CityTree, is_the_same_for_the_same_scene) {
    const Scene raw = apps::build_chc_city(0.03, 5);
    Tree again = apps::build_kd_tree(raw, apps::leaf_count(*apps::find_scene("chc-city"), raw));
    EXPECT_EQ(hash_of(apps::in_leaf_order(raw, again)), hash_of(city));
    EXPECT_EQ(again.objects, tree.objects);
}

/// Keeps every call.
struct Recorder final : apps::Canvas {
    void draw(std::span<const ObjectId> objects) override {
        drawn.insert(drawn.end(), objects.begin(), objects.end());
    }
    std::vector<ObjectId> drawn;
};

TEST_F(CityTree, lets_an_object_that_straddles_leaves_be_drawn_once) {
    ASSERT_GT(tree.objects.size(), city.objects.size()) << "nothing straddles: the test would prove nothing";
    const apps::View view({{72, 72, 900}, glm::normalize(glm::vec3(0.01F, 0, -1)), {60, 0.3F, 5000}}, 640,
                          480);
    Recorder recorder;
    apps::Frame frame(0, city, tree, view, recorder);
    apps::make_culler("frustum")->draw(frame);
    std::sort(recorder.drawn.begin(), recorder.drawn.end());
    EXPECT_EQ(std::adjacent_find(recorder.drawn.begin(), recorder.drawn.end()), recorder.drawn.end());
    EXPECT_EQ(recorder.drawn.size(), city.objects.size()) << "the whole city is in view";
}

}  // namespace
