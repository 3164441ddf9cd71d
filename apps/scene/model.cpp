// SPDX-License-Identifier: MIT
// Reads a model and cuts it into objects: triangles in Morton order of their middles, cut at equal numbers.
#include "apps/scene/model.h"

#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cctype>
#include <cmath>
#include <fstream>
#include <map>
#include <numbers>
#include <optional>
#include <stdexcept>

#include "apps/scene/mesh_builder.h"

namespace apps {
namespace {

constexpr double kDiagonalMetres = 100;

/// A mesh of the file where the file shows it.
struct Use {
    unsigned mesh;
    glm::dmat4 placement;  // to the scene
};

struct Triangle {
    glm::vec3 corners[3];
    Albedo albedo;
    std::uint32_t order = 0;  // Morton code
};

struct Extent {
    glm::dvec3 min{std::numeric_limits<double>::max()};
    glm::dvec3 max{std::numeric_limits<double>::lowest()};

    void add(const glm::dvec3& point) {
        min = glm::min(min, point);
        max = glm::max(max, point);
    }
};

glm::dmat4 matrix_of(const aiMatrix4x4& m) {
    return glm::transpose(glm::dmat4(m.a1, m.a2, m.a3, m.a4, m.b1, m.b2, m.b3, m.b4, m.c1, m.c2, m.c3, m.c4,
                                     m.d1, m.d2, m.d3, m.d4));
}

void add_uses(const aiNode& node, const glm::dmat4& above, std::vector<Use>& uses) {
    const glm::dmat4 placement = above * matrix_of(node.mTransformation);
    for (unsigned m = 0; m < node.mNumMeshes; ++m) uses.push_back({node.mMeshes[m], placement});
    for (unsigned c = 0; c < node.mNumChildren; ++c) add_uses(*node.mChildren[c], placement, uses);
}

/// Calls `visit(face)` for each triangle; points and lines hide nothing.
template <class Visit>
void each_triangle(const aiMesh& mesh, Visit&& visit) {
    for (unsigned f = 0; f < mesh.mNumFaces; ++f)
        if (mesh.mFaces[f].mNumIndices == 3) visit(mesh.mFaces[f]);
}

glm::dvec3 corner_of(const aiMesh& mesh, const Use& use, unsigned index) {
    const aiVector3D& p = mesh.mVertices[index];
    return {use.placement * glm::dvec4(p.x, p.y, p.z, 1)};
}

Extent extent_of(const aiScene& model, const std::vector<Use>& uses) {
    Extent extent;
    for (const Use& use : uses)
        each_triangle(*model.mMeshes[use.mesh], [&](const aiFace& face) {
            for (unsigned c = 0; c < 3; ++c) {
                const glm::dvec3 corner = corner_of(*model.mMeshes[use.mesh], use, face.mIndices[c]);
                if (!std::isfinite(corner.x + corner.y + corner.z))
                    throw std::runtime_error("has a corner that is no finite number");
                extent.add(corner);
            }
        });
    return extent;
}

Albedo albedo_of(const aiScene& model, const aiMesh& mesh, const aiFace& face) {
    if (mesh.HasVertexColors(0)) {
        Albedo sum(0);
        for (unsigned c = 0; c < 3; ++c) {
            const aiColor4D& colour = mesh.mColors[0][face.mIndices[c]];
            sum += Albedo(colour.r, colour.g, colour.b);
        }
        return sum / 3.0F;
    }
    aiColor4D colour(0.7F, 0.7F, 0.7F, 1);
    if (mesh.mMaterialIndex < model.mNumMaterials)
        aiGetMaterialColor(model.mMaterials[mesh.mMaterialIndex], AI_MATKEY_COLOR_DIFFUSE, &colour);
    return {colour.r, colour.g, colour.b};
}

void add_triangles(const aiScene& model, const Use& use, std::vector<Triangle>& triangles) {
    const aiMesh& mesh = *model.mMeshes[use.mesh];
    each_triangle(mesh, [&](const aiFace& face) {
        Triangle& triangle = triangles.emplace_back();
        triangle.albedo = albedo_of(model, mesh, face);
        for (unsigned c = 0; c < 3; ++c)
            triangle.corners[c] = glm::vec3(corner_of(mesh, use, face.mIndices[c]));
    });
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

/// One object, or as few of at most `most` neighbours as it takes.
void add_objects(MeshBuilder& mesh, std::vector<Triangle>& triangles, std::size_t most) {
    Box box;
    for (const Triangle& triangle : triangles)
        for (const glm::vec3& corner : triangle.corners) box.add(corner);
    const float size = std::max(glm::length(box.max - box.min), std::numeric_limits<float>::min());
    for (Triangle& triangle : triangles)
        triangle.order = morton(
            (triangle.corners[0] + triangle.corners[1] + triangle.corners[2] - 3.0F * box.min) / (3 * size));
    std::stable_sort(triangles.begin(), triangles.end(),
                     [](const Triangle& a, const Triangle& b) { return a.order < b.order; });
    const std::size_t parts = (triangles.size() + most - 1) / most;
    std::size_t part = 0;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        mesh.triangle(triangles[i].corners[0], triangles[i].corners[1], triangles[i].corners[2],
                      triangles[i].albedo);
        if (i + 1 != (part + 1) * triangles.size() / parts) continue;
        mesh.finish();
        ++part;
    }
}

/// A placement as a rigid motion after an even scale: nothing where it skews or mirrors.
struct Rigid {
    double scale = 0;
    glm::dmat4 motion{1};
};
std::optional<Rigid> rigid_part(const glm::dmat4& placement) {
    constexpr double kEven = 1e-5;
    const glm::dmat3 linear(placement);
    Rigid rigid;
    rigid.scale = glm::length(linear[0]);
    if (!(rigid.scale > 0)) return std::nullopt;
    for (int a = 0; a < 3; ++a)
        for (int b = 0; b < 3; ++b)
            if (!(std::abs(glm::dot(linear[a], linear[b]) / (rigid.scale * rigid.scale) - (a == b)) <= kEven))
                return std::nullopt;
    if (glm::determinant(linear) < 0) return std::nullopt;
    const glm::dvec3 x = glm::normalize(linear[0]);
    const glm::dvec3 y = glm::normalize(linear[1] - glm::dot(linear[1], x) * x);
    rigid.motion = glm::dmat4(glm::dmat3(x, y, glm::cross(x, y)));
    rigid.motion[3] = placement[3];
    return rigid;
}

/// Each mesh wherever the file shows it; the triangles of one shown again are those of its first.
void add_by_object(const aiScene& model, const std::vector<Use>& uses, std::size_t most, Scene& scene) {
    std::map<unsigned, int> times_shown;
    for (const Use& use : uses) ++times_shown[use.mesh];
    struct Shared {
        double scale;
        std::size_t first, end;  // its objects
    };
    std::map<unsigned, Shared> shared;
    MeshBuilder mesh(scene);
    for (const Use& use : uses) {
        const std::optional<Rigid> rigid =
            times_shown[use.mesh] > 1 ? rigid_part(use.placement) : std::nullopt;
        const auto known = shared.find(use.mesh);
        const bool is_known =
            rigid && known != shared.end() && std::abs(known->second.scale / rigid->scale - 1) <= 1e-5;
        const std::size_t first = scene.objects.size();
        if (is_known) {
            for (std::size_t id = known->second.first; id < known->second.end; ++id)
                scene.objects.push_back(Object(scene.objects[id]));
        } else {
            Use stored = use;
            if (rigid) stored.placement = glm::dmat4(glm::dmat3(rigid->scale));
            std::vector<Triangle> triangles;
            add_triangles(model, stored, triangles);
            add_objects(mesh, triangles, most);
            if (rigid) shared.insert_or_assign(use.mesh, Shared{rigid->scale, first, scene.objects.size()});
        }
        if (!rigid) continue;
        scene.placements.emplace_back(rigid->motion);
        for (std::size_t id = first; id < scene.objects.size(); ++id) {
            scene.objects[id].placement = static_cast<std::uint32_t>(scene.placements.size() - 1);
            scene.objects[id].box = placed_box(scene, scene.objects[id], scene.placements.back());
        }
    }
}

/// Once around at 0.75 diagonals from the middle, going up to look down on it half way.
CameraPath path_around(const Box& bounds) {
    std::vector<CameraKey> keys;
    constexpr auto kDiagonal = static_cast<float>(kDiagonalMetres);
    constexpr int kKeys = 500;
    for (int key = 0; key < kKeys; ++key) {
        const float at = static_cast<float>(key) / (kKeys - 1);
        const float angle = 2 * std::numbers::pi_v<float> * at;
        const float rise = 0.5F - 0.5F * std::cos(angle);
        const glm::vec3 offset(std::cos(angle), std::sin(angle), 0.05F + 0.7F * rise);
        keys.push_back({at, bounds.centre() + 0.75F * kDiagonal * offset, bounds.centre()});
    }
    return {std::move(keys), Lens{45, 0.1F, 4 * kDiagonal}};
}

Scene scene_of(const aiScene& model, const ModelSplit& split) {
    glm::dmat4 up(1);  // files have y up
    up[1] = {0, 0, 1, 0};
    up[2] = {0, -1, 0, 0};
    std::vector<Use> uses;
    if (model.mRootNode) add_uses(*model.mRootNode, up, uses);
    const Extent raw = extent_of(model, uses);
    const double diagonal = glm::length(raw.max - raw.min);
    if (!(diagonal > 0 && std::isfinite(diagonal) && raw.min.x <= raw.max.x))
        throw std::runtime_error("has no triangles of finite size");
    const double scale = kDiagonalMetres / diagonal;
    const glm::dvec3 base(0.5 * (raw.min.x + raw.max.x), 0.5 * (raw.min.y + raw.max.y), raw.min.z);
    glm::dmat4 fit(glm::dmat3(1) * scale);
    fit[3] = glm::dvec4(-scale * base, 1);
    for (Use& use : uses) use.placement = fit * use.placement;

    Scene scene;
    if (split.by == ModelSplit::By::kObject) {
        add_by_object(model, uses, split.most_triangles, scene);
    } else {
        std::vector<Triangle> triangles;
        for (const Use& use : uses) add_triangles(model, use, triangles);
        MeshBuilder mesh(scene);
        add_objects(mesh, triangles, split.most_triangles);
    }
    scene.bounds = {};
    for (const Object& object : scene.objects) scene.bounds.add(object.box);
    scene.path = path_around(scene.bounds);
    return scene;
}

/// Before polygons are cut into triangles: that trusts every corner, and aborts over a mesh that is marked to
/// have polygons and has none, as the readers of files that end early leave it.
void check_faces(const aiScene& model) {
    for (unsigned m = 0; m < model.mNumMeshes; ++m) {
        aiMesh& mesh = *model.mMeshes[m];
        bool has_polygons = false;
        for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
            const aiFace& face = mesh.mFaces[f];
            has_polygons |= face.mNumIndices > 3;
            for (unsigned c = 0; c < face.mNumIndices; ++c)
                if (face.mIndices[c] >= mesh.mNumVertices)
                    throw std::runtime_error("has a face whose corner is not in the file");
        }
        if (!has_polygons) mesh.mPrimitiveTypes &= ~unsigned{aiPrimitiveType_POLYGON};
        if (mesh.mPrimitiveTypes == 0) mesh.mPrimitiveTypes = aiPrimitiveType_TRIANGLE;
    }
}

/// A PLY file that ends in its head: assimp 5.2 seeks in it for ever.
bool is_cut_in_its_head(const std::filesystem::path& file) {
    constexpr std::size_t kLongestHead = 1 << 16;  // bytes
    std::string head(kLongestHead, '\0');
    std::ifstream in(file, std::ios::binary);
    in.read(head.data(), static_cast<std::streamsize>(head.size()));
    head.resize(static_cast<std::size_t>(in.gcount()));
    std::string extension = file.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return std::tolower(c); });
    return (extension == ".ply" || head.starts_with("ply")) &&
           head.find("end_header\n") == std::string::npos && head.find("end_header\r") == std::string::npos;
}

}  // namespace

Scene load_model(const std::filesystem::path& file, const ModelSplit& split) {
    if (is_cut_in_its_head(file))
        throw std::runtime_error("the model " + file.string() + " cannot be read: its head has no end");
    Assimp::Importer importer;
    const aiScene* model = importer.ReadFile(file.string(), 0);
    if (!model) {
        std::string reason = importer.GetErrorString();
        std::replace_if(
            reason.begin(), reason.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
        throw std::runtime_error("the model " + file.string() + " cannot be read: " + reason);
    }
    try {
        check_faces(*model);
        model = importer.ApplyPostProcessing(aiProcess_Triangulate);
        if (!model) throw std::runtime_error("cannot be cut into triangles");
        Scene scene = scene_of(*model, split);
        scene.name = file.stem().string();
        return scene;
    } catch (const std::runtime_error& error) {
        throw std::runtime_error("the model " + file.string() + " " + error.what());
    }
}

}  // namespace apps
