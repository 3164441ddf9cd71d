// SPDX-License-Identifier: MIT
// chc-plant: a PROXY of the power plant of the University of North Carolina that Bittner et al., Coherent
// Hierarchical Culling, 2004, section 6.1, walk through. The model itself cannot be had; of it are kept the
// 12,748,510 triangles, the shares in the frustum and drawn, and what the paper says of the viewpoints.
// Our plan: floors of bays between columns; each bay has an aisle along x and beside it a rack of pipes,
// valves, tanks and pumps; cladding outside, open at the aisles; a shaft of upright pipes through the floors;
// a yard with tanks, chimneys and spare pipes. Every bay is given its share of the triangles, filled with
// pipes; spare pipes and at last a broken one use up the rest exactly.
#include <cmath>
#include <stdexcept>

#include "apps/scene/chc_plant_parts.h"
#include "apps/scene/chc_plant_path.h"
#include "apps/scene/random.h"
#include "apps/scene/scenes.h"

namespace apps {
namespace {

using namespace plant;

/// A mesh's +x axis in the world, and its +z.
enum class Heading : std::uint8_t { kX, kXDown, kXAside, kY, kUp };

glm::mat3 turn_to(Heading heading) {
    switch (heading) {
        case Heading::kX:
            break;
        case Heading::kXDown:
            return {{1, 0, 0}, {0, -1, 0}, {0, 0, -1}};
        case Heading::kXAside:
            return {{1, 0, 0}, {0, 0, 1}, {0, -1, 0}};
        case Heading::kY:
            return {{0, 1, 0}, {-1, 0, 0}, {0, 0, 1}};
        case Heading::kUp:
            return {{0, 0, 1}, {0, 1, 0}, {-1, 0, 0}};
    }
    return glm::mat3(1);
}

/// A run of pipe through a row of bays: where, in a bay, and how thick.
struct Track {
    Heading heading;
    glm::vec3 start;
    int gauge;
};

int random_gauge(Random& random) {
    constexpr int kGaugeOf[] = {0, 0, 1, 1, 1, 2, 2, 2, 3, 3};
    return kGaugeOf[random.below(10)];
}

/// In the order in which a bay takes them.
std::vector<Track> plan_tracks(Random& random, bool is_shaft) {
    std::vector<Track> tracks;
    if (is_shaft) {
        for (int column = 0; column < 8; ++column)
            for (int row = 0; row < 5; ++row)
                tracks.push_back(
                    {Heading::kUp,
                     {0.5F + 0.7F * static_cast<float>(column), 2.7F + 0.7F * static_cast<float>(row), 0},
                     random_gauge(random)});
    } else {
        for (const float z : {0.4F, 1.05F, 1.7F, 2.35F, 3.0F, 4.2F})
            for (int row = 0; row < 6; ++row)
                tracks.push_back(
                    {Heading::kX, {0, 2.6F + 0.6F * static_cast<float>(row), z}, random_gauge(random)});
        for (const float z : {3.6F, 4.8F})
            for (int column = 0; column < 8; ++column)
                tracks.push_back(
                    {Heading::kY, {0.6F + 0.7F * static_cast<float>(column), 0, z}, random_gauge(random)});
    }
    for (std::size_t i = tracks.size() - 1; i > 0; --i)
        std::swap(tracks[i], tracks[static_cast<std::size_t>(random.below(static_cast<int>(i) + 1))]);
    return tracks;
}

class Builder {
  public:
    Builder(Scene& scene, std::uint32_t total, const glm::ivec3& bays)
        : scene_(scene), parts_(build_parts(scene)), total_(total), bays_(bays) {}

    void build(Random& random) {
        add_yard(random);
        const std::uint64_t share = made_ < total_ ? total_ - made_ : 0;
        const auto count =
            static_cast<std::uint64_t>(bays_.x) * static_cast<std::uint64_t>(bays_.y * bays_.z);
        std::uint64_t bay = 0;
        const std::uint32_t yard = made_;
        for (int k = 0; k < bays_.z; ++k)
            for (int j = 0; j < bays_.y; ++j) {
                Random row = random.split();
                std::vector<Track> tracks = plan_tracks(row, false);
                for (int i = 0; i < bays_.x; ++i) {
                    Random here = row.split();
                    const auto end = static_cast<std::uint32_t>(yard + share * ++bay / count);
                    if (is_shaft(i, j)) {
                        Random shaft(static_cast<std::uint64_t>(i * 1000 + j));
                        add_bay(here, {i, j, k}, plan_tracks(shaft, true), end);
                    } else {
                        add_bay(here, {i, j, k}, tracks, end);
                        // Some runs end here, others begin.
                        for (int change = 0; change < 4; ++change)
                            std::swap(tracks[static_cast<std::size_t>(here.below(20))],
                                      tracks[20 + static_cast<std::size_t>(here.below(32))]);
                    }
                }
            }
        if (made_ > total_) throw std::runtime_error("the plant's scale is too small for its building");
        add_spares();
    }

  private:
    bool is_shaft(int i, int j) const {
        return bays_.x >= 6 && bays_.y >= 4 && i >= bays_.x / 3 && i < bays_.x / 3 + 2 &&
               j >= bays_.y / 3 + 1 && j < bays_.y / 3 + 2;
    }

    void put(const Object& mesh, const glm::vec3& at, Heading heading = Heading::kX) {
        glm::mat4 placement{turn_to(heading)};
        placement[3] = {at, 1};
        scene_.placements.push_back(placement);
        Object object = mesh;
        object.placement = static_cast<std::uint32_t>(scene_.placements.size() - 1);
        object.box = placed_box(scene_, object, placement);
        scene_.bounds.add(object.box);
        scene_.objects.push_back(object);
        made_ += mesh.triangle_count();
    }

    /// Ground, tanks and chimneys around the building.
    void add_yard(Random& random) {
        constexpr float kTile = 12;
        const glm::vec2 size = kBayMetres * glm::vec2(bays_);
        for (float x = -2 * kTile; x < size.x + 2 * kTile; x += kTile)
            for (float y = -2 * kTile; y < size.y + 2 * kTile; y += kTile) put(parts_.ground, {x, y, -0.3F});
        for (int chimney = 0; chimney < bays_.x / 6; ++chimney)
            put(parts_.chimney, {8 + 24 * static_cast<float>(chimney), size.y + 10, -0.3F});
        for (int tank = 0; tank < bays_.y; ++tank)
            put(parts_.tank, {size.x + random.between(8, 22), 6 * static_cast<float>(tank) + 3, -0.3F});
    }

    void add_structure(Random& random, const glm::ivec3& cell, const glm::vec3& corner) {
        if (cell.z == 0 || !is_shaft(cell.x, cell.y)) put(parts_.slab, corner);
        if (cell.z + 1 == bays_.z) put(parts_.slab, corner + glm::vec3(0, 0, kFloorMetres));
        put(parts_.column, corner + glm::vec3(0.3F, 2.35F, 0));
        put(parts_.beam, corner + glm::vec3(0, 2.35F, kFloorMetres));
        put(parts_.beam, corner + glm::vec3(0.3F, 0, kFloorMetres), Heading::kY);
        if (random.below(2) == 0) put(parts_.rail, corner + glm::vec3(0, kAisleMetres + 0.05F, 0));
        const glm::vec3 rack = corner + glm::vec3(0, kBayMetres - kCladdingMetres, 0);
        if (cell.x == 0 && random.below(8) != 0)
            put(parts_.cladding, rack + glm::vec3(-0.1F, 0, 0), Heading::kY);
        if (cell.x + 1 == bays_.x && random.below(8) != 0)
            put(parts_.cladding, rack + glm::vec3(kBayMetres + 0.1F, 0, 0), Heading::kY);
        for (const bool is_far : {false, true}) {
            if (cell.y != (is_far ? bays_.y - 1 : 0)) continue;
            const glm::vec3 wall = corner + glm::vec3(0, is_far ? kBayMetres + 0.1F : -0.1F, 0);
            for (const float along : {0.0F, kBayMetres - kCladdingMetres})
                if (random.below(4) != 0) put(parts_.cladding, wall + glm::vec3(along, 0, 0));
        }
    }

    void add_bay(Random& random, const glm::ivec3& cell, const std::vector<Track>& tracks,
                 std::uint32_t end) {
        const glm::vec3 corner = kBayMetres * glm::vec3(cell);
        add_structure(random, cell, corner);
        const bool has_machines = random.below(6) == 0 && !is_shaft(cell.x, cell.y);
        if (has_machines && made_ + parts_.tank.triangle_count() + parts_.pump.triangle_count() < end) {
            put(parts_.tank, corner + glm::vec3(1.6F, 4.2F, 0));
            put(parts_.pump, corner + glm::vec3(3.4F, 4.2F, 0));
        }
        for (const Track& track : tracks) {
            if (has_machines && track.start.z < 3.5F) continue;
            const auto gauge = static_cast<std::size_t>(track.gauge);
            const int choice = random.below(10);
            const Object& mesh = choice == 0   ? parts_.elbows[gauge]
                                 : choice <= 2 ? parts_.valves[gauge]
                                               : parts_.pipes[gauge];
            if (made_ + mesh.triangle_count() > end) return;
            Heading heading = track.heading;
            if (choice == 0 && heading == Heading::kX && random.below(2) == 0)
                heading = random.below(2) == 0 ? Heading::kXDown : Heading::kXAside;
            put(mesh, corner + track.start, heading);
        }
    }

    /// Stacks of pipes in the yard, and what is left of a broken one.
    void add_spares() {
        const std::uint32_t whole = most_scrap(parts_);
        const float east = kBayMetres * static_cast<float>(bays_.x) + 26;
        for (int spare = 0; total_ - made_ > whole; ++spare)
            put(parts_.pipes[0],
                {east, 0.2F * static_cast<float>(spare % 200), 0.2F * static_cast<float>(spare / 200)});
        if (total_ > made_) put(build_scrap(scene_, total_ - made_), {east, -2, 0});
    }

    Scene& scene_;
    Parts parts_;
    std::uint32_t total_;
    glm::ivec3 bays_;
    std::uint32_t made_ = 0;
};

}  // namespace

Scene build_chc_plant(double scale, std::uint64_t seed) {
    Scene scene;
    scene.name = "chc-plant";
    const auto total = static_cast<std::uint32_t>(std::lround(scale * kChcPlantTriangles));
    const double growth = std::cbrt(scale);
    const auto scaled = [&](double at_one) { return std::max(1, static_cast<int>(at_one * growth + 0.5)); };
    const glm::ivec3 bays{scaled(12), scaled(8), scaled(8)};
    Random random(seed);
    Builder(scene, total, bays).build(random);
    scene.path = walk(bays);
    return scene;
}

}  // namespace apps
