// SPDX-License-Identifier: MIT
// What exists: triangles in metres with baked colours, grouped into the objects that a culler draws or leaves
// out. Objects may share a mesh, a range of the arrays, each placed in the world by a motion of its own.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <vector>

#include "apps/scene/box.h"
#include "apps/scene/camera.h"

namespace apps {

using ObjectId = std::uint32_t;  // index into Scene::objects

/// A range of the index and vertex arrays, its mesh, where Scene::placements[placement] puts it. Two ranges
/// are the same or have nothing in common.
struct Object {
    std::uint32_t first_index = 0;
    std::uint32_t index_count = 0;
    std::uint32_t first_vertex = 0;
    std::uint32_t vertex_count = 0;
    std::uint32_t placement = 0;
    Box box;  // in the world

    std::uint32_t triangle_count() const { return index_count / 3; }
};

struct Scene {
    std::string name;
    std::vector<glm::vec3> positions;  // metres, of meshes before they are placed
    std::vector<glm::u8vec4> colours;  // RGBA, light baked in; one per position
    std::vector<std::uint32_t> indices;
    std::vector<glm::mat4> placements{glm::mat4(1)};  // rigid motions, mesh to world; the first is none
    std::vector<Object> objects;
    CameraPath path;
    Box bounds;

    /// Of all objects: what a mesh is shown twice counts twice.
    std::uint64_t triangle_count() const;
};

/// The triangles of `objects` together.
std::uint64_t triangles_of(const Scene& scene, std::span<const ObjectId> objects);

/// The box in the world of a mesh's vertices, as `placement` puts them: no larger than float rounding needs.
Box placed_box(const Scene& scene, const Object& mesh, const glm::mat4& placement);

/// The same scene with object `order[i]` as object i and meshes in the order of their first object; `order`
/// is a permutation of the ids.
Scene reordered(const Scene& scene, std::span<const ObjectId> order);

/// The same scene with a mesh of its own for each object, where it lies in the world, and no placements: what
/// a program has in memory that does not share. Vertices are rounded once more.
Scene unshared(const Scene& scene);

/// 64-bit FNV-1a of everything that can reach a picture: geometry, objects, placements and path.
std::uint64_t hash_of(const Scene& scene);

/// Folds `bytes` into an FNV-1a hash; start with kHashSeed.
inline constexpr std::uint64_t kHashSeed = 0xCBF29CE484222325ULL;
std::uint64_t hash_bytes(std::span<const std::byte> bytes, std::uint64_t hash = kHashSeed);

}  // namespace apps
