// SPDX-License-Identifier: MIT
// The walk: a line through street crossings, its corners rounded within the crossing, the gaze a few steps
// ahead.
#include "apps/scene/city_path.h"

#include <algorithm>
#include <cmath>

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

/// The line with its corners rounded, in metres.
std::vector<glm::vec2> rounded_line(int side) {
    std::vector<glm::vec2> corners;
    for (const glm::vec2& share : kCrossings) {
        const glm::vec2 crossing = glm::round(share * static_cast<float>(side)) * kPitchMetres;
        if (corners.empty() || corners.back() != crossing) corners.push_back(crossing);
    }
    if (corners.size() < 2) corners.push_back(corners.front() + glm::vec2(0, kPitchMetres));
    std::vector<glm::vec2> line{corners.front()};
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
        const glm::vec2 from = corners[i] + kCornerMetres * glm::normalize(corners[i - 1] - corners[i]);
        const glm::vec2 to = corners[i] + kCornerMetres * glm::normalize(corners[i + 1] - corners[i]);
        for (int step = 0; step <= 8; ++step) {
            const float t = static_cast<float>(step) / 8;
            line.push_back(glm::mix(glm::mix(from, corners[i], t), glm::mix(corners[i], to, t), t));
        }
    }
    line.push_back(corners.back());
    return line;
}

/// The point `metres` along the line, straight on after its end.
glm::vec2 point_at(const std::vector<glm::vec2>& line, float metres) {
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const float length = glm::distance(line[i], line[i + 1]);
        if (metres <= length || i + 2 == line.size())
            return line[i] + (line[i + 1] - line[i]) * (metres / length);
        metres -= length;
    }
    return line.back();
}

float length_of(const std::vector<glm::vec2>& line) {
    float sum = 0;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) sum += glm::distance(line[i], line[i + 1]);
    return sum;
}

/// 0 in the street, 1 at the highest point, smooth in between.
float rise(float at) {
    const float share = std::clamp((at - kRoofShareFrom) / (kRoofShareTo - kRoofShareFrom), 0.0F, 1.0F);
    const float up = std::clamp(1.5F - std::abs(3 * share - 1.5F), 0.0F, 1.0F);
    return up * up * (3 - 2 * up);
}

}  // namespace

CameraPath walk(int side) {
    const std::vector<glm::vec2> line = rounded_line(side);
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
