// SPDX-License-Identifier: MIT
// The bounding volume hierarchy holds everything once, in boxes that enclose it, also after things have
// moved.
#include "apps/hierarchy/bvh.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>

#include "apps/hierarchy/kd_tree.h"
#include "apps/hierarchy/refit.h"
#include "apps/scene/random.h"
#include "apps/scene/scenes.h"

namespace {

using apps::Box;
using apps::BvhLimits;
using apps::Node;
using apps::NodeId;
using apps::ObjectId;
using apps::Scene;
using apps::Tree;

/// Each child once below its parent and inside it, each object in one leaf that encloses it.
void expect_sound(const Tree& tree, const std::vector<Box>& boxes) {
    std::vector<int> times_listed(boxes.size(), 0);
    std::vector<int> times_reached(tree.nodes.size(), 0);
    times_reached[0] = 1;
    for (NodeId id = 0; id < tree.nodes.size(); ++id) {
        const Node& node = tree.nodes[id];
        EXPECT_EQ(node.axis, Node::kNoPlane);
        Box exact;
        for (const ObjectId object : tree.objects_of(node)) {
            ++times_listed[object];
            exact.add(boxes[object]);
        }
        if (!node.is_leaf) {
            EXPECT_EQ(node.count, 0U);
            for (const NodeId child : {id + 1, node.upper}) {
                ++times_reached[child];
                EXPECT_EQ(tree.nodes[child].parent, id);
                exact.add(tree.nodes[child].box);
            }
        }
        EXPECT_EQ(node.box.min, exact.min) << "node " << id;
        EXPECT_EQ(node.box.max, exact.max) << "node " << id;
    }
    EXPECT_EQ(std::count(times_listed.begin(), times_listed.end(), 1), std::ssize(boxes));
    EXPECT_EQ(std::count(times_reached.begin(), times_reached.end(), 1), std::ssize(tree.nodes));
}

std::vector<Box> boxes_of(const Scene& scene) {
    std::vector<Box> boxes;
    for (const apps::Object& object : scene.objects) boxes.push_back(object.box);
    return boxes;
}

/// What a ray of random direction is expected to cost, by the surface area heuristic.
double expected_triangles(const Tree& tree, const Scene& scene) {
    double sum = 0;
    for (const Node& node : tree.nodes)
        sum += node.box.surface_area() * static_cast<double>(triangles_of(scene, tree.objects_of(node)));
    return sum / tree.nodes[0].box.surface_area();
}

bool same_bits(const Tree& a, const Tree& b) {
    const auto is_same = [](const Node& x, const Node& y) {
        return std::equal(&x.box.min.x, &x.box.min.x + 3, &y.box.min.x) &&
               std::equal(&x.box.max.x, &x.box.max.x + 3, &y.box.max.x) && x.upper == y.upper &&
               x.first == y.first && x.count == y.count && x.parent == y.parent && x.is_leaf == y.is_leaf;
    };
    return a.objects == b.objects &&
           std::equal(a.nodes.begin(), a.nodes.end(), b.nodes.begin(), b.nodes.end(), is_same);
}

TEST(Bvh, has_as_many_leaves_as_asked_for_and_holds_each_object_once) {
    const Scene city = apps::build_chc_city(0.05, 3);
    for (const std::size_t leaves : {std::size_t{1}, std::size_t{2}, std::size_t{700}}) {
        const Tree tree = build_bvh(city, {.leaves = leaves});
        EXPECT_EQ(tree.leaf_count(), leaves);
        expect_sound(tree, boxes_of(city));
    }
    const Tree whole = build_bvh(city, {.leaves = 10 * city.objects.size()});
    EXPECT_EQ(whole.leaf_count(), city.objects.size());
}

TEST(Bvh, has_no_leaf_of_more_triangles_than_allowed_but_a_single_object) {
    const Scene city = apps::build_chc_city(0.05, 3);
    for (const std::size_t most : {1U, 30U, 100U, 1500U}) {
        const Tree tree = build_bvh(city, {.leaf_triangles = most});
        expect_sound(tree, boxes_of(city));
        for (const Node& node : tree.nodes)
            EXPECT_TRUE(node.count < 2 || triangles_of(city, tree.objects_of(node)) <= most);
    }
}

TEST(Bvh, costs_rays_no_more_than_a_kd_tree_of_as_many_leaves) {
    const Scene city = apps::build_chc_city(0.05, 3);
    const std::size_t leaves = 800;
    EXPECT_LT(expected_triangles(build_bvh(city, {.leaves = leaves}), city),
              1.1 * expected_triangles(apps::build_kd_tree(city, leaves), city));
}

TEST(Bvh, of_an_empty_scene_is_one_leaf) {
    const Tree tree = build_bvh(Scene(), {.leaves = 100, .leaf_triangles = 1});
    ASSERT_EQ(tree.nodes.size(), 1U);
    EXPECT_TRUE(tree.nodes[0].is_leaf && tree.nodes[0].box.is_empty());
}

TEST(Bvh, divides_what_lies_in_one_place) {
    const std::vector<apps::SoupTriangle> soup(100, {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}});
    const Tree tree = build_bvh(soup, {.leaf_triangles = 10});
    for (const Node& node : tree.nodes) EXPECT_LE(node.count, 10U);
}

TEST(Bvh, over_the_bare_triangles_of_a_scene_encloses_each_of_them) {
    const Scene city = apps::build_chc_city(0.05, 3);
    const std::vector<apps::SoupTriangle> soup = flattened(city);
    ASSERT_EQ(soup.size(), city.triangle_count());
    std::vector<Box> boxes(soup.size());
    for (std::size_t i = 0; i < soup.size(); ++i)
        for (const glm::vec3& corner : soup[i].corners) boxes[i].add(corner);
    const Tree tree = build_bvh(soup, {.leaf_triangles = 150});
    expect_sound(tree, boxes);
    for (const Node& node : tree.nodes) EXPECT_LE(node.count, 150U);
}

TEST(Bvh, is_the_same_bits_for_any_number_of_threads) {
    const Scene city = apps::build_chc_city(0.2, 3);
    const std::vector<apps::SoupTriangle> soup = flattened(city);
    ASSERT_GT(soup.size(), 200'000U) << "too few triangles for several threads: the test would prove nothing";
    const auto built_by = [&](std::size_t threads) {
        const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
        return std::pair(build_bvh(soup, {.leaf_triangles = 100}), build_bvh(city, {.leaves = 3000}));
    };
    const auto alone = built_by(1);
    const auto together = built_by(4);
    EXPECT_TRUE(same_bits(alone.first, together.first));
    EXPECT_TRUE(same_bits(alone.second, together.second));
}

TEST(Bvh, fits_again_after_objects_have_moved) {
    Scene city = apps::build_chc_city(0.05, 3);
    Tree all = build_bvh(city, {.leaves = 800});
    Tree few = all;
    apps::Refitter refitter(few, city.objects.size());
    apps::Random random(8);
    for (int round = 0; round < 3; ++round) {
        std::vector<ObjectId> moved;
        for (ObjectId id = 0; id < city.objects.size(); ++id) {
            if (random.below(20) != 0) continue;
            const glm::vec3 way(random.between(-300, 300), random.between(-300, 300), random.unit());
            city.objects[id].box.min += way;
            city.objects[id].box.max += way;
            moved.push_back(id);
        }
        ASSERT_GT(moved.size(), 20U);
        refit(all, city);
        refitter.refit(few, city, moved);
        expect_sound(few, boxes_of(city));
        EXPECT_TRUE(same_bits(all, few));
    }
}

}  // namespace
