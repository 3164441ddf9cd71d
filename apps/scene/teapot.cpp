// SPDX-License-Identifier: MIT
// Newell's control points. The public-domain table lists 306 of them, some twice. Body and lid are turned:
// what is written here of them is their profile, an octant's worth of each ring; handle and spout are
// mirrored. A patch is evaluated at 7 x 7 places by Bernstein polynomials, its normals from both derivatives.
#include "apps/scene/teapot.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "apps/scene/light.h"

namespace apps {
namespace {

/// A quarter of it has the control points (radius, 0), (radius, -inner), (inner, -radius), (0, -radius).
struct Ring {
    float radius;
    float inner;
    float height;
};

/// From inside the rim, over it, down and under the bottom.
constexpr Ring kBody[] = {{1.4F, 0.784F, 2.4F},
                          {1.3375F, 0.749F, 2.53125F},
                          {1.4375F, 0.805F, 2.53125F},
                          {1.5F, 0.84F, 2.4F},
                          {1.75F, 0.98F, 1.875F},
                          {2, 1.12F, 1.35F},
                          {2, 1.12F, 0.9F},
                          {2, 1.12F, 0.45F},
                          {1.5F, 0.84F, 0.225F},
                          {1.5F, 0.84F, 0.15F},
                          {1.5F, 0.84F, 0.075F},
                          {1.425F, 0.798F, 0},
                          {0, 0, 0}};
/// From the top of the knob outwards.
constexpr Ring kLid[] = {{0, 0, 3.15F},        {0.8F, 0.45F, 3.15F},  {0, 0, 2.85F},
                         {0.2F, 0.112F, 2.7F}, {0.4F, 0.224F, 2.55F}, {1.3F, 0.728F, 2.55F},
                         {1.3F, 0.728F, 2.4F}};

using Row = std::array<glm::vec3, 4>;  // across, on the side of -y
constexpr Row row(float x0, float z0, float half_width, float x1, float z1) {
    return {{{x0, 0, z0}, {x0, -half_width, z0}, {x1, -half_width, z1}, {x1, 0, z1}}};
}
/// From its upper end to its lower one.
constexpr Row kHandle[] = {row(-1.6F, 2.025F, 0.3F, -1.5F, 2.25F), row(-2.3F, 2.025F, 0.3F, -2.5F, 2.25F),
                           row(-2.7F, 2.025F, 0.3F, -3, 2.25F),    row(-2.7F, 1.8F, 0.3F, -3, 1.8F),
                           row(-2.7F, 1.575F, 0.3F, -3, 1.35F),    row(-2.5F, 1.125F, 0.3F, -2.65F, 0.9375F),
                           row(-2, 0.9F, 0.3F, -1.9F, 0.6F)};
/// From the body to the tip.
constexpr Row kSpout[] = {
    row(1.7F, 1.425F, 0.66F, 1.7F, 0.6F),       row(2.6F, 1.425F, 0.66F, 3.1F, 0.825F),
    row(2.3F, 2.1F, 0.25F, 2.4F, 2.025F),       row(2.7F, 2.4F, 0.25F, 3.3F, 2.4F),
    row(2.8F, 2.475F, 0.25F, 3.525F, 2.49375F), row(2.9F, 2.475F, 0.15F, 3.45F, 2.5125F),
    row(2.8F, 2.4F, 0.15F, 3.2F, 2.4F)};

using Patch = std::array<Row, 4>;

/// Quarter `turn` of four, counter-clockwise from the one with x >= 0 >= y.
Row quarter(const Ring& ring, int turn) {
    Row points{{{ring.radius, 0, ring.height},
                {ring.radius, -ring.inner, ring.height},
                {ring.inner, -ring.radius, ring.height},
                {0, -ring.radius, ring.height}}};
    for (; turn > 0; --turn)
        for (glm::vec3& p : points) p = {-p.y, p.x, p.z};
    return points;
}

/// The patches of a quarter, all with their outside to the same hand. Quarters 0 and 1 share the spout, 2 and
/// 3 the handle.
std::vector<Patch> patches_of(int turn) {
    std::vector<Patch> patches;
    for (const std::span<const Ring> rings : {std::span<const Ring>(kBody), std::span<const Ring>(kLid)})
        for (std::size_t first = 0; first + 3 < rings.size(); first += 3) {
            Patch patch;
            for (std::size_t r = 0; r < 4; ++r) patch[r] = quarter(rings[first + r], turn);
            patches.push_back(patch);
        }
    const bool is_mirrored = turn == 1 || turn == 2;  // on the side of +y
    const std::span<const Row> rows = turn < 2 ? kSpout : kHandle;
    for (std::size_t first = 0; first + 3 < rows.size(); first += 3) {
        Patch patch;
        for (std::size_t r = 0; r < 4; ++r) {
            patch[r] = rows[first + r];
            if (!is_mirrored) continue;
            std::reverse(patch[r].begin(), patch[r].end());
            for (glm::vec3& p : patch[r]) p.y = -p.y;
        }
        patches.push_back(patch);
    }
    return patches;
}

/// Weights of four control points in the point at t, and in its derivative.
struct Weights {
    std::array<float, 4> of_point;
    std::array<float, 4> of_slope;
};

Weights weights_at(float t) {
    const float s = 1 - t;
    return {{s * s * s, 3 * t * s * s, 3 * t * t * s, t * t * t},
            {-3 * s * s, 3 * s * (s - 2 * t), 3 * t * (2 * s - t), 3 * t * t}};
}

glm::vec3 sum(const Patch& patch, const std::array<float, 4>& down, const std::array<float, 4>& across) {
    glm::vec3 point(0);
    for (std::size_t r = 0; r < 4; ++r)
        for (std::size_t c = 0; c < 4; ++c) point += down[r] * across[c] * patch[r][c];
    return point;
}

/// Outwards; where a ring shrinks to a point, the axis.
glm::vec3 normal_at(const Patch& patch, const Weights& down, const Weights& across, float height) {
    const glm::vec3 cross =
        glm::cross(sum(patch, down.of_point, across.of_slope), sum(patch, down.of_slope, across.of_point));
    const float length = glm::length(cross);
    return length > 1e-5F ? cross / length : glm::vec3(0, 0, height > 1 ? 1 : -1);
}

class Potter {
  public:
    Potter(Scene& scene, float unit_metres, Albedo glaze)
        : scene_(scene), unit_metres_(unit_metres), glaze_(glaze) {}

    Object quarter_of(int turn, std::uint32_t triangles) {
        Object object;
        object.first_index = static_cast<std::uint32_t>(scene_.indices.size());
        object.first_vertex = static_cast<std::uint32_t>(scene_.positions.size());
        for (const Patch& patch : patches_of(turn)) {
            if (triangles == 0) break;
            triangles -= add(patch, triangles);
        }
        object.index_count = static_cast<std::uint32_t>(scene_.indices.size()) - object.first_index;
        object.vertex_count = static_cast<std::uint32_t>(scene_.positions.size()) - object.first_vertex;
        object.box = placed_box(scene_, object, glm::mat4(1));
        return object;
    }

  private:
    /// At most so many triangles of it; returns how many.
    std::uint32_t add(const Patch& patch, std::uint32_t triangles) {
        constexpr glm::vec3 kMiddle{0.225F, 0, 1.575F};
        const auto first = static_cast<std::uint32_t>(scene_.positions.size());
        for (std::uint32_t r = 0; r <= kTeapotSteps; ++r)
            for (std::uint32_t c = 0; c <= kTeapotSteps; ++c) {
                const Weights down = weights_at(static_cast<float>(r) / kTeapotSteps);
                const Weights across = weights_at(static_cast<float>(c) / kTeapotSteps);
                const glm::vec3 point = sum(patch, down.of_point, across.of_point);
                const glm::vec3 normal = normal_at(patch, down, across, point.z);
                const glm::vec3 place = unit_metres_ * (point - kMiddle);
                const glm::vec3 light = glm::clamp(glaze_ * baked_light(place, normal), 0.0F, 1.0F);
                scene_.positions.push_back(place);
                scene_.colours.emplace_back(glm::u8vec3(light * 255.0F + 0.5F), 255);
            }
        const std::uint32_t count = std::min(triangles, 2 * kTeapotSteps * kTeapotSteps);
        for (std::uint32_t t = 0; t < count; ++t) {
            const std::uint32_t cell = t / 2;
            const std::uint32_t a = first + cell / kTeapotSteps * (kTeapotSteps + 1) + cell % kTeapotSteps;
            const std::uint32_t below = a + kTeapotSteps + 1;
            for (const std::uint32_t v :
                 t % 2 == 0 ? std::array{a, a + 1, below} : std::array{a + 1, below + 1, below})
                scene_.indices.push_back(v);
        }
        return count;
    }

    Scene& scene_;
    float unit_metres_;
    Albedo glaze_;
};

}  // namespace

std::array<Object, 4> add_teapot(Scene& scene, float unit_metres, Albedo glaze, std::uint32_t triangles) {
    Potter potter(scene, unit_metres, glaze);
    std::array<Object, 4> quarters;
    for (int turn = 0; turn < 4; ++turn) {
        const std::uint32_t share = std::min(triangles, kTeapotTriangles / 4);
        quarters[static_cast<std::size_t>(turn)] = potter.quarter_of(turn, share);
        triangles -= share;
    }
    return quarters;
}

}  // namespace apps
