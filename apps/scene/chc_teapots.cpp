// SPDX-License-Identifier: MIT
// chc-teapots: the teapots of Bittner et al., Coherent Hierarchical Culling, 2004, section 6.1: 5,000 of
// 2,304 triangles, "randomly positioned", an arrangement "long and thin" with "many thin holes through which
// it is possible to see quite far into" it. The paper's table 1 gives triangles; size and density of the
// arrangement are ours, chosen for the shares of the triangles in the frustum and drawn. The walk looks at it
// from one end, from its longer side (the paper's frames 25 to 90; here from a sixth to a half of the walk),
// and from the other end.
#include <algorithm>
#include <cmath>

#include "apps/scene/random.h"
#include "apps/scene/scenes.h"
#include "apps/scene/teapot.h"

namespace apps {
namespace {

constexpr float kUnitMetres = 0.15F;        // a teapot is a metre long
constexpr float kTeapotReachMetres = 0.6F;  // from its middle
// Of the box in which their middles lie, at scale 1.
constexpr glm::vec3 kBoxMetres{44, 14, 2.2F};
constexpr Albedo kGlazes[] = {{0.86F, 0.84F, 0.78F}, {0.60F, 0.24F, 0.16F}, {0.22F, 0.42F, 0.50F},
                              {0.78F, 0.62F, 0.26F}, {0.34F, 0.46F, 0.28F}, {0.46F, 0.34F, 0.44F},
                              {0.74F, 0.52F, 0.40F}, {0.30F, 0.32F, 0.36F}};

/// Uniform over all rotations: a point of the unit ball in four dimensions, as a quaternion (Shoemake:
/// Uniform Random Rotations, Graphics Gems III, 1992, gives the uniformity; the ball saves him the sines).
glm::dmat3 random_rotation(Random& random) {
    glm::dvec4 q;
    double square = 0;
    do {
        for (int i = 0; i < 4; ++i) q[i] = 2.0 * static_cast<double>(random.unit()) - 1.0;
        square = glm::dot(q, q);
    } while (square > 1 || square < 0.01);
    q /= std::sqrt(square);
    const glm::dvec3 v(q);
    const double w = q[3];
    glm::dmat3 rotation;
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 e(0);
        e[axis] = 1;
        rotation[axis] = e + 2.0 * glm::cross(v, glm::cross(v, e) + w * e);
    }
    return rotation;
}

/// Around an arrangement that lies along x, its middle at the origin; all lengths grow with `size`.
CameraPath walk(float size) {
    struct Stand {
        float at;
        glm::vec3 eye;
        glm::vec3 look_at;
    };
    constexpr float kEnd = kBoxMetres.x / 2;
    const Stand stands[] = {
        {0, {-kEnd - 7, -1, 0.2F}, {0, 0, 0}},     {0.15F, {-kEnd - 7, -2, 0.4F}, {0, 0, 0}},
        {0.18F, {-kEnd, -30, 0.5F}, {0, 0, 0}},    {0.30F, {-8, -41, 0.7F}, {0, 0, 0}},
        {0.40F, {8, -40, 0.5F}, {0, 0, 0}},        {0.515F, {kEnd, -30, 0.3F}, {0, 0, 0}},
        {0.545F, {kEnd + 7.5F, -3, 0}, {0, 0, 0}}, {1, {kEnd + 6.5F, 1, -0.3F}, {0, 0, 0}},
    };
    std::vector<CameraKey> keys;
    // Of a small arrangement much sticks out of the box.
    const float aside = kTeapotReachMetres * std::max(0.0F, 1 - size);
    for (const Stand& stand : stands)
        keys.push_back(
            {stand.at, size * stand.eye + aside * glm::normalize(stand.eye), size * stand.look_at});
    return {std::move(keys), Lens{45, 0.1F, 400}};
}

}  // namespace

Scene build_chc_teapots(double scale, std::uint64_t seed) {
    Scene scene;
    scene.name = "chc-teapots";
    const auto total = static_cast<std::uint32_t>(std::lround(scale * kChcTeapotsTriangles));
    // How deep one sees depends on how many teapots share how large a face of the box: all lengths go with
    // the root.
    const auto size = static_cast<float>(std::sqrt(scale));
    std::vector<std::array<Object, 4>> meshes;
    for (const Albedo& glaze : kGlazes) meshes.push_back(add_teapot(scene, kUnitMetres, glaze));
    if (const std::uint32_t rest = total % kTeapotTriangles; rest > 0)
        meshes.push_back(add_teapot(scene, kUnitMetres, kGlazes[0], rest));
    Random random(seed);
    for (std::uint32_t made = 0; made < total; made += kTeapotTriangles) {
        const bool is_broken = total - made < kTeapotTriangles;
        const auto glaze = static_cast<std::size_t>(random.below(std::size(kGlazes)));
        const glm::dmat3 rotation = random_rotation(random);
        const float x = random.between(-0.5F, 0.5F);
        const float y = random.between(-0.5F, 0.5F);
        const float z = random.between(-0.5F, 0.5F);
        glm::mat4 placement{glm::mat3(rotation)};
        placement[3] = {size * kBoxMetres * glm::vec3(x, y, z), 1};
        scene.placements.push_back(placement);
        for (Object quarter : is_broken ? meshes.back() : meshes[glaze]) {
            if (quarter.index_count == 0) continue;
            quarter.placement = static_cast<std::uint32_t>(scene.placements.size() - 1);
            quarter.box = placed_box(scene, quarter, placement);
            scene.bounds.add(quarter.box);
            scene.objects.push_back(quarter);
        }
    }
    scene.path = walk(size);
    return scene;
}

}  // namespace apps
