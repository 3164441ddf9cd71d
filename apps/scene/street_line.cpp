// SPDX-License-Identifier: MIT
// Corners become parabolas.
#include "apps/scene/street_line.h"

namespace apps {

std::vector<glm::vec2> rounded_line(const std::vector<glm::vec2>& corners, float rounding) {
    std::vector<glm::vec2> line{corners.front()};
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
        const glm::vec2 from = corners[i] + rounding * glm::normalize(corners[i - 1] - corners[i]);
        const glm::vec2 to = corners[i] + rounding * glm::normalize(corners[i + 1] - corners[i]);
        for (int step = 0; step <= 8; ++step) {
            const float t = static_cast<float>(step) / 8;
            line.push_back(glm::mix(glm::mix(from, corners[i], t), glm::mix(corners[i], to, t), t));
        }
    }
    line.push_back(corners.back());
    return line;
}

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

}  // namespace apps
