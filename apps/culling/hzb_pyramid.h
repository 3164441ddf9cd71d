// SPDX-License-Identifier: MIT
// A pyramid of furthest depths over a copy of the depth buffer, kept by the CPU: N. Greene, M. Kass, G.
// Miller, Hierarchical Z-Buffer Visibility, 1993. A texel of a level covers 2 x 2 of the one below, or what
// there is of them at the edge of an odd level.
#pragma once

#include <span>
#include <vector>

#include "apps/culling/screen_box.h"

namespace apps {

class DepthPyramid {
  public:
    /// All far.
    void clear(int width_pixels, int height_pixels);

    /// Copies a rectangle's depths, as GL tells them, and brings the levels above up to date.
    void put(const Rectangle& rectangle, std::span<const float> depths);

    /// True if every pixel of the rectangle is before the box. Coarse first, refined to pixels where a texel
    /// does not decide.
    bool is_hidden(const ScreenBox& box) const;

    int levels() const { return static_cast<int>(levels_.size()); }

  private:
    struct Level {
        int width, height;
        std::vector<DepthSteps> furthest;
        std::size_t index(int x, int y) const { return static_cast<std::size_t>(y * width + x); }
        DepthSteps& at(int x, int y) { return furthest[index(x, y)]; }
        DepthSteps at(int x, int y) const { return furthest[index(x, y)]; }
    };

    bool is_hidden(const ScreenBox& box, int level, int x, int y) const;

    std::vector<Level> levels_;  // the first has a texel to a pixel, the last has one texel
};

}  // namespace apps
