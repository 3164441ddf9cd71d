// SPDX-License-Identifier: MIT
// Sums, permutation and fingerprint of a scene.
#include "apps/scene/scene.h"

#include <map>
#include <unordered_map>

namespace apps {

std::uint64_t Scene::triangle_count() const {
    std::uint64_t sum = 0;
    for (const Object& object : objects) sum += object.triangle_count();
    return sum;
}

std::uint64_t triangles_of(const Scene& scene, std::span<const ObjectId> objects) {
    std::uint64_t sum = 0;
    for (const ObjectId id : objects) sum += scene.objects[id].triangle_count();
    return sum;
}

Box placed_box(const Scene& scene, const Object& mesh, const glm::mat4& placement) {
    Box box;
    for (std::uint32_t v = 0; v < mesh.vertex_count; ++v)
        box.add(glm::vec3(placement * glm::vec4(scene.positions[mesh.first_vertex + v], 1)));
    return box;
}

Scene reordered(const Scene& scene, std::span<const ObjectId> order) {
    struct Start {
        std::uint32_t index;
        std::uint32_t vertex;
    };
    std::unordered_map<std::uint32_t, Start> starts;  // of the new mesh, by the first index of the old
    Scene result;
    result.name = scene.name;
    result.path = scene.path;
    result.bounds = scene.bounds;
    result.placements = scene.placements;
    result.positions.reserve(scene.positions.size());
    result.colours.reserve(scene.colours.size());
    result.indices.reserve(scene.indices.size());
    result.objects.reserve(scene.objects.size());
    const auto add_mesh = [&](const Object& object) {
        const Start end{static_cast<std::uint32_t>(result.indices.size()),
                        static_cast<std::uint32_t>(result.positions.size())};
        const auto [place, is_new] = starts.try_emplace(object.first_index, end);
        if (!is_new) return;
        for (std::uint32_t v = 0; v < object.vertex_count; ++v) {
            result.positions.push_back(scene.positions[object.first_vertex + v]);
            result.colours.push_back(scene.colours[object.first_vertex + v]);
        }
        for (std::uint32_t i = 0; i < object.index_count; ++i)
            result.indices.push_back(scene.indices[object.first_index + i] - object.first_vertex +
                                     end.vertex);
    };
    // Meshes that objects may share keep their order: what is one behind the other there stays so.
    std::map<std::uint32_t, const Object*> placed;
    for (const Object& object : scene.objects)
        if (object.placement != 0) placed.try_emplace(object.first_index, &object);
    for (const auto& [first_index, object] : placed) add_mesh(*object);
    for (const ObjectId id : order) {
        Object object = scene.objects[id];
        add_mesh(object);
        const Start start = starts.at(object.first_index);
        object.first_vertex = start.vertex;
        object.first_index = start.index;
        result.objects.push_back(object);
    }
    return result;
}

Scene unshared(const Scene& scene) {
    Scene result;
    result.name = scene.name;
    result.path = scene.path;
    result.bounds = scene.bounds;
    result.objects.reserve(scene.objects.size());
    for (Object object : scene.objects) {
        const glm::mat4& placement = scene.placements[object.placement];
        const auto first_vertex = static_cast<std::uint32_t>(result.positions.size());
        const auto first_index = static_cast<std::uint32_t>(result.indices.size());
        for (std::uint32_t v = object.first_vertex; v < object.first_vertex + object.vertex_count; ++v) {
            result.positions.emplace_back(placement * glm::vec4(scene.positions[v], 1));
            result.colours.push_back(scene.colours[v]);
        }
        for (std::uint32_t i = object.first_index; i < object.first_index + object.index_count; ++i)
            result.indices.push_back(scene.indices[i] - object.first_vertex + first_vertex);
        object.first_vertex = first_vertex;
        object.first_index = first_index;
        object.placement = 0;
        object.box = placed_box(result, object, glm::mat4(1));
        result.objects.push_back(object);
    }
    return result;
}

std::uint64_t hash_bytes(std::span<const std::byte> bytes, std::uint64_t hash) {
    for (const std::byte byte : bytes) hash = (hash ^ static_cast<std::uint64_t>(byte)) * 0x100000001B3ULL;
    return hash;
}

std::uint64_t hash_of(const Scene& scene) {
    std::uint64_t hash = hash_bytes(std::as_bytes(std::span(scene.positions)));
    hash = hash_bytes(std::as_bytes(std::span(scene.colours)), hash);
    hash = hash_bytes(std::as_bytes(std::span(scene.indices)), hash);
    for (const Object& object : scene.objects) {
        hash = hash_bytes(std::as_bytes(std::span(&object.first_index, 1)), hash);
        hash = hash_bytes(std::as_bytes(std::span(&object.index_count, 1)), hash);
        if (object.placement != 0) {
            hash = hash_bytes(std::as_bytes(std::span(&object.placement, 1)), hash);
            hash = hash_bytes(std::as_bytes(std::span(&scene.placements[object.placement], 1)), hash);
        }
    }
    return hash_bytes(std::as_bytes(std::span(scene.path.keys())), hash);
}

}  // namespace apps
