// SPDX-License-Identifier: MIT
// Facades of windows, floors of rooms. What stands in the rooms is most of the triangles, and nobody in the
// street sees it: walls and window panes are closed.
#include "apps/scene/log_city_block.h"

#include <algorithm>
#include <cmath>

#include "apps/scene/random.h"

namespace apps::log_city {
namespace {

constexpr int kFloors = 10;
constexpr float kFloorMetres = 3;
constexpr float kHeightMetres = kFloors * kFloorMetres;
constexpr float kWindowMetres = 1.65F;  // of facade to a window, about
constexpr float kRecessMetres = 0.22F;
constexpr float kFacadeMetres = 5.4F;  // of wall in an object, at most
// Free of furniture behind a facade. A method that goes by depth has then drawn the facade before it comes to
// what lies behind.
constexpr float kWallMetres = 10;
constexpr std::uint32_t kBoxTriangles = 12;
constexpr std::uint32_t kRoomTriangles = 700;  // at most
constexpr Albedo kWalls[] = {{0.78F, 0.70F, 0.58F}, {0.72F, 0.62F, 0.52F}, {0.80F, 0.76F, 0.70F}};
constexpr Albedo kFrame{0.86F, 0.84F, 0.80F};
constexpr Albedo kPane{0.22F, 0.28F, 0.34F};
constexpr Albedo kRoof{0.42F, 0.36F, 0.33F};
constexpr Albedo kPaving{0.46F, 0.45F, 0.43F};
constexpr Albedo kWood{0.52F, 0.38F, 0.25F};

struct Square {
    glm::vec2 low;
    float side;

    glm::vec2 high() const { return low + side; }
};

/// A part of a wall: along it, upwards, and inwards.
struct Wall {
    glm::vec2 start;
    glm::vec2 along;    // unit
    glm::vec2 inwards;  // unit, to the left of along

    glm::vec3 at(float forward, float height, float depth) const {
        return {start + along * forward + inwards * depth, height};
    }
};

/// A wall with a window in it, 38 triangles: four strips, four sides of the recess, the pane with four
/// bars before it, a sill.
void add_window(MeshBuilder& mesh, const Wall& wall, float left, float right, float low, float high,
                Albedo colour) {
    const float l = left + 0.26F * (right - left);
    const float r = right - 0.26F * (right - left);
    const float b = low + 0.9F;
    const float t = high - 0.45F;
    const auto strip = [&](float x0, float x1, float z0, float z1) {
        mesh.quad(wall.at(x0, z0, 0), wall.at(x1, z0, 0), wall.at(x1, z1, 0), wall.at(x0, z1, 0), colour);
    };
    strip(left, right, low, b);
    strip(left, right, t, high);
    strip(left, l, b, t);
    strip(r, right, b, t);
    constexpr float d = kRecessMetres;
    mesh.quad(wall.at(l, b, 0), wall.at(r, b, 0), wall.at(r, b, d), wall.at(l, b, d), kFrame);
    mesh.quad(wall.at(l, t, d), wall.at(r, t, d), wall.at(r, t, 0), wall.at(l, t, 0), kFrame);
    mesh.quad(wall.at(l, b, 0), wall.at(l, b, d), wall.at(l, t, d), wall.at(l, t, 0), kFrame);
    mesh.quad(wall.at(r, b, d), wall.at(r, b, 0), wall.at(r, t, 0), wall.at(r, t, d), kFrame);
    mesh.quad(wall.at(l, b, d), wall.at(r, b, d), wall.at(r, t, d), wall.at(l, t, d), kPane);
    const auto bar = [&](float x0, float x1, float z0, float z1) {
        constexpr float e = d - 0.03F;
        mesh.quad(wall.at(x0, z0, e), wall.at(x1, z0, e), wall.at(x1, z1, e), wall.at(x0, z1, e), kFrame);
    };
    constexpr float kBar = 0.04F;
    const float third = (t - b) / 3;
    bar(0.5F * (l + r) - kBar, 0.5F * (l + r) + kBar, b, t);
    bar(l, l + kBar, b, t);
    bar(l, r, b + third - kBar, b + third + kBar);
    bar(l, r, t - third - kBar, t - third + kBar);
    mesh.hanging_box(wall.at(l - 0.06F, b - 0.08F, -0.10F), wall.at(r + 0.06F, b, d), kFrame);
}

/// One object: `length` metres of a wall, all floors.
void add_facade(MeshBuilder& mesh, const Wall& wall, float length, Albedo colour) {
    const int windows = static_cast<int>(length / kWindowMetres);
    const float width = length / static_cast<float>(windows);
    for (int floor = 0; floor < kFloors; ++floor)
        for (int window = 0; window < windows; ++window) {
            const auto x = static_cast<float>(window);
            const auto z = static_cast<float>(floor);
            add_window(mesh, wall, width * x, width * (x + 1), kFloorMetres * z, kFloorMetres * (z + 1),
                       colour);
        }
    mesh.finish();
}

/// The four walls of a building and its roof.
void add_shell(MeshBuilder& mesh, const Square& building, Albedo colour) {
    const glm::vec2 lo = building.low;
    const glm::vec2 hi = building.high();
    const Wall sides[] = {{lo, {1, 0}, {0, 1}},
                          {{hi.x, lo.y}, {0, 1}, {-1, 0}},
                          {hi, {-1, 0}, {0, -1}},
                          {{lo.x, hi.y}, {0, -1}, {1, 0}}};
    const int parts = static_cast<int>(std::ceil(building.side / kFacadeMetres));
    const float length = building.side / static_cast<float>(parts);
    for (const Wall& side : sides)
        for (int part = 0; part < parts; ++part) {
            const glm::vec2 start = side.start + side.along * (length * static_cast<float>(part));
            add_facade(mesh, {start, side.along, side.inwards}, length, colour);
        }
    mesh.quad({lo, kHeightMetres}, {hi.x, lo.y, kHeightMetres}, {hi, kHeightMetres},
              {lo.x, hi.y, kHeightMetres}, kRoof);
    mesh.finish();
}

void add_paving(MeshBuilder& mesh, const Square& square) {
    constexpr int kSlabs = 4;
    const float slab = square.side / kSlabs;
    for (int i = 0; i < kSlabs * kSlabs; ++i) {
        const glm::vec2 lo = square.low + slab * glm::vec2(i % kSlabs, i / kSlabs);
        mesh.quad({lo, 0}, {lo.x + slab, lo.y, 0}, {lo + slab, 0}, {lo.x, lo.y + slab, 0},
                  kPaving * ((i + i / kSlabs) % 2 == 0 ? 1.0F : 0.93F));
    }
    mesh.finish();
}

/// One object of `triangles`: boxes of furniture in a room; what is left over are single triangles.
void add_room(MeshBuilder& mesh, const glm::vec3& low, const glm::vec3& size, std::uint32_t triangles,
              Random random) {
    const auto somewhere = [&](float share) {
        return low + size * glm::vec3(random.unit(), random.unit(), random.unit()) * (1 - share);
    };
    for (; triangles >= kBoxTriangles; triangles -= kBoxTriangles) {
        const glm::vec3 corner = somewhere(0.12F);
        const glm::vec3 extent =
            0.12F * size *
            glm::vec3(random.between(0.2F, 1), random.between(0.2F, 1), random.between(0.2F, 1));
        mesh.hanging_box(corner, corner + extent, kWood * random.between(0.6F, 1.5F));
    }
    for (; triangles > 0; --triangles) {
        const glm::vec3 corner = somewhere(0.1F);
        mesh.triangle(corner, corner + glm::vec3(0.1F * size.x, 0, 0),
                      corner + glm::vec3(0, 0.1F * size.y, 0), kWood);
    }
    mesh.finish();
}

}  // namespace

void add_block(MeshBuilder& mesh, std::uint64_t seed) {
    Random random(seed);
    const std::uint32_t before = mesh.triangles_so_far();
    const Square large{glm::vec2(kStreetMetres / 2), kLargeMetres - kStreetMetres};
    const Square small{{kLargeMetres + kStreetMetres / 2, kStreetMetres / 2}, kSmallMetres - kStreetMetres};
    add_paving(mesh, {{0, 0}, kLargeMetres});
    add_paving(mesh, {{kLargeMetres, 0}, kSmallMetres});
    add_shell(mesh, large, kWalls[0]);
    add_shell(mesh, small, kWalls[1]);

    // The rest is furniture: a room to a floor and quarter of the large building, as many as it takes.
    std::uint32_t rest = kBlockTriangles - (mesh.triangles_so_far() - before);
    const std::uint32_t rooms = (rest + kRoomTriangles - 1) / kRoomTriangles;
    const float half = (large.side - 2 * kWallMetres) / 2;
    for (std::uint32_t room = 0; room < rooms; ++room) {
        const std::uint32_t triangles = rest / (rooms - room);
        rest -= triangles;
        const auto floor = static_cast<float>(room / 4 % kFloors);
        const glm::vec2 corner = large.low + kWallMetres + half * glm::vec2(room % 2, room / 2 % 2);
        add_room(mesh, {corner, floor * kFloorMetres + 0.2F}, {half, half, kFloorMetres - 0.4F}, triangles,
                 random.split());
    }
}

}  // namespace apps::log_city
