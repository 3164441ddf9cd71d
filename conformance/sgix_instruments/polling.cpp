// SPDX-License-Identifier: MIT
// SGIX_instruments: how a program learns of measurements, and of an overflow (SGI-08 to SGI-10).
#include "sgix_instruments/instruments_test.h"

namespace conformance {
namespace {

class Polling : public InstrumentTest {
  protected:
    // Measurements of <count> fragments each, with markers from 1.
    static void take(int measurements, int count = 7) {
        for (int marker = 1; marker <= measurements; ++marker) {
            glStartInstrumentsSGIX();
            draw_rect({0, 0, count, 1}, 0.0f);
            glStopInstrumentsSGIX(marker);
        }
    }
};

// SGI-08. "If a new measurement has appeared in the buffer since the last call to PollInstrumentsSGIX, 1 will
// be returned, otherwise zero is returned. If 1 is returned, the value of marker associated with the
// measurement ... is written into the integer referred to by <markerp>."
TEST_F(Polling, a_poll_tells_of_each_measurement_once) {
    define();
    GLint marker = kUnwritten;
    EXPECT_EQ(glPollInstrumentsSGIX(&marker), 0);
    glEnable(kDepthPass);
    glStartInstrumentsSGIX();
    glStopInstrumentsSGIX(-15);
    EXPECT_EQ(next_marker(), -15);
    for (int poll = 0; poll < 3; ++poll) EXPECT_EQ(glPollInstrumentsSGIX(&marker), 0);
    EXPECT_EQ(marker, kUnwritten);
}

// SGI-08. "The measurements will appear in the buffer in the order in which they were requested."
TEST_F(Polling, measurements_come_in_the_order_of_their_requests) {
    define();
    glEnable(kDepthPass);
    glStartInstrumentsSGIX();
    for (const GLint marker : {30, 10, 20}) {
        draw_rect({0, 0, 5, 1}, 0.0f);
        glReadInstrumentsSGIX(marker);
    }
    draw_rect({0, 0, 3, 1}, 0.0f);
    glStopInstrumentsSGIX(10);  // markers need not differ
    for (const GLint marker : {30, 10, 20, 10}) EXPECT_EQ(next_marker(), marker);
    EXPECT_EQ(response(0), (Response{kDepthPass, 4, 5, 30}));
    EXPECT_EQ(response(1), (Response{kDepthPass, 4, 10, 10}));
    EXPECT_EQ(response(2), (Response{kDepthPass, 4, 15, 20}));
    EXPECT_EQ(response(3), (Response{kDepthPass, 4, 18, 10}));
}

// SGI-08. A poll that returns 1 says that the measurement "has appeared in the buffer".
TEST_F(Polling, a_measurement_is_in_the_buffer_when_a_poll_tells_of_it) {
    define();
    glEnable(kDepthPass);
    take(16);
    for (int i = 0; i < 16; ++i) {
        ASSERT_EQ(next_marker(), i + 1);
        EXPECT_EQ(response(i), (Response{kDepthPass, 4, 7, i + 1}));
    }
}

// SGI-08. GL 1.1, 5.5, of Finish: "all effects from previous commands ... are fully realized".
TEST_F(Polling, after_finish_all_measurements_are_there) {
    define();
    glEnable(kDepthPass);
    take(3);
    glFinish();
    for (int i = 0; i < 3; ++i) EXPECT_EQ(response(i), (Response{kDepthPass, 4, 7, i + 1}));
    GLint marker = kUnwritten;
    for (int i = 1; i <= 3; ++i) {
        EXPECT_EQ(glPollInstrumentsSGIX(&marker), 1);
        EXPECT_EQ(marker, i);
    }
    EXPECT_EQ(glPollInstrumentsSGIX(&marker), 0);
}

// SGI-08. "An implementation may choose to delay reporting the overflow until the measurement that caused the
// overflow is the one being polled." Decided: it does, and each measurement that did not fit is told of once;
// nothing of it is written, nor past the size.
TEST_F(Polling, a_measurement_that_does_not_fit_is_reported_in_its_turn) {
    define(10);
    glEnable(kDepthPass);
    take(4);
    EXPECT_EQ(next_marker(), 1);
    EXPECT_EQ(next_marker(), 2);
    GLint marker = kUnwritten;
    EXPECT_EQ(glPollInstrumentsSGIX(&marker), -1);
    EXPECT_EQ(glPollInstrumentsSGIX(&marker), -1);
    EXPECT_EQ(glPollInstrumentsSGIX(&marker), 0);
    EXPECT_EQ(marker, kUnwritten);
    EXPECT_TRUE(is_unwritten(8));
    EXPECT_EQ(get_integer(GL_INSTRUMENT_MEASUREMENTS_SGIX), 4) << "they were taken all the same";
}

// SGI-08, decided: after an overflow nothing is written until the buffer is reset, though it would fit.
TEST_F(Polling, after_an_overflow_nothing_is_written_until_the_reset) {
    define(10);
    glEnable(kDepthPass);
    take(1);
    glEnable(kOcclusion);
    take(1);  // eight ints
    glDisable(kOcclusion);
    take(1);
    EXPECT_EQ(next_marker(), 1);
    EXPECT_EQ(next_marker(), -1);
    EXPECT_EQ(next_marker(), -1);
    EXPECT_TRUE(is_unwritten(4));
    define(10);
    take(1);
    EXPECT_EQ(next_marker(), 1);
}

TEST_F(Polling, a_buffer_of_no_size_overflows_at_once) {
    define(0);
    glEnable(kOcclusion);
    take(1);
    EXPECT_EQ(next_marker(), -1);
    EXPECT_EQ(glGetInstrumentsSGIX(), -1);
    EXPECT_TRUE(is_unwritten(0));
}

// SGI-09. "The value returned is the number of ints that have been written to the buffer since the last call
// to GetInstrumentsSGIX. GetInstrumentsSGIX can be used independently of PollInstrumentsSGIX."
TEST_F(Polling, get_instruments_counts_the_ints_since_its_last_call) {
    define();
    glEnable(kDepthPass);
    EXPECT_EQ(glGetInstrumentsSGIX(), 0);
    take(2);
    glFinish();
    EXPECT_EQ(glGetInstrumentsSGIX(), 8);
    EXPECT_EQ(glGetInstrumentsSGIX(), 0);
    EXPECT_EQ(next_marker(), 1);
    glEnable(kOcclusion);
    take(1);
    glFinish();
    EXPECT_EQ(glGetInstrumentsSGIX(), 8);
    EXPECT_EQ(next_marker(), 2);
    EXPECT_EQ(next_marker(), 1);
}

// SGI-09. "If the buffer has been overflowed since the last call to GetInstrumentsSGIX, -1 is returned for
// the count." Decided: it stands for all ints since then, so the next count starts anew.
TEST_F(Polling, get_instruments_tells_of_an_overflow_once) {
    define(8);
    glEnable(kDepthPass);
    take(1);
    glFinish();
    EXPECT_EQ(glGetInstrumentsSGIX(), 4);
    take(2);
    glFinish();
    EXPECT_EQ(glGetInstrumentsSGIX(), -1);
    EXPECT_EQ(glGetInstrumentsSGIX(), 0);
    take(1);
    EXPECT_EQ(glGetInstrumentsSGIX(), -1) << "another measurement did not fit";
    define(8);
    EXPECT_EQ(glGetInstrumentsSGIX(), 0) << "the buffer was reset";
}

// SGI-10. The text's example: "the sum of count0 and count1 should be 2 times the size in words of an
// instrument measurement that we have enabled."
TEST_F(Polling, all_counts_together_are_the_measurements_times_their_size) {
    for (const bool both : {false, true}) {
        define();
        glEnable(kOcclusion);
        if (both) glEnable(kDepthPass);
        glStartInstrumentsSGIX();
        draw_rect(kWhole, 0.5f);
        glReadInstrumentsSGIX(14);
        draw_rect(kWhole, 0.25f);
        glStopInstrumentsSGIX(15);
        GLint sum = glGetInstrumentsSGIX();
        EXPECT_TRUE(sum == 0 || sum == (both ? 8 : 4) || sum == (both ? 16 : 8)) << sum;
        EXPECT_EQ(next_marker(), 14);
        EXPECT_EQ(next_marker(), 15);
        sum += glGetInstrumentsSGIX();
        EXPECT_EQ(sum, both ? 16 : 8);
    }
}

// A program that measures and never asks: the buffer overflows, and nothing else comes of it.
TEST_F(Polling, a_program_that_never_asks_does_no_harm) {
    define();
    glEnable(kOcclusion);
    for (int i = 0; i < 1000; ++i) {
        glStartInstrumentsSGIX();
        draw_point(i % kSurfaceSize, 0, 0.0f);
        glStopInstrumentsSGIX(i);
    }
    EXPECT_EQ(get_integer(GL_INSTRUMENT_MEASUREMENTS_SGIX), 1000);
    for (int i = 0; i < kSize / 4; ++i) EXPECT_EQ(next_marker(), i);
    for (int i = kSize / 4; i < 1000; ++i) ASSERT_EQ(next_marker(), -1);
    EXPECT_TRUE(is_unwritten(kSize));
}

}  // namespace
}  // namespace conformance
