// SPDX-License-Identifier: MIT
// What answers in device time, and what waits in it (DEVT-10 to DEVT-17). What a thing costs is the machine's
// affair.
#include <array>
#include <vector>

#include "emu_device_time/device_time_test.h"

namespace conformance {
namespace {

class DeviceAnswers : public DeviceTimeTest {
  protected:
    void SetUp() override {
        ASSERT_NO_FATAL_FAILURE(DeviceTimeTest::SetUp());
        if (IsSkipped()) return;
        if (const auto why = lacks(15)) GTEST_SKIP() << *why;
    }
};

constexpr int kMostPolls = 1'000'000;

// DEVT-10. "QueryCounter: the GPU's clock when all work of the commands before it is done".
TEST_F(DeviceAnswers, a_stamp_is_later_than_the_work_before_it) {
    const std::array<Query, 3> stamps;
    const GLint64 before = cpu_time();
    stamp(stamps[0]);
    draw_layers(4);
    stamp(stamps[1]);
    const GLint64 made = cpu_time();
    stamp(stamps[2]);
    EXPECT_EQ(cpu_time(), made) << "a stamp does not wait";
    EXPECT_GE(time_of(stamps[0]), before);
    EXPECT_GT(time_of(stamps[1]), time_of(stamps[0]));
    EXPECT_EQ(time_of(stamps[2]), time_of(stamps[1])) << "nothing was done between the two";
}

// DEVT-11. "Queries of TIME_ELAPSED: the difference of the GPU's clock between the beginning and the end of
// the query, each rounded down".
TEST_F(DeviceAnswers, a_timer_is_the_difference_of_two_stamps) {
    if (const auto why = lacks(33, "GL_ARB_timer_query")) GTEST_SKIP() << *why;
    const Query timer(GL_TIME_ELAPSED);
    const Query first;
    const Query last;
    stamp(first);
    timer.begin();
    draw_layers(4);
    timer.end();
    stamp(last);
    EXPECT_EQ(time_of(timer), time_of(last) - time_of(first));
}

// DEVT-12. "Asking for QUERY_RESULT moves the CPU's clock up to then, if it has not come so far."
TEST_F(DeviceAnswers, a_result_that_is_read_is_waited_for_once) {
    const Query query;
    query.begin();
    draw_layers(1);
    query.end();
    EXPECT_EQ(query.result(), static_cast<GLuint>(kWhole.area()));
    const GLint64 read = cpu_time();
    EXPECT_TRUE(is_there(query));
    const GLint64 asked = cpu_time();
    EXPECT_EQ(query.result(), static_cast<GLuint>(kWhole.area()));
    EXPECT_EQ(cpu_time(), asked);
    EXPECT_GE(asked, read);
    // Had the program worked for so long, the result would have been there.
    const Query stamped;
    stamp(stamped);
    const GLint64 made = cpu_time();
    const GLint64 done = time_of(stamped);
    EXPECT_GE(cpu_time(), done);
    EXPECT_GE(cpu_time(), made);
}

// DEVT-13. "Asking for QUERY_RESULT_AVAILABLE takes a time that is not zero, so that a program that does
// nothing else comes to an end, and QUERY_RESULT_NO_WAIT the same."
TEST_F(DeviceAnswers, polling_takes_time_and_ends) {
    const bool has_no_wait = !lacks(44, "GL_ARB_query_buffer_object");
    for (const bool waits_for_value : {false, true}) {
        if (waits_for_value && !has_no_wait) continue;
        const Query query;
        draw_layers(5);
        query.begin();
        draw_layers(1);
        query.end();
        int polls = 0;
        for (bool has_come = false; !has_come && polls < kMostPolls; ++polls) {
            const GLint64 before = cpu_time();
            GLuint value = kUntouched;
            glGetQueryObjectuiv(
                query.name(), waits_for_value ? GL_QUERY_RESULT_NO_WAIT : GL_QUERY_RESULT_AVAILABLE, &value);
            has_come = waits_for_value ? value != kUntouched : value == GL_TRUE;
            ASSERT_GT(cpu_time(), before);
        }
        EXPECT_LT(polls, kMostPolls);
        const GLint64 before = cpu_time();
        EXPECT_EQ(query.result(), static_cast<GLuint>(kWhole.area()));
        EXPECT_EQ(cpu_time(), before);
    }
}

// DEVT-14. "Finish: the CPU's clock moves up to the GPU's."
TEST_F(DeviceAnswers, finish_leaves_nothing_to_be_done) {
    const Query drawn;
    draw_layers(10);
    stamp(drawn);
    glFinish();
    const GLint64 finished = cpu_time();
    EXPECT_LE(time_of(drawn), finished);
    EXPECT_EQ(cpu_time(), finished);
}

// DEVT-14. "A buffer swap waits until all work is done".
TEST_F(DeviceAnswers, a_swap_leaves_nothing_to_be_done) {
    const Query drawn;
    draw_layers(10);
    stamp(drawn);
    surface().swap();
    const GLint64 swapped = cpu_time();
    EXPECT_LE(time_of(drawn), swapped);
}

// DEVT-15. "ClientWaitSync moves the CPU's clock up to then, or by its timeout if that is less; a question
// takes what a question about a query does."
TEST_F(DeviceAnswers, a_fence_is_waited_for_in_device_time) {
    if (const auto why = lacks(32, "GL_ARB_sync")) GTEST_SKIP() << *why;
    draw_layers(50);
    const GLsync fence = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
    GLint64 before = cpu_time();
    GLint status = 0;
    glGetSynciv(fence, GL_SYNC_STATUS, 1, nullptr, &status);
    const GLint64 poll = cpu_time() - before;
    EXPECT_GT(poll, 0);
    if (status == GL_UNSIGNALED) {
        before = cpu_time();
        EXPECT_EQ(glClientWaitSync(fence, 0, 1), static_cast<GLenum>(GL_TIMEOUT_EXPIRED));
        EXPECT_EQ(cpu_time(), before + 1);
    }
    const Query drawn;
    stamp(drawn);
    EXPECT_NE(glClientWaitSync(fence, 0, GL_TIMEOUT_IGNORED), static_cast<GLenum>(GL_TIMEOUT_EXPIRED));
    const GLint64 signalled = cpu_time();
    EXPECT_GE(signalled, time_of(drawn)) << "nothing was done between the two";
    EXPECT_EQ(glClientWaitSync(fence, 0, GL_TIMEOUT_IGNORED), static_cast<GLenum>(GL_ALREADY_SIGNALED));
    glDeleteSync(fence);
}

// DEVT-16. "Conditional rendering: with a mode that waits the GPU waits for the result; with one that does
// not the CPU asks once whether it is there."
TEST_F(DeviceAnswers, a_condition_holds_the_gpu_or_takes_a_poll) {
    if (const auto why = lacks(30, "GL_NV_conditional_render")) GTEST_SKIP() << *why;
    const Query query;
    const Query after;
    query.begin();
    draw_layers(1);
    query.end();
    GLint64 before = cpu_time();
    glBeginConditionalRender(query.name(), GL_QUERY_WAIT);
    glEndConditionalRender();
    EXPECT_EQ(cpu_time(), before);
    stamp(after);
    before = cpu_time();
    is_there(query);
    const GLint64 poll = cpu_time() - before;
    before = cpu_time();
    glBeginConditionalRender(query.name(), GL_QUERY_NO_WAIT);
    EXPECT_EQ(cpu_time(), before + poll);
    glEndConditionalRender();
    // The GPU has waited, so whoever waits for what it did then has the result too.
    time_of(after);
    EXPECT_TRUE(is_there(query));
}

// DEVT-17. "ReadPixels into client memory: waits until the work before it is done, and takes a time for its
// pixels on the CPU. Into a buffer object it takes the GPU's."
TEST_F(DeviceAnswers, pixels_are_waited_for_unless_a_buffer_takes_them) {
    if (const auto why = lacks(21, "GL_ARB_pixel_buffer_object")) GTEST_SKIP() << *why;
    const Query drawn;
    const Query copied;
    draw_layers(50);
    stamp(drawn);
    GLuint buffer = 0;
    glGenBuffers(1, &buffer);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, buffer);
    glBufferData(GL_PIXEL_PACK_BUFFER, 4 * kWhole.area(), nullptr, GL_STREAM_READ);
    glReadPixels(0, 0, kSurfaceSize, kSurfaceSize, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    stamp(copied);
    const GLint64 left = cpu_time();
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    glDeleteBuffers(1, &buffer);
    std::vector<GLubyte> pixel(4);
    glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel.data());
    const GLint64 read = cpu_time();
    EXPECT_GT(time_of(copied), time_of(drawn));
    EXPECT_GT(read, time_of(copied));
    EXPECT_LT(left, read);
}

}  // namespace
}  // namespace conformance
