// SPDX-License-Identifier: MIT
// chc-city: the city of Bittner et al., Coherent Hierarchical Culling, 2004, as far as the paper describes
// it: 1,036,146 triangles, streets between buildings without interiors, a walk in the streets and a look over
// the roofs. Our plan: a square grid of perimeter blocks around courtyards. Every block is given its share of
// the triangles; its buildings grow floor by floor while they fit, and trees, cars and bushes use up the rest
// exactly.
#include <cmath>
#include <stdexcept>

#include "apps/scene/city_parts.h"
#include "apps/scene/city_path.h"
#include "apps/scene/scenes.h"

namespace apps {
namespace {

using city::Building;
using city::kBayMetres;
using city::kPavementMetres;
using city::Outlook;

constexpr int kSideBays = 18;  // of a block's footprint
constexpr int kDepthBays = 4;  // of a row of houses
constexpr float kFootprintMetres = kSideBays * kBayMetres;
constexpr float kSidewalkMetres = 3;
constexpr float kRoadMetres = city::kPitchMetres - kFootprintMetres - 2 * kSidewalkMetres;
constexpr float kSlabMetres = kFootprintMetres + 2 * kSidewalkMetres;
constexpr float kTileMetres = 6;  // of road
constexpr Albedo kAsphalt{0.30F, 0.30F, 0.32F};
constexpr Albedo kPaving{0.62F, 0.61F, 0.58F};
constexpr Albedo kGrass{0.36F, 0.48F, 0.26F};

/// Flat ground between two corners.
void add_ground(MeshBuilder& mesh, glm::vec2 a, glm::vec2 b, float z, Albedo albedo) {
    mesh.quad({a, z}, {b.x, a.y, z}, {b, z}, {a.x, b.y, z}, albedo);
}

void add_road(MeshBuilder& mesh, glm::vec2 corner, bool along_x) {
    const float edges[] = {0, kRoadMetres / 2 - 0.1F, kRoadMetres / 2 + 0.1F, kRoadMetres};
    for (int tile = 0; tile * kTileMetres < kSlabMetres; ++tile) {
        const float from = static_cast<float>(tile) * kTileMetres;
        for (int strip = 0; strip < 3; ++strip) {
            const bool is_paint = strip == 1 && tile % 2 == 0;
            const glm::vec2 a{from, edges[strip]};
            const glm::vec2 b{from + kTileMetres, edges[strip + 1]};
            const glm::vec2 low = corner + (along_x ? a : glm::vec2(a.y, a.x));
            const glm::vec2 high = corner + (along_x ? b : glm::vec2(b.y, b.x));
            add_ground(mesh, low, high, 0, is_paint ? Albedo(0.82F) : kAsphalt);
        }
        mesh.finish();
    }
}

/// The roads north and east of a block, and those south and west of it where the city begins there.
void add_roads(MeshBuilder& mesh, int column, int row, glm::vec2 slab) {
    for (int south = row == 0 ? 0 : 1; south < 2; ++south)
        add_road(mesh, {slab.x, south ? slab.y + kSlabMetres : slab.y - kRoadMetres}, true);
    for (int west = column == 0 ? 0 : 1; west < 2; ++west)
        add_road(mesh, {west ? slab.x + kSlabMetres : slab.x - kRoadMetres, slab.y}, false);
    for (int y = row == 0 ? 0 : 1; y < 2; ++y)
        for (int x = column == 0 ? 0 : 1; x < 2; ++x) {
            const glm::vec2 corner{x ? slab.x + kSlabMetres : slab.x - kRoadMetres,
                                   y ? slab.y + kSlabMetres : slab.y - kRoadMetres};
            add_ground(mesh, corner, corner + kRoadMetres, 0, kAsphalt);
            mesh.finish();
        }
}

void add_slab(MeshBuilder& mesh, glm::vec2 slab) {
    const auto ring = [&](float inset, int corner) {
        const float far = kSlabMetres - inset;
        const glm::vec2 corners[] = {{inset, inset}, {far, inset}, {far, far}, {inset, far}};
        return slab + corners[corner % 4];
    };
    for (int side = 0; side < 4; ++side) {
        const glm::vec2 a = ring(0, side);
        const glm::vec2 b = ring(0, side + 1);
        mesh.quad({a, kPavementMetres}, {b, kPavementMetres},
                  {ring(kSidewalkMetres, side + 1), kPavementMetres},
                  {ring(kSidewalkMetres, side), kPavementMetres}, kPaving);
        mesh.quad({a, 0}, {b, 0}, {b, kPavementMetres}, {a, kPavementMetres}, kPaving * 0.9F);
        mesh.finish();
    }
    const float inset = kSidewalkMetres + kDepthBays * kBayMetres;
    add_ground(mesh, ring(inset, 0), ring(inset, 2), kPavementMetres, kGrass);
    mesh.finish();
}

/// Four rows of houses around a court: south and north over the whole width, west and east between them.
std::vector<Building> plan_houses(Random& random, glm::vec2 footprint) {
    std::vector<Building> houses;
    const auto add_row = [&](int first, int last, bool along_x, bool is_far_side) {
        for (int from = first; from < last;) {
            int to = std::min(last, from + 4 + random.below(3));
            if (last - to < 4) to = last;
            Building house;
            const int across = is_far_side ? kSideBays - kDepthBays : 0;
            const glm::vec2 low(from, across);
            const glm::vec2 high(to, across + kDepthBays);
            house.min = footprint + kBayMetres * (along_x ? low : glm::vec2(low.y, low.x));
            house.max = footprint + kBayMetres * (along_x ? high : glm::vec2(high.y, high.x));
            const auto length = static_cast<std::size_t>(to - from);
            const int front = along_x ? (is_far_side ? 2 : 0) : (is_far_side ? 1 : 3);
            const int low_end = along_x ? 3 : 0;
            const int high_end = along_x ? 1 : 2;
            house.walls[front].assign(length, Outlook::kStreet);
            house.walls[low_end].assign(kDepthBays,
                                        along_x && from == 0 ? Outlook::kStreet : Outlook::kNeighbour);
            house.walls[high_end].assign(kDepthBays,
                                         along_x && to == kSideBays ? Outlook::kStreet : Outlook::kNeighbour);
            std::vector<Outlook>& back = house.walls[(front + 2) % 4];
            for (std::size_t bay = 0; bay < length; ++bay) {
                // Walls 0 and 1 run with the axes, 2 and 3 against them.
                const int at =
                    (front + 2) % 4 < 2 ? from + static_cast<int>(bay) : to - 1 - static_cast<int>(bay);
                const bool sees_court = at >= kDepthBays && at < kSideBays - kDepthBays;
                back.push_back(sees_court ? Outlook::kCourt : Outlook::kNeighbour);
            }
            house.random = random.split();
            house.style = city::random_style(random);
            house.height_weight = random.between(0.5F, 1.5F);
            houses.push_back(house);
            from = to;
        }
    };
    for (const bool is_far_side : {false, true}) {
        add_row(0, kSideBays, true, is_far_side);
        add_row(kDepthBays, kSideBays - kDepthBays, false, is_far_side);
    }
    return houses;
}

/// Adds floors while they fit, always to the house that lags its weight most.
void raise_houses(std::vector<Building>& houses, std::uint32_t budget) {
    std::vector<std::uint32_t> floor_cost;
    for (Building& house : houses) {
        const std::uint32_t one = triangles_of(house);
        house.floors = 2;
        floor_cost.push_back(triangles_of(house) - one);
        house.floors = 1;
        if (one > budget) throw std::runtime_error("the city's scale is too small for its blocks");
        budget -= one;
    }
    while (true) {
        std::size_t best = houses.size();
        for (std::size_t i = 0; i < houses.size(); ++i) {
            if (floor_cost[i] > budget) continue;
            const auto lag = [&](std::size_t h) {
                return static_cast<float>(houses[h].floors) / houses[h].height_weight;
            };
            if (best == houses.size() || lag(i) < lag(best)) best = i;
        }
        if (best == houses.size()) return;
        ++houses[best].floors;
        budget -= floor_cost[best];
    }
}

void add_furniture(MeshBuilder& mesh, Random& random, glm::vec2 slab) {
    for (int side = 0; side < 4; ++side)
        for (float u = 6; u < kSlabMetres - 5; u += 8) {
            const bool along_x = side % 2 == 0;
            const float edge = side < 2 ? 0.9F : kSlabMetres - 0.9F;
            const float outwards = side < 2 ? -1.0F : 1.0F;
            const glm::vec2 spot = slab + (along_x ? glm::vec2(u, edge) : glm::vec2(edge, u));
            const glm::vec2 out = along_x ? glm::vec2(0, outwards) : glm::vec2(outwards, 0);
            const int choice = random.below(3);
            if (choice == 0) city::add_tree(mesh, random, {spot, kPavementMetres});
            if (choice == 1) city::add_lamp(mesh, {spot, kPavementMetres}, {out, 0});
            if (choice == 2) city::add_car(mesh, random, {spot + 2.1F * out, 0}, along_x);
        }
}

/// Uses up exactly `triangles`, at least 3, in the court.
void plant_court(MeshBuilder& mesh, Random& random, glm::vec2 slab, std::uint32_t triangles) {
    const auto spot = [&] {
        const float inset = kSidewalkMetres + kDepthBays * kBayMetres + 2;
        const glm::vec2 at =
            slab + inset + (kSlabMetres - 2 * inset) * glm::vec2(random.unit(), random.unit());
        return glm::vec3(at, kPavementMetres);
    };
    for (; triangles >= 2 * city::kTreeTriangles; triangles -= city::kTreeTriangles)
        city::add_tree(mesh, random, spot());
    city::add_bush(mesh, random, spot(), static_cast<int>(triangles));
}

void add_block(MeshBuilder& mesh, Random random, int column, int row, std::uint32_t triangles) {
    const std::uint32_t end = mesh.triangles_so_far() + triangles;
    const glm::vec2 slab = city::kPitchMetres * glm::vec2(column, row) + kRoadMetres / 2;
    add_roads(mesh, column, row, slab);
    add_slab(mesh, slab);
    add_furniture(mesh, random, slab);
    std::vector<Building> houses = plan_houses(random, slab + kSidewalkMetres);
    const std::uint32_t court = 8 * city::kTreeTriangles;
    const std::uint32_t used = mesh.triangles_so_far() + court;
    if (used > end) throw std::runtime_error("the city's scale is too small for its blocks");
    raise_houses(houses, end - used);
    for (const Building& house : houses) add_building(mesh, house);
    plant_court(mesh, random, slab, end - mesh.triangles_so_far());
}

/// Fields around the city, so that it does not end in the void: 4 * side + 4 objects of 2 triangles.
void add_outskirts(MeshBuilder& mesh, int side) {
    constexpr float kWidth = 60;
    const float low = -kRoadMetres / 2;
    const float high = static_cast<float>(side) * city::kPitchMetres - low;
    const auto add_field = [&](glm::vec2 a, glm::vec2 b) {
        add_ground(mesh, a, b, 0, kGrass);
        mesh.finish();
    };
    for (int piece = 0; piece < side; ++piece) {
        const float from = piece == 0 ? low : static_cast<float>(piece) * city::kPitchMetres;
        const float to = piece + 1 == side ? high : static_cast<float>(piece + 1) * city::kPitchMetres;
        add_field({from, low - kWidth}, {to, low});
        add_field({from, high}, {to, high + kWidth});
        add_field({low - kWidth, from}, {low, to});
        add_field({high, from}, {high + kWidth, to});
    }
    for (const float x : {low - kWidth, high})
        for (const float y : {low - kWidth, high}) add_field({x, y}, {x + kWidth, y + kWidth});
}

}  // namespace

Scene build_chc_city(double scale, std::uint64_t seed) {
    Scene scene;
    scene.name = "chc-city";
    const auto total = static_cast<std::uint32_t>(std::lround(scale * kChcCityTriangles));
    const int side = std::max(1, static_cast<int>(city::kSideBlocks * std::sqrt(scale) + 0.3));
    Random random(seed);
    // Houses are tall where a block's share is large: towards the middle, and by chance.
    std::vector<double> shares;
    double all_shares = 0;
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column) {
            const double middle = (side - 1) / 2.0;
            const double off = std::max(std::abs(column - middle), std::abs(row - middle)) / (middle + 1);
            shares.push_back(0.75 + 0.6 * (1 - off) + 0.5 * random.unit());
            all_shares += shares.back();
        }
    MeshBuilder mesh(scene);
    add_outskirts(mesh, side);
    double share = 0;
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column) {
            share += shares[static_cast<std::size_t>(row * side + column)];
            const bool is_last = row + 1 == side && column + 1 == side;
            const auto end = is_last ? total : static_cast<std::uint32_t>(share / all_shares * total);
            add_block(mesh, random.split(), column, row, end - mesh.triangles_so_far());
        }
    scene.path = city::walk(side);
    return scene;
}

}  // namespace apps
