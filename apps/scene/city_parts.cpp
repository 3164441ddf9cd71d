// SPDX-License-Identifier: MIT
// Facades, roofs and street furniture. Neighbouring bays meet in whole edges: a crack would let single pixels
// of what lies behind through, and make it visible.
#include "apps/scene/city_parts.h"

#include <iterator>

namespace apps::city {
namespace {

constexpr float kRecessMetres = 0.22F;  // of a pane behind its wall

/// A wall seen from outside: u to the right, z up, d out of the wall, all in metres.
struct Wall {
    glm::vec3 origin, along, out;

    glm::vec3 at(float u, float d, float z) const {
        return origin + u * along + d * out + glm::vec3(0, 0, z);
    }
};

Wall wall_of(const Building& b, int side) {
    const glm::vec3 origins[] = {
        {b.min.x, b.min.y, 0}, {b.max.x, b.min.y, 0}, {b.max.x, b.max.y, 0}, {b.min.x, b.max.y, 0}};
    const glm::vec3 alongs[] = {{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
    const glm::vec3 outs[] = {{0, -1, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}};
    return {origins[side], alongs[side], outs[side]};
}

struct Opening {
    float left, right, bottom, top;
};

/// 18 triangles: a rectangle of wall around a recessed pane. The frame is mitred: no edge ends inside
/// another.
void add_window(MeshBuilder& mesh, const Wall& w, const Opening& wall, const Opening& hole, Albedo colour,
                Albedo glass) {
    const float us[] = {wall.left, wall.right, wall.right, wall.left};
    const float zs[] = {wall.bottom, wall.bottom, wall.top, wall.top};
    const float hole_us[] = {hole.left, hole.right, hole.right, hole.left};
    const float hole_zs[] = {hole.bottom, hole.bottom, hole.top, hole.top};
    for (int a = 0; a < 4; ++a) {
        const int b = (a + 1) % 4;
        const glm::vec3 inner_a = w.at(hole_us[a], 0, hole_zs[a]);
        const glm::vec3 inner_b = w.at(hole_us[b], 0, hole_zs[b]);
        mesh.quad(w.at(us[a], 0, zs[a]), w.at(us[b], 0, zs[b]), inner_b, inner_a, colour);
        mesh.quad(inner_a, inner_b, inner_b - kRecessMetres * w.out, inner_a - kRecessMetres * w.out,
                  colour * 0.8F);
    }
    mesh.quad(w.at(hole.left, -kRecessMetres, hole.bottom), w.at(hole.right, -kRecessMetres, hole.bottom),
              w.at(hole.right, -kRecessMetres, hole.top), w.at(hole.left, -kRecessMetres, hole.top), glass);
}

Albedo pane_colour(Random& random, const Style& style) {
    const bool is_lit = random.below(14) == 0;
    return is_lit ? Albedo(1.0F, 0.86F, 0.55F) : style.glass * random.between(0.7F, 1.3F);
}

void add_street_bay(MeshBuilder& mesh, Random& random, const Style& s, const Wall& w, int bay, int floor) {
    const float u = static_cast<float>(bay) * kBayMetres;
    const float z = kPavementMetres + static_cast<float>(floor) * kFloorMetres;
    const Opening wall{u, u + kBayMetres, z, z + kFloorMetres};
    if (floor == 0) {  // shops, and a door here and there
        const bool is_door = random.below(4) == 0;
        const float margin = is_door ? 0.85F : 0.3F;
        const Albedo pane = is_door ? s.trim * 0.45F : pane_colour(random, s);
        add_window(mesh, w, wall,
                   {u + margin, u + kBayMetres - margin, z + (is_door ? 0.04F : 0.5F), z + 2.6F}, s.trim,
                   pane);
        return mesh.finish();
    }
    const float left = u + (kBayMetres - s.window_width) / 2;
    const Opening hole{left, left + s.window_width, z + s.sill_height, z + s.head_height};
    add_window(mesh, w, wall, hole, s.wall, pane_colour(random, s));
    if (s.has_bars)
        mesh.quad(w.at(u + 1.46F, 0.04F - kRecessMetres, hole.bottom),
                  w.at(u + 1.54F, 0.04F - kRecessMetres, hole.bottom),
                  w.at(u + 1.54F, 0.04F - kRecessMetres, hole.top),
                  w.at(u + 1.46F, 0.04F - kRecessMetres, hole.top), s.trim);
    if (s.has_sills)
        mesh.hanging_box(w.at(hole.left - 0.1F, 0.01F, hole.bottom - 0.12F),
                         w.at(hole.right + 0.1F, 0.16F, hole.bottom - 0.02F), s.trim);
    if (s.has_balconies && bay % 2 == 1) {
        mesh.hanging_box(w.at(u + 0.3F, 0.01F, z - 0.05F), w.at(u + 2.7F, 1.1F, z + 0.08F), s.trim);
        mesh.hanging_box(w.at(u + 0.3F, 1.02F, z + 0.1F), w.at(u + 2.7F, 1.08F, z + 1.0F), s.trim * 0.7F);
    }
    mesh.finish();
}

void add_court_bay(MeshBuilder& mesh, Random& random, const Style& s, const Wall& w, int bay, int floor) {
    const float u = static_cast<float>(bay) * kBayMetres;
    const float z = kPavementMetres + static_cast<float>(floor) * kFloorMetres;
    add_window(mesh, w, {u, u + kBayMetres, z, z + kFloorMetres}, {u + 0.9F, u + 2.1F, z + 1.0F, z + 2.4F},
               s.wall * 0.85F, pane_colour(random, s));
    mesh.finish();
}

void add_walls(MeshBuilder& mesh, Random random, const Building& b) {
    const float top = kPavementMetres + static_cast<float>(b.floors) * kFloorMetres;
    for (int side = 0; side < 4; ++side) {
        const Wall w = wall_of(b, side);
        const auto bays = static_cast<int>(b.walls[side].size());
        for (int bay = 0; bay < bays; ++bay) {
            const Outlook outlook = b.walls[side][static_cast<std::size_t>(bay)];
            const float u = static_cast<float>(bay) * kBayMetres;
            Random column = random.split();
            if (outlook == Outlook::kNeighbour) {
                mesh.quad(w.at(u, 0, kPavementMetres), w.at(u + kBayMetres, 0, kPavementMetres),
                          w.at(u + kBayMetres, 0, top), w.at(u, 0, top), b.style.wall * 0.75F);
                mesh.finish();
                continue;
            }
            const auto add_bay = outlook == Outlook::kStreet ? add_street_bay : add_court_bay;
            for (int floor = 0; floor < b.floors; ++floor) add_bay(mesh, column, b.style, w, bay, floor);
        }
        if (b.walls[side].front() != Outlook::kStreet) continue;
        const float length = static_cast<float>(bays) * kBayMetres;
        mesh.hanging_box(w.at(0.05F, 0.01F, top - 0.35F), w.at(length - 0.05F, 0.35F, top - 0.05F),
                         b.style.trim);
        mesh.finish();
    }
}

void add_flat_roof(MeshBuilder& mesh, Random random, const Building& b, float top) {
    mesh.quad({b.min, top}, {b.max.x, b.min.y, top}, {b.max, top}, {b.min.x, b.max.y, top},
              Albedo(0.55F, 0.54F, 0.52F));
    mesh.finish();
    const glm::vec2 lo = b.min + 0.06F;
    const glm::vec2 hi = b.max - 0.06F;
    const float rim = top + 0.7F;
    mesh.standing_box({lo, top}, {hi.x, lo.y + 0.25F, rim}, b.style.trim);
    mesh.standing_box({lo.x, hi.y - 0.25F, top}, {hi, rim}, b.style.trim);
    mesh.standing_box({lo.x, lo.y + 0.25F, top}, {lo.x + 0.25F, hi.y - 0.25F, rim}, b.style.trim);
    mesh.standing_box({hi.x - 0.25F, lo.y + 0.25F, top}, {hi.x, hi.y - 0.25F, rim}, b.style.trim);
    mesh.finish();
    for (int unit = 0; unit < 3; ++unit) {  // stair heads and machines
        const glm::vec2 size{random.between(1.2F, 3.2F), random.between(1.2F, 3.2F)};
        const glm::vec2 at = lo + 0.8F + glm::vec2(random.unit(), random.unit()) * (hi - lo - size - 1.6F);
        mesh.standing_box({at, top}, {at + size, top + random.between(0.8F, 2.6F)},
                          Albedo(0.62F, 0.63F, 0.64F));
        mesh.finish();
    }
}

void add_gable_roof(MeshBuilder& mesh, Random random, const Building& b, float top) {
    const bool ridge_along_x = b.walls[0].size() >= b.walls[1].size();
    const float depth = ridge_along_x ? b.max.y - b.min.y : b.max.x - b.min.x;
    const float ridge = top + 0.38F * depth;
    const float length = ridge_along_x ? b.max.x - b.min.x : b.max.y - b.min.y;
    const auto at = [&](float along, float across, float z) {
        return ridge_along_x ? glm::vec3(b.min.x + along, b.min.y + across, z)
                             : glm::vec3(b.max.x - across, b.min.y + along, z);
    };
    const auto bays = static_cast<int>(length / kBayMetres + 0.5F);
    for (int bay = 0; bay < bays; ++bay) {
        const float u = static_cast<float>(bay) * kBayMetres;
        const float v = u + kBayMetres;
        mesh.quad(at(u, 0, top), at(v, 0, top), at(v, depth / 2, ridge), at(u, depth / 2, ridge),
                  b.style.roof);
        mesh.quad(at(v, depth, top), at(u, depth, top), at(u, depth / 2, ridge), at(v, depth / 2, ridge),
                  b.style.roof);
        if (random.below(3) == 0) {
            const float chimney = random.between(0.25F, 0.65F) * depth;
            mesh.standing_box(at(u + 1.0F, chimney, top + 1), at(u + 1.7F, chimney + 0.9F, ridge + 1.1F),
                              Albedo(0.52F, 0.30F, 0.24F));
        } else {
            mesh.standing_box(at(u + 0.8F, 1.2F, top + 0.3F), at(u + 2.2F, 3.4F, top + 2.0F), b.style.trim);
        }
        mesh.finish();
    }
    mesh.triangle(at(0, depth, top), at(0, 0, top), at(0, depth / 2, ridge), b.style.wall);
    mesh.triangle(at(length, 0, top), at(length, depth, top), at(length, depth / 2, ridge), b.style.wall);
    mesh.finish();
}

}  // namespace

Style random_style(Random& random) {
    static constexpr Albedo kWalls[] = {{0.86F, 0.80F, 0.68F}, {0.78F, 0.55F, 0.44F}, {0.70F, 0.36F, 0.28F},
                                        {0.83F, 0.83F, 0.80F}, {0.90F, 0.74F, 0.50F}, {0.66F, 0.70F, 0.72F},
                                        {0.76F, 0.66F, 0.58F}, {0.58F, 0.62F, 0.56F}};
    static constexpr Albedo kRoofs[] = {{0.66F, 0.34F, 0.25F}, {0.55F, 0.28F, 0.22F}, {0.38F, 0.40F, 0.44F}};
    Style style{};
    style.wall = kWalls[random.below(std::size(kWalls))] * random.between(0.9F, 1.05F);
    style.trim = glm::mix(style.wall, Albedo(0.93F, 0.92F, 0.88F), random.between(0.4F, 0.9F));
    style.glass = Albedo(0.20F, 0.27F, 0.34F) * random.between(0.8F, 1.3F);
    style.roof = kRoofs[random.below(std::size(kRoofs))];
    style.window_width = random.between(1.0F, 2.0F);
    style.sill_height = random.between(0.5F, 1.0F);
    style.head_height = random.between(2.4F, 2.8F);
    style.has_sills = random.below(3) != 0;
    style.has_bars = random.below(2) != 0;
    style.has_balconies = random.below(4) == 0;
    style.has_gable = random.below(2) != 0;
    return style;
}

void add_building(MeshBuilder& mesh, const Building& building) {
    Random random = building.random;
    const float top = kPavementMetres + static_cast<float>(building.floors) * kFloorMetres;
    add_walls(mesh, random.split(), building);
    (building.style.has_gable ? add_gable_roof : add_flat_roof)(mesh, random.split(), building, top);
}

std::uint32_t triangles_of(const Building& building) {
    Scene scratch;
    MeshBuilder mesh(scratch);
    add_building(mesh, building);
    return mesh.triangles_so_far();
}

void add_tree(MeshBuilder& mesh, Random& random, const glm::vec3& foot) {
    const float trunk = random.between(1.6F, 2.4F);
    const float radius = random.between(1.2F, 1.9F);
    const Albedo green = glm::mix(Albedo(0.25F, 0.42F, 0.16F), Albedo(0.46F, 0.52F, 0.20F), random.unit());
    mesh.standing_box(foot - glm::vec3(0.15F, 0.15F, 0), foot + glm::vec3(0.15F, 0.15F, trunk + 1),
                      {0.36F, 0.27F, 0.20F});
    const glm::vec3 crown = foot + glm::vec3(0, 0, trunk + 1);
    mesh.cone(crown, radius, random.between(2.4F, 4.2F), 8, green);
    mesh.cone(crown, radius, -1, 8, green * 0.7F);
    mesh.finish();
}

void add_car(MeshBuilder& mesh, Random& random, const glm::vec3& centre, bool along_x) {
    static constexpr Albedo kPaints[] = {{0.75F, 0.10F, 0.10F}, {0.12F, 0.25F, 0.55F}, {0.85F, 0.85F, 0.85F},
                                         {0.15F, 0.15F, 0.16F}, {0.55F, 0.56F, 0.58F}, {0.20F, 0.40F, 0.30F}};
    const Albedo paint = kPaints[random.below(std::size(kPaints))];
    const auto box = [&](float half_length, float half_width, float from, float to, Albedo colour) {
        const glm::vec3 half =
            along_x ? glm::vec3(half_length, half_width, 0) : glm::vec3(half_width, half_length, 0);
        mesh.standing_box(centre - half + glm::vec3(0, 0, from), centre + half + glm::vec3(0, 0, to), colour);
    };
    box(1.75F, 0.78F, 0.02F, 0.32F, {0.08F, 0.08F, 0.08F});
    box(2.1F, 0.88F, 0.33F, 0.85F, paint);
    box(1.1F, 0.78F, 0.86F, 1.42F, glm::mix(paint, Albedo(0.15F, 0.2F, 0.25F), 0.75F));
    mesh.finish();
}

void add_lamp(MeshBuilder& mesh, const glm::vec3& foot, const glm::vec3& towards_street) {
    mesh.standing_box(foot - glm::vec3(0.07F, 0.07F, 0), foot + glm::vec3(0.07F, 0.07F, 5.2F),
                      {0.20F, 0.22F, 0.24F});
    const glm::vec3 side(towards_street.y, towards_street.x, 0);
    mesh.hanging_box(foot - 0.1F * side + glm::vec3(0, 0, 5.21F),
                     foot + 0.1F * side + 1.3F * towards_street + glm::vec3(0, 0, 5.36F),
                     {0.85F, 0.83F, 0.72F});
    mesh.finish();
}

void add_bush(MeshBuilder& mesh, Random& random, const glm::vec3& foot, int triangles) {
    mesh.cone(foot, random.between(0.6F, 1.1F), random.between(0.8F, 1.5F), triangles, {0.30F, 0.46F, 0.20F});
    mesh.finish();
}

}  // namespace apps::city
