// SPDX-License-Identifier: MIT
// The Occlusion Unit by itself: what each register counts, whatever the pipes and their widths. Fragments are
// random; a plain loop over them, written without any of the unit's code, is the witness.
#include "occlusion_unit/unit.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <vector>

namespace occlusion_unit {
namespace {

// The paper's sentences as arithmetic, one register at a time.
Record by_hand(const std::vector<Fragment>& fragments, std::uint32_t registers, FarEnd end) {
    Record told;
    told.registers = registers;
    std::vector<Fragment> visible;
    for (const Fragment& fragment : fragments) {
        if (registers & kProjectedHits) told.projected_hits += fragment.samples;
        if (registers & kVisibleHits) told.visible_hits += fragment.passing;
        if (fragment.passing > 0) visible.push_back(fragment);
    }
    if ((registers & kVisible) && !visible.empty()) told.visible = 1;
    if (registers & kNearestDepth) {
        told.nearest_depth = end == FarEnd::kOne ? 1.0f : 0.0f;
        for (const Fragment& fragment : visible) {
            told.nearest_depth = end == FarEnd::kOne ? std::min(told.nearest_depth, fragment.depth)
                                                     : std::max(told.nearest_depth, fragment.depth);
        }
    }
    if ((registers & kScreenBox) && !visible.empty()) {
        const auto [left, right] = std::ranges::minmax(visible, {}, &Fragment::x);
        const auto [bottom, top] = std::ranges::minmax(visible, {}, &Fragment::y);
        told.box = {left.x, bottom.y, right.x, top.y};
    }
    return told;
}

rc::Gen<Fragment> any_fragment() {
    return rc::gen::map(
        rc::gen::tuple(rc::gen::inRange(0, 4096), rc::gen::inRange(0, 4096), rc::gen::inRange(0, 65536),
                       rc::gen::inRange<std::uint32_t>(0, 9), rc::gen::inRange<std::uint32_t>(0, 9)),
        [](const auto& drawn) {
            const auto& [x, y, code, samples, passing] = drawn;
            return Fragment{x, y, static_cast<float>(code) / 65535.0f, samples, std::min(samples, passing)};
        });
}

rc::Gen<std::vector<Fragment>> any_fragments() {
    return rc::gen::container<std::vector<Fragment>>(any_fragment());
}

FarEnd far_end(bool is_reversed) {
    return is_reversed ? FarEnd::kZero : FarEnd::kOne;
}

RC_GTEST_PROP(OcclusionUnit, however_fragments_fall_on_pipes_the_record_is_the_papers, (bool is_reversed)) {
    const int pipes = *rc::gen::inRange(1, 17);
    const int partial_bits = *rc::gen::inRange(1, 65);
    const auto registers = *rc::gen::inRange<std::uint32_t>(0, kAllRegisters + 1);
    const std::vector<Fragment> fragments = *any_fragments();
    Unit unit({pipes, 64, partial_bits});
    unit.begin(registers, far_end(is_reversed));
    for (const Fragment& fragment : fragments) unit.step(*rc::gen::inRange(0, pipes), fragment);
    RC_ASSERT(unit.drain() == by_hand(fragments, registers, far_end(is_reversed)));
}

RC_GTEST_PROP(OcclusionUnit, the_order_of_fragments_does_not_matter, (bool is_reversed)) {
    std::vector<Fragment> fragments = *any_fragments();
    const auto record_of = [&] {
        Unit unit({4, 20, 5});
        unit.begin(kAllRegisters, far_end(is_reversed));
        int pipe = 0;
        for (const Fragment& fragment : fragments) unit.step(pipe++ % 4, fragment);
        return unit.drain();
    };
    const Record first = record_of();
    std::ranges::reverse(fragments);
    const Record second = record_of();
    std::ranges::sort(fragments, {}, &Fragment::depth);
    RC_ASSERT(first == second);
    RC_ASSERT(first == record_of());
}

RC_GTEST_PROP(OcclusionUnit, a_counter_stops_at_its_width_and_never_wraps, ()) {
    const int bits = *rc::gen::inRange(1, 12);
    const std::vector<Fragment> fragments = *any_fragments();
    Unit unit({3, bits, *rc::gen::inRange(1, 12)});
    unit.begin(kAllRegisters);
    std::uint64_t last = 0;
    for (const Fragment& fragment : fragments) {
        unit.step(*rc::gen::inRange(0, 3), fragment);
        const std::uint64_t now = unit.drain().projected_hits;
        RC_ASSERT(now >= last);
        last = now;
    }
    const Record exact = by_hand(fragments, kAllRegisters, FarEnd::kOne);
    const std::uint64_t largest = (std::uint64_t{1} << bits) - 1;
    RC_ASSERT(last == std::min(exact.projected_hits, largest));
    RC_ASSERT(unit.drain().visible_hits == std::min(exact.visible_hits, largest));
    RC_ASSERT(unit.drain().visible == exact.visible);
}

// 6.2: "the projection hit counter (PHC) is incremented. Furthermore, the non-occlusion hit counter (NOHC) is
// increased, if the depth buffer test was successful".
TEST(OcclusionUnit, hidden_fragments_are_projected_and_nothing_else) {
    Unit unit({});
    unit.begin(kAllRegisters);
    unit.step(0, {.x = 5, .y = 6, .depth = 0.25f, .samples = 4, .passing = 0});
    const Record record = unit.drain();
    EXPECT_EQ(record.projected_hits, 4u);
    EXPECT_EQ(record.visible_hits, 0u);
    EXPECT_EQ(record.visible, 0u);
    EXPECT_EQ(record.nearest_depth, 1.0f);
    EXPECT_EQ(record.box, (Box{0, 0, -1, -1}));
}

TEST(OcclusionUnit, begin_forgets_what_was_before) {
    Unit unit({});
    unit.begin(kAllRegisters);
    unit.step(0, {.x = 5, .y = 6, .depth = 0.25f});
    EXPECT_EQ(unit.drain().box, (Box{5, 6, 5, 6}));
    unit.begin(kAllRegisters, FarEnd::kZero);
    EXPECT_EQ(unit.drain(), empty_record(kAllRegisters, FarEnd::kZero));
    unit.begin(kProjectedHits);
    EXPECT_EQ(unit.drain(), empty_record(kProjectedHits, FarEnd::kOne));
}

// End puts the record behind the others, or waits with it: nothing is lost, nothing is told twice.
TEST(OcclusionUnit, a_full_queue_holds_the_unit_back) {
    ReportQueue queue(1);
    Unit unit({});
    unit.begin(kVisibleHits);
    unit.step(0, {});
    EXPECT_TRUE(unit.end(queue));
    unit.begin(kVisibleHits);
    unit.step(0, {});
    unit.step(0, {});
    EXPECT_FALSE(unit.end(queue));
    EXPECT_EQ(queue.pop()->visible_hits, 1u);
    EXPECT_TRUE(unit.end(queue));
    EXPECT_EQ(queue.pop()->visible_hits, 2u);
    EXPECT_FALSE(queue.pop());
}

// An unarmed register costs no step: each register's work is there with it alone, and gone without it.
TEST(OcclusionUnit, only_armed_registers_work) {
    const auto work_of = [](std::uint32_t registers) {
        Unit unit({});
        unit.begin(registers);
        unit.step(0, {.samples = 2, .passing = 1});
        unit.step(0, {.samples = 2, .passing = 0});
        return unit.work();
    };
    EXPECT_EQ(work_of(0), (Work{}));
    EXPECT_EQ(work_of(kVisible), (Work{1, 0, 0, 0, 0, 0}));
    EXPECT_EQ(work_of(kProjectedHits), (Work{0, 2, 0, 0, 0, 0}));
    EXPECT_EQ(work_of(kVisibleHits), (Work{0, 0, 1, 0, 0, 0}));
    EXPECT_EQ(work_of(kNearestDepth), (Work{0, 0, 0, 1, 0, 0}));
    EXPECT_EQ(work_of(kScreenBox), (Work{0, 0, 0, 0, 4, 0}));
    EXPECT_EQ(work_of(kAllRegisters), (Work{1, 2, 1, 1, 4, 0}));
}

// 3 bits hold 7: the eighth hit finds the counter full.
TEST(OcclusionUnit, a_partial_counter_drains_before_it_would_overflow) {
    Unit unit({.partial_counter_bits = 3});
    unit.begin(kProjectedHits);
    for (int hit = 1; hit <= 7; ++hit) unit.step(0, {});
    EXPECT_EQ(unit.work().drains, 0u);
    unit.step(0, {});
    EXPECT_EQ(unit.work().drains, 1u);
    for (int hit = 9; hit <= 14; ++hit) unit.step(0, {});
    EXPECT_EQ(unit.work().drains, 1u);
    unit.step(0, {});
    EXPECT_EQ(unit.work().drains, 2u);
    EXPECT_EQ(unit.drain().projected_hits, 15u);
}

}  // namespace
}  // namespace occlusion_unit
