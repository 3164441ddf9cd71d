// SPDX-License-Identifier: MIT
// Models that people bring, of three formats; and files that are none, which are refused in one sentence.
#include "apps/scene/model.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

namespace {

namespace fs = std::filesystem;
using apps::load_model;
using apps::ModelSplit;
using apps::Scene;

constexpr ModelSplit kByObject{ModelSplit::By::kObject, ModelSplit::kMostOfAMesh};

struct Models : testing::Test {
    Models() { fs::create_directories(folder); }
    ~Models() override { fs::remove_all(folder); }

    fs::path file(const std::string& name, const std::string& text) const {
        std::ofstream(folder / name, std::ios::binary) << text;
        return folder / name;
    }

    /// What it is refused with; empty where it is read.
    static std::string refusal(const fs::path& path) {
        try {
            load_model(path);
            return "";
        } catch (const std::runtime_error& error) {
            return error.what();
        }
    }

    fs::path folder = fs::temp_directory_path() / ("model_test_" + std::to_string(getpid()));
};

const std::string kTwoQuads =
    "o left\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n"
    "o right\nv 5 0 0\nv 6 0 0\nv 6 1 0\nv 5 1 0\nf 5 6 7\nf 5 7 8\n";

const std::string kPly =
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
    "property uchar red\nproperty uchar green\nproperty uchar blue\n"
    "element face 2\nproperty list uchar int vertex_indices\nend_header\n"
    "0 0 0 255 0 0\n1 0 0 255 0 0\n1 1 0 255 0 0\n0 1 0 255 0 0\n3 0 1 2\n3 0 2 3\n";

/// One triangle in its own file of numbers, and `nodes` that show it.
struct Gltf {
    std::string bytes;
    nlohmann::json json;

    explicit Gltf(const nlohmann::json& nodes) {
        const float corners[9] = {0, 0, 0, 1, 0, 0, 0, 2, 0};
        bytes.assign(reinterpret_cast<const char*>(corners), sizeof corners);
        nlohmann::json roots = nlohmann::json::array();
        for (std::size_t i = 0; i < nodes.size(); ++i) roots.push_back(i);
        json = {{"asset", {{"version", "2.0"}}},
                {"scene", 0},
                {"scenes", {{{"nodes", roots}}}},
                {"nodes", nodes},
                {"meshes", {{{"primitives", {{{"attributes", {{"POSITION", 0}}}}}}}}},
                {"buffers", {{{"byteLength", bytes.size()}}}},
                {"bufferViews", {{{"buffer", 0}, {"byteLength", bytes.size()}}}},
                {"accessors",
                 {{{"bufferView", 0},
                   {"componentType", 5126},
                   {"count", 3},
                   {"type", "VEC3"},
                   {"min", {0, 0, 0}},
                   {"max", {1, 2, 0}}}}}};
    }

    std::string binary() const {
        std::string text = json.dump();
        text.resize((text.size() + 3) / 4 * 4, ' ');
        const auto word = [](std::size_t value) {
            const auto v = static_cast<std::uint32_t>(value);
            return std::string(reinterpret_cast<const char*>(&v), 4);
        };
        return "glTF" + word(2) + word(28 + text.size() + bytes.size()) + word(text.size()) + "JSON" + text +
               word(bytes.size()) + std::string("BIN\0", 4) + bytes;
    }
};

TEST_F(Models, are_split_into_neighbours_or_into_the_objects_of_the_file) {
    const fs::path path = file("quads.obj", kTwoQuads);
    EXPECT_EQ(load_model(path).objects.size(), 1U);
    EXPECT_EQ(load_model(path, kByObject).objects.size(), 2U);
    const Scene single = load_model(path, {ModelSplit::By::kObject, 1});
    EXPECT_EQ(single.objects.size(), 4U);
    EXPECT_EQ(single.triangle_count(), 4U);
    EXPECT_NEAR(glm::length(single.bounds.max - single.bounds.min), 100, 1e-3);
    EXPECT_EQ(single.bounds.min.z, 0);
    EXPECT_GT(single.bounds.max.z, 10) << "y of the file is up";
}

TEST_F(Models, may_be_ply_with_colours_of_its_own) {
    const Scene scene = load_model(file("quad.ply", kPly));
    ASSERT_EQ(scene.triangle_count(), 2U);
    EXPECT_GT(scene.colours[0].r, 0);
    EXPECT_EQ(scene.colours[0].g, 0);
}

TEST_F(Models, of_binary_gltf_store_a_mesh_once_however_often_it_is_shown) {
    const Gltf model(
        nlohmann::json{{{"mesh", 0}},
                       {{"mesh", 0}, {"translation", {10, 0, 0}}},
                       {{"mesh", 0}, {"rotation", {0, 0.7071068, 0, 0.7071068}}, {"translation", {0, 0, 20}}},
                       {{"mesh", 0}, {"scale", {1, 3, 1}}, {"translation", {5, 0, 5}}},
                       {{"mesh", 0}, {"scale", {-1, 1, 1}}, {"translation", {5, 0, 9}}}});
    const fs::path path = file("triangles.glb", model.binary());
    const Scene shared = load_model(path, kByObject);
    const Scene apart = load_model(path, {ModelSplit::By::kSize, 1});
    ASSERT_EQ(shared.objects.size(), 5U);
    ASSERT_EQ(apart.objects.size(), 5U);
    EXPECT_EQ(shared.indices.size(), 9U) << "one for three, and the skewed and the mirrored for themselves";

    // Every corner is where it is without sharing.
    const auto corners_of = [](const Scene& scene) {
        std::vector<glm::vec3> corners;
        for (const apps::Object& object : scene.objects)
            for (std::uint32_t i = 0; i < object.index_count; ++i) {
                const glm::vec3 p = scene.positions[scene.indices[object.first_index + i]];
                corners.emplace_back(scene.placements[object.placement] * glm::vec4(p, 1));
                EXPECT_TRUE(object.box.grown(1e-4F).contains(corners.back()));
            }
        return corners;
    };
    const std::vector<glm::vec3> others = corners_of(apart);
    for (const glm::vec3& corner : corners_of(shared))
        EXPECT_TRUE(std::any_of(others.begin(), others.end(),
                                [&](const glm::vec3& other) { return glm::length(corner - other) < 1e-3F; }));
}

TEST_F(Models, that_cannot_be_shown_are_refused_in_one_sentence) {
    std::string ply_of_nan = kPly;
    ply_of_nan.replace(ply_of_nan.find("0 0 0 255"), 9, "nan 0 0 255");
    std::string ply_outside = kPly;
    ply_outside.replace(ply_outside.find("3 0 2 3"), 7, "3 0 2 9");
    const std::pair<const char*, std::string> files[] = {
        {"empty.obj", ""},
        {"empty.ply", ""},
        {"empty.glb", ""},
        {"words.obj", "hello\n"},
        {"points.obj", "v 0 0 0\nv 1 0 0\np 1 2\n"},
        {"line.obj", "v 0 0 0\nv 1 0 0\nl 1 2\n"},
        {"point.obj", "v 1 1 1\nf 1 1 1\n"},
        {"huge.obj", "v 0 0 0\nv 1e39 0 0\nv 0 1 0\nf 1 2 3\n"},
        {"nan.obj", "v 0 0 0\nv nan 0 0\nv 0 1 0\nf 1 2 3\n"},
        {"outside.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 7\n"},
        {"nan.ply", ply_of_nan},
        {"outside.ply", ply_outside},
        {"no_nodes.glb", Gltf(nlohmann::json::array()).binary()},
        {"unknown.format", "hello\n"},
    };
    for (const auto& [name, text] : files) {
        const std::string said = refusal(file(name, text));
        EXPECT_NE(said.find(name), std::string::npos) << name << ": \"" << said << '"';
        EXPECT_EQ(said.find('\n'), std::string::npos) << said;
    }
}

TEST_F(Models, that_end_too_early_are_read_in_part_or_refused) {
    const std::string glb = Gltf(nlohmann::json::array({{{"mesh", 0}}})).binary();
    const std::pair<const char*, const std::string*> files[] = {
        {"cut.obj", &kTwoQuads}, {"cut.ply", &kPly}, {"cut.glb", &glb}};
    std::size_t refused = 0;
    for (const auto& [name, whole] : files) {
        ASSERT_EQ(refusal(file(name, *whole)), "");
        for (std::size_t length = 0; length < whole->size(); length += 7) {
            const std::string said = refusal(file(name, whole->substr(0, length)));
            EXPECT_EQ(said.find('\n'), std::string::npos) << said;
            refused += !said.empty();
        }
    }
    EXPECT_GT(refused, 20U);
}

TEST_F(Models, of_very_small_size_are_made_as_large_as_others) {
    const Scene scene = load_model(file("small.obj", "v 0 0 0\nv 1e-30 0 0\nv 0 1e-30 0\nf 1 2 3\n"));
    EXPECT_NEAR(glm::length(scene.bounds.max - scene.bounds.min), 100, 1e-3);
}

}  // namespace
