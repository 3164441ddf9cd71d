// SPDX-License-Identifier: MIT
// The walk: a line through street crossings, its corners rounded within the crossing, the gaze a few steps
// ahead.
#include "apps/scene/city_path.h"

#include <algorithm>
#include <cmath>

#include "apps/scene/street_line.h"

namespace apps::city {
namespace {

constexpr float kCornerMetres = 5;  // the crossing is 12 m wide: the rounded corner stays inside
constexpr float kLookAheadMetres = 14;
constexpr float kRoofHeightMetres = 43;
constexpr int kKeys = 2000;
// With the height above, the mean shares of the paper's walk: 15.1 % of the triangles in the frustum, 19.5 %
// of those drawn.
constexpr float kViewDegrees = 43;

/// Crossings as shares of the city's side.
constexpr glm::vec2 kCrossings[] = {{0.22F, 0.11F}, {0.22F, 0.44F}, {0.55F, 0.44F}, {0.55F, 0.22F},
                                    {0.78F, 0.22F}, {0.78F, 0.66F}, {0.44F, 0.66F}, {0.44F, 0.89F},
                                    {0.11F, 0.89F}, {0.11F, 0.55F}};

/// The corners of the walk, in metres.
std::vector<glm::vec2> corners_of(int side) {
    std::vector<glm::vec2> corners;
    for (const glm::vec2& share : kCrossings) {
        const glm::vec2 crossing = glm::round(share * static_cast<float>(side)) * kPitchMetres;
        if (corners.empty() || corners.back() != crossing) corners.push_back(crossing);
    }
    if (corners.size() < 2) corners.push_back(corners.front() + glm::vec2(0, kPitchMetres));
    return corners;
}

/// 0 in the street, 1 at the highest point, smooth in between.
float rise(float at) {
    const float share = std::clamp((at - kRoofShareFrom) / (kRoofShareTo - kRoofShareFrom), 0.0F, 1.0F);
    const float up = std::clamp(1.5F - std::abs(3 * share - 1.5F), 0.0F, 1.0F);
    return up * up * (3 - 2 * up);
}

}  // namespace

CameraPath walk(int side) {
    const std::vector<glm::vec2> line = rounded_line(corners_of(side), kCornerMetres);
    const float length = length_of(line);
    std::vector<CameraKey> keys;
    for (int key = 0; key < kKeys; ++key) {
        const float at = static_cast<float>(key) / (kKeys - 1);
        const float up = rise(at);
        const glm::vec2 eye = point_at(line, at * length);
        const glm::vec2 ahead = point_at(line, at * length + kLookAheadMetres);
        const float height = kEyeMetres + kRoofHeightMetres * up;
        keys.push_back({at, {eye, height}, {ahead, height - 4 * up}});
    }
    return {std::move(keys), Lens{kViewDegrees, 0.3F, 2000}};
}

}  // namespace apps::city
