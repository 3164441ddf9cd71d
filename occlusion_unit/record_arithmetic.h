// SPDX-License-Identifier: MIT
// What can be done with records: the arithmetic by which partial units become one, by which a counter stops
// at its width, and by which a query that was cut into parts is put together. Exact; in any order and any
// grouping the same.
#pragma once

#include <cstdint>

#include "occlusion_unit/record.h"

namespace occlusion_unit {

// Which end of the depth range is far: 1, or 0 where depth is reversed.
enum class FarEnd { kOne, kZero };

constexpr float far_depth(FarEnd end) {
    return end == FarEnd::kOne ? 1.0f : 0.0f;
}
constexpr float near_depth(FarEnd end) {
    return end == FarEnd::kOne ? 0.0f : 1.0f;
}
// Strictly; false where either is no number.
constexpr bool is_nearer(float a, float b, FarEnd end) {
    return end == FarEnd::kOne ? a < b : a > b;
}

constexpr bool is_empty(const Box& box) {
    return box.right < box.left || box.top < box.bottom;
}
// The box of one pixel.
constexpr Box box_of_pixel(std::int32_t x, std::int32_t y) {
    return {x, y, x, y};
}
// The smallest box that holds both; the empty one is always {0, 0, -1, -1}.
Box united(const Box& a, const Box& b);

// a + b, at most the largest that 64 bits hold: a counter never wraps.
constexpr std::uint64_t saturated_sum(std::uint64_t a, std::uint64_t b) {
    return a + b < a ? ~std::uint64_t{0} : a + b;
}
// The largest count that a counter of <bits> (1..64) holds.
constexpr std::uint64_t largest_count(int bits) {
    return ~std::uint64_t{0} >> (64 - bits);
}

// What Begin leaves in the registers that are armed: no hits, the far depth, the empty box.
Record empty_record(std::uint32_t registers, FarEnd end);

// Two parts of one query as one record. Determined is what both have determined. empty_record(kAllRegisters,
// end) changes nothing.
Record merged(const Record& a, const Record& b, FarEnd end);

// The counters stop at the largest value of <bits>; nothing else changes.
Record saturated(Record record, int bits);

// What a fixed-point depth register of <bits> (1..32) holds of <depth>, in [0, 1]: <depth> itself where it is
// one of its values, else the next of them towards one or zero.
float quantised(float depth, int bits, bool towards_one);

// As a record is reported: the flag is set where visible hits were counted, too; what is not among
// record.registers is 0, the box then empty.
Record finished(const Record& record, FarEnd end);

}  // namespace occlusion_unit
