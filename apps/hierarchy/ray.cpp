// SPDX-License-Identifier: MIT
// Any hit will do, so the order of nodes does not matter. Boxes by slabs; triangles by Moeller, Trumbore:
// Fast, minimum storage ray-triangle intersection, 1997. A placed object is met in its mesh's own space: its
// placement is a rigid motion, so lengths along the ray stay.
#include "apps/hierarchy/ray.h"

#include <algorithm>
#include <cmath>

#include "apps/hierarchy/bvh.h"

namespace apps {
namespace {

constexpr std::size_t kLeafTriangles = 4;

bool crosses(const Ray& ray, const Box& box) {
    const glm::vec3 a = (box.min - ray.origin) * ray.inverse;
    const glm::vec3 b = (box.max - ray.origin) * ray.inverse;
    const glm::vec3 low = glm::min(a, b);
    const glm::vec3 high = glm::max(a, b);
    const float enter = std::max({low.x, low.y, low.z, 0.0F});
    const float leave = std::min({high.x, high.y, high.z, ray.reach});
    return enter <= leave;
}

bool crosses(const Ray& ray, const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    const glm::vec3 u = b - a;
    const glm::vec3 v = c - a;
    const glm::vec3 p = glm::cross(ray.direction, v);
    const float determinant = glm::dot(u, p);
    if (std::abs(determinant) < 1e-9F) return false;
    const glm::vec3 t = ray.origin - a;
    const float s = glm::dot(t, p) / determinant;
    const glm::vec3 q = glm::cross(t, u);
    const float r = glm::dot(ray.direction, q) / determinant;
    const float distance = glm::dot(v, q) / determinant;
    return s >= 0 && r >= 0 && s + r <= 1 && distance > 0 && distance < ray.reach;
}

Ray in_mesh_space(const Ray& ray, const glm::mat4& placement) {
    const glm::mat3 back = glm::transpose(glm::mat3(placement));
    return {back * (ray.origin - glm::vec3(placement[3])), back * ray.direction, ray.reach};
}

/// True where `hits` is true of something that hangs in a node whose box the ray crosses.
template <class Hits>
bool is_met(const Ray& ray, const Tree& tree, Hits&& hits) {
    std::vector<NodeId> stack{0};
    stack.reserve(64);
    while (!stack.empty()) {
        const NodeId id = stack.back();
        stack.pop_back();
        const Node& node = tree.nodes[id];
        if (!crosses(ray, node.box)) continue;
        for (const ObjectId member : tree.objects_of(node))
            if (hits(member)) return true;
        if (node.is_leaf) continue;
        stack.push_back(node.upper);
        stack.push_back(id + 1);
    }
    return false;
}

}  // namespace

RayCaster::RayCaster(const Scene& scene, const Tree& tree) : scene_(scene), tree_(tree) {
    meshes_.reserve(scene.objects.size());
    for (const Object& object : scene.objects) meshes_.try_emplace(object.first_index);
}

const Tree& RayCaster::tree_of(const Object& object) const {
    Mesh& mesh = meshes_.find(object.first_index)->second;
    std::call_once(mesh.is_built, [&] {
        std::vector<SoupTriangle> triangles(object.triangle_count());
        for (std::uint32_t i = 0; i < 3 * triangles.size(); ++i)
            triangles[i / 3].corners[i % 3] = scene_.positions[scene_.indices[object.first_index + i]];
        mesh.tree = build_bvh(triangles, {.leaf_triangles = kLeafTriangles});
    });
    return mesh.tree;
}

bool RayCaster::crosses(const Ray& ray, const Object& object) const {
    if (!apps::crosses(ray, object.box)) return false;
    const Ray local = object.placement == 0 ? ray : in_mesh_space(ray, scene_.placements[object.placement]);
    return is_met(local, tree_of(object), [&](std::uint32_t triangle) {
        const std::uint32_t* corner = &scene_.indices[object.first_index + 3 * triangle];
        return apps::crosses(local, scene_.positions[corner[0]], scene_.positions[corner[1]],
                             scene_.positions[corner[2]]);
    });
}

bool RayCaster::is_blocked(const Ray& ray) const {
    return is_met(ray, tree_, [&](ObjectId id) { return crosses(ray, scene_.objects[id]); });
}

}  // namespace apps
