// SPDX-License-Identifier: MIT
// What query hardware costs to build, counted in the elements of figure 12 of Bartz, Meissner and Huettner
// (1999): registers, the adders that step the counters, the comparators of z and of the screen box, and the
// gates that enable them. A count of elements, not of gates or of area: it says what a register adds to a
// pipe, and what grows with the pipes, with the counter's width and with the queue. Memory traffic and wires
// are not in it. The formulas, one for each register, are in cost.cpp and in docs/hardware.md.
#pragma once

#include <cstdint>

#include "occlusion_unit/record.h"

namespace occlusion_unit {

// Widths of a machine; the defaults stand for whatever a device does not state.
struct HardwareSizes {
    int pipes = 4;             // pixels that are tested in a clock, each by a pipe of its own
    int counter_bits = 32;     // of a counter in a report
    int coordinate_bits = 12;  // of a window coordinate
    int depth_bits = 24;       // of a depth
    int report_queue = 64;     // reports that wait to be read; 0: one at a time, read from the record itself
};

// A pipe's own counters are at most this wide: a full one drains into the record's, at most once in 65,536
// hits, and the pipe does not pay for the whole width.
inline constexpr int kPartialCounterBits = 16;

struct Parts {
    std::int64_t register_bits = 0;
    std::int64_t adders = 0;
    std::int64_t adder_bits = 0;  // of all of them together
    std::int64_t comparators = 0;
    std::int64_t comparator_bits = 0;
    std::int64_t gates = 0;  // of two inputs and one bit

    bool operator==(const Parts&) const = default;
    Parts& operator+=(const Parts& other);
};
Parts operator+(Parts a, const Parts& b);
Parts operator*(std::int64_t count, Parts parts);

struct HardwareCost {
    int pipes = 1;
    Parts pipe;    // beside the depth test of each pipe
    Parts shared;  // once: the merge tree, and the record that it ends in
    Parts queue;   // once: where reports wait

    Parts total() const { return pipes * pipe + shared + queue; }
    bool operator==(const HardwareCost&) const = default;
};

// One register of the unit: kVisible alone is the hardware of HP_occlusion_test, kVisibleHits alone that of
// NV_occlusion_query and ARB_occlusion_query, but for the queue's control.
HardwareCost register_cost(const HardwareSizes& sizes, std::uint32_t register_bit);
// Several registers, each of which can be armed by itself, with one queue for their records.
HardwareCost unit_cost(const HardwareSizes& sizes, std::uint32_t registers);
// The furthest or nearest z of a rectangle, or whether all of it is occluded; with a queue, rectangles wait
// as well.
HardwareCost region_query_cost(const HardwareSizes& sizes);

}  // namespace occlusion_unit
