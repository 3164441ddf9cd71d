// SPDX-License-Identifier: MIT
// Builds a scene object by object from quads, boxes and cones, and bakes a light into their colours: a sun, a
// sky that is brighter from above, and air that is darker deep in a street. Fixed-function GL then draws
// without lights.
#pragma once

#include "apps/scene/scene.h"

namespace apps {

using Albedo = glm::vec3;  // reflected share of red, green, blue, in 0..1

class MeshBuilder {
  public:
    explicit MeshBuilder(Scene& scene) : scene_(scene) {}

    /// What is added until finish() is one object; an object without triangles is not kept.
    void finish();

    /// 2 triangles; corners counter-clockwise seen from outside.
    void quad(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const glm::vec3& d, Albedo albedo);

    /// 1 triangle, counter-clockwise seen from outside.
    void triangle(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, Albedo albedo);

    /// 10 triangles: all faces but the one that it stands on. Corners in any order.
    void standing_box(const glm::vec3& corner, const glm::vec3& opposite, Albedo albedo);

    /// 12 triangles: a box that is seen from below too.
    void hanging_box(const glm::vec3& corner, const glm::vec3& opposite, Albedo albedo);

    /// `sides` triangles (at least 3): a cone without its base, around a circle of `radius` metres; its tip
    /// hangs down where `height` is negative.
    void cone(const glm::vec3& base, float radius, float height, int sides, Albedo albedo);

    std::uint32_t triangles_so_far() const { return static_cast<std::uint32_t>(scene_.indices.size() / 3); }

  private:
    std::uint32_t vertex(const glm::vec3& position, const glm::vec3& normal, Albedo albedo);

    Scene& scene_;
    std::uint32_t first_index_ = 0;
    std::uint32_t first_vertex_ = 0;
};

}  // namespace apps
