// SPDX-License-Identifier: MIT
// The rules of the timeline, one by one, to the picosecond, on a machine with round numbers. What holds for
// any commands is in timeline_property_test.cpp, what comes out for two papers in paper_times_test.cpp.
#include "occlusion_unit/timeline.h"

#include <gtest/gtest.h>

#include "span_recorder.h"

namespace occlusion_unit {
namespace {

TEST(Timeline, a_draw_is_seen_by_the_gpu_when_its_command_is_made) {
    Timeline timeline(round_machine());
    timeline.draw(triangles(50));
    EXPECT_EQ(timeline.cpu(), 7);
    EXPECT_EQ(timeline.gpu(), 7 + 50);
    EXPECT_EQ(timeline.frame_sums().starvation, 7);
    timeline.draw(triangles(50));
    EXPECT_EQ(timeline.cpu(), 14);
    EXPECT_EQ(timeline.gpu(), 57 + 50);
    EXPECT_EQ(timeline.frame_sums().starvation, 7);
}

TEST(Timeline, the_larger_of_vertices_and_fragments_counts) {
    Timeline vertices(round_machine());
    vertices.draw(triangles(50, 12));
    EXPECT_EQ(vertices.gpu(), 7 + 50);
    EXPECT_EQ(vertices.frame_sums().fill, 0);
    Timeline fragments(round_machine());
    fragments.draw(triangles(50, 13));
    EXPECT_EQ(fragments.gpu(), 7 + 52);
    EXPECT_EQ(fragments.frame_sums().fill, 2);
}

TEST(Timeline, fragments_without_colour_have_their_own_rate) {
    Timeline timeline(round_machine());
    DrawWork work = triangles(0);
    work.fragments = volume(30);
    timeline.draw(work);
    EXPECT_EQ(timeline.gpu(), 7 + 60);
}

TEST(Timeline, triangles_are_copied_while_the_gpu_draws_them) {
    Timeline timeline(round_machine());
    timeline.draw(copied(50));
    EXPECT_EQ(timeline.cpu(), 7 + 100);
    EXPECT_EQ(timeline.gpu(), 7 + 50);
    EXPECT_EQ(timeline.frame_sums().driver_copy, 100);
    EXPECT_EQ(timeline.frame_sums().copied_triangles, 50u);
}

TEST(Timeline, a_run_of_draws_costs_each_of_them_on_the_cpu) {
    Timeline timeline(round_machine());
    DrawWork work = triangles(50);
    work.batches = 3;
    timeline.draw(work);
    EXPECT_EQ(timeline.cpu(), 21);
    EXPECT_EQ(timeline.gpu(), 7 + 50) << "the first of them is seen at once";
}

TEST(Timeline, the_cpu_waits_when_the_fifo_is_full) {
    SpanRecorder recorder;
    Timeline timeline(round_machine(), all_effects(), &recorder);
    timeline.draw(triangles(200));  // until 207
    timeline.draw(triangles(1));    // room is there at 107
    EXPECT_EQ(timeline.cpu(), 107 + 7);
    EXPECT_EQ(timeline.gpu(), 208);
    EXPECT_EQ(timeline.frame_sums().back_pressure, 100);
    EXPECT_EQ(timeline.frame_sums().stall, 0) << "that is not a stall";
    EXPECT_EQ(recorder.time_of(Lane::kCpu, Activity::kBackPressure), 100);
}

TEST(Timeline, every_command_for_the_gpu_waits_for_room) {
    const auto waits = [](auto command) {
        Timeline timeline(round_machine());
        timeline.draw(triangles(200));
        command(timeline);
        return timeline.frame_sums().back_pressure == 100;
    };
    EXPECT_TRUE(waits([](Timeline& t) { t.query(volume(1)); }));
    EXPECT_TRUE(waits([](Timeline& t) { t.regions(1, 1); }));
    EXPECT_TRUE(waits([](Timeline& t) { t.clear(1); }));
    EXPECT_TRUE(waits([](Timeline& t) { t.copy(1); }));
    EXPECT_TRUE(waits([](Timeline& t) { t.stamp(); }));
    EXPECT_FALSE(waits([](Timeline& t) { t.read(1); })) << "which waits for everything";
    EXPECT_FALSE(waits([](Timeline& t) { t.work(1); }));
    EXPECT_FALSE(waits([](Timeline& t) { t.poll(); }));
}

TEST(Timeline, a_fifo_without_a_length_is_never_full) {
    Profile profile = round_machine();
    profile.fifo = 0;
    Timeline timeline(profile);
    timeline.draw(triangles(10'000));
    timeline.draw(triangles(1));
    EXPECT_EQ(timeline.cpu(), 14);
}

TEST(Timeline, a_result_is_there_when_the_work_is_done_and_the_latency_is_over) {
    Timeline timeline(round_machine());
    const ResultTime result = timeline.query(volume(10));
    EXPECT_EQ(timeline.cpu(), 5);
    EXPECT_EQ(result.done, 5 + 2 + 20);
    EXPECT_EQ(result.available, 27 + 20);
    EXPECT_EQ(result.query, 1u);
    EXPECT_FALSE(timeline.has_come(result));
    timeline.wait(result);
    EXPECT_EQ(timeline.cpu(), 47);
    EXPECT_TRUE(timeline.has_come(result));
    const TimeSums sums = timeline.frame_sums();
    EXPECT_EQ(sums.stall, 42);
    EXPECT_EQ(sums.result_stall, 42);
    EXPECT_EQ(sums.latency, 20);
    timeline.wait(result);
    EXPECT_EQ(timeline.cpu(), 47) << "it is there, so it costs nothing";
}

TEST(Timeline, a_query_waits_for_the_draws_before_it) {
    Timeline timeline(round_machine());
    timeline.draw(triangles(50));  // until 57
    const ResultTime result = timeline.query(volume(0));
    EXPECT_EQ(result.done, 57 + 2);
}

TEST(Timeline, many_shapes_in_one_command_pay_the_processor_and_the_latency_once) {
    Timeline timeline(round_machine());
    const ResultTime result = timeline.query(volume(10), 8);
    EXPECT_EQ(timeline.cpu(), 5);
    EXPECT_EQ(result.done, 5 + 8 * 2 + 20);
    EXPECT_EQ(result.available, result.done + 20);
}

TEST(Timeline, a_poll_costs_time_so_that_polling_ends) {
    Timeline timeline(round_machine());
    const ResultTime result = timeline.query(volume(10));
    int polls = 0;
    do {
        timeline.poll(result.query);
        ++polls;
    } while (!timeline.has_come(result));
    EXPECT_EQ(polls, 42);
    EXPECT_EQ(timeline.frame_sums().stall, 0) << "polling is work";
    EXPECT_EQ(timeline.frame_sums().results_asked, 42u);
}

TEST(Timeline, a_wait_may_end_before_the_result_is_there) {
    Timeline timeline(round_machine());
    const ResultTime result = timeline.query(volume(10));
    timeline.wait_until(30, result.query);
    EXPECT_EQ(timeline.cpu(), 30);
    EXPECT_EQ(timeline.frame_sums().result_stall, 25);
    EXPECT_EQ(timeline.frame_sums().results_asked, 1u);
    EXPECT_FALSE(timeline.has_come(result));
}

TEST(Timeline, depth_regions_cost_their_pixels_on_the_gpu) {
    Timeline timeline(round_machine());
    const ResultTime result = timeline.regions(4, 100);
    EXPECT_EQ(timeline.cpu(), 5);
    EXPECT_EQ(result.done, 5 + 4 * 2 + 300);
    EXPECT_EQ(timeline.frame_sums().read_cost, 300);
}

TEST(Timeline, reading_pixels_waits_for_all_that_was_drawn) {
    Timeline timeline(round_machine());
    timeline.draw(triangles(50));  // until 57
    timeline.read(10);
    EXPECT_EQ(timeline.cpu(), 57 + 3 + 50);
    EXPECT_EQ(timeline.gpu(), 57 + 50);
    const TimeSums sums = timeline.frame_sums();
    EXPECT_EQ(sums.stall, 50);
    EXPECT_EQ(sums.result_stall, 0) << "it is not a query's result";
    EXPECT_EQ(sums.read_cost, 50);
}

TEST(Timeline, pixels_for_a_buffer_object_are_not_waited_for) {
    Timeline timeline(round_machine());
    timeline.draw(triangles(50));  // until 57
    timeline.copy(10);
    EXPECT_EQ(timeline.cpu(), 7 + 3);
    EXPECT_EQ(timeline.gpu(), 57 + 50);
}

TEST(Timeline, a_conditional_draw_makes_the_gpu_wait_for_its_result) {
    SpanRecorder recorder;
    Timeline timeline(round_machine(), all_effects(), &recorder);
    const ResultTime result = timeline.query(volume(10));  // there at 47
    timeline.wait_on_gpu(result);
    timeline.draw(triangles(50));
    EXPECT_EQ(timeline.cpu(), 12) << "the CPU does not wait";
    EXPECT_EQ(timeline.gpu(), 47 + 50);
    EXPECT_EQ(recorder.time_of(Lane::kGpu, Activity::kCondition), 20);
    EXPECT_EQ(timeline.frame_sums().results_asked, 1u);
}

}  // namespace
}  // namespace occlusion_unit
