// SPDX-License-Identifier: MIT
// For how many frames a leaf that was found visible is assumed to stay so.
//
// J. Bittner, M. Wimmer, H. Piringer, W. Purgathofer, Coherent Hierarchical Culling, 2004, section 5.1: "In
// the simplest case, the number of frames a node is assumed visible can be a predefined constant. In a more
// complicated scenario this number should be influenced by the history of the success of occlusion queries
// and/or the current speed of camera movement." The rules of the complicated scenario are ours, but for
// randomising: O. Mattausch, J. Bittner, M. Wimmer, CHC++, 2008, section 5.3.
#pragma once

#include "apps/culling/chc_memory.h"

namespace apps {

enum class PatienceRule : std::uint8_t {
    kConstant,  // always so many frames
    kRandom,    // the first time any number up to that, so that leaves seen together are not asked together
    kHistory,   // none, 1, 3, 7 ...: after n visible answers in a row 2^(n-1) - 1, at most so many
    kSpeed,     // until the eye has moved the leaf by kParallaxPixels against what is far, at most so many
    kRandomHistory,  // kHistory, but any number from that to the next of the row, 2^n - 2
};

class Patience {
  public:
    static constexpr float kParallaxPixels = 16;

    Patience(std::uint32_t frames, PatienceRule rule) : frames_(frames), rule_(rule) {}

    void start_frame(const View& view);
    void forget() { has_eye_ = false; }

    /// Frames to skip after an answer, the `visible_answers`-th in a row.
    std::uint32_t frames(PartId part, const Box& box, std::uint32_t visible_answers,
                         std::uint32_t frame) const;

  private:
    std::uint32_t frames_;
    PatienceRule rule_;
    glm::vec3 eye_{0};
    bool has_eye_ = false;
    float step_metres_ = 0;  // of the eye since the last frame
    double pixel_slope_ = 0;
};

}  // namespace apps
