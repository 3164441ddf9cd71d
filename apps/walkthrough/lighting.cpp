// SPDX-License-Identifier: MIT
// Deferred: a flat paint of vertex numbers is drawn and read back; a pixel's place is where its ray meets the
// plane of that vertex's triangle. One ray to a point of the sun's disc, one into the sky above the surface.
#include "apps/walkthrough/lighting.h"

#include <bit>
#include <cmath>
#include <numbers>
#include <thread>

#include "apps/hierarchy/ray.h"
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
constexpr float kLiftMetres = 2e-3F;  // off the surface, before a ray starts

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

}  // namespace

Lighting::Lighting(Renderer& renderer, const Scene& scene, const Tree& tree)
    : renderer_(renderer), scene_(scene), tree_(tree), normals_(scene.positions.size(), glm::vec3(0, 0, 1)) {
    std::vector<glm::u8vec4> numbers;
    for (std::uint32_t v = 0; v < scene.positions.size(); ++v)
        numbers.push_back(std::bit_cast<glm::u8vec4>(v + 1));
    vertex_paint_ = renderer.add_paint(std::move(numbers));
    for (std::size_t i = 0; i + 2 < scene.indices.size(); i += 3) {
        const glm::vec3& a = scene.positions[scene.indices[i]];
        const glm::vec3 cross =
            glm::cross(scene.positions[scene.indices[i + 1]] - a, scene.positions[scene.indices[i + 2]] - a);
        const float length = glm::length(cross);
        for (std::size_t c = i; length > 0 && c < i + 3; ++c) normals_[scene.indices[c]] = cross / length;
    }
}

glm::vec3 Lighting::albedo(std::uint32_t vertex) const {
    const glm::vec3 baked = glm::vec3(scene_.colours[vertex]) / 255.0F;
    return baked / baked_light(scene_.positions[vertex], normals_[vertex]);
}

glm::vec3 Lighting::normal_of(const Lit& pixel) const {
    return pixel.is_back ? -normals_[pixel.vertex] : normals_[pixel.vertex];
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
        if (pixel.vertex == Lit::kSky) {
            pixel.light = sky_colour(glm::vec3(direction));
            continue;
        }
        const glm::dvec3 plane(normals_[pixel.vertex]);
        const double slope = glm::dot(plane, direction);
        const double height_above = glm::dot(plane, glm::dvec3(scene_.positions[pixel.vertex]) - origin);
        pixel.is_back = slope > 0;
        if (std::abs(slope) > 1e-9) pixel.distance = static_cast<float>(std::max(0.0, height_above / slope));

        Random random(Random(at * 64 + pass).next());
        const glm::vec3 normal = normal_of(pixel);
        const glm::vec3 start =
            glm::vec3(origin + direction * static_cast<double>(pixel.distance)) + kLiftMetres * normal;
        const glm::vec3 sun = sunlight(normal);
        const glm::vec3 towards =
            glm::normalize(kTowardsSun + kSunRadius * cosine_direction(kTowardsSun, random));
        if (sun.x > 0 && !is_blocked(scene_, tree_, start, towards, kSunReachMetres))
            pixel.light += kSunGain * sun;
        pixel.open_sky = !is_blocked(scene_, tree_, start, cosine_direction(normal, random), kSkyReachMetres);
    }
}

void Lighting::add_sky_row(int width, int height, int y, std::vector<Lit>& pixels) const {
    const auto at = [&](int column, int row) {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
               static_cast<std::size_t>(column);
    };
    for (int x = 0; x < width; ++x) {
        Lit& pixel = pixels[at(x, y)];
        if (pixel.vertex == Lit::kSky) continue;
        const glm::vec3 normal = normal_of(pixel);
        float sum = 0;
        float count = 0;
        for (int row = std::max(0, y - kSmooth); row <= std::min(height - 1, y + kSmooth); ++row)
            for (int column = std::max(0, x - kSmooth); column <= std::min(width - 1, x + kSmooth);
                 ++column) {
                const Lit& other = pixels[at(column, row)];
                if (other.vertex == Lit::kSky || normal_of(other) != normal) continue;
                if (std::abs(other.distance - pixel.distance) > 0.3F + 0.05F * pixel.distance) continue;
                sum += other.open_sky;
                count += 1;
            }
        pixel.light += (kElsewhere + kSkyGain * sum / count) * skylight(normal);
    }
}

std::vector<Lit> Lighting::light(const Eye& eye, int width, int height, std::span<const ObjectId> objects,
                                 unsigned pass) {
    renderer_.use_paint(vertex_paint_, true);
    renderer_.set_matrices(eye.modelview, eye.projection, width, height);
    renderer_.clear({0, 0, 0, 0});
    renderer_.draw(objects);
    const std::vector<std::uint32_t> numbers = renderer_.read_pixels();
    renderer_.use_paint(Renderer::kBaked, false);

    std::vector<Lit> pixels(numbers.size());
    for (std::size_t i = 0; i < pixels.size(); ++i)
        pixels[i].vertex = numbers[i] - 1;  // 0, the background, is kSky
    each_row(height, [&](int y) { light_row(eye, width, height, y, pass, pixels); });
    each_row(height, [&](int y) { add_sky_row(width, height, y, pixels); });
    return pixels;
}

}  // namespace apps
