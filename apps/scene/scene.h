// SPDX-License-Identifier: MIT
// What exists: triangles in metres with baked colours, grouped into the objects that a culler draws or leaves
// out. Vertices belong to one object each, so an item buffer can give every object a colour of its own.
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

/// Objects hold consecutive ranges of the index and vertex arrays, in the order of their ids.
struct Object {
    std::uint32_t first_index = 0;
    std::uint32_t index_count = 0;
    std::uint32_t first_vertex = 0;
    std::uint32_t vertex_count = 0;
    Box box;

    std::uint32_t triangle_count() const { return index_count / 3; }
};

struct Scene {
    std::string name;
    std::vector<glm::vec3> positions;  // metres
    std::vector<glm::u8vec4> colours;  // RGBA, light baked in; one per position
    std::vector<std::uint32_t> indices;
    std::vector<Object> objects;
    CameraPath path;
    Box bounds;

    std::uint32_t triangle_count() const { return static_cast<std::uint32_t>(indices.size() / 3); }
};

/// The triangles of `objects` together.
std::uint64_t triangles_of(const Scene& scene, std::span<const ObjectId> objects);

/// The same scene with object `order[i]` as object i; `order` is a permutation of the ids.
Scene reordered(const Scene& scene, std::span<const ObjectId> order);

/// 64-bit FNV-1a of everything that can reach a picture: geometry, objects and path.
std::uint64_t hash_of(const Scene& scene);

/// Folds `bytes` into an FNV-1a hash; start with kHashSeed.
inline constexpr std::uint64_t kHashSeed = 0xCBF29CE484222325ULL;
std::uint64_t hash_bytes(std::span<const std::byte> bytes, std::uint64_t hash = kHashSeed);

}  // namespace apps
