// SPDX-License-Identifier: MIT
// When results are there, to the nanosecond, and what it takes to ask for them.
#include <vector>

#include "device_test.h"

namespace clock_tests {
namespace {

using conformance::Query;

// When the result of a query that ends at <end> on the CPU is there, of an idle GPU.
constexpr GLint64 there(GLint64 end) {
    return end + kGpuQuery + kLatency;
}

class DeviceResults : public DeviceTest {};

TEST_F(DeviceResults, a_query_takes_its_time_on_both_clocks) {
    const Query query;
    rest();
    EXPECT_EQ(on_cpu([&] { ask(query); }), kQuery);
    rest();
    EXPECT_EQ(on_gpu([&] { ask(query); }), kQuery + kGpuQuery);
    // A bounding volume is part of it but for its fragments, whose colour nobody sees.
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    keep_gpu_busy();
    EXPECT_EQ(on_gpu([&] {
                  query.begin();
                  fill();
                  query.end();
              }),
              kGpuQuery + kFilled * kDepthFragment);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

TEST_F(DeviceResults, what_is_more_than_a_bounding_volume_is_drawn_for_its_own_sake) {
    const Query query;
    rest();
    EXPECT_EQ(on_cpu([&] {
                  query.begin();
                  draw(12);
                  query.end();
              }),
              kQuery);
    rest();
    EXPECT_EQ(on_cpu([&] {
                  query.begin();
                  draw_batches(3, 5);
                  query.end();
              }),
              3 * kBatch + kQuery);
    keep_gpu_busy();
    EXPECT_EQ(on_gpu([&] {
                  query.begin();
                  draw_batches(3, 5);
                  query.end();
              }),
              3 * (kGpuBatch + 5 * kTriangle) + kGpuQuery);
}

TEST_F(DeviceResults, polling_ends_when_the_latency_has_passed) {
    const Query query;
    const GLint64 end = rest() + kQuery;
    ask(query);
    GLint64 polls = 1;
    while (!is_available(query) && polls < 1'000'000) ++polls;
    EXPECT_EQ(polls, (there(end) - end) / kPoll);
    EXPECT_EQ(cpu(), there(end));
    // It is still asked for, and still there.
    EXPECT_EQ(on_cpu([&] { EXPECT_TRUE(is_available(query)); }), kPoll);
}

TEST_F(DeviceResults, a_blocking_read_moves_the_cpu_to_the_results_time) {
    const Query query;
    const GLint64 end = rest() + kQuery;
    ask(query);
    EXPECT_EQ(query.result(), 0u);
    EXPECT_EQ(cpu(), there(end));
    EXPECT_EQ(on_cpu([&] { EXPECT_EQ(query.result(), 0u); }), 0);
    // The time that the program needs itself is not waited for again.
    const GLint64 second_end = rest() + kQuery;
    ask(query);
    work(static_cast<GLuint64>(kGpuQuery + kLatency));
    EXPECT_EQ(query.result(), 0u);
    EXPECT_EQ(cpu(), there(second_end));
}

TEST_F(DeviceResults, a_read_that_does_not_wait_is_a_poll) {
    if (const auto why = conformance::lacks(44, "GL_ARB_query_buffer_object")) GTEST_SKIP() << *why;
    const Query query;
    ask(query);
    GLuint value = conformance::kUntouched;
    const auto read = [&] { glGetQueryObjectuiv(query.name(), GL_QUERY_RESULT_NO_WAIT, &value); };
    EXPECT_EQ(on_cpu(read), kPoll);
    EXPECT_EQ(value, conformance::kUntouched);
    work(static_cast<GLuint64>(kGpuQuery + kLatency));
    EXPECT_EQ(on_cpu(read), kPoll);
    EXPECT_EQ(value, 0u);
}

TEST_F(DeviceResults, results_come_in_the_order_of_their_queries) {
    const std::vector<Query> queries(20);
    const GLint64 end = rest() + kQuery;
    for (const Query& query : queries) ask(query);
    for (std::size_t i = 0; i < queries.size(); ++i) {
        // The GPU works longer at one than the CPU.
        EXPECT_EQ(queries[i].result(), 0u);
        EXPECT_EQ(cpu(), there(end) + static_cast<GLint64>(i) * kGpuQuery);
        if (i + 1 < queries.size()) {
            EXPECT_FALSE(is_available(queries[i + 1]));
        }
    }
}

TEST_F(DeviceResults, a_time_stamp_is_where_the_gpu_is_and_comes_as_late_as_a_result) {
    const Query before;
    const Query after;
    const GLint64 start = rest();
    glQueryCounter(before.name(), GL_TIMESTAMP);
    draw(5);
    glQueryCounter(after.name(), GL_TIMESTAMP);
    EXPECT_EQ(cpu(), start + kBatch);
    const GLint64 drawn = start + kBatch + kGpuBatch + 5 * kTriangle;
    EXPECT_FALSE(is_available(after));
    GLint64 time = -1;
    glGetQueryObjecti64v(after.name(), GL_QUERY_RESULT, &time);
    EXPECT_EQ(time, drawn);
    EXPECT_EQ(cpu(), drawn + kLatency);
    glGetQueryObjecti64v(before.name(), GL_QUERY_RESULT, &time);
    EXPECT_EQ(time, start);
    EXPECT_EQ(cpu(), drawn + kLatency);
}

TEST_F(DeviceResults, a_timer_holds_what_was_done_between_its_ends_whatever_else_is_asked) {
    keep_gpu_busy();
    const Query inner;
    const Query stamp;
    EXPECT_EQ(on_gpu([&] {
                  glQueryCounter(stamp.name(), GL_TIMESTAMP);
                  draw(1);
                  ask(inner);
                  cpu();
                  EXPECT_FALSE(is_available(inner));
                  draw(2);
              }),
              2 * kGpuBatch + 3 * kTriangle + kGpuQuery);
}

// Whoever asks for a time in the midst of a query sees what has been drawn until then.
TEST_F(DeviceResults, a_query_under_way_has_drawn_what_it_has_drawn) {
    const Query query;
    const GLint64 start = rest();
    query.begin();
    draw(100);
    EXPECT_EQ(cpu(), start + kBatch);
    const GLint64 drawn = start + kBatch + kGpuBatch + 100 * kTriangle;
    EXPECT_EQ(gpu(), drawn);
    rest();
    EXPECT_EQ(on_gpu([] { draw(100); }), kBatch + kGpuBatch + 100 * kTriangle);
    EXPECT_EQ(on_gpu([] { fill(); }), kFilled * kFragment);
    EXPECT_EQ(on_cpu([&] { query.end(); }), kQuery);
    EXPECT_GT(query.result(), 0u);
}

TEST_F(DeviceResults, every_latency_of_a_query_beside_others_ends) {
    for (int ahead = 0; ahead < 5; ++ahead) {
        const std::vector<Query> queries(static_cast<std::size_t>(ahead) + 1);
        draw(100 * ahead);
        for (const Query& query : queries) ask(query);
        GLint64 polls = 1;
        while (!is_available(queries.back()) && polls < 1'000'000) ++polls;
        EXPECT_LT(polls, 1'000'000);
        for (const Query& query : queries) EXPECT_TRUE(is_available(query));
    }
}

}  // namespace
}  // namespace clock_tests
