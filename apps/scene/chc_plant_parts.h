// SPDX-License-Identifier: MIT
// The parts that the proxy of a power plant is put together from: each a mesh around its own origin, placed
// as often as it is needed. Pipes and all that is turned have smooth sides.
#pragma once

#include <vector>

#include "apps/scene/mesh_builder.h"

namespace apps::plant {

inline constexpr float kBayMetres = 6;    // between columns, both ways
inline constexpr float kFloorMetres = 6;  // from floor to floor
inline constexpr float kCladdingMetres = 3;
inline constexpr int kGauges = 4;  // of pipes

/// Metres: the outer radius of a pipe of that gauge.
constexpr float radius_of(int gauge) {
    constexpr float kRadii[kGauges] = {0.06F, 0.11F, 0.18F, 0.27F};
    return kRadii[gauge];
}

/// Meshes in the scene's arrays; boxes as they stand, none of them in Scene::objects.
struct Parts {
    Object pipes[kGauges];   // from the origin along +x, a bay long, a flange at either end, bands between
    Object valves[kGauges];  // a pipe with a valve in its middle, its wheel up
    Object elbows[kGauges];  // from the origin along +x, then up: an end of a run
    Object tank;             // 4.4 m tall on the origin, 1.3 m in radius
    Object pump;             // 2.2 m along +x, from the origin
    Object column;           // a floor tall, on the origin
    Object beam;             // along +x from the origin, a bay long
    Object slab;             // a bay of floor, its upper face in z = 0, from the origin along +x and +y
    Object cladding;         // a floor tall, kCladdingMetres wide, along +x from the origin in y = 0
    Object rail;             // along +x from the origin, a bay long
    Object chimney;          // 60 m tall on the origin
    Object ground;           // 12 m of it along +x and +y
};

Parts build_parts(Scene& scene);

/// A pipe of the smallest gauge of which only `triangles` are left.
Object build_scrap(Scene& scene, std::uint32_t triangles);

/// Triangles of the longest pipe that build_scrap can begin.
std::uint32_t most_scrap(const Parts& parts);

}  // namespace apps::plant
