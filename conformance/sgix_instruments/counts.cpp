// SPDX-License-Identifier: MIT
// SGIX_depth_pass_instrument and SGIX_occlusion_instrument: what is measured (SGI-12, SGI-13, SGI-15,
// SGI-16). Every expected number is an area.
#include "sgix_instruments/instruments_test.h"

namespace conformance {
namespace {

constexpr Rect kLeft = {0, 0, 24, kSurfaceSize};  // covered by an occluder
constexpr Rect kBox = {16, 10, 20, 5};            // 8 columns before it, 12 beside it
constexpr Rect kHidden = {2, 3, 10, 10};

class InstrumentCounts : public InstrumentTest {
  protected:
    // An occluder over the left part; then depth is only tested.
    void occlude_left() {
        glEnable(GL_DEPTH_TEST);
        draw_rect(kLeft, kMiddle);
        glDepthMask(GL_FALSE);
    }
    GLuint passed(const Rect& rect, float depth) {
        return value_of(kDepthPass, [&] { draw_rect(rect, depth); });
    }
    bool occluded(const Rect& rect, float depth) {
        const GLuint flag = value_of(kOcclusion, [&] { draw_rect(rect, depth); });
        EXPECT_TRUE(flag == GL_TRUE || flag == GL_FALSE) << flag;
        return flag == GL_TRUE;
    }
};

// SGI-12. "DEPTH_PASS_INSTRUMENT_SGIX responses are formatted as follows (starting at the first word):
// DEPTH_PASS_INSTRUMENT_SGIX, Number of int's in the response (4), Counter value, Marker value".
TEST_F(InstrumentCounts, a_measurement_has_a_response_for_each_counter) {
    const GLint counters = get_integer(kDepthPassCounters);
    ASSERT_GE(counters, 1);
    ASSERT_LE(counters, kSize / 4);
    define();
    glEnable(kDepthPass);
    glStartInstrumentsSGIX();
    draw_rect(kBox, 0.0f);
    glStopInstrumentsSGIX(-3);
    EXPECT_EQ(next_marker(), -3);
    GLuint sum = 0;
    for (int i = 0; i < counters; ++i) {
        EXPECT_EQ(response(i), (Response{kDepthPass, 4, response(i).value, -3}));
        sum += response(i).value;
    }
    EXPECT_EQ(sum, 100u);
    EXPECT_TRUE(is_unwritten(4 * counters));
}

// SGI-13. "For each fragment which passes the depth test or is drawn with depth testing disabled, one counter
// is incremented by one."
TEST_F(InstrumentCounts, fragments_that_pass_the_depth_test_are_counted) {
    occlude_left();
    EXPECT_EQ(passed(kBox, kFar), 60u);
    EXPECT_EQ(passed(kBox, kNear), 100u);
    EXPECT_EQ(passed(kHidden, kFar), 0u);
    glDisable(GL_DEPTH_TEST);
    EXPECT_EQ(passed(kBox, kFar), 100u);
}

// SGI-13. A pixel counts as often as a fragment of it passes.
TEST_F(InstrumentCounts, fragments_are_counted_not_pixels) {
    EXPECT_EQ(value_of(kDepthPass,
                       [] {
                           for (int i = 0; i < 3; ++i) draw_rect(kBox, 0.5f);
                       }),
              300u);
}

// SGI-13. What never reaches the depth test does not pass it: the scissor test is before it, as are alpha and
// stencil test (GL 1.1, figure 4.1).
TEST_F(InstrumentCounts, fragments_that_fail_an_earlier_test_are_not_counted) {
    glEnable(GL_SCISSOR_TEST);
    glScissor(16, 10, 3, 2);
    EXPECT_EQ(passed(kBox, 0.5f), 6u);
    glDisable(GL_SCISSOR_TEST);
    glEnable(GL_STENCIL_TEST);
    glStencilFunc(GL_NEVER, 0, ~0u);
    EXPECT_EQ(passed(kBox, 0.5f), 0u);
    EXPECT_TRUE(occluded(kBox, 0.5f));
}

// SGI-14 of the text of the neighbour: "clear does not count"; a Clear makes no fragments.
TEST_F(InstrumentCounts, a_clear_is_not_counted) {
    EXPECT_EQ(value_of(kDepthPass, [] { clear(); }), 0u);
    EXPECT_EQ(value_of(kOcclusion, [] { clear(); }), GLuint{GL_TRUE});
}

// SGI-13. "If the increment would have caused the counter to go beyond is maximum representable value, the
// count is clamped to the maximum. The maximum value of the counters may be queried using
// DEPTH_PASS_INSTRUMENT_MAX_SGIX."
TEST_F(InstrumentCounts, a_full_counter_stays_at_its_maximum) {
    GLdouble most = -1.0;
    glGetDoublev(kDepthPassMax, &most);
    ASSERT_GE(most, 1.0);
    constexpr double kMostDrawings = 100.0;
    const double drawings = most / kWhole.area() + 1.0;
    if (drawings > kMostDrawings) GTEST_SKIP() << "the counter is too wide to be filled";
    EXPECT_EQ(value_of(kDepthPass,
                       [&] {
                           for (int i = 0; i < static_cast<int>(drawings) + 1; ++i) draw_rect(kWhole, 0.5f);
                       }),
              static_cast<GLuint>(most));
}

// SGI-13. "DEPTH_PASS_INSTRUMENT_MAX_SGIX may be as high as the maximum value of an unsigned integer"; what
// an int cannot hold is the largest int (GL 1.1, 6.1.2).
TEST_F(InstrumentCounts, every_get_tells_the_maximum) {
    GLdouble most = -1.0;
    glGetDoublev(kDepthPassMax, &most);
    EXPECT_LE(most, 4294967295.0);
    EXPECT_EQ(get_integer(kDepthPassMax), static_cast<GLint>(std::min(most, 2147483647.0)));
    GLboolean is_set = 0xAA;
    glGetBooleanv(kDepthPassMax, &is_set);
    EXPECT_EQ(is_set, GL_TRUE);
    EXPECT_TRUE(no_error());
}

// SGI-15. "The flag's initial state is TRUE and it is set to FALSE whenever a fragment generated during
// rasterization passes the depth test."
TEST_F(InstrumentCounts, the_occlusion_flag_is_true_until_a_fragment_passes) {
    occlude_left();
    EXPECT_TRUE(occluded(kHidden, kFar));
    EXPECT_FALSE(occluded(kHidden, kNear));
    EXPECT_FALSE(occluded({23, 5, 2, 1}, kFar)) << "one fragment beside the occluder";
    EXPECT_TRUE(value_of(kOcclusion, [] {})) << "nothing was drawn";
    EXPECT_EQ(value_of(kOcclusion,
                       [] {
                           draw_rect(kHidden, kNear);
                           draw_rect(kHidden, kFar);
                       }),
              GLuint{GL_FALSE})
        << "the later fragments failed";
}

// SGI-12, SGI-15. "If there are multiple instruments enabled, the measurement for each enabled instrument can
// appear in the buffer in any order for a given measurement."
TEST_F(InstrumentCounts, two_instruments_measure_side_by_side) {
    occlude_left();
    define();
    glEnable(kOcclusion);
    glEnable(kDepthPass);
    glStartInstrumentsSGIX();
    draw_rect(kBox, kFar);
    glStopInstrumentsSGIX(21);
    EXPECT_EQ(next_marker(), 21);
    const Response depth_pass{kDepthPass, 4, 60, 21};
    const Response occlusion{kOcclusion, 4, GL_FALSE, 21};
    EXPECT_TRUE((response(0) == depth_pass && response(1) == occlusion) ||
                (response(0) == occlusion && response(1) == depth_pass));
    EXPECT_TRUE(is_unwritten(8));
}

// SGI-16. "To take an instrument measurement use ReadInstrumentsSGIX." Decided: a Read changes nothing, so
// every measurement tells of all since the Start; a Start begins anew.
TEST_F(InstrumentCounts, a_read_neither_stops_nor_resets) {
    define();
    glEnable(kDepthPass);
    for (int round = 0; round < 2; ++round) {
        glStartInstrumentsSGIX();
        draw_rect({0, 0, 10, 1}, 0.5f);
        glReadInstrumentsSGIX(1);
        glReadInstrumentsSGIX(2);
        draw_rect({0, 0, 5, 1}, 0.5f);
        glStopInstrumentsSGIX(3);
        draw_rect({0, 0, 7, 1}, 0.5f);  // while nothing is started
        for (const GLint marker : {1, 2, 3}) EXPECT_EQ(next_marker(), marker);
        EXPECT_EQ(response(3 * round).value, 10u);
        EXPECT_EQ(response(3 * round + 1).value, 10u);
        EXPECT_EQ(response(3 * round + 2).value, 15u);
    }
}

// SGI-16, of the flag, whose "initial state" is that of a Start.
TEST_F(InstrumentCounts, the_flag_stays_false_from_one_read_to_the_next) {
    occlude_left();
    define();
    glEnable(kOcclusion);
    glStartInstrumentsSGIX();
    draw_rect(kHidden, kFar);
    glReadInstrumentsSGIX(1);
    draw_rect(kHidden, kNear);
    glReadInstrumentsSGIX(2);
    draw_rect(kHidden, kFar);
    glStopInstrumentsSGIX(3);
    glStartInstrumentsSGIX();
    glStopInstrumentsSGIX(4);
    for (const GLint marker : {1, 2, 3, 4}) EXPECT_EQ(next_marker(), marker);
    const std::array<GLuint, 4> expected = {GL_TRUE, GL_FALSE, GL_FALSE, GL_TRUE};
    for (int i = 0; i < 4; ++i) EXPECT_EQ(response(i).value, expected[static_cast<std::size_t>(i)]) << i;
}

// SGI-13, SGI-15. "If ..._INSTRUMENT_SGIX is enabled and instruments have been started": both at once.
// Decided: those are measured that are enabled when the measurement is asked for.
TEST_F(InstrumentCounts, an_instrument_counts_while_it_is_enabled_and_started) {
    define();
    draw_rect({0, 0, 1, 1}, 0.5f);
    glEnable(kDepthPass);
    draw_rect({0, 0, 2, 1}, 0.5f);
    glStartInstrumentsSGIX();
    draw_rect({0, 0, 4, 1}, 0.5f);
    glDisable(kDepthPass);
    draw_rect({0, 0, 8, 1}, 0.5f);
    glReadInstrumentsSGIX(1);
    glEnable(kDepthPass);
    draw_rect({0, 0, 16, 1}, 0.5f);
    glStopInstrumentsSGIX(2);
    EXPECT_EQ(next_marker(), 2) << "at the Read no instrument was enabled";
    EXPECT_EQ(response(0), (Response{kDepthPass, 4, 20, 2}));
}

// SGI-13. A measurement asked for while many are under way counts its own draws alone.
TEST_F(InstrumentCounts, a_hundred_measurements_in_flight_are_kept_apart) {
    std::vector<GLint> words(400, kUnwritten);
    glInstrumentsBufferSGIX(400, words.data());
    glEnable(kDepthPass);
    for (int i = 0; i < 100; ++i) {
        glStartInstrumentsSGIX();
        draw_rect({0, 0, 1 + i % 50, 1 + i / 50}, 0.5f);
        glStopInstrumentsSGIX(i);
    }
    for (int i = 0; i < 100; ++i) {
        ASSERT_EQ(next_marker(), i);
        const auto at = static_cast<std::size_t>(4 * i);
        EXPECT_EQ(words[at + 2], (1 + i % 50) * (1 + i / 50)) << i;
    }
    define();
}

// A primitive that is drawn for long, with reads in between, is counted whole.
TEST_F(InstrumentCounts, many_reads_of_one_start_add_up) {
    std::vector<GLint> words(1200, kUnwritten);
    glInstrumentsBufferSGIX(1200, words.data());
    glEnable(kDepthPass);
    glStartInstrumentsSGIX();
    for (int i = 0; i < 300; ++i) {
        draw_rect({0, 0, 2, 3}, 0.5f);
        glReadInstrumentsSGIX(i);
    }
    glStopInstrumentsSGIX(300);  // does not fit
    for (int i = 0; i < 300; ++i) {
        ASSERT_EQ(next_marker(), i);
        EXPECT_EQ(words[static_cast<std::size_t>(4 * i) + 2], 6 * (i + 1)) << i;
    }
    EXPECT_EQ(next_marker(), -1);
    define();
}

}  // namespace
}  // namespace conformance
