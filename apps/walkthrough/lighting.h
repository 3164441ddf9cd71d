// SPDX-License-Identifier: MIT
// Sun, shadow and sky for pictures: GL says which surface each pixel shows, rays say what light falls on it.
#pragma once

#include "apps/culling/culler.h"
#include "apps/hierarchy/ray.h"
#include "apps/render/renderer.h"

namespace apps {

/// Matrices of a picture; perspective or orthographic.
struct Eye {
    glm::mat4 modelview;
    glm::mat4 projection;
};

/// One pixel of a picture before its colours.
struct Lit {
    static constexpr std::uint32_t kSky = ~0U;
    ObjectId object = kSky;      // what is seen
    std::uint32_t triangle = 0;  // of it: the first of its indices in Scene::indices
    float distance = 0;          // metres from the near plane
    float open_sky = 0;          // share of the sky above the surface that one ray found
    glm::vec3 normal{0};         // in the world, towards the eye
    glm::vec3 light{0};          // that its albedo is multiplied by; of the sky: its colour

    bool is_sky() const { return object == kSky; }
};

class Lighting {
  public:
    Lighting(Renderer& renderer, const Scene& scene, const Tree& tree);

    /// Draws `objects` and lights every pixel; `pass` chooses the random directions.
    std::vector<Lit> light(const Eye& eye, int width, int height, std::span<const ObjectId> objects,
                           unsigned pass);

    /// The share of light that a surface reflects; of no sky.
    glm::vec3 albedo(const Lit& pixel) const;

  private:
    void light_row(const Eye& eye, int width, int height, int y, unsigned pass,
                   std::vector<Lit>& pixels) const;
    void add_sky_row(int width, int height, int y, std::vector<Lit>& pixels) const;
    std::vector<std::uint32_t> numbers_in(Renderer::Paint paint, const Eye& eye, int width, int height,
                                          std::span<const ObjectId> objects);
    void locate(const glm::dvec3& origin, const glm::dvec3& direction, std::uint32_t last_vertex,
                Lit& pixel) const;

    Renderer& renderer_;
    const Scene& scene_;
    RayCaster rays_;
    Renderer::Paint vertex_paint_;
    Renderer::Paint owner_paint_;
    std::vector<std::uint32_t> starts_;     // by vertex: of those of triangles_ that have it as their last
    std::vector<std::uint32_t> triangles_;  // the first index of each
};

}  // namespace apps
