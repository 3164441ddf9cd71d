// SPDX-License-Identifier: MIT
// The block that the city of log-city is made of: a large and a small building, closed all around and
// furnished inside. Such pairs tile the plane (the Pythagorean tiling) with streets that all end at a facade.
#pragma once

#include "apps/scene/mesh_builder.h"

namespace apps::log_city {

inline constexpr std::uint32_t kBlockTriangles = 66'473;  // 34,034,176 / 512
inline constexpr std::uint32_t kMostTriangles = 1'500;    // of an object: the paper's leaves
inline constexpr float kLargeMetres = 48;                 // side of the large square, street included
inline constexpr float kSmallMetres = 24;
inline constexpr float kStreetMetres = 8;

/// The objects of a block whose large square has its corner at the origin, exactly kBlockTriangles. The small
/// one touches the large one's right side at its lower end.
void add_block(MeshBuilder& mesh, std::uint64_t seed);

}  // namespace apps::log_city
