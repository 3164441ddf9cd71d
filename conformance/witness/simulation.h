// SPDX-License-Identifier: MIT
// Stencil and depth test of known fragments by hand, and the registers that follow: what the unit has to
// tell.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "witness/fragments.h"
#include "witness/pipelines.h"
#include "witness/targets.h"

namespace conformance {

struct Registers {
    std::uint64_t projected_hits = 0;
    std::uint64_t visible_hits = 0;
    float nearest_depth = 1.0f;
    std::array<int, 4> box = {0, 0, -1, -1};  // left, bottom, right, top, inclusive
};

class Simulation {
  public:
    Simulation(const Target& target, Buffers initial, GLenum far_end);

    void draw(const std::vector<FragmentLayer>& fragments, const Pipeline& pipeline,
              const Settings& settings);

    const Registers& registers() const { return registers_; }
    const Buffers& buffers() const { return buffers_; }

  private:
    void step(std::size_t sample, float depth, std::size_t side, const Pipeline& pipeline, GLint reference);
    void see(std::size_t sample, float depth);

    const Target& target_;
    Buffers buffers_;
    GLenum far_end_;
    Registers registers_;
};

}  // namespace conformance
