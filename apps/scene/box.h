// SPDX-License-Identifier: MIT
// Axis-aligned boxes in world metres: closed sets, so two boxes that share a face leave no gap between them.
#pragma once

#include <algorithm>
#include <glm/glm.hpp>
#include <limits>

namespace apps {

struct Box {
    glm::vec3 min{std::numeric_limits<float>::max()};
    glm::vec3 max{std::numeric_limits<float>::lowest()};

    bool is_empty() const { return !(min.x <= max.x && min.y <= max.y && min.z <= max.z); }

    void add(const glm::vec3& point) {
        min = glm::min(min, point);
        max = glm::max(max, point);
    }
    void add(const Box& other) {
        min = glm::min(min, other.min);
        max = glm::max(max, other.max);
    }

    bool contains(const glm::vec3& point) const {
        return glm::all(glm::lessThanEqual(min, point)) && glm::all(glm::lessThanEqual(point, max));
    }
    bool contains(const Box& other) const { return contains(other.min) && contains(other.max); }

    /// The box with every face moved outwards by `metres`.
    Box grown(float metres) const { return {min - glm::vec3(metres), max + glm::vec3(metres)}; }

    /// Corner 0..7: bit k chooses max on axis k.
    glm::vec3 corner(int index) const {
        return {index & 1 ? max.x : min.x, index & 2 ? max.y : min.y, index & 4 ? max.z : min.z};
    }

    glm::vec3 centre() const { return (min + max) * 0.5F; }

    /// Square metres of the six faces; 0 for an empty box.
    double surface_area() const {
        if (is_empty()) return 0;
        const glm::dvec3 size = glm::dvec3(max) - glm::dvec3(min);
        return 2 * (size.x * size.y + size.y * size.z + size.z * size.x);
    }
};

inline Box intersection(const Box& a, const Box& b) {
    return {glm::max(a.min, b.min), glm::min(a.max, b.max)};
}

}  // namespace apps
