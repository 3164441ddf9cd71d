// SPDX-License-Identifier: MIT
// The cost of query hardware, counted by hand for a machine small enough to draw: three pipes, so that the
// merge tree has an odd one out, 4-bit counters, 3-bit coordinates, 5-bit depths, a queue of 4.
#include "occlusion_unit/cost.h"

#include <gtest/gtest.h>

namespace occlusion_unit {
namespace {

constexpr HardwareSizes kSmall{
    .pipes = 3, .counter_bits = 4, .coordinate_bits = 3, .depth_bits = 5, .report_queue = 4};

TEST(HardwareCost, a_flag_is_a_bit_in_each_pipe_and_a_tree_of_ors) {
    const HardwareCost cost = register_cost(kSmall, kVisible);
    EXPECT_EQ(cost.pipe, (Parts{.register_bits = 1, .gates = 2}));
    EXPECT_EQ(cost.shared, (Parts{.register_bits = 1 + 1, .gates = 2}));
    EXPECT_EQ(cost.queue, (Parts{.register_bits = 4}));
}

// The tree: a + b on 4 bits, (a + b) + c on 5, which are cut to the 4 of the report; then the sum to what
// drained before.
TEST(HardwareCost, a_counter_is_an_adder_in_each_pipe_and_a_tree_of_adders) {
    for (const std::uint32_t counter : {kProjectedHits, kVisibleHits}) {
        const HardwareCost cost = register_cost(kSmall, counter);
        EXPECT_EQ(cost.pipe, (Parts{.register_bits = 4, .adders = 1, .adder_bits = 4, .gates = 1}));
        EXPECT_EQ(cost.shared,
                  (Parts{.register_bits = 4 + 1, .adders = 2 + 1, .adder_bits = 4 + 4 + 4, .gates = 4}));
        EXPECT_EQ(cost.queue, (Parts{.register_bits = 4 * 4}));
    }
}

TEST(HardwareCost, a_wide_counter_is_narrow_in_the_pipe_and_grows_down_the_tree) {
    const HardwareCost cost =
        register_cost({.pipes = 4, .counter_bits = 32, .report_queue = 0}, kVisibleHits);
    EXPECT_EQ(cost.pipe, (Parts{.register_bits = 16, .adders = 1, .adder_bits = 16, .gates = 1}));
    // Two adders of 16 bits, one of 17, one of 32.
    EXPECT_EQ(cost.shared, (Parts{.register_bits = 33, .adders = 4, .adder_bits = 81, .gates = 32}));
    EXPECT_EQ(cost.queue, Parts{});
}

TEST(HardwareCost, depth_takes_one_comparator_in_each_pipe_and_the_box_four) {
    const HardwareCost depth = register_cost(kSmall, kNearestDepth);
    EXPECT_EQ(depth.pipe, (Parts{.register_bits = 5, .comparators = 1, .comparator_bits = 5, .gates = 1}));
    EXPECT_EQ(depth.shared, (Parts{.register_bits = 6, .comparators = 2, .comparator_bits = 10}));
    EXPECT_EQ(depth.queue, (Parts{.register_bits = 20}));
    const HardwareCost box = register_cost(kSmall, kScreenBox);
    EXPECT_EQ(box.pipe, (Parts{.register_bits = 12, .comparators = 4, .comparator_bits = 12, .gates = 1}));
    EXPECT_EQ(box.shared, (Parts{.register_bits = 13, .comparators = 8, .comparator_bits = 24}));
    EXPECT_EQ(box.queue, (Parts{.register_bits = 48}));
}

// A queue of four: head and tail of 2 bits, the full bit, two steppers, one comparator.
TEST(HardwareCost, the_unit_is_its_registers_and_one_queue) {
    const HardwareCost unit = unit_cost(kSmall, kAllRegisters);
    EXPECT_EQ(unit.pipe, (Parts{.register_bits = 1 + 4 + 4 + 5 + 12,
                                .adders = 2,
                                .adder_bits = 8,
                                .comparators = 5,
                                .comparator_bits = 17,
                                .gates = 2 + 1 + 1 + 1 + 1}));
    EXPECT_EQ(unit.queue, (Parts{.register_bits = 4 * (1 + 4 + 4 + 5 + 12) + 5,
                                 .adders = 2,
                                 .adder_bits = 4,
                                 .comparators = 1,
                                 .comparator_bits = 2}));
    EXPECT_EQ(unit.total().register_bits, 3 * 26 + (2 + 5 + 5 + 6 + 13) + (4 * 26 + 5));
    EXPECT_EQ(unit.total().comparators, 3 * 5 + (2 + 8) + 1);

    EXPECT_EQ(unit_cost(kSmall, kVisible).pipe, register_cost(kSmall, kVisible).pipe);
    EXPECT_EQ(unit_cost(kSmall, 0).pipe, Parts{});
}

TEST(HardwareCost, one_pipe_needs_no_tree) {
    const HardwareSizes one{
        .pipes = 1, .counter_bits = 4, .coordinate_bits = 3, .depth_bits = 5, .report_queue = 1};
    const HardwareCost unit = unit_cost(one, kAllRegisters);
    EXPECT_EQ(unit.shared.comparators, 0);
    EXPECT_EQ(unit.shared.adders, 2) << "what adds to what drained before, for each counter";
    EXPECT_EQ(unit.queue.register_bits, 26 + 1) << "one place is full or empty";
    EXPECT_EQ(unit.queue.adders, 0);
}

// Pipes: a 5-bit register and comparator. Shared: 5 bits of result, 2 of question, 4 edges, x and y of 3 bits
// each.
TEST(HardwareCost, a_region_query_compares_depths_and_walks_a_rectangle) {
    HardwareSizes sizes = kSmall;
    const HardwareCost many = region_query_cost(sizes);
    EXPECT_EQ(many.pipe, (Parts{.register_bits = 5, .comparators = 1, .comparator_bits = 5, .gates = 2}));
    EXPECT_EQ(many.shared, (Parts{.register_bits = 5 + 2 + 12 + 6,
                                  .adders = 2,
                                  .adder_bits = 6,
                                  .comparators = 2 + 1 + 2,
                                  .comparator_bits = 10 + 5 + 6}));
    EXPECT_EQ(many.queue.register_bits, 4 * (5 + 2 + 12) + 2 * 5);
    sizes.report_queue = 0;
    EXPECT_EQ(region_query_cost(sizes).queue, Parts{});
    EXPECT_EQ(region_query_cost(sizes).shared, many.shared);
}

}  // namespace
}  // namespace occlusion_unit
