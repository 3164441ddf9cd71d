// SPDX-License-Identifier: MIT
// Deferred: objects are drawn in the colour of their number, then in those of their vertices' numbers; flat
// shading shows the last vertex of a triangle. Of the triangles that end with it the pixel's ray tells which.
// One ray to a point of the sun's disc, one into the sky above the surface.
#include "apps/walkthrough/lighting.h"

#include <array>
#include <bit>
#include <cmath>
#include <numbers>
#include <numeric>
#include <thread>

#include "apps/scene/light.h"
#include "apps/scene/random.h"

namespace apps {
namespace {

constexpr float kSkyReachMetres = 18;  // what is farther away hides little of the sky
constexpr float kSunReachMetres = 400;
constexpr float kSunRadius = 0.012F;  // softer than the real one, 0.0047
constexpr float kSunGain = 1.25F;     // against the baked light, which knows no shadow
constexpr float kSkyGain = 1.0F;
constexpr float kElsewhere = 0.30F;  // light that other surfaces throw back
constexpr int kSmooth = 3;  // pixels around, of the same orientation, that share their rays into the sky
constexpr float kSameOrientation = 0.9999F;  // cosine between normals
constexpr float kLiftMetres = 2e-3F;         // off the surface, before a ray starts

glm::vec3 sky_colour(const glm::vec3& direction) {
    const float up = std::clamp(direction.z * 1.8F, 0.0F, 1.0F);
    return glm::mix(glm::vec3(0.84F, 0.90F, 0.95F), glm::vec3(0.40F, 0.60F, 0.87F), up * (2 - up));
}

/// Rows in turn to as many threads as the machine has.
template <class Work>
void each_row(int height, Work&& work) {
    const auto count = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
    std::vector<std::jthread> threads;
    for (int first = 0; first < count; ++first)
        threads.emplace_back([&, first] {
            for (int y = first; y < height; y += count) work(y);
        });
}

/// Around `normal`, as a matt surface gathers light: more from above it than from its sides.
glm::vec3 cosine_direction(const glm::vec3& normal, Random& random) {
    const float turn = 2 * std::numbers::pi_v<float> * random.unit();
    const float z = 2 * random.unit() - 1;
    const float r = std::sqrt(std::max(0.0F, 1 - z * z));
    return glm::normalize(normal * 1.001F + glm::vec3(r * std::cos(turn), r * std::sin(turn), z));
}

using Corners = std::array<glm::dvec3, 3>;  // in the space of the mesh

Corners corners_of(const Scene& scene, std::uint32_t first_index) {
    Corners corners;
    for (std::uint32_t c = 0; c < 3; ++c) corners[c] = scene.positions[scene.indices[first_index + c]];
    return corners;
}

/// Up for a triangle without an area.
glm::dvec3 normal_of(const Corners& corners) {
    const glm::dvec3 cross = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    const double length = glm::length(cross);
    return length > 0 ? cross / length : glm::dvec3(0, 0, 1);
}

/// Metres by which a point of its plane lies outside a triangle.
double miss_of(const Corners& corners, const glm::dvec3& normal, const glm::dvec3& point) {
    double most = 0;
    for (std::size_t c = 0; c < 3; ++c) {
        const glm::dvec3 edge = corners[(c + 1) % 3] - corners[c];
        const double length = glm::length(edge);
        if (length > 0)
            most = std::max(most, -glm::dot(glm::cross(normal, edge), point - corners[c]) / length);
    }
    return most;
}

}  // namespace

Lighting::Lighting(Renderer& renderer, const Scene& scene, const Tree& tree)
    : renderer_(renderer), scene_(scene), rays_(scene, tree), starts_(scene.positions.size() + 1, 0) {
    std::vector<glm::u8vec4> numbers(scene.positions.size());
    for (std::uint32_t v = 0; v < numbers.size(); ++v) numbers[v] = std::bit_cast<glm::u8vec4>(v + 1);
    vertex_paint_ = renderer.add_paint(std::move(numbers));
    owner_paint_ = renderer.add_owner_paint();
    for (std::size_t i = 2; i < scene.indices.size(); i += 3) ++starts_[scene.indices[i] + 1];
    std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
    triangles_.resize(scene.indices.size() / 3);
    std::vector<std::uint32_t> next(starts_.begin(), starts_.end() - 1);
    for (std::size_t i = 2; i < scene.indices.size(); i += 3)
        triangles_[next[scene.indices[i]]++] = static_cast<std::uint32_t>(i - 2);
}

glm::vec3 Lighting::albedo(const Lit& pixel) const {
    const std::uint32_t last = scene_.indices[pixel.triangle + 2];
    const glm::vec3 baked = glm::vec3(scene_.colours[last]) / 255.0F;
    const glm::vec3 normal(normal_of(corners_of(scene_, pixel.triangle)));
    return baked / baked_light(scene_.positions[last], normal);
}

/// Where the ray of a pixel meets the surface whose last vertex was seen there.
void Lighting::locate(const glm::dvec3& origin, const glm::dvec3& direction, std::uint32_t last_vertex,
                      Lit& pixel) const {
    const glm::dmat4 placement(scene_.placements[scene_.objects[pixel.object].placement]);
    const glm::dmat3 back = glm::transpose(glm::dmat3(placement));
    const glm::dvec3 from = back * (origin - glm::dvec3(placement[3]));
    const glm::dvec3 along = back * direction;
    double least_miss = std::numeric_limits<double>::infinity();
    pixel.triangle = triangles_.at(starts_[last_vertex]);
    for (std::uint32_t t = starts_[last_vertex]; t < starts_[last_vertex + 1]; ++t) {
        const Corners corners = corners_of(scene_, triangles_[t]);
        const glm::dvec3 normal = normal_of(corners);
        const double slope = glm::dot(normal, along);
        const double distance =
            std::abs(slope) > 1e-9 ? std::max(0.0, glm::dot(normal, corners[0] - from) / slope) : 0;
        const double miss = miss_of(corners, normal, from + distance * along);
        if (miss >= least_miss) continue;
        least_miss = miss;
        pixel.triangle = triangles_[t];
        pixel.distance = static_cast<float>(distance);
        pixel.normal = glm::vec3(glm::dmat3(placement) * (slope > 0 ? -normal : normal));
    }
}

void Lighting::light_row(const Eye& eye, int width, int height, int y, unsigned pass,
                         std::vector<Lit>& pixels) const {
    const glm::dmat4 to_world = glm::inverse(glm::dmat4(eye.projection) * glm::dmat4(eye.modelview));
    for (int x = 0; x < width; ++x) {
        const auto at =
            static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
        Lit& pixel = pixels[at];
        const glm::dvec2 ndc = 2.0 * (glm::dvec2(x, y) + 0.5) / glm::dvec2(width, height) - 1.0;
        const glm::dvec4 near = to_world * glm::dvec4(ndc, -1, 1);
        const glm::dvec4 far = to_world * glm::dvec4(ndc, 1, 1);
        const glm::dvec3 origin = glm::dvec3(near) / near.w;
        const glm::dvec3 direction = glm::normalize(glm::dvec3(far) / far.w - origin);
        if (pixel.is_sky()) {
            pixel.light = sky_colour(glm::vec3(direction));
            continue;
        }
        locate(origin, direction, pixel.triangle, pixel);

        Random random(Random(at * 64 + pass).next());
        const glm::vec3 start =
            glm::vec3(origin + direction * static_cast<double>(pixel.distance)) + kLiftMetres * pixel.normal;
        const glm::vec3 sun = sunlight(pixel.normal);
        const glm::vec3 towards =
            glm::normalize(kTowardsSun + kSunRadius * cosine_direction(kTowardsSun, random));
        if (sun.x > 0 && !rays_.is_blocked({start, towards, kSunReachMetres})) pixel.light += kSunGain * sun;
        const glm::vec3 up = cosine_direction(pixel.normal, random);
        pixel.open_sky = !rays_.is_blocked({start, up, kSkyReachMetres});
    }
}

void Lighting::add_sky_row(int width, int height, int y, std::vector<Lit>& pixels) const {
    const auto at = [&](int column, int row) {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
               static_cast<std::size_t>(column);
    };
    for (int x = 0; x < width; ++x) {
        Lit& pixel = pixels[at(x, y)];
        if (pixel.is_sky()) continue;
        float sum = 0;
        float count = 0;
        for (int row = std::max(0, y - kSmooth); row <= std::min(height - 1, y + kSmooth); ++row)
            for (int column = std::max(0, x - kSmooth); column <= std::min(width - 1, x + kSmooth);
                 ++column) {
                const Lit& other = pixels[at(column, row)];
                if (other.is_sky() || glm::dot(other.normal, pixel.normal) < kSameOrientation) continue;
                if (std::abs(other.distance - pixel.distance) > 0.3F + 0.05F * pixel.distance) continue;
                sum += other.open_sky;
                count += 1;
            }
        pixel.light += (kElsewhere + kSkyGain * sum / count) * skylight(pixel.normal);
    }
}

std::vector<std::uint32_t> Lighting::numbers_in(Renderer::Paint paint, const Eye& eye, int width, int height,
                                                std::span<const ObjectId> objects) {
    renderer_.use_paint(paint, true);
    renderer_.set_matrices(eye.modelview, eye.projection, width, height);
    renderer_.clear({0, 0, 0, 0});
    renderer_.draw(objects);
    std::vector<std::uint32_t> numbers = renderer_.read_pixels();
    renderer_.use_paint(Renderer::kBaked, false);
    return numbers;
}

std::vector<Lit> Lighting::light(const Eye& eye, int width, int height, std::span<const ObjectId> objects,
                                 unsigned pass) {
    const std::vector<std::uint32_t> owners = numbers_in(owner_paint_, eye, width, height, objects);
    const std::vector<std::uint32_t> vertices = numbers_in(vertex_paint_, eye, width, height, objects);
    std::vector<Lit> pixels(owners.size());
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        if (owners[i] == 0) continue;  // the background
        pixels[i].object = owners[i] - 1;
        pixels[i].triangle = vertices[i] - 1;  // its last vertex, until the ray tells which it is
    }
    each_row(height, [&](int y) { light_row(eye, width, height, y, pass, pixels); });
    each_row(height, [&](int y) { add_sky_row(width, height, y, pixels); });
    return pixels;
}

}  // namespace apps
