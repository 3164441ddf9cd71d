// SPDX-License-Identifier: MIT
// Fences under a clock: one is signalled when everything before it is complete, late results included.
#include "latency.h"

namespace clock_tests {
namespace {

using conformance::lacks;
using conformance::Query;

constexpr GLuint64 kTenSeconds = 10'000'000'000;  // nanoseconds

// GL 4.5, 4.1: a fence becomes signalled "when all previous commands [...] are complete"; a program may
// conclude that what it has asked for is there.
class Fences : public ClockTest {
  protected:
    void SetUp() override {
        ASSERT_NO_FATAL_FAILURE(ClockTest::SetUp());
        if (const auto why = lacks(32, "GL_ARB_sync")) GTEST_SKIP() << *why;
        draw_visible();  // compiles
        glFinish();
    }

    // Ends a query and sets a fence behind it; the moment before the end.
    static Moment ask(const Query& query, GLsync& fence) {
        query.begin();
        draw_visible();
        const Moment end = now();
        query.end();
        fence = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
        return end;
    }

    static bool is_signalled(GLsync fence) {
        GLint status = 0;
        glGetSynciv(fence, GL_SYNC_STATUS, 1, nullptr, &status);
        EXPECT_TRUE(status == GL_SIGNALED || status == GL_UNSIGNALED) << status;
        return status == GL_SIGNALED;
    }

    static bool is_available(const Query& query) {
        GLuint available = GL_FALSE;
        glGetQueryObjectuiv(query.name(), GL_QUERY_RESULT_AVAILABLE, &available);
        return available == GL_TRUE;
    }
};

TEST_F(Fences, a_fence_is_not_signalled_before_the_result_before_it_is_due) {
    if (!latency().can_be_seen()) GTEST_SKIP() << "needs a latency to see something pending in";
    for (const bool waits : {false, true}) {
        while_pending([&](bool& is_as_expected) {
            const Query query;
            GLsync fence = nullptr;
            const Moment end = ask(query, fence);
            let_driver_finish();
            is_as_expected =
                waits ? glClientWaitSync(fence, GL_SYNC_FLUSH_COMMANDS_BIT, 0) == GL_TIMEOUT_EXPIRED
                      : !is_signalled(fence);
            glDeleteSync(fence);
            return end;
        });
    }
}

TEST_F(Fences, waiting_for_a_fence_ends_when_the_result_before_it_is_due) {
    const Query query;
    GLsync fence = nullptr;
    const Moment end = ask(query, fence);
    const GLenum answer = glClientWaitSync(fence, GL_SYNC_FLUSH_COMMANDS_BIT, kTenSeconds);
    EXPECT_TRUE(is_not_early(end, now()));
    EXPECT_TRUE(answer == GL_CONDITION_SATISFIED || answer == GL_ALREADY_SIGNALED) << answer;
    EXPECT_TRUE(is_signalled(fence));
    EXPECT_TRUE(is_available(query));
    EXPECT_EQ(glClientWaitSync(fence, 0, 0), static_cast<GLenum>(GL_ALREADY_SIGNALED));
    glDeleteSync(fence);
}

TEST_F(Fences, a_wait_too_short_expires_in_its_time) {
    if (latency().kind != Latency::kWall || !latency().can_be_seen()) GTEST_SKIP() << "needs wall time";
    const auto patience = std::chrono::microseconds(latency().amount) / 10;
    while_pending([&](bool& is_as_expected) {
        const Query query;
        GLsync fence = nullptr;
        const Moment end = ask(query, fence);
        let_driver_finish();
        const Moment before = now();
        const auto patience_ns = static_cast<GLuint64>(std::chrono::nanoseconds(patience).count());
        const GLenum answer = glClientWaitSync(fence, GL_SYNC_FLUSH_COMMANDS_BIT, patience_ns);
        is_as_expected = answer == GL_TIMEOUT_EXPIRED && now() - before >= patience;
        glDeleteSync(fence);
        return end;
    });
}

TEST_F(Fences, asking_for_a_fence_ends_and_then_the_result_is_there) {
    const Query query;
    GLsync fence = nullptr;
    const Moment end = ask(query, fence);
    glFlush();
    const auto deadline = now() + std::chrono::seconds(60);
    while (!is_signalled(fence)) ASSERT_LT(now(), deadline);
    EXPECT_TRUE(is_not_early(end, now()));
    EXPECT_TRUE(is_available(query));
    EXPECT_EQ(query.result(), 64u);
    glDeleteSync(fence);
}

TEST_F(Fences, a_fence_before_the_query_does_not_wait_for_it) {
    if (!latency().can_be_seen()) GTEST_SKIP() << "needs a latency to see something pending in";
    while_pending([&](bool& is_as_expected) {
        glFinish();
        GLsync fence = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
        const Query query;
        query.begin();
        const Moment end = now();
        query.end();
        const GLenum answer = glClientWaitSync(fence, GL_SYNC_FLUSH_COMMANDS_BIT, kTenSeconds);
        is_as_expected =
            (answer == GL_CONDITION_SATISFIED || answer == GL_ALREADY_SIGNALED) && !is_available(query);
        glDeleteSync(fence);
        return end;
    });
}

}  // namespace
}  // namespace clock_tests
