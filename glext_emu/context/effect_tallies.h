// SPDX-License-Identifier: MIT
// Which effects of the device's time a program called for: each has a predicate over what was counted, a
// reason in a sentence and the time that it took. Where the predicate is false, switching the effect off
// changes the time by less than a hundredth, and no bit of a result.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "occlusion_unit/timeline.h"

namespace glext_emu {

struct Context;

struct EffectTally {
    occlusion_unit::Effect effect;
    bool is_on = true;
    std::optional<bool> is_called_for;  // none: it was off, and what it would have taken was not counted
    std::string reason;
    std::optional<occlusion_unit::Picoseconds> time;  // none: it is not one of time
};

// Of <ctx> so far, which runs under the device's clock; in the order of Effect.
std::vector<EffectTally> tally_effects(const Context& ctx);

}  // namespace glext_emu
