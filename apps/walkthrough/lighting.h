// SPDX-License-Identifier: MIT
// Sun, shadow and sky for pictures: GL says which surface each pixel shows, rays say what light falls on it.
#pragma once

#include "apps/culling/culler.h"
#include "apps/render/renderer.h"

namespace apps {

/// Matrices of a picture; perspective or orthographic.
struct Eye {
    glm::mat4 modelview;
    glm::mat4 projection;
};

/// One pixel of a picture before its colours.
struct Lit {
    std::uint32_t vertex = kSky;  // a vertex of the surface that is seen
    float distance = 0;           // metres from the near plane
    bool is_back = false;         // seen against its normal
    float open_sky = 0;           // share of the sky above the surface that one ray found
    glm::vec3 light{0};           // that its albedo is multiplied by; of the sky: its colour
    static constexpr std::uint32_t kSky = ~0U;
};

class Lighting {
  public:
    Lighting(Renderer& renderer, const Scene& scene, const Tree& tree);

    /// Draws `objects` and lights every pixel; `pass` chooses the random directions.
    std::vector<Lit> light(const Eye& eye, int width, int height, std::span<const ObjectId> objects,
                           unsigned pass);

    /// The share of light that the surface of a vertex reflects.
    glm::vec3 albedo(std::uint32_t vertex) const;

  private:
    void light_row(const Eye& eye, int width, int height, int y, unsigned pass,
                   std::vector<Lit>& pixels) const;
    void add_sky_row(int width, int height, int y, std::vector<Lit>& pixels) const;
    glm::vec3 normal_of(const Lit& pixel) const;

    Renderer& renderer_;
    const Scene& scene_;
    const Tree& tree_;
    Renderer::Paint vertex_paint_;
    std::vector<glm::vec3> normals_;  // by vertex
};

}  // namespace apps
