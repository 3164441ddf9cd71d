// SPDX-License-Identifier: MIT
// Only + - * / touch a coordinate, so that the same frame is the same bits on every machine.
#include "apps/scene/motion.h"

#include <algorithm>

#include "apps/scene/random.h"

namespace apps {
namespace {

constexpr float kSmallestReach = 0.005F;  // half axes, of the diagonal of the scene's bounds
constexpr float kLargestReach = 0.03F;
constexpr int kShortestPeriod = 90;  // frames
constexpr int kLongestPeriod = 360;

/// A point of the unit circle for a share of a turn, in [0, 1): the rational parametrisation, a quarter at a
/// time.
glm::vec2 circle(float turn) {
    const auto quarter = static_cast<int>(4 * turn);
    const float t = 4 * turn - static_cast<float>(quarter);
    const glm::vec2 point = glm::vec2(1 - t * t, 2 * t) / (1 + t * t);
    const glm::vec2 turned[] = {point, {-point.y, point.x}, -point, {point.y, -point.x}};
    return turned[quarter & 3];
}

float diagonal_of(const Box& box) {
    return box.is_empty() ? 0 : glm::length(box.max - box.min);
}

float median_diagonal(const Scene& scene) {
    if (scene.objects.empty()) return 0;
    std::vector<float> diagonals;
    for (const Object& object : scene.objects) diagonals.push_back(diagonal_of(object.box));
    const auto middle = diagonals.begin() + std::ssize(diagonals) / 2;
    std::nth_element(diagonals.begin(), middle, diagonals.end());
    return *middle;
}

std::uint64_t fingerprint(const Object& object) {
    return hash_bytes(std::as_bytes(std::span(&object.index_count, 1)),
                      hash_bytes(std::as_bytes(std::span(&object.box, 1))));
}

/// About a vertical axis through `middle`, to where the cosine and sine point, then by `way`.
glm::mat4 turned_about(const glm::vec3& middle, const glm::vec2& turn, const glm::vec3& way) {
    glm::mat4 motion(1);
    motion[0] = {turn.x, turn.y, 0, 0};
    motion[1] = {-turn.y, turn.x, 0, 0};
    motion[3] = {middle.x + way.x - turn.x * middle.x + turn.y * middle.y,
                 middle.y + way.y - turn.y * middle.x - turn.x * middle.y, way.z, 1};
    return motion;
}

/// The box of the turned box: each half extent is shared out by the turn. Larger by what float rounding of a
/// product of two placements may come to.
Box turned_box(const Box& box, const glm::vec2& turn, const glm::vec3& way) {
    const glm::vec3 half = 0.5F * (box.max - box.min);
    const glm::vec3 extent(half.x * std::abs(turn.x) + half.y * std::abs(turn.y),
                           half.x * std::abs(turn.y) + half.y * std::abs(turn.x), half.z);
    const glm::vec3 middle = box.centre() + way;
    const glm::vec3 far = glm::abs(box.centre()) + glm::abs(middle) + extent;
    return Box{middle - extent, middle + extent}.grown(1e-6F * std::max({far.x, far.y, far.z}));
}

}  // namespace

Motion::Motion(Scene& scene, double share, std::uint64_t seed) {
    const float largest = 2 * median_diagonal(scene);
    const float reach = diagonal_of(scene.bounds);
    for (ObjectId id = 0; id < scene.objects.size(); ++id) {
        Object& object = scene.objects[id];
        if (object.box.is_empty() || !(diagonal_of(object.box) <= largest)) continue;
        Random random(fingerprint(object) ^ Random(seed).next());
        if (!(random.unit() < share)) continue;

        const glm::vec2 direction = circle(random.unit());
        const auto half_axis = [&] { return reach * random.between(kSmallestReach, kLargestReach); };
        Curve curve;
        curve.home = scene.placements[object.placement];
        curve.box = object.box;
        curve.along = half_axis() * direction;
        curve.across = half_axis() * glm::vec2(-direction.y, direction.x);
        curve.rise = 0.25F * half_axis();
        curve.period_frames = kShortestPeriod + random.below(kLongestPeriod - kShortestPeriod);
        curve.turns = random.below(2) == 0 ? -1 - random.below(2) : 1 + random.below(2);
        object.placement = static_cast<std::uint32_t>(scene.placements.size());
        scene.placements.push_back(curve.home);
        moving_.push_back(id);
        curves_.push_back(curve);

        const glm::vec2 sweep = 2.0F * glm::abs(curve.along) + glm::abs(curve.across);
        const glm::vec2 turning(glm::length(glm::vec2(object.box.max - object.box.min)));
        const glm::vec3 most(sweep + turning, 0);
        scene.bounds.add(Box{object.box.min - most, object.box.max + most + glm::vec3(0, 0, curve.rise)});
    }
}

void Motion::place(Scene& scene, int frame) const {
    for (std::size_t i = 0; i < moving_.size(); ++i) {
        const Curve& curve = curves_[i];
        Object& object = scene.objects[moving_[i]];
        const int moment = frame % curve.period_frames;
        if (moment == 0) {
            scene.placements[object.placement] = curve.home;
            object.box = curve.box;
            continue;
        }
        const auto share_of_turn = [&](int count) {
            const int passed = (count * moment) % curve.period_frames;
            return static_cast<float>(passed < 0 ? passed + curve.period_frames : passed) /
                   static_cast<float>(curve.period_frames);
        };
        const glm::vec2 at = circle(share_of_turn(1));
        const glm::vec3 way((at.x - 1) * curve.along + at.y * curve.across,
                            (0.5F - 0.5F * at.x) * curve.rise);
        const glm::vec2 turn = circle(share_of_turn(curve.turns));
        scene.placements[object.placement] = turned_about(curve.box.centre(), turn, way) * curve.home;
        object.box = turned_box(curve.box, turn, way);
    }
}

}  // namespace apps
