// SPDX-License-Identifier: MIT
// Geometry and baked light. Only + - * / and sqrt touch a coordinate, so the bits do not depend on a libm.
#include "apps/scene/mesh_builder.h"

#include <algorithm>

#include "apps/scene/light.h"

namespace apps {
namespace {

/// Of a cross product; up for a triangle without an area.
glm::vec3 unit(const glm::vec3& cross) {
    const float length = glm::length(cross);
    return length > 0 ? cross / length : glm::vec3(0, 0, 1);
}

glm::u8vec4 lit(const glm::vec3& position, const glm::vec3& normal, const Albedo& albedo) {
    const glm::vec3 light = albedo * baked_light(position, normal);
    return {glm::u8vec3(glm::clamp(light, 0.0F, 1.0F) * 255.0F + 0.5F), 255};
}

}  // namespace

std::uint32_t MeshBuilder::vertex(const glm::vec3& position, const glm::vec3& normal, Albedo albedo) {
    scene_.positions.push_back(position);
    scene_.colours.push_back(lit(position, normal, albedo));
    return static_cast<std::uint32_t>(scene_.positions.size() - 1);
}

void MeshBuilder::finish() {
    Object object;
    object.first_index = first_index_;
    object.first_vertex = first_vertex_;
    object.index_count = static_cast<std::uint32_t>(scene_.indices.size()) - first_index_;
    object.vertex_count = static_cast<std::uint32_t>(scene_.positions.size()) - first_vertex_;
    if (object.index_count == 0) return;
    for (std::uint32_t v = 0; v < object.vertex_count; ++v)
        object.box.add(scene_.positions[first_vertex_ + v]);
    first_index_ += object.index_count;
    first_vertex_ += object.vertex_count;
    scene_.bounds.add(object.box);
    scene_.objects.push_back(object);
}

void MeshBuilder::quad(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const glm::vec3& d,
                       Albedo albedo) {
    const glm::vec3 normal = unit(glm::cross(c - a, d - b));
    const std::uint32_t first = vertex(a, normal, albedo);
    vertex(b, normal, albedo);
    vertex(c, normal, albedo);
    vertex(d, normal, albedo);
    for (const std::uint32_t corner : {0U, 1U, 2U, 0U, 2U, 3U}) scene_.indices.push_back(first + corner);
}

void MeshBuilder::triangle(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, Albedo albedo) {
    const glm::vec3 normal = unit(glm::cross(b - a, c - a));
    for (const glm::vec3& corner : {a, b, c}) scene_.indices.push_back(vertex(corner, normal, albedo));
}

void MeshBuilder::standing_box(const glm::vec3& corner, const glm::vec3& opposite, Albedo albedo) {
    const glm::vec3 lo = glm::min(corner, opposite);
    const glm::vec3 hi = glm::max(corner, opposite);
    quad({lo.x, lo.y, hi.z}, {hi.x, lo.y, hi.z}, {hi.x, hi.y, hi.z}, {lo.x, hi.y, hi.z}, albedo);
    quad({lo.x, lo.y, lo.z}, {hi.x, lo.y, lo.z}, {hi.x, lo.y, hi.z}, {lo.x, lo.y, hi.z}, albedo);
    quad({hi.x, lo.y, lo.z}, {hi.x, hi.y, lo.z}, {hi.x, hi.y, hi.z}, {hi.x, lo.y, hi.z}, albedo);
    quad({hi.x, hi.y, lo.z}, {lo.x, hi.y, lo.z}, {lo.x, hi.y, hi.z}, {hi.x, hi.y, hi.z}, albedo);
    quad({lo.x, hi.y, lo.z}, {lo.x, lo.y, lo.z}, {lo.x, lo.y, hi.z}, {lo.x, hi.y, hi.z}, albedo);
}

void MeshBuilder::hanging_box(const glm::vec3& corner, const glm::vec3& opposite, Albedo albedo) {
    standing_box(corner, opposite, albedo);
    const glm::vec3 lo = glm::min(corner, opposite);
    const glm::vec3 hi = glm::max(corner, opposite);
    quad({lo.x, hi.y, lo.z}, {hi.x, hi.y, lo.z}, {hi.x, lo.y, lo.z}, {lo.x, lo.y, lo.z}, albedo);
}

void MeshBuilder::cone(const glm::vec3& base, float radius, float height, int sides, Albedo albedo) {
    // The rational parametrisation of the circle, a quarter at a time: no sine, the same bits everywhere.
    const auto rim = [&](int side) {
        const float turn = 4 * static_cast<float>(side % sides) / static_cast<float>(sides);
        const auto quarter = static_cast<int>(turn);
        const float t = turn - static_cast<float>(quarter);
        const glm::vec2 point = glm::vec2(1 - t * t, 2 * t) / (1 + t * t);
        const glm::vec2 turned[] = {point, {-point.y, point.x}, -point, {point.y, -point.x}};
        return base + radius * glm::vec3(turned[quarter], 0);
    };
    const glm::vec3 tip = base + glm::vec3(0, 0, height);
    for (int side = 0; side < sides; ++side) {
        const int next = side + 1;
        triangle(rim(height < 0 ? next : side), rim(height < 0 ? side : next), tip, albedo);
    }
}

}  // namespace apps
