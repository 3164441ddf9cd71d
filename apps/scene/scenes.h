// SPDX-License-Identifier: MIT
// The one list of scenes.
#pragma once

#include <functional>
#include <span>
#include <string_view>

#include "apps/scene/scene.h"

namespace apps {

enum class TreeKind : std::uint8_t { kKdTree, kBvh };

struct SceneRecipe {
    std::string_view name;
    std::uint32_t triangles;  // at scale 1
    std::uint32_t objects;    // at scale 1
    std::uint32_t leaves;     // of its tree at scale 1; 0: an object to a leaf
    TreeKind tree;            // of the paper
    std::string_view paper;
    double smallest_scale;
    double largest_scale;
    /// Builds it with round(scale * triangles) triangles; the same arguments give the same bits.
    Scene (*build)(double scale, std::uint64_t seed);
};

std::span<const SceneRecipe> scenes();

/// nullptr where no scene has that name.
const SceneRecipe* find_scene(std::string_view name);

/// Leaves of its tree: the paper's, in proportion to the triangles; at least one.
std::size_t leaf_count(const SceneRecipe& recipe, const Scene& scene);

inline constexpr std::uint32_t kLogForestTriangles = 1'694'426;
Scene build_log_forest(double scale, std::uint64_t seed);

inline constexpr std::uint32_t kLogCityTriangles = 34'034'176;
Scene build_log_city(double scale, std::uint64_t seed);

inline constexpr std::uint32_t kChcCityTriangles = 1'036'146;
Scene build_chc_city(double scale, std::uint64_t seed);

inline constexpr std::uint32_t kChcTeapotsTriangles = 11'520'000;  // 5,000 teapots
Scene build_chc_teapots(double scale, std::uint64_t seed);

inline constexpr std::uint32_t kChcPlantTriangles = 12'748'510;  // a proxy: the model cannot be had
Scene build_chc_plant(double scale, std::uint64_t seed);

}  // namespace apps
