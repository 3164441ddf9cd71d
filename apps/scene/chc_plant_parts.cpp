// SPDX-License-Identifier: MIT
// Turned bodies by the rational parametrisation of the circle, steel of boxes. Only + - * / and sqrt touch a
// coordinate.
#include "apps/scene/chc_plant_parts.h"

#include <algorithm>
#include <span>

#include "apps/scene/light.h"

namespace apps::plant {
namespace {

constexpr Albedo kSteel{0.42F, 0.45F, 0.48F};
constexpr Albedo kConcrete{0.58F, 0.57F, 0.54F};
constexpr Albedo kCladding{0.62F, 0.68F, 0.70F};
constexpr Albedo kSafety{0.86F, 0.70F, 0.16F};
constexpr Albedo kGreen{0.24F, 0.44F, 0.34F};
constexpr Albedo kGravel{0.50F, 0.47F, 0.42F};
constexpr Albedo kBrick{0.60F, 0.36F, 0.28F};
constexpr Albedo kGaugePaint[kGauges] = {
    {0.70F, 0.30F, 0.22F}, {0.30F, 0.48F, 0.66F}, {0.78F, 0.78F, 0.74F}, {0.62F, 0.62F, 0.58F}};

/// Side `side` of `sides` of the unit circle.
glm::vec2 on_circle(int side, int sides) {
    const float turn = 4 * static_cast<float>(side % sides) / static_cast<float>(sides);
    const auto quarter = static_cast<int>(turn);
    const float t = turn - static_cast<float>(quarter);
    const glm::vec2 point = glm::vec2(1 - t * t, 2 * t) / (1 + t * t);
    const glm::vec2 turned[] = {point, {-point.y, point.x}, -point, {point.y, -point.x}};
    return turned[quarter];
}

/// A circle in space, about the direction cross(u, v).
struct Hoop {
    glm::vec3 centre;
    glm::vec3 u;
    glm::vec3 v;
    float radius;
};

/// Collects one mesh in the arrays of the scene.
class Lathe {
  public:
    explicit Lathe(Scene& scene)
        : scene_(scene),
          first_index_(static_cast<std::uint32_t>(scene.indices.size())),
          first_vertex_(static_cast<std::uint32_t>(scene.positions.size())) {}

    /// The band between two hoops, its normals leaning by `lean` of the axis: 2 triangles a side, 1 where a
    /// hoop is a point.
    void band(const Hoop& from, const Hoop& to, int sides, float lean, Albedo albedo) {
        const auto first = static_cast<std::uint32_t>(scene_.positions.size());
        for (int side = 0; side <= sides; ++side)
            for (const Hoop* hoop : {&from, &to}) {
                const glm::vec2 c = on_circle(side, sides);
                const glm::vec3 radial = c.x * hoop->u + c.y * hoop->v;
                add(hoop->centre + hoop->radius * radial, radial, glm::cross(hoop->u, hoop->v), lean, albedo);
            }
        for (int side = 0; side < sides; ++side) {
            const std::uint32_t a = first + 2 * static_cast<std::uint32_t>(side);
            if (from.radius > 0) triangle(a, a + 2, a + 1);
            if (to.radius > 0) triangle(a + 2, a + 3, a + 1);
        }
    }

    /// A profile of (place on the axis, radius) turned about the axis cross(u, v) through `origin`.
    void turn(const Hoop& origin, std::span<const glm::vec2> profile, int sides, Albedo albedo) {
        const glm::vec3 axis = glm::cross(origin.u, origin.v);
        for (std::size_t i = 0; i + 1 < profile.size(); ++i) {
            const glm::vec2 step = profile[i + 1] - profile[i];
            // An infinite lean is a flat end.
            const float lean = step.x > 0 ? -step.y / step.x : step.y < 0 ? 1e6F : -1e6F;
            const auto hoop = [&](const glm::vec2& p) {
                return Hoop{origin.centre + p.x * axis, origin.u, origin.v, p.y};
            };
            band(hoop(profile[i]), hoop(profile[i + 1]), sides, lean, albedo);
        }
    }

    void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        for (const std::uint32_t v : {a, b, c}) scene_.indices.push_back(v);
    }

    void quad(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const glm::vec3& d, Albedo albedo) {
        const glm::vec3 normal = glm::normalize(glm::cross(c - a, d - b));
        const auto first = static_cast<std::uint32_t>(scene_.positions.size());
        for (const glm::vec3& corner : {a, b, c, d}) add(corner, normal, normal, 0, albedo);
        triangle(first, first + 1, first + 2);
        triangle(first, first + 2, first + 3);
    }

    /// 12 triangles.
    void box(const glm::vec3& lo, const glm::vec3& hi, Albedo albedo) {
        for (int axis = 0; axis < 3; ++axis)
            for (const bool is_high : {false, true}) {
                const int u = (axis + 1) % 3;
                const int v = (axis + 2) % 3;
                glm::vec3 corners[4];
                for (int c = 0; c < 4; ++c) {
                    corners[c][axis] = is_high ? hi[axis] : lo[axis];
                    corners[c][u] = c == 1 || c == 2 ? hi[u] : lo[u];
                    corners[c][v] = c >= 2 ? hi[v] : lo[v];
                }
                if (!is_high) std::swap(corners[1], corners[3]);
                quad(corners[0], corners[1], corners[2], corners[3], albedo);
            }
    }

    /// The mesh so far.
    Object done() const {
        Object mesh;
        mesh.first_index = first_index_;
        mesh.first_vertex = first_vertex_;
        mesh.index_count = static_cast<std::uint32_t>(scene_.indices.size()) - first_index_;
        mesh.vertex_count = static_cast<std::uint32_t>(scene_.positions.size()) - first_vertex_;
        mesh.box = placed_box(scene_, mesh, glm::mat4(1));
        return mesh;
    }

  private:
    void add(const glm::vec3& place, const glm::vec3& radial, const glm::vec3& axis, float lean,
             Albedo albedo) {
        const glm::vec3 normal = glm::normalize(radial + lean * axis);
        const glm::vec3 light = glm::clamp(albedo * baked_light(place, normal), 0.0F, 1.0F);
        scene_.positions.push_back(place);
        scene_.colours.emplace_back(glm::u8vec3(light * 255.0F + 0.5F), 255);
    }

    Scene& scene_;
    std::uint32_t first_index_;
    std::uint32_t first_vertex_;
};

constexpr int kPipeSides[kGauges] = {8, 10, 12, 14};
constexpr int kPipeBands[kGauges] = {4, 5, 6, 5};
const Hoop kAlongX{{0, 0, 0}, {0, 1, 0}, {0, 0, 1}, 0};
const Hoop kUp{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 0};

/// A flange, `bands` bands around the insulation, a flange: 2 * sides * (7 + 4 * bands) triangles.
void add_pipe(Lathe& lathe, int gauge) {
    const float r = radius_of(gauge);
    const int bands = kPipeBands[gauge];
    std::vector<glm::vec2> profile{{0, r}, {0, 1.35F * r}, {0.06F, 1.35F * r}, {0.06F, r}};
    for (int b = 1; b <= bands; ++b) {
        const float x = kBayMetres * static_cast<float>(b) / static_cast<float>(bands + 1);
        for (const glm::vec2& p : {glm::vec2(x - 0.03F, r), glm::vec2(x - 0.03F, 1.08F * r),
                                   glm::vec2(x + 0.03F, 1.08F * r), glm::vec2(x + 0.03F, r)})
            profile.push_back(p);
    }
    for (const glm::vec2& p : {glm::vec2(kBayMetres - 0.06F, r), glm::vec2(kBayMetres - 0.06F, 1.35F * r),
                               glm::vec2(kBayMetres, 1.35F * r), glm::vec2(kBayMetres, r)})
        profile.push_back(p);
    lathe.turn(kAlongX, profile, kPipeSides[gauge], kGaugePaint[gauge]);
}

/// A bend about (0, `bend`) in the plane of x and z, starting along +x at the origin, a quarter turn up.
void add_bend(Lathe& lathe, float bend, float radius, int sides, int steps, Albedo albedo) {
    const auto hoop = [&](int step) {
        const glm::vec2 c = on_circle(step, 4 * steps);  // cosine and sine of the turn so far
        return Hoop{{bend * c.y, 0, bend * (1 - c.x)}, {0, 1, 0}, {-c.y, 0, c.x}, radius};
    };
    for (int step = 0; step < steps; ++step) lathe.band(hoop(step), hoop(step + 1), sides, 0, albedo);
}

void add_wheel(Lathe& lathe, const glm::vec3& hub, float radius, Albedo albedo) {
    constexpr int kSteps = 12;
    const auto hoop = [&](int step) {
        const glm::vec2 c = on_circle(step, kSteps);
        return Hoop{hub + radius * glm::vec3(c, 0), {c, 0}, {0, 0, 1}, 0.1F * radius};
    };
    for (int step = 0; step < kSteps; ++step) lathe.band(hoop(step + 1), hoop(step), 5, 0, albedo);
}

Object build_valve(Scene& scene, int gauge) {
    Lathe lathe(scene);
    add_pipe(lathe, gauge);
    const float r = radius_of(gauge);
    const float x = kBayMetres / 2 + 0.4F;
    const glm::vec2 body[] = {{x - 2.5F * r, r},        {x - 2.5F * r, 1.6F * r}, {x - 2 * r, 1.6F * r},
                              {x - r, 1.9F * r},        {x + r, 1.9F * r},        {x + 2 * r, 1.6F * r},
                              {x + 2.5F * r, 1.6F * r}, {x + 2.5F * r, r}};
    lathe.turn(kAlongX, body, kPipeSides[gauge], kGreen);
    const glm::vec2 stem[] = {
        {r, 0.5F * r}, {2.4F * r, 0.5F * r}, {2.4F * r, 0.2F * r}, {3.6F * r, 0.2F * r}};
    lathe.turn({{x, 0, 0}, {1, 0, 0}, {0, 1, 0}, 0}, stem, 6, kSteel);
    add_wheel(lathe, {x, 0, 3.5F * r}, 1.2F * r, kSafety);
    return lathe.done();
}

Object build_elbow(Scene& scene, int gauge) {
    Lathe lathe(scene);
    const float r = radius_of(gauge);
    add_bend(lathe, 2.5F * r, r, kPipeSides[gauge], 7, kGaugePaint[gauge]);
    const Hoop end{{2.5F * r, 0, 2.5F * r}, {1, 0, 0}, {0, 1, 0}, 0};
    const glm::vec2 flange[] = {{0, r}, {0, 1.35F * r}, {0.06F, 1.35F * r}, {0.06F, r}, {1.2F, r}, {1.2F, 0}};
    lathe.turn(end, flange, kPipeSides[gauge], kGaugePaint[gauge]);
    return lathe.done();
}

Object build_tank(Scene& scene) {
    Lathe lathe(scene);
    std::vector<glm::vec2> profile{{0.3F, 0.4F}, {0.3F, 0.9F}, {0.5F, 1.2F}};
    for (int ring = 0; ring < 5; ++ring) {
        const float z = 0.7F + 0.7F * static_cast<float>(ring);
        for (const glm::vec2& p :
             {glm::vec2(z, 1.2F), glm::vec2(z, 1.3F), glm::vec2(z + 0.1F, 1.3F), glm::vec2(z + 0.1F, 1.2F)})
            profile.push_back(p);
    }
    for (const glm::vec2& p :
         {glm::vec2(3.9F, 1.2F), glm::vec2(4.2F, 0.9F), glm::vec2(4.4F, 0.4F), glm::vec2(4.4F, 0)})
        profile.push_back(p);
    lathe.turn(kUp, profile, 16, kGaugePaint[2]);
    for (const glm::vec2& foot :
         {glm::vec2(0.7F, 0.7F), glm::vec2(-0.7F, 0.7F), glm::vec2(-0.7F, -0.7F), glm::vec2(0.7F, -0.7F)})
        lathe.box({foot - 0.08F, 0}, {foot + 0.08F, 0.6F}, kSteel);
    return lathe.done();
}

Object build_pump(Scene& scene) {
    Lathe lathe(scene);
    lathe.box({0, -0.45F, 0}, {2.2F, 0.45F, 0.2F}, kConcrete);
    const Hoop axle{{0, 0, 0.65F}, {0, 1, 0}, {0, 0, 1}, 0};
    std::vector<glm::vec2> motor{{0.1F, 0}, {0.1F, 0.36F}};
    for (int fin = 0; fin < 8; ++fin) {
        const float x = 0.15F + 0.1F * static_cast<float>(fin);
        for (const glm::vec2& p : {glm::vec2(x, 0.36F), glm::vec2(x, 0.42F), glm::vec2(x + 0.04F, 0.42F),
                                   glm::vec2(x + 0.04F, 0.36F)})
            motor.push_back(p);
    }
    for (const glm::vec2& p :
         {glm::vec2(1, 0.36F), glm::vec2(1, 0.1F), glm::vec2(1.4F, 0.1F), glm::vec2(1.4F, 0.44F),
          glm::vec2(1.9F, 0.44F), glm::vec2(1.9F, 0.2F), glm::vec2(2.2F, 0.2F), glm::vec2(2.2F, 0)})
        motor.push_back(p);
    lathe.turn(axle, motor, 12, kGreen);
    return lathe.done();
}

}  // namespace

Parts build_parts(Scene& scene) {
    Parts parts;
    for (int gauge = 0; gauge < kGauges; ++gauge) {
        Lathe pipe(scene);
        add_pipe(pipe, gauge);
        parts.pipes[gauge] = pipe.done();
        parts.valves[gauge] = build_valve(scene, gauge);
        parts.elbows[gauge] = build_elbow(scene, gauge);
    }
    parts.tank = build_tank(scene);
    parts.pump = build_pump(scene);
    {
        Lathe column(scene);
        column.box({-0.15F, -0.15F, 0}, {0.15F, -0.12F, kFloorMetres}, kSteel);
        column.box({-0.15F, 0.12F, 0}, {0.15F, 0.15F, kFloorMetres}, kSteel);
        column.box({-0.02F, -0.12F, 0}, {0.02F, 0.12F, kFloorMetres}, kSteel);
        column.box({-0.22F, -0.22F, 0}, {0.22F, 0.22F, 0.03F}, kSteel);
        parts.column = column.done();
    }
    {
        Lathe beam(scene);
        beam.box({0, -0.12F, -0.40F}, {kBayMetres, 0.12F, -0.37F}, kSteel);
        beam.box({0, -0.12F, -0.23F}, {kBayMetres, 0.12F, -0.20F}, kSteel);
        beam.box({0, -0.015F, -0.37F}, {kBayMetres, 0.015F, -0.23F}, kSteel);
        parts.beam = beam.done();
    }
    {
        Lathe slab(scene);
        slab.box({0, 0, -0.2F}, {kBayMetres, kBayMetres, 0}, kConcrete);
        parts.slab = slab.done();
    }
    {
        Lathe cladding(scene);
        constexpr int kFolds = 10;
        constexpr float kFoldMetres = kCladdingMetres / kFolds;
        for (int fold = 0; fold < kFolds; ++fold) {
            const float x = kFoldMetres * static_cast<float>(fold);
            const float edges[] = {x, x + 0.10F, x + 0.15F, x + 0.25F, x + kFoldMetres};
            const float depths[] = {0, 0, -0.05F, -0.05F, 0};
            for (int e = 0; e < 4; ++e)
                cladding.quad({edges[e], depths[e], 0}, {edges[e + 1], depths[e + 1], 0},
                              {edges[e + 1], depths[e + 1], kFloorMetres},
                              {edges[e], depths[e], kFloorMetres}, kCladding);
        }
        parts.cladding = cladding.done();
    }
    {
        Lathe rail(scene);
        for (const float z : {0.5F, 1.0F}) {
            const glm::vec2 bar[] = {{0, 0.025F}, {kBayMetres, 0.025F}};
            rail.turn({{0, 0, z}, {0, 1, 0}, {0, 0, 1}, 0}, bar, 6, kSafety);
        }
        for (int post = 0; post < 4; ++post) {
            const glm::vec2 bar[] = {{0, 0.025F}, {1, 0.025F}};
            rail.turn({{0.75F + 1.5F * static_cast<float>(post), 0, 0}, {1, 0, 0}, {0, 1, 0}, 0}, bar, 6,
                      kSafety);
        }
        parts.rail = rail.done();
    }
    {
        Lathe chimney(scene);
        std::vector<glm::vec2> profile;
        for (int ring = 0; ring <= 20; ++ring) {
            const float z = 3 * static_cast<float>(ring);
            profile.emplace_back(z, 3 - 0.02F * z);
        }
        chimney.turn(kUp, profile, 24, kBrick);
        parts.chimney = chimney.done();
    }
    {
        Lathe ground(scene);
        ground.quad({0, 0, 0}, {12, 0, 0}, {12, 12, 0}, {0, 12, 0}, kGravel);
        parts.ground = ground.done();
    }
    return parts;
}

Object build_scrap(Scene& scene, std::uint32_t triangles) {
    Lathe lathe(scene);
    add_pipe(lathe, 0);
    Object scrap = lathe.done();
    scrap.index_count = std::min(scrap.index_count, 3 * triangles);
    scene.indices.resize(scrap.first_index + scrap.index_count);
    return scrap;
}

std::uint32_t most_scrap(const Parts& parts) {
    return parts.pipes[0].triangle_count();
}

}  // namespace apps::plant
