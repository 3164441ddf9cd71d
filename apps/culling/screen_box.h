// SPDX-License-Identifier: MIT
// Where on the screen, and between which depths, a box can leave samples: what the methods that look at the
// depth buffer know of a box. Depth is counted in steps of the buffer and by the buffer's own function, so
// that of two boxes whose ranges do not meet, whatever is drawn of the nearer one is nearer in the buffer.
#pragma once

#include <cstdint>

#include "apps/culling/canvas.h"
#include "apps/culling/view.h"

namespace apps {

/// Steps of a 24 bit depth buffer, 0 near; kFarStep is what a clear leaves.
using DepthSteps = std::int32_t;
inline constexpr DepthSteps kFarStep = (1 << 24) - 1;

/// By how many steps a box's range is longer than its corners say, at each end: two triangulations of one
/// plane differ by up to 4.
inline constexpr DepthSteps kDepthMarginSteps = 4;

struct ScreenBox {
    bool is_known = false;  // else it may show anywhere and at any depth from znear on: take it as visible
    Rectangle pixels;       // clipped to the view; no pixels where it can leave no sample
    DepthSteps znear = 0;
    DepthSteps zfar = kFarStep;

    /// Whether a pixel with something at `furthest` hides it there.
    bool is_behind(DepthSteps furthest) const { return furthest < znear; }
};

/// Rounded outwards to whole pixels and steps, with margins for what rasterisation snaps and what float
/// matrices lose on large coordinates. Not known where the near plane cuts the box or a corner is not a
/// number; zfar holds even then, unless it is not a number.
ScreenBox screen_box(const View& view, const Box& box);

/// The step that GL told as a float, 0 near to 1 far; exactly, of a 24 bit buffer. What is not a number is
/// far.
DepthSteps steps_of(float depth);

}  // namespace apps
