// SPDX-License-Identifier: MIT
// The teapot that Martin Newell measured in Utah in 1975, as Bezier patches, tessellated: the object that
// Bittner et al., Coherent Hierarchical Culling, 2004, section 6.1, fill a scene with.
#pragma once

#include <array>

#include "apps/scene/mesh_builder.h"

namespace apps {

inline constexpr std::uint32_t kTeapotPatches = 32;
inline constexpr std::uint32_t kTeapotSteps = 6;  // along either side of a patch
inline constexpr std::uint32_t kTeapotTriangles = kTeapotPatches * kTeapotSteps * kTeapotSteps * 2;  // 2,304

/// Appends a teapot to the scene's arrays, around the origin, its base down, its spout towards +x; light is
/// baked in as it stands. A unit of Newell's table, of which the teapot is 6.4 long and 3.15 high, becomes
/// `unit_metres`. Returns its quarters, 576 triangles each: those that share the spout, then those that share
/// the handle. Their boxes are as they stand; they are not in Scene::objects yet. `triangles` cuts the teapot
/// short: of a broken one that many are left, and a quarter may be empty.
std::array<Object, 4> add_teapot(Scene& scene, float unit_metres, Albedo glaze,
                                 std::uint32_t triangles = kTeapotTriangles);

}  // namespace apps
