// SPDX-License-Identifier: MIT
#include "occlusion_unit/cost.h"

#include <algorithm>
#include <bit>

namespace occlusion_unit {
namespace {

Parts registers(std::int64_t bits) {
    return {.register_bits = bits};
}
Parts adders(std::int64_t count, std::int64_t bits_of_each) {
    return {.adders = count, .adder_bits = count * bits_of_each};
}
Parts comparators(std::int64_t count, std::int64_t bits_of_each) {
    return {.comparators = count, .comparator_bits = count * bits_of_each};
}
Parts gates(std::int64_t count) {
    return {.gates = count};
}

// The sums of <pipes> numbers of <bits> in pairs, level by level: each level's sums are a bit wider, at most
// <most_bits>.
Parts adder_tree(int pipes, int bits, int most_bits) {
    Parts tree;
    for (int left = pipes; left > 1; left = (left + 1) / 2) {
        tree += adders(left / 2, std::min(bits, most_bits));
        ++bits;
    }
    return tree;
}

// Head and tail, each stepped by an adder of its own, a comparator that finds them equal, and the bit that
// says whether that means full or empty.
Parts queue_control(int length) {
    if (length == 0) return {};
    const int bits = std::bit_width(static_cast<unsigned>(length - 1));
    return bits == 0 ? registers(1) : registers(2 * bits + 1) + adders(2, bits) + comparators(1, bits);
}

// "For each incoming fragment, the projection hit counter (PHC) is incremented": a counter and what steps it,
// behind the AND of "armed" and "a fragment comes by" (PHC) or "it passes the depth test" (NOHC). At the end
// of the tree a counter of the full width, which gathers what drains, and an OR for each of its bits, which
// holds it at its largest once it has carried.
HardwareCost counter_cost(const HardwareSizes& sizes) {
    const int partial_bits = std::min(kPartialCounterBits, sizes.counter_bits);
    return {sizes.pipes, registers(partial_bits) + adders(1, partial_bits) + gates(1),
            adder_tree(sizes.pipes, partial_bits, sizes.counter_bits) + adders(1, sizes.counter_bits) +
                registers(sizes.counter_bits) + gates(sizes.counter_bits),
            registers(std::int64_t{sizes.report_queue} * sizes.counter_bits)};
}

// A set-only flag: the AND that enables it and the OR with what it was; a tree of ORs.
HardwareCost flag_cost(const HardwareSizes& sizes) {
    return {sizes.pipes, registers(1) + gates(2), registers(1) + gates(sizes.pipes - 1),
            registers(sizes.report_queue)};
}

// <count> registers of <bits>, each with the comparator that says whether a fragment replaces its value; a
// tree of comparators for each. "Further registers are needed to store the closest z-value and the minimal
// screen space bounding box": one for z, four for the box.
HardwareCost extremes_cost(const HardwareSizes& sizes, int count, int bits) {
    return {sizes.pipes, registers(count * bits) + comparators(count, bits) + gates(1),
            registers(count * bits) + comparators(std::int64_t{count} * (sizes.pipes - 1), bits),
            registers(std::int64_t{sizes.report_queue} * count * bits)};
}

}  // namespace

Parts& Parts::operator+=(const Parts& other) {
    register_bits += other.register_bits;
    adders += other.adders;
    adder_bits += other.adder_bits;
    comparators += other.comparators;
    comparator_bits += other.comparator_bits;
    gates += other.gates;
    return *this;
}

Parts operator+(Parts a, const Parts& b) {
    return a += b;
}

Parts operator*(std::int64_t count, Parts parts) {
    for (std::int64_t* member : {&parts.register_bits, &parts.adders, &parts.adder_bits, &parts.comparators,
                                 &parts.comparator_bits, &parts.gates}) {
        *member *= count;
    }
    return parts;
}

HardwareCost register_cost(const HardwareSizes& sizes, std::uint32_t register_bit) {
    HardwareCost cost;
    switch (register_bit) {
        case kVisible:
            cost = flag_cost(sizes);
            break;
        case kProjectedHits:
        case kVisibleHits:
            cost = counter_cost(sizes);
            break;
        case kNearestDepth:
            cost = extremes_cost(sizes, 1, sizes.depth_bits);
            break;
        case kScreenBox:
            cost = extremes_cost(sizes, 4, sizes.coordinate_bits);
            break;
        default:
            return cost;
    }
    cost.shared += registers(1);  // says whether it is armed
    return cost;
}

HardwareCost unit_cost(const HardwareSizes& sizes, std::uint32_t armable) {
    HardwareCost cost{sizes.pipes, {}, {}, queue_control(sizes.report_queue)};
    for (std::uint32_t bit = 1; bit <= kAllRegisters; bit *= 2) {
        if (!(armable & bit)) continue;
        const HardwareCost one = register_cost(sizes, bit);
        cost.pipe += one.pipe;
        cost.shared += one.shared;
        cost.queue += one.queue;
    }
    return cost;
}

// The pipes read the rectangle's depths, each its share; a comparator's sense is turned for nearest z and for
// reversed depth (one XOR), and it is enabled inside the rectangle (one AND). Shared: the tree, its result,
// the comparison with the far depth for "all occluded", which of the three questions it is (2 bits), and what
// walks the rectangle: its four edges, x and y, each with what steps it and what finds its end.
HardwareCost region_query_cost(const HardwareSizes& sizes) {
    const int depth = sizes.depth_bits;
    const int coordinate = sizes.coordinate_bits;
    HardwareCost cost{sizes.pipes,
                      registers(depth) + comparators(1, depth) + gates(2),
                      registers(depth + 2 + 4 * coordinate + 2 * coordinate) +
                          comparators(sizes.pipes - 1, depth) + comparators(1, depth) +
                          adders(2, coordinate) + comparators(2, coordinate),
                      {}};
    if (sizes.report_queue > 0) {
        const std::int64_t entry_bits = depth + (2 + 4 * coordinate);  // an answer, and a question
        cost.queue = registers(sizes.report_queue * entry_bits) + 2 * queue_control(sizes.report_queue);
    }
    return cost;
}

}  // namespace occlusion_unit
