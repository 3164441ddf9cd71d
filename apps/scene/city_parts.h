// SPDX-License-Identifier: MIT
// The parts of the city: buildings with facades of window bays, trees, cars and lamps. Every bay is an object
// of its own, so that objects are small against the buildings they make up. Nothing stands inside a building.
#pragma once

#include "apps/scene/mesh_builder.h"
#include "apps/scene/random.h"

namespace apps::city {

inline constexpr float kBayMetres = 3.0F;
inline constexpr float kFloorMetres = 3.2F;
inline constexpr float kPavementMetres = 0.15F;  // height above the street

/// What a stretch of wall looks onto, and so how it is built.
enum class Outlook { kStreet, kCourt, kNeighbour };

struct Style {
    Albedo wall, trim, glass, roof;
    float window_width, sill_height, head_height;  // metres
    bool has_sills, has_bars, has_balconies, has_gable;
};
Style random_style(Random& random);

/// A box of bays: its walls in the order south, east, north, west, each a list of outlooks, left to right
/// from outside.
struct Building {
    glm::vec2 min{0}, max{0};
    std::vector<Outlook> walls[4];
    Style style{};
    Random random{0};  // of the building alone: its look does not depend on its height
    float height_weight = 1;
    int floors = 1;
};

/// Adds the building; the triangles grow by the same amount with every floor.
void add_building(MeshBuilder& mesh, const Building& building);

/// The triangles that add_building would add.
std::uint32_t triangles_of(const Building& building);

inline constexpr std::uint32_t kTreeTriangles = 26;
void add_tree(MeshBuilder& mesh, Random& random, const glm::vec3& foot);

inline constexpr std::uint32_t kCarTriangles = 30;
void add_car(MeshBuilder& mesh, Random& random, const glm::vec3& centre, bool along_x);

inline constexpr std::uint32_t kLampTriangles = 22;
void add_lamp(MeshBuilder& mesh, const glm::vec3& foot, const glm::vec3& towards_street);

/// A bush of exactly `triangles` triangles, at least 3.
void add_bush(MeshBuilder& mesh, Random& random, const glm::vec3& foot, int triangles);

}  // namespace apps::city
