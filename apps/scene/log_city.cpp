// SPDX-License-Identifier: MIT
// log-city: the city of H. Hey, R. F. Tobler, W. Purgathofer, Real-Time Occlusion Culling with a Lazy
// Occlusion Grid, 2001, section 5: 34,034,176 triangles, "subdivided into bounding boxes until each contains
// no more than 1500". That number is 512 times 66,473: one block, placed 512 times, which stands once in
// memory. The paper tells no more of its city; streets, buildings and walk are ours, chosen for its shares of
// triangles in the frustum and drawn.
//
// A scale is a number of blocks, rounded, and blocks are added far from the walk: from 16 blocks on (scale
// 1/32) it is the same walk through the same streets, with more behind them.
#include <algorithm>
#include <cmath>

#include "apps/scene/log_city_block.h"
#include "apps/scene/scenes.h"
#include "apps/scene/street_line.h"

namespace apps {
namespace {

using log_city::kLargeMetres;
using log_city::kSmallMetres;

constexpr int kBlocks = 512;
constexpr float kEyeMetres = 1.7F;
constexpr float kCornerMetres = 3;  // streets are 8 m wide
constexpr float kLookAheadMetres = 5;
constexpr float kViewDegrees = 45;
constexpr int kKeys = 1500;

/// Where block (i, j) of the Pythagorean tiling has the corner of its large square.
glm::vec2 corner_of(int i, int j) {
    return static_cast<float>(i) * glm::vec2(kLargeMetres, kSmallMetres) +
           static_cast<float>(j) * glm::vec2(-kSmallMetres, kLargeMetres);
}

/// The first `count` blocks of the quarter plane i, j >= 0: squares that grow from its corner.
std::vector<glm::vec2> corners(std::size_t count) {
    std::vector<glm::vec2> all;
    for (int ring = 0; all.size() < count; ++ring) {
        for (int i = 0; i < ring; ++i) all.push_back(corner_of(i, ring));
        for (int j = 0; j <= ring; ++j) all.push_back(corner_of(ring, j));
    }
    all.resize(count);
    return all;
}

/// Through streets of the first 16 blocks: into the city, then out of it again. Corners are given by the
/// block and the place from its corner; every street is a line that two squares' sides make.
CameraPath walk() {
    constexpr float a = kLargeMetres;
    constexpr float b = kSmallMetres;
    const auto of = [](int i, int j, float x, float y) { return corner_of(i, j) + glm::vec2(x, y); };
    const std::vector<glm::vec2> turns = {
        of(3, 1, 0, 0.8F * a), of(3, 1, 0, a),  of(3, 1, a, a), of(3, 1, a, a + b), of(3, 1, a - b, a + b),
        of(3, 1, a - b, a),    of(3, 1, -b, a), of(2, 2, a, 0), of(2, 2, 0, 0),     of(2, 2, 0, -b),
        of(1, 1, -b, a),       of(0, 2, a, 0),  of(0, 2, 0, 0), of(0, 2, 0, -b)};
    const std::vector<glm::vec2> line = rounded_line(turns, kCornerMetres);
    const float length = length_of(line);
    std::vector<CameraKey> keys;
    for (int key = 0; key < kKeys; ++key) {
        const float at = static_cast<float>(key) / (kKeys - 1);
        const glm::vec2 eye = point_at(line, at * length);
        const glm::vec2 ahead = point_at(line, at * length + kLookAheadMetres);
        keys.push_back({at, {eye, kEyeMetres}, {ahead, kEyeMetres + 0.4F}});
    }
    return {std::move(keys), Lens{kViewDegrees, 0.3F, 4000}};
}

}  // namespace

Scene build_log_city(double scale, std::uint64_t seed) {
    Scene scene;
    scene.name = "log-city";
    MeshBuilder mesh(scene);
    log_city::add_block(mesh, seed);
    const std::vector<Object> block = std::move(scene.objects);
    scene.objects.clear();
    scene.bounds = {};
    const auto blocks = static_cast<std::size_t>(std::max(1L, std::lround(scale * kBlocks)));
    for (const glm::vec2& corner : corners(blocks)) {
        glm::mat4 placement(1);
        placement[3] = {corner, 0, 1};
        scene.placements.push_back(placement);
        for (Object object : block) {
            object.placement = static_cast<std::uint32_t>(scene.placements.size() - 1);
            object.box.min += glm::vec3(corner, 0);
            object.box.max += glm::vec3(corner, 0);
            scene.bounds.add(object.box);
            scene.objects.push_back(object);
        }
    }
    scene.path = walk();
    return scene;
}

}  // namespace apps
