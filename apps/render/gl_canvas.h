// SPDX-License-Identifier: MIT
// The canvas of a culler on real GL: a Renderer that draws and an OcclusionTest that answers, with what they
// cost.
#pragma once

#include "apps/culling/culler.h"
#include "apps/query/occlusion_test.h"
#include "apps/render/renderer.h"

namespace apps {

struct Counters {
    std::uint64_t queries = 0;
    std::uint64_t results_waited = 0;
    std::uint64_t pixels_read = 0;   // of a depth buffer
    std::uint64_t tiles_tested = 0;  // of a grid of occlusion
    double stall_ms = 0;             // in the blocking fetch of answers, and nowhere else
};

class GlCanvas final : public Canvas {
  public:
    /// `test` may be null for a culler that never asks.
    GlCanvas(Renderer& renderer, OcclusionTest* test) : renderer_(renderer), test_(test) {}

    void draw(std::span<const ObjectId> objects) override { renderer_.draw(objects); }
    bool is_visible(const Box& proxy) override;

    const Counters& counters() const { return counters_; }

  private:
    Renderer& renderer_;
    OcclusionTest* test_;
    Counters counters_;
};

}  // namespace apps
