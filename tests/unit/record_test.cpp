// SPDX-License-Identifier: MIT
// Records: merging, saturation, what is reported; and the queue in which they wait.
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <deque>
#include <limits>

#include "occlusion_unit/record_arithmetic.h"
#include "occlusion_unit/report_queue.h"

namespace occlusion_unit {
namespace {

// Counts that sometimes come near 2^64, boxes that are sometimes empty.
rc::Gen<Record> any_record() {
    return rc::gen::exec([] {
        Record record;
        record.projected_hits =
            *rc::gen::oneOf(rc::gen::inRange<std::uint64_t>(0, 1000), rc::gen::arbitrary<std::uint64_t>());
        record.visible_hits = *rc::gen::inRange<std::uint64_t>(0, 1000);
        record.visible = record.visible_hits != 0;
        record.nearest_depth = static_cast<float>(*rc::gen::inRange(0, 101)) / 100.0f;
        if (*rc::gen::arbitrary<bool>()) {
            const int left = *rc::gen::inRange(-100, 100);
            const int bottom = *rc::gen::inRange(-100, 100);
            record.box = {left, bottom, left + *rc::gen::inRange(0, 50), bottom + *rc::gen::inRange(0, 50)};
        }
        record.registers = *rc::gen::inRange<std::uint32_t>(0, kAllRegisters + 1);
        return record;
    });
}

rc::Gen<FarEnd> any_end() {
    return rc::gen::element(FarEnd::kOne, FarEnd::kZero);
}

RC_GTEST_PROP(Record, merging_is_commutative_and_associative, ()) {
    const Record a = *any_record();
    const Record b = *any_record();
    const Record c = *any_record();
    const FarEnd end = *any_end();
    RC_ASSERT(merged(a, b, end) == merged(b, a, end));
    RC_ASSERT(merged(merged(a, b, end), c, end) == merged(a, merged(b, c, end), end));
}

RC_GTEST_PROP(Record, the_empty_record_changes_nothing, ()) {
    const Record a = *any_record();
    const FarEnd end = *any_end();
    RC_ASSERT(merged(a, empty_record(kAllRegisters, end), end) == a);
}

RC_GTEST_PROP(Record, a_counter_never_wraps, (std::uint64_t a, std::uint64_t b)) {
    const std::uint64_t sum = saturated_sum(a, b);
    RC_ASSERT(sum >= a);
    RC_ASSERT(sum >= b);
    RC_ASSERT(sum - a == b || sum == std::numeric_limits<std::uint64_t>::max());
}

TEST(Record, a_counter_holds_what_its_bits_hold) {
    EXPECT_EQ(largest_count(1), 1u);
    EXPECT_EQ(largest_count(24), 16'777'215u);
    EXPECT_EQ(largest_count(64), std::numeric_limits<std::uint64_t>::max());
    Record record;
    record.projected_hits = 16'777'216;
    record.visible_hits = 16'777'215;
    EXPECT_EQ(saturated(record, 24).projected_hits, 16'777'215u);
    EXPECT_EQ(saturated(record, 24).visible_hits, 16'777'215u);
    EXPECT_EQ(saturated(record, 25), record);
}

TEST(Record, the_box_of_two_is_the_smallest_around_both) {
    EXPECT_EQ(united({2, 3, 4, 5}, {1, 4, 2, 9}), (Box{1, 3, 4, 9}));
    EXPECT_EQ(united({2, 3, 4, 5}, {}), (Box{2, 3, 4, 5}));
    EXPECT_EQ(united({}, {-2, -3, -2, -3}), (Box{-2, -3, -2, -3}));
    EXPECT_EQ(united({7, 7, 6, 9}, {}), (Box{0, 0, -1, -1})) << "none has one form only";
}

TEST(Record, nearer_follows_the_far_end) {
    EXPECT_TRUE(is_nearer(0.25f, 0.5f, FarEnd::kOne));
    EXPECT_TRUE(is_nearer(0.5f, 0.25f, FarEnd::kZero));
    for (const FarEnd end : {FarEnd::kOne, FarEnd::kZero}) {
        EXPECT_FALSE(is_nearer(0.5f, 0.5f, end));
        EXPECT_FALSE(is_nearer(std::nanf(""), 0.5f, end));
        EXPECT_TRUE(is_nearer(near_depth(end), far_depth(end), end));
    }
}

TEST(Record, what_was_not_armed_is_reported_as_nothing) {
    const Record full{10, 5, 0, 0.5f, {1, 2, 3, 4}, kAllRegisters, 0};
    const Record told = finished(full, FarEnd::kOne);
    EXPECT_EQ(told.visible, 1u) << "counted hits set the flag";
    for (std::uint32_t bit = 1; bit <= kAllRegisters; bit *= 2) {
        Record one = full;
        one.registers = bit;
        Record expected;
        expected.registers = bit;
        if (bit == kVisible) expected.visible = 1;
        if (bit == kProjectedHits) expected.projected_hits = 10;
        if (bit == kVisibleHits) expected.visible_hits = 5;
        if (bit == kNearestDepth) expected.nearest_depth = 0.5f;
        if (bit == kScreenBox) expected.box = {1, 2, 3, 4};
        EXPECT_EQ(finished(one, FarEnd::kOne), expected) << bit;
    }
}

// Against a plain deque: in order, bounded, nothing dropped, a refusal changes nothing.
RC_GTEST_PROP(ReportQueue, is_a_bounded_queue_that_drops_nothing, ()) {
    const auto capacity = *rc::gen::inRange<std::size_t>(1, 6);
    ReportQueue queue(capacity);
    std::deque<std::uint64_t> model;
    std::uint64_t refusals = 0;
    std::uint64_t next = 0;
    for (const bool is_push : *rc::gen::arbitrary<std::vector<bool>>()) {
        if (is_push) {
            Record record;
            record.projected_hits = next;
            const bool has_room = model.size() < capacity;
            RC_ASSERT(queue.push(record) == has_room);
            if (has_room) {
                model.push_back(next++);
            } else {
                ++refusals;
            }
        } else if (model.empty()) {
            RC_ASSERT(!queue.pop());
        } else {
            RC_ASSERT(queue.pop()->projected_hits == model.front());
            model.pop_front();
        }
        RC_ASSERT(queue.size() == model.size());
    }
    RC_ASSERT(queue.refusals() == refusals);
}

}  // namespace
}  // namespace occlusion_unit
