// SPDX-License-Identifier: MIT
// What a machine's registers make of a result: a counter stops at its width, and a depth has as many bits as
// its register. Told apart from the result itself, so that it can be switched off and seen to matter or not.
#pragma once

#include <cstdint>

#include "occlusion_unit/record_arithmetic.h"

namespace glext_emu {

struct Context;

// How many results came by, and how many of them changed.
struct Narrowing {
    std::uint64_t counts = 0;
    std::uint64_t saturated = 0;
    std::uint64_t depths = 0;
    std::uint64_t quantised = 0;
};

// What a counter of <bits> shows of <count>.
std::uint64_t narrowed_count(Context& ctx, std::uint64_t count, int bits);
// What a depth register of <bits> holds of <depth>: the next value towards one or zero that it can hold.
float narrowed_depth(Context& ctx, float depth, int bits, bool towards_one);
// What the device's unit reports of <record>, which is finished.
occlusion_unit::Record narrowed(Context& ctx, occlusion_unit::Record record, occlusion_unit::FarEnd far_end);

}  // namespace glext_emu
