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
/// `unit_metres`. Returns its halves, that of the spout and that of the handle, 1,152 triangles each, boxes
/// as they stand; they are not in Scene::objects yet. `triangles` cuts it short: of a broken teapot that many
/// are left, the spout's half first, and a half may be empty.
std::array<Object, 2> add_teapot(Scene& scene, float unit_metres, Albedo glaze,
                                 std::uint32_t triangles = kTeapotTriangles);

}  // namespace apps
