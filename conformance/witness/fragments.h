// SPDX-License-Identifier: MIT
// Every fragment of a draw, as the driver makes it, taken apart by reading depth and stencil back.
//
// Fragments here are those that reach the stencil test: what scissor, coverage, alpha test and shaders
// discard is gone.
#pragma once

#include <cstdint>
#include <vector>

#include "witness/scene.h"

namespace conformance {

// The k-th fragment of every sample that has so many, in the order in which they were drawn.
struct FragmentLayer {
    std::vector<std::uint8_t> is_there;
    std::vector<std::uint8_t> is_front;  // facing; pixels, points and lines do
    std::vector<float> depth;            // as the target's format holds it
};

// Leaves the target's contents lost.
std::vector<FragmentLayer> fragments_of(Scene& scene, const Draw& draw);

}  // namespace conformance
