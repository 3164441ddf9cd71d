// SPDX-License-Identifier: MIT
// Reads a model and cuts it into objects: triangles in Morton order of their middles, cut every 64.
#include "apps/scene/model.h"

#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "apps/scene/mesh_builder.h"

namespace apps {
namespace {

constexpr float kDiagonalMetres = 100;
constexpr std::size_t kObjectTriangles = 64;

struct Triangle {
    glm::vec3 corners[3];
    Albedo albedo;
    std::uint32_t order = 0;  // Morton code
};

std::vector<Triangle> triangles_of(const aiScene& model) {
    std::vector<Triangle> all;
    for (unsigned m = 0; m < model.mNumMeshes; ++m) {
        const aiMesh& mesh = *model.mMeshes[m];
        aiColor4D colour(0.7F, 0.7F, 0.7F, 1);
        if (mesh.mMaterialIndex < model.mNumMaterials)
            aiGetMaterialColor(model.mMaterials[mesh.mMaterialIndex], AI_MATKEY_COLOR_DIFFUSE, &colour);
        for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
            if (mesh.mFaces[f].mNumIndices != 3) continue;  // points and lines hide nothing
            Triangle& triangle = all.emplace_back();
            triangle.albedo = {colour.r, colour.g, colour.b};
            for (unsigned c = 0; c < 3; ++c) {
                const aiVector3D& p = mesh.mVertices[mesh.mFaces[f].mIndices[c]];
                triangle.corners[c] = {p.x, -p.z, p.y};  // files have y up
            }
        }
    }
    return all;
}

/// Ten bits of each axis, interleaved.
std::uint32_t morton(const glm::vec3& unit) {
    std::uint32_t code = 0;
    const glm::uvec3 cell(glm::clamp(unit, 0.0F, 1.0F) * 1023.0F);
    for (std::uint32_t bit = 0; bit < 10; ++bit)
        for (int axis = 0; axis < 3; ++axis)
            code |= (cell[axis] >> bit & 1) << (3 * bit + static_cast<std::uint32_t>(axis));
    return code;
}

/// Once around at 0.75 diagonals from the middle, going up to look down on it half way.
CameraPath path_around(const Box& bounds) {
    std::vector<CameraKey> keys;
    constexpr int kKeys = 500;
    for (int key = 0; key < kKeys; ++key) {
        const float at = static_cast<float>(key) / (kKeys - 1);
        const float angle = 2 * std::numbers::pi_v<float> * at;
        const float rise = 0.5F - 0.5F * std::cos(angle);
        const glm::vec3 offset(std::cos(angle), std::sin(angle), 0.05F + 0.7F * rise);
        keys.push_back({at, bounds.centre() + 0.75F * kDiagonalMetres * offset, bounds.centre()});
    }
    return {std::move(keys), Lens{45, 0.1F, 4 * kDiagonalMetres}};
}

}  // namespace

Scene load_model(const std::filesystem::path& file) {
    Assimp::Importer importer;
    const aiScene* model =
        importer.ReadFile(file.string(), aiProcess_Triangulate | aiProcess_PreTransformVertices);
    if (!model)
        throw std::runtime_error("the model " + file.string() +
                                 " cannot be read: " + importer.GetErrorString());
    std::vector<Triangle> triangles = triangles_of(*model);
    Box raw;
    for (const Triangle& triangle : triangles)
        for (const glm::vec3& corner : triangle.corners) raw.add(corner);
    const float diagonal = glm::length(raw.max - raw.min);
    if (triangles.empty() || !std::isfinite(diagonal) || diagonal == 0)
        throw std::runtime_error("the model " + file.string() + " has no triangles of finite size");

    const glm::vec3 base(raw.centre().x, raw.centre().y, raw.min.z);
    for (Triangle& triangle : triangles) {
        glm::vec3 middle(0);
        for (glm::vec3& corner : triangle.corners) {
            middle += (corner - raw.min) / (3 * diagonal);
            corner = (corner - base) * (kDiagonalMetres / diagonal);
        }
        triangle.order = morton(middle);
    }
    std::stable_sort(triangles.begin(), triangles.end(),
                     [](const Triangle& a, const Triangle& b) { return a.order < b.order; });

    Scene scene;
    scene.name = file.stem().string();
    MeshBuilder mesh(scene);
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        mesh.triangle(triangles[i].corners[0], triangles[i].corners[1], triangles[i].corners[2],
                      triangles[i].albedo);
        if (i % kObjectTriangles == kObjectTriangles - 1) mesh.finish();
    }
    mesh.finish();
    scene.path = path_around(scene.bounds);
    return scene;
}

}  // namespace apps
