// SPDX-License-Identifier: MIT
// Counting goes on across flushes and other contexts (CNT-49, CNT-50).
#include "counting/counters.h"

namespace conformance {
namespace {

class InterruptedCounts : public CountingTest {};

COUNT_WITH_EACH(InterruptedCounts);

// CNT-49. GL 4.5, 2.3.3: Flush and Finish are about when, not about what.
TEST_P(InterruptedCounts, flush_and_finish_keep_the_count) {
    expect_count(kAll / 2 + 2, [] {
        draw_rect(kLeft, kMiddle);
        glFlush();
        draw_point(1, 1, kMiddle);
        glFinish();
        draw_point(2, 2, kMiddle);
        glFinish();
        glFlush();
    });
    expect_count(0, [] {
        glFlush();
        glFinish();
    });
}

// CNT-50. ARB: the active query is state of the context, and so are the enable and the flag of the HP test.
TEST_P(InterruptedCounts, another_context_in_between_neither_ends_nor_feeds_the_count) {
    const Context other;
    ASSERT_TRUE(other);
    const auto away_and_back = [&] {
        ASSERT_TRUE(other.make_current(surface()));
        use_pixel_coordinates();
        draw_whole();
        EXPECT_EQ(drawn_pixels(), kSize * kSize);
        come_back();
    };
    expect_count(kAll / 2, [&] {
        draw_rect(kLeft, kMiddle);
        away_and_back();
    });
    expect_count(0, away_and_back);
    expect_count(kAll / 4 + kAll / 2, [&] {
        draw_rect(kQuarter, kMiddle);
        away_and_back();
        draw_rect(kRight, kMiddle);
    });
}

// CNT-50. Being without a context for a while likewise.
TEST_P(InterruptedCounts, no_context_in_between_keeps_the_count) {
    expect_count(kAll, [&] {
        draw_rect(kLeft, kMiddle);
        Context::release_current();
        come_back();
        draw_rect(kRight, kMiddle);
    });
    expect_count(0, [&] {
        Context::release_current();
        come_back();
    });
}

}  // namespace
}  // namespace conformance
