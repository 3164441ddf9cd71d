// SPDX-License-Identifier: MIT
// Figure 1 of Bittner et al., "Coherent Hierarchical Culling" (2004), as commands: seven objects of which the
// fifth is hidden, asked about and drawn one after the other, and in the better order, which draws the fourth
// and the sixth without waiting, since they were visible before.
#pragma once

#include "occlusion_unit/timeline.h"

namespace glext_emu {

// A machine like the paper's in its proportions: a result comes later than a query takes, an object's drawing
// takes longer than both.
occlusion_unit::Profile figure_one_machine();

// Each a frame, which ends with a swap; returns its sums.
occlusion_unit::TimeSums stop_and_wait(occlusion_unit::Timeline& timeline);
occlusion_unit::TimeSums better_order(occlusion_unit::Timeline& timeline);

}  // namespace glext_emu
