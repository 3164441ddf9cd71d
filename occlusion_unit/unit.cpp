// SPDX-License-Identifier: MIT
#include "occlusion_unit/unit.h"

#include <algorithm>
#include <cassert>

namespace occlusion_unit {

Unit::Unit(const UnitShape& shape) : shape_(shape), partials_(static_cast<std::size_t>(shape.pipes)) {
    assert(shape.pipes > 0 && shape.counter_bits >= 1 && shape.counter_bits <= 64);
    assert(shape.partial_counter_bits >= 1 && shape.partial_counter_bits <= 64);
}

void Unit::begin(std::uint32_t registers, FarEnd far_end) {
    armed_ = registers & kAllRegisters;
    far_end_ = far_end;
    projected_hits_ = 0;
    visible_hits_ = 0;
    Partial reset;
    reset.nearest_depth = far_depth(far_end_);
    std::ranges::fill(partials_, reset);
}

// Section 6.2: "For each incoming fragment, the projection hit counter (PHC) is incremented. Furthermore, the
// non-occlusion hit counter (NOHC) is increased, if the depth buffer test was successful".
void Unit::step(int pipe, const Fragment& fragment) {
    assert(fragment.passing <= fragment.samples);
    Partial& partial = partials_[static_cast<std::size_t>(pipe)];
    if (fragment.samples == 0) return;
    if (armed_ & kProjectedHits) {
        ++work_.projected_increments;
        count(partial.projected_hits, projected_hits_, fragment.samples);
    }
    if (fragment.passing == 0) return;  // the AND of figure 12: all that follows is of visible samples
    if (armed_ & kVisible) {
        ++work_.flag_sets;
        partial.visible = true;
    }
    if (armed_ & kVisibleHits) {
        ++work_.visible_increments;
        count(partial.visible_hits, visible_hits_, fragment.passing);
    }
    if (armed_ & kNearestDepth) {
        ++work_.depth_comparisons;
        if (is_nearer(fragment.depth, partial.nearest_depth, far_end_)) {
            partial.nearest_depth = fragment.depth;
        }
    }
    if (armed_ & kScreenBox) {
        work_.box_comparisons += 4;
        partial.box = united(partial.box, box_of_pixel(fragment.x, fragment.y));
    }
}

// The partial counter really has only its bits: what did not drain in time would be lost. One too narrow for
// the hits of a single fragment passes them on.
void Unit::count(std::uint64_t& partial, std::uint64_t& total, std::uint32_t hits) {
    const std::uint64_t largest = largest_count(shape_.partial_counter_bits);
    if (hits > largest - partial) {
        ++work_.drains;
        total = saturated_sum(total, partial);
        partial = 0;
    }
    if (hits > largest) {
        total = saturated_sum(total, hits);
    } else {
        partial = (partial + hits) & largest;
    }
}

Record Unit::as_record(const Partial& partial) const {
    Record record;
    record.visible = partial.visible ? 1 : 0;
    record.projected_hits = partial.projected_hits;
    record.visible_hits = partial.visible_hits;
    record.nearest_depth = partial.nearest_depth;
    record.box = partial.box;
    record.registers = armed_;
    return record;
}

Record Unit::drain() {
    // The merge tree: neighbours in pairs until one is left.
    std::vector<Record> level;
    for (const Partial& partial : partials_) level.push_back(as_record(partial));
    while (level.size() > 1) {
        const std::size_t half = (level.size() + 1) / 2;
        for (std::size_t i = 0; i + half < level.size(); ++i) {
            level[i] = merged(level[i], level[i + half], far_end_);
        }
        level.resize(half);
    }
    Record record = level.front();
    record.projected_hits = saturated_sum(record.projected_hits, projected_hits_);
    record.visible_hits = saturated_sum(record.visible_hits, visible_hits_);
    return finished(saturated(record, shape_.counter_bits), far_end_);
}

bool Unit::end(ReportQueue& queue) {
    return queue.push(drain());
}

}  // namespace occlusion_unit
