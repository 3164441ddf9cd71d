// SPDX-License-Identifier: MIT
#include "occlusion_unit/record_arithmetic.h"

#include <cmath>

#include <algorithm>

namespace occlusion_unit {

Box united(const Box& a, const Box& b) {
    if (is_empty(a)) return is_empty(b) ? Box{} : b;
    if (is_empty(b)) return a;
    return {std::min(a.left, b.left), std::min(a.bottom, b.bottom), std::max(a.right, b.right),
            std::max(a.top, b.top)};
}

Record empty_record(std::uint32_t registers, FarEnd end) {
    Record record;
    record.registers = registers & kAllRegisters;
    if (registers & kNearestDepth) record.nearest_depth = far_depth(end);
    return record;
}

Record merged(const Record& a, const Record& b, FarEnd end) {
    Record record;
    record.projected_hits = saturated_sum(a.projected_hits, b.projected_hits);
    record.visible_hits = saturated_sum(a.visible_hits, b.visible_hits);
    record.visible = a.visible | b.visible;
    record.nearest_depth =
        is_nearer(b.nearest_depth, a.nearest_depth, end) ? b.nearest_depth : a.nearest_depth;
    record.box = united(a.box, b.box);
    record.registers = a.registers & b.registers;
    return record;
}

float quantised(float depth, int bits, bool towards_one) {
    if (!(depth > 0.0f && depth < 1.0f)) return depth;
    const double steps = static_cast<double>(largest_count(bits));
    const double exact = static_cast<double>(depth) * steps;
    // A float is seldom the value itself: it is where the nearest value becomes this float.
    if (static_cast<float>(std::nearbyint(exact) / steps) == depth) return depth;
    return static_cast<float>((towards_one ? std::ceil(exact) : std::floor(exact)) / steps);
}

Record saturated(Record record, int bits) {
    record.projected_hits = std::min(record.projected_hits, largest_count(bits));
    record.visible_hits = std::min(record.visible_hits, largest_count(bits));
    return record;
}

Record finished(const Record& record, FarEnd end) {
    Record told = empty_record(record.registers, end);
    if (record.registers & kProjectedHits) told.projected_hits = record.projected_hits;
    if (record.registers & kVisibleHits) told.visible_hits = record.visible_hits;
    if (record.registers & kVisible) told.visible = record.visible_hits != 0 || record.visible != 0;
    if (record.registers & kNearestDepth) told.nearest_depth = record.nearest_depth;
    if (record.registers & kScreenBox) told.box = united(record.box, {});
    return told;
}

}  // namespace occlusion_unit
