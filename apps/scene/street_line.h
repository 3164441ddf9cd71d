// SPDX-License-Identifier: MIT
// A line through streets: corners, rounded, and points along it by the way gone.
#pragma once

#include <glm/glm.hpp>
#include <vector>

namespace apps {

/// The corners joined, each rounded from `rounding` metres before it to as far behind. At least two.
std::vector<glm::vec2> rounded_line(const std::vector<glm::vec2>& corners, float rounding);

/// The point `metres` along the line, straight on after its end.
glm::vec2 point_at(const std::vector<glm::vec2>& line, float metres);

/// Metres.
float length_of(const std::vector<glm::vec2>& line);

}  // namespace apps
