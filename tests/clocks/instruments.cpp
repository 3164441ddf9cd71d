// SPDX-License-Identifier: MIT
// What SGI's instruments and HP's batch of visibility tests write into the program's memory: not before it is
// due, and Finish and a Get that waits return when it is.
#include <algorithm>
#include <array>

#include "latency.h"

namespace clock_tests {
namespace {

using conformance::lacks;

constexpr GLenum kDepthPass = 0x8310;
constexpr GLenum kVisibilityTest = 0x837A;

class Measurements : public ClockTest {
  protected:
    void SetUp() override {
        ASSERT_NO_FATAL_FAILURE(ClockTest::SetUp());
        if (const auto why = lacks("GL_SGIX_depth_pass_instrument")) GTEST_SKIP() << *why;
        draw_visible();  // compiles
        glFinish();
    }

    // Measures 64 fragments into a fresh buffer; returns the moment before the Stop.
    Moment measure() {
        words.fill(-7);
        glInstrumentsBufferSGIX(8, words.data());
        glEnable(kDepthPass);
        glStartInstrumentsSGIX();
        draw_visible();
        const Moment end = now();
        glStopInstrumentsSGIX(3);
        return end;
    }

    std::array<GLint, 8> words{};
    const std::array<GLint, 8> measured = {kDepthPass, 4, 64, 3, -7, -7, -7, -7};
};

TEST_F(Measurements, neither_poll_nor_get_nor_the_buffer_shows_one_before_it_is_due) {
    if (!latency().can_be_seen()) GTEST_SKIP() << "too short a latency";
    while_pending([&](bool& is_as_expected) {
        const Moment end = measure();
        let_driver_finish();
        GLint marker = -7;
        is_as_expected = glPollInstrumentsSGIX(&marker) == 0 && marker == -7 && glGetInstrumentsSGIX() == 0 &&
                         std::all_of(words.begin(), words.end(), [](GLint word) { return word == -7; });
        return end;
    });
}

TEST_F(Measurements, one_is_there_once_it_is_due) {
    measure();
    let_pass();
    let_driver_finish();
    GLint marker = -7;
    EXPECT_EQ(glPollInstrumentsSGIX(&marker), 1);
    EXPECT_EQ(marker, 3);
    EXPECT_EQ(words, measured);
    EXPECT_EQ(glGetInstrumentsSGIX(), 4);
}

TEST_F(Measurements, polling_alone_comes_to_an_end) {
    const Moment end = measure();
    GLint marker = -7;
    int polls = 0;
    while (glPollInstrumentsSGIX(&marker) == 0) ASSERT_LT(++polls, 10'000'000);
    EXPECT_TRUE(is_not_early(end, now()));
    EXPECT_EQ(words, measured);
}

TEST_F(Measurements, finish_returns_when_they_are_due) {
    const Moment end = measure();
    glFinish();
    EXPECT_TRUE(is_not_early(end, now()));
    EXPECT_EQ(words, measured);
}

class VisibilityBatch : public ClockTest {
  protected:
    void SetUp() override {
        ASSERT_NO_FATAL_FAILURE(ClockTest::SetUp());
        if (const auto why = lacks("GL_HP_visibility_test")) GTEST_SKIP() << *why;
        buffer_ = reinterpret_cast<Buffer>(conformance::platform().get_proc_address("glVisibilityBufferHP"));
        next_ = reinterpret_cast<Next>(conformance::platform().get_proc_address("glNextVisibilityTestHP"));
        draw_visible();  // compiles
        glFinish();
    }

    // A test that sees nothing, then one that does; returns the moment before the end.
    Moment run(GLboolean waits) {
        results.fill(0xAA);
        buffer_(4, results.data(), waits);
        glEnable(kVisibilityTest);
        next_();
        draw_visible();
        const Moment end = now();
        glDisable(kVisibilityTest);
        return end;
    }
    static bool is_complete() {
        std::array<GLboolean, 2> values{};
        glGetBooleanv(kVisibilityTest, values.data());
        return values[1] == GL_TRUE;
    }

    std::array<GLubyte, 4> results{};
    const std::array<GLubyte, 4> expected = {GL_FALSE, GL_TRUE, 0xAA, 0xAA};

  private:
    using Buffer = void (*)(GLsizei, GLboolean*, GLboolean);
    using Next = void (*)();
    Buffer buffer_ = nullptr;
    Next next_ = nullptr;
};

TEST_F(VisibilityBatch, a_get_that_does_not_wait_finds_no_result_before_it_is_due) {
    if (!latency().can_be_seen()) GTEST_SKIP() << "too short a latency";
    while_pending([&](bool& is_as_expected) {
        const Moment end = run(GL_FALSE);
        let_driver_finish();
        is_as_expected = !is_complete() && results[1] == 0xAA;
        return end;
    });
}

TEST_F(VisibilityBatch, a_get_that_does_not_wait_finds_all_once_they_are_due) {
    const Moment end = run(GL_FALSE);
    int gets = 0;
    while (!is_complete()) ASSERT_LT(++gets, 10'000'000);
    EXPECT_TRUE(is_not_early(end, now()));
    EXPECT_EQ(results, expected);
}

TEST_F(VisibilityBatch, a_get_that_waits_returns_when_all_are_due) {
    const Moment end = run(GL_TRUE);
    EXPECT_TRUE(is_complete());
    EXPECT_TRUE(is_not_early(end, now()));
    EXPECT_EQ(results, expected);
}

}  // namespace
}  // namespace clock_tests
