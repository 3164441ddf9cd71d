// SPDX-License-Identifier: MIT
// A scene: a target, what stands in it, and the draws that a query is asked about. All of it follows from a
// seed.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "witness/draws.h"
#include "witness/random.h"
#include "witness/targets.h"

namespace conformance {

class Scene {
  public:
    explicit Scene(std::uint64_t seed);

    Target& target() { return target_; }
    GLenum far_end() const { return far_end_; }
    const std::vector<Draw>& draws() const { return draws_; }

    // The target cleared, the background drawn; the state is neutral, but for matrices and viewport.
    void start() const;
    // A draw of the scene, with its state.
    void play(const Draw& draw) const;
    void play_all() const;

    // Whether the extension's text lets a register be undetermined here.
    bool may_leave_nearest_depth() const;
    bool may_leave_projected_hits() const;
    bool may_leave_marks() const;  // nearest depth and screen box

    std::string description() const;

  private:
    struct Shape {
        std::vector<Vertex> corners;  // a triangle or a quad
        int layer;
        GLint stencil;
    };

    void add_background(Random& random);

    Random random_;
    int kind_;
    Target target_;
    GLenum far_end_ = GL_ONE;
    float cleared_depth_ = 1.0f;
    std::vector<Shape> background_;
    std::vector<Draw> draws_;
};

// Prints what the failed test played, and how to play it again.
void tell_recipe(const Scene& scene);

}  // namespace conformance
