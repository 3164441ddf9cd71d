// SPDX-License-Identifier: MIT
// The rules of the timeline, to the picosecond, on a machine with round numbers: what ends a frame, and each
// effect that can be switched off.
#include <gtest/gtest.h>

#include "span_recorder.h"

namespace occlusion_unit {
namespace {

TEST(TimelineFrame, a_timestamp_is_when_all_before_it_is_done) {
    Timeline timeline(round_machine());
    timeline.draw(triangles(50));
    const ResultTime stamp = timeline.stamp();
    EXPECT_EQ(stamp.done, 57);
    EXPECT_EQ(stamp.available, 77);
    EXPECT_EQ(timeline.cpu(), 7);
}

TEST(TimelineFrame, finish_waits_until_all_is_done) {
    Timeline timeline(round_machine());
    timeline.draw(triangles(50));
    timeline.finish();
    EXPECT_EQ(timeline.cpu(), 57);
    EXPECT_EQ(timeline.frame_sums().drain, 50);
    EXPECT_EQ(timeline.frame_sums().stall, 0);
}

TEST(TimelineFrame, a_swap_ends_the_frame_with_both_clocks_alike) {
    SpanRecorder recorder;
    Timeline timeline(round_machine(), all_effects(), &recorder);
    timeline.work(100);
    timeline.draw(triangles(50));               // 107; until 157
    const TimeSums first = timeline.swap(300);  // 117; until 457
    EXPECT_EQ(first.cpu, 457);
    EXPECT_EQ(first.gpu_busy, 350);
    EXPECT_EQ(first.drain, 457 - 117);
    EXPECT_EQ(timeline.cpu(), timeline.gpu());
    timeline.work(5);
    const TimeSums second = timeline.swap(0);
    EXPECT_EQ(second.cpu, 15);
    EXPECT_EQ(timeline.total_sums().cpu, 472);
    ASSERT_EQ(recorder.frames.size(), 2u);
    EXPECT_EQ(recorder.frames[1].index, 1u);
    EXPECT_EQ(recorder.frames[1].end, 472);
}

TEST(TimelineFrame, a_gpu_that_works_ahead_does_not_work_ahead_of_a_frame) {
    Timeline timeline(round_machine(), without(Effect::kStarvation));
    timeline.work(100);
    timeline.draw(triangles(50));
    EXPECT_EQ(timeline.gpu(), 50) << "before its command was made";
    timeline.swap(0);
    timeline.draw(triangles(50));
    EXPECT_EQ(timeline.gpu(), 117 + 50);
}

TEST(TimelineFrame, work_tells_when_it_came_into_the_fifo) {
    SpanRecorder recorder;
    Timeline timeline(round_machine(), all_effects(), &recorder);
    timeline.draw(triangles(50));
    timeline.draw(triangles(50));
    const std::vector<Span> gpu = recorder.of(Lane::kGpu);
    ASSERT_EQ(gpu.size(), 3u);  // starvation, and two draws
    EXPECT_EQ(gpu[1].queued, 7);
    EXPECT_EQ(gpu[1].begin, 7);
    EXPECT_EQ(gpu[2].queued, 14);
    EXPECT_EQ(gpu[2].begin, 57);
}

// Each effect, in a frame that calls for it.
TEST(TimelineFrame, each_effect_can_be_switched_off) {
    const auto frame = [](Effects effects) {
        Timeline timeline(round_machine(), effects);
        timeline.clear(20);
        timeline.work(30);
        timeline.draw(copied(40));
        timeline.draw(triangles(300, 400, 4));
        timeline.draw(triangles(10));
        timeline.wait(timeline.query(volume(10)));
        timeline.read(10);
        return timeline.swap(100);
    };
    const TimeSums all = frame(all_effects());
    const auto off = [&](Effect effect) { return frame(without(effect)); };
    EXPECT_EQ(off(Effect::kLatency).cpu, all.cpu - all.latency);
    EXPECT_EQ(off(Effect::kLatency).latency, 0);
    EXPECT_GT(all.back_pressure, 0);
    EXPECT_EQ(off(Effect::kBackPressure).back_pressure, 0);
    EXPECT_EQ(off(Effect::kBackPressure).cpu, all.cpu) << "the wait for the result takes its place";
    EXPECT_LT(off(Effect::kFill).gpu_busy, all.gpu_busy - 6'000);
    EXPECT_EQ(off(Effect::kFill).fill, 0);
    EXPECT_LT(off(Effect::kDriverCopy).cpu, all.cpu);
    EXPECT_EQ(off(Effect::kMultisampling).gpu_busy, all.gpu_busy - all.multisampling);
    EXPECT_EQ(off(Effect::kReadCost).cpu, all.cpu - all.read_cost);
    EXPECT_GT(all.starvation, 0);
    EXPECT_EQ(off(Effect::kStarvation).starvation, 0);
    EXPECT_LT(off(Effect::kStarvation).cpu, all.cpu);
    EXPECT_EQ(off(Effect::kSaturation).cpu, all.cpu) << "of which the timeline knows nothing";
    EXPECT_EQ(off(Effect::kDepthQuantisation).cpu, all.cpu);
}

TEST(TimelineFrame, samples_cost_what_as_many_pixels_cost) {
    Timeline timeline(round_machine());
    timeline.draw(triangles(0, 10, 4));
    EXPECT_EQ(timeline.gpu(), 7 + 160);
    EXPECT_EQ(timeline.frame_sums().multisampling, 120);
    Timeline clearing(round_machine());
    clearing.clear(10, 4);
    EXPECT_EQ(clearing.gpu(), 40);
    EXPECT_EQ(clearing.frame_sums().multisampling, 30);
    EXPECT_EQ(clearing.frame_sums().multisampled_fragments, 10u);
}

}  // namespace
}  // namespace occlusion_unit
