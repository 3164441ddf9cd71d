// SPDX-License-Identifier: MIT
// What moves is where its box says, comes back, and is the same whatever the order of the objects.
#include "apps/scene/motion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>

#include "apps/scene/scenes.h"

namespace {

using apps::Box;
using apps::Motion;
using apps::Object;
using apps::ObjectId;
using apps::Scene;

constexpr int kSomeFrames[] = {1, 7, 45, 90, 181, 359, 10'000};

Scene city() {
    return apps::build_chc_city(0.03, 5);
}

TEST(Motion, starts_with_the_scene_as_it_is) {
    const Scene still = city();
    Scene scene = still;
    const Motion motion(scene, 0.3, 1);
    motion.place(scene, 200);
    motion.place(scene, 0);
    for (ObjectId id = 0; id < scene.objects.size(); ++id) {
        EXPECT_EQ(scene.objects[id].box.min, still.objects[id].box.min);
        EXPECT_EQ(scene.objects[id].box.max, still.objects[id].box.max);
        EXPECT_EQ(scene.placements[scene.objects[id].placement], glm::mat4(1));
    }
}

TEST(Motion, keeps_every_object_whole_and_inside_its_box) {
    const Scene still = city();
    Scene scene = still;
    const Motion motion(scene, 1, 4);
    for (const int frame : kSomeFrames) {
        motion.place(scene, frame);
        double farthest = 0;
        for (const ObjectId id : motion.moving()) {
            const Object& object = scene.objects[id];
            const glm::dmat4 placement(scene.placements[object.placement]);
            for (std::uint32_t v = object.first_vertex; v < object.first_vertex + object.vertex_count; ++v) {
                const glm::dvec3 point(placement * glm::dvec4(scene.positions[v], 1));
                EXPECT_TRUE(glm::all(glm::lessThanEqual(glm::dvec3(object.box.min), point)) &&
                            glm::all(glm::lessThanEqual(point, glm::dvec3(object.box.max))))
                    << "object " << id << " in frame " << frame;
                farthest = std::max(farthest, glm::length(point - glm::dvec3(scene.positions[v])));
            }
            // A rigid motion: lengths and right angles stay.
            const glm::dmat3 turn(placement);
            for (int a = 0; a < 3; ++a)
                for (int b = 0; b < 3; ++b) EXPECT_NEAR(glm::dot(turn[a], turn[b]), a == b, 1e-6);
            EXPECT_TRUE(scene.bounds.contains(object.box));
        }
        EXPECT_GT(farthest, 0.1) << "nothing has moved in frame " << frame;
    }
}

TEST(Motion, has_boxes_not_much_larger_than_what_is_in_them) {
    Scene scene = city();
    const Motion motion(scene, 1, 4);
    motion.place(scene, 77);
    double tight = 0;
    double made = 0;
    for (const ObjectId id : motion.moving()) {
        const Object& object = scene.objects[id];
        tight += placed_box(scene, object, scene.placements[object.placement]).surface_area();
        made += object.box.surface_area();
    }
    EXPECT_LT(made, 1.5 * tight);
}

TEST(Motion, leaves_the_ground_and_other_large_objects_where_they_are) {
    Scene scene = city();
    std::vector<std::pair<double, ObjectId>> sizes;
    for (ObjectId id = 0; id < scene.objects.size(); ++id)
        sizes.emplace_back(scene.objects[id].box.surface_area(), id);
    std::sort(sizes.rbegin(), sizes.rend());
    const Motion motion(scene, 1, 1);
    EXPECT_GT(motion.moving().size(), scene.objects.size() / 2);
    for (int i = 0; i < 20; ++i)
        EXPECT_FALSE(std::binary_search(motion.moving().begin(), motion.moving().end(),
                                        sizes[static_cast<std::size_t>(i)].second));
}

TEST(Motion, moves_about_the_share_that_was_asked_for_and_more_of_the_same_for_a_larger_one) {
    Scene all = city();
    Scene third = city();
    Scene tenth = city();
    const Motion everything(all, 1, 9);
    const Motion more(third, 0.33, 9);
    const Motion less(tenth, 0.1, 9);
    const auto count = static_cast<double>(everything.moving().size());
    EXPECT_NEAR(static_cast<double>(more.moving().size()), 0.33 * count, 0.05 * count);
    EXPECT_NEAR(static_cast<double>(less.moving().size()), 0.1 * count, 0.04 * count);
    EXPECT_TRUE(std::includes(more.moving().begin(), more.moving().end(), less.moving().begin(),
                              less.moving().end()));
    Scene other = city();
    EXPECT_NE(Motion(other, 0.1, 10).moving(), less.moving());
}

TEST(Motion, does_not_depend_on_the_order_of_the_objects) {
    Scene forwards = city();
    std::vector<ObjectId> order(forwards.objects.size());
    std::iota(order.rbegin(), order.rend(), ObjectId{0});
    Scene backwards = reordered(forwards, order);
    const Motion a(forwards, 0.5, 2);
    const Motion b(backwards, 0.5, 2);
    a.place(forwards, 123);
    b.place(backwards, 123);
    for (ObjectId id = 0; id < order.size(); ++id) {
        const Box& one = forwards.objects[order[id]].box;
        const Box& other = backwards.objects[id].box;
        EXPECT_TRUE(one.min == other.min && one.max == other.max);
    }
}

}  // namespace
