// SPDX-License-Identifier: MIT
// Any hit will do, so the order of nodes does not matter. Boxes by slabs; triangles by Moeller, Trumbore:
// Fast, minimum storage ray-triangle intersection, 1997.
#include "apps/hierarchy/ray.h"

#include <algorithm>
#include <cmath>

namespace apps {
namespace {

struct Ray {
    glm::vec3 origin, direction, inverse;
    float reach;
};

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

bool crosses(const Ray& ray, const Scene& scene, const Object& object) {
    if (!crosses(ray, object.box)) return false;
    for (std::uint32_t i = object.first_index; i < object.first_index + object.index_count; i += 3)
        if (crosses(ray, scene.positions[scene.indices[i]], scene.positions[scene.indices[i + 1]],
                    scene.positions[scene.indices[i + 2]]))
            return true;
    return false;
}

}  // namespace

bool is_blocked(const Scene& scene, const Tree& tree, const glm::vec3& origin, const glm::vec3& direction,
                float reach) {
    const Ray ray{origin, direction, 1.0F / direction, reach};
    std::vector<NodeId> stack{0};
    stack.reserve(64);
    while (!stack.empty()) {
        const NodeId id = stack.back();
        stack.pop_back();
        const Node& node = tree.nodes[id];
        if (!crosses(ray, node.box)) continue;
        if (!node.is_leaf) {
            stack.push_back(node.upper);
            stack.push_back(id + 1);
            continue;
        }
        for (const ObjectId object : tree.objects_of(node))
            if (crosses(ray, scene, scene.objects[object])) return true;
    }
    return false;
}

}  // namespace apps
