// SPDX-License-Identifier: MIT
// Rays through a scene, for the shadows in pictures: through the tree to objects, and in each through a tree
// over the triangles of its mesh, built when the first ray asks.
#pragma once

#include <memory>
#include <mutex>
#include <unordered_map>

#include "apps/hierarchy/tree.h"

namespace apps {

/// From a point, so many metres along a direction of unit length.
struct Ray {
    Ray(const glm::vec3& from, const glm::vec3& unit_direction, float reach_metres)
        : origin(from), direction(unit_direction), inverse(1.0F / unit_direction), reach(reach_metres) {}

    glm::vec3 origin, direction, inverse;
    float reach;
};

class RayCaster {
  public:
    /// Both stay as they are while rays are cast.
    RayCaster(const Scene& scene, const Tree& tree);

    /// True where a triangle crosses the ray between 0 and its reach. Several threads may ask.
    bool is_blocked(const Ray& ray) const;

  private:
    struct Mesh {
        std::once_flag is_built;
        Tree tree;  // over triangles: 0 is the one at the mesh's first index
    };

    const Tree& tree_of(const Object& object) const;
    bool crosses(const Ray& ray, const Object& object) const;

    const Scene& scene_;
    const Tree& tree_;
    mutable std::unordered_map<std::uint32_t, Mesh> meshes_;  // by first index; all there from the start
};

}  // namespace apps
