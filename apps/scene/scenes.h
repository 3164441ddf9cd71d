// SPDX-License-Identifier: MIT
// The one list of scenes.
#pragma once

#include <functional>
#include <span>
#include <string_view>

#include "apps/scene/scene.h"

namespace apps {

struct SceneRecipe {
    std::string_view name;
    std::uint32_t triangles;  // at scale 1
    std::string_view paper;
    double smallest_scale;
    /// Builds it with round(scale * triangles) triangles; the same arguments give the same bits.
    Scene (*build)(double scale, std::uint64_t seed);
};

std::span<const SceneRecipe> scenes();

/// nullptr where no scene has that name.
const SceneRecipe* find_scene(std::string_view name);

inline constexpr std::uint32_t kChcCityTriangles = 1'036'146;
Scene build_chc_city(double scale, std::uint64_t seed);

}  // namespace apps
