// SPDX-License-Identifier: MIT
// Arithmetic of the papers' frames: amounts in parts that add up, and milliseconds of a timeline.
#pragma once

#include <cmath>
#include <cstdint>

#include "occlusion_unit/profile.h"

namespace papers {

constexpr double kPicosecondsPerMillisecond = 1e9;

inline std::uint64_t rounded(double amount) {
    return static_cast<std::uint64_t>(std::llround(amount));
}
inline occlusion_unit::Picoseconds picoseconds(double milliseconds) {
    return std::llround(milliseconds * kPicosecondsPerMillisecond);
}
inline double milliseconds(occlusion_unit::Picoseconds span) {
    return static_cast<double>(span) / kPicosecondsPerMillisecond;
}

// The <index>th of <parts> parts of <whole>, from 0; they differ by one at most, and add up to it.
constexpr std::uint64_t part(std::uint64_t whole, std::uint64_t index, std::uint64_t parts) {
    return whole * (index + 1) / parts - whole * index / parts;
}

}  // namespace papers
