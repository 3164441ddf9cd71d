// SPDX-License-Identifier: MIT
// Who waits for whom: Finish, fences, conditions, query buffers and pixels that are read, on each clock.
#include <array>
#include <vector>

#include "device_test.h"

namespace clock_tests {
namespace {

using conformance::kNear;
using conformance::lacks;
using conformance::Query;

class DeviceWaits : public DeviceTest {};

constexpr GLint64 kAsked =
    kQuery + kGpuQuery + kLatency;  // of a query on an idle machine, until its result is there

TEST_F(DeviceWaits, finish_waits_for_the_gpu_and_for_results) {
    // Results of before are no matter.
    GLint64 before = rest();
    draw(100);
    glFinish();
    EXPECT_EQ(cpu(), before + kBatch + kGpuBatch + 100 * kTriangle);
    const Query query;
    before = rest();
    ask(query);
    glFlush();
    EXPECT_EQ(cpu(), before + kQuery);
    glFinish();
    EXPECT_EQ(cpu(), before + kAsked);
    EXPECT_EQ(on_cpu(glFinish), 0);
    EXPECT_TRUE(is_available(query));
}

TEST_F(DeviceWaits, a_fence_is_signalled_when_a_query_in_its_place_would_be_there) {
    const GLint64 before = rest();
    draw(100);
    const GLint64 signalled = before + kBatch + kGpuBatch + 100 * kTriangle + kLatency;
    GLsync fence = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
    EXPECT_EQ(cpu(), before + kBatch);
    EXPECT_EQ(on_cpu([&] {
                  GLint status = 0;
                  glGetSynciv(fence, GL_SYNC_STATUS, 1, nullptr, &status);
                  EXPECT_EQ(status, GL_UNSIGNALED);
              }),
              kPoll);
    EXPECT_EQ(
        on_cpu([&] { EXPECT_EQ(glClientWaitSync(fence, 0, 0), static_cast<GLenum>(GL_TIMEOUT_EXPIRED)); }),
        kPoll);
    EXPECT_EQ(on_cpu([&] {
                  EXPECT_EQ(glClientWaitSync(fence, 0, 7'000), static_cast<GLenum>(GL_TIMEOUT_EXPIRED));
              }),
              7'000);
    EXPECT_EQ(glClientWaitSync(fence, 0, GL_TIMEOUT_IGNORED), static_cast<GLenum>(GL_CONDITION_SATISFIED));
    EXPECT_EQ(cpu(), signalled);
    EXPECT_EQ(on_cpu([&] {
                  EXPECT_EQ(glClientWaitSync(fence, 0, GL_TIMEOUT_IGNORED),
                            static_cast<GLenum>(GL_ALREADY_SIGNALED));
              }),
              0);
    glDeleteSync(fence);
}

TEST_F(DeviceWaits, a_condition_that_waits_holds_the_gpu_and_not_the_cpu) {
    for (const bool is_visible : {false, true}) {
        const Query query;
        conformance::clear();
        const GLint64 before = rest();
        query.begin();
        if (is_visible) fill();
        query.end();
        const GLint64 work_done = before + kQuery + kGpuQuery + (is_visible ? kFilled * kFragment : 0);
        EXPECT_EQ(on_cpu([&] { glBeginConditionalRender(query.name(), GL_QUERY_WAIT); }), 0);
        fill();
        glEndConditionalRender();
        // What is discarded is not drawn.
        const GLint64 drawn = is_visible ? kGpuBatch + kFilled * kFragment : 0;
        EXPECT_EQ(gpu(), work_done + kLatency + drawn) << is_visible;
    }
}

TEST_F(DeviceWaits, a_condition_that_does_not_wait_asks_once_and_draws_while_nothing_is_known) {
    const Query query;
    rest();
    ask(query);
    const auto condition = [&] { glBeginConditionalRender(query.name(), GL_QUERY_NO_WAIT); };
    const auto drawn_pixels = [] { return conformance::drawn_pixels({0, 0, 4, 4}); };
    EXPECT_EQ(on_cpu(condition), kPoll);
    fill();
    glEndConditionalRender();
    work(static_cast<GLuint64>(kAsked));
    EXPECT_EQ(drawn_pixels(), 16);
    conformance::clear();
    EXPECT_EQ(on_cpu(condition), kPoll);
    EXPECT_EQ(on_gpu([] { fill(); }), 0);
    glEndConditionalRender();
    EXPECT_EQ(drawn_pixels(), 0);
}

class DeviceQueryBuffers : public DeviceWaits {
  protected:
    void SetUp() override {
        ASSERT_NO_FATAL_FAILURE(DeviceWaits::SetUp());
        if (IsSkipped()) return;
        if (const auto why = lacks(45, "GL_ARB_query_buffer_object")) GTEST_SKIP() << *why;
        glGenBuffers(1, &buffer_);
        glBindBuffer(GL_COPY_WRITE_BUFFER, buffer_);
        glBufferData(GL_COPY_WRITE_BUFFER, sizeof conformance::kUntouched, &conformance::kUntouched,
                     GL_STATIC_COPY);
    }
    void TearDown() override {
        glDeleteBuffers(1, &buffer_);
        DeviceWaits::TearDown();
    }
    void write(const Query& query, GLenum parameter) const {
        glGetQueryBufferObjectuiv(query.name(), buffer_, parameter, 0);
    }
    static GLuint written() {
        GLuint value = 0;
        glGetBufferSubData(GL_COPY_WRITE_BUFFER, 0, sizeof value, &value);
        return value;
    }

  private:
    GLuint buffer_ = 0;
};

TEST_F(DeviceQueryBuffers, a_result_that_is_written_is_waited_for_by_the_gpu) {
    const Query query;
    const GLint64 before = rest();
    ask(query);
    EXPECT_EQ(on_cpu([&] { write(query, GL_QUERY_RESULT); }), 0);
    EXPECT_EQ(written(), 0u);
    EXPECT_EQ(gpu(), before + kAsked);
}

TEST_F(DeviceQueryBuffers, a_write_that_does_not_wait_is_a_poll) {
    const Query query;
    rest();
    ask(query);
    EXPECT_EQ(on_cpu([&] { write(query, GL_QUERY_RESULT_NO_WAIT); }), kPoll);
    EXPECT_EQ(written(), conformance::kUntouched);
    EXPECT_EQ(on_cpu([&] { write(query, GL_QUERY_RESULT_AVAILABLE); }), kPoll);
    EXPECT_EQ(written(), 0u);
    work(static_cast<GLuint64>(kAsked));
    EXPECT_EQ(on_cpu([&] { write(query, GL_QUERY_RESULT_AVAILABLE); }), kPoll);
    EXPECT_EQ(written(), 1u);
    EXPECT_EQ(on_cpu([&] { write(query, GL_QUERY_RESULT_NO_WAIT); }), kPoll);
    EXPECT_EQ(written(), 0u);
}

TEST_F(DeviceWaits, reading_pixels_waits_for_the_gpu_and_takes_the_cpu_time) {
    std::vector<GLubyte> pixels(4 * kWholePixels);
    const auto read = [&](GLsizei width, GLsizei height) {
        glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    };
    GLint64 before = rest();
    read(10, 20);
    EXPECT_EQ(cpu(), before + kRead + 200 * kReadPixel);
    before = rest();
    draw(100);
    read(1, 1);
    EXPECT_EQ(cpu(), before + kBatch + kGpuBatch + 100 * kTriangle + kRead + kReadPixel);
    before = rest();
    read(0, 10);
    EXPECT_EQ(cpu(), before);
    const Query query;
    query.begin();
    draw(100);
    read(1, 1);
    query.end();
    EXPECT_EQ(cpu(), before + kBatch + kGpuBatch + 100 * kTriangle + kRead + kReadPixel + kQuery);
}

TEST_F(DeviceWaits, pixels_for_a_buffer_are_not_waited_for) {
    GLuint buffer = 0;
    glGenBuffers(1, &buffer);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, buffer);
    glBufferData(GL_PIXEL_PACK_BUFFER, 4 * kWholePixels, nullptr, GL_STREAM_READ);
    const auto read = [] { glReadPixels(0, 0, 10, 20, GL_RGBA, GL_UNSIGNED_BYTE, nullptr); };
    const GLint64 before = rest();
    draw(100);
    EXPECT_EQ(on_cpu(read), kRead);
    EXPECT_EQ(gpu(), before + kBatch + kGpuBatch + 100 * kTriangle + 200 * kReadPixel);
    glDeleteBuffers(1, &buffer);
}

}  // namespace
}  // namespace clock_tests
