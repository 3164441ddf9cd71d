// SPDX-License-Identifier: MIT
// Conditional rendering under a clock: the WAIT modes wait, the NO_WAIT modes draw until the result is due.
#include <array>

#include "latency.h"

namespace clock_tests {
namespace {

using conformance::clear;
using conformance::draw_rect;
using conformance::drawn_pixels;
using conformance::kNear;
using conformance::kWhole;
using conformance::lacks;
using conformance::Query;

struct Mode {
    GLenum name;
    bool is_inverted;
};
constexpr std::array<Mode, 4> kWaiting = {{{GL_QUERY_WAIT, false},
                                           {GL_QUERY_BY_REGION_WAIT, false},
                                           {GL_QUERY_WAIT_INVERTED, true},
                                           {GL_QUERY_BY_REGION_WAIT_INVERTED, true}}};
constexpr std::array<Mode, 4> kNotWaiting = {{{GL_QUERY_NO_WAIT, false},
                                              {GL_QUERY_BY_REGION_NO_WAIT, false},
                                              {GL_QUERY_NO_WAIT_INVERTED, true},
                                              {GL_QUERY_BY_REGION_NO_WAIT_INVERTED, true}}};

class Conditions : public ClockTest {
  protected:
    void SetUp() override {
        ASSERT_NO_FATAL_FAILURE(ClockTest::SetUp());
        if (const auto why = lacks(30, "GL_NV_conditional_render")) GTEST_SKIP() << *why;
        // The first drawing compiles shaders, which no latency outlasts.
        draw_rect(kWhole, kNear);
        drawn_pixels();
        clear();
    }

    static bool has(const Mode& mode) {
        return !mode.is_inverted || !lacks(45, "GL_ARB_conditional_render_inverted");
    }

    // Ends a query that makes a mode discard, or draw; the moment before its end.
    static Moment ask(const Query& query, bool is_visible) {
        clear();
        glFlush();
        query.begin();
        if (is_visible) draw_visible();
        const Moment end = now();
        query.end();
        return end;
    }

    static GLuint is_available(const Query& query) {
        GLuint available = GL_FALSE;
        glGetQueryObjectuiv(query.name(), GL_QUERY_RESULT_AVAILABLE, &available);
        return available;
    }

    // A rectangle beside what the query itself draws.
    static constexpr conformance::Rect kBeside = {16, 16, 10, 10};
};

TEST_F(Conditions, with_wait_drawing_begins_when_the_result_is_due_and_obeys_it) {
    for (const Mode& mode : kWaiting) {
        if (!has(mode)) continue;
        for (const bool is_visible : {false, true}) {
            const Query query;
            const Moment end = ask(query, is_visible);
            glBeginConditionalRender(query.name(), mode.name);
            EXPECT_TRUE(is_not_early(end, now())) << mode.name;
            draw_rect(kBeside, kNear);
            glEndConditionalRender();
            // By region, what contributed to no sample may be left out.
            const bool is_drawn = is_visible != mode.is_inverted;
            const bool is_open = is_drawn && (mode.name == GL_QUERY_BY_REGION_WAIT);
            if (!is_open) {
                EXPECT_EQ(drawn_pixels(kBeside), is_drawn ? kBeside.area() : 0) << mode.name;
            }
            EXPECT_EQ(is_available(query), GLuint{GL_TRUE}) << mode.name;
        }
    }
}

TEST_F(Conditions, without_wait_all_is_drawn_while_the_result_is_not_due) {
    if (!latency().can_be_seen()) GTEST_SKIP() << "needs a latency to see something pending in";
    for (const Mode& mode : kNotWaiting) {
        if (!has(mode)) continue;
        while_pending([&](bool& is_as_expected) {
            const Query query;
            const Moment end = ask(query, mode.is_inverted);
            let_driver_finish();
            glBeginConditionalRender(query.name(), mode.name);
            const Moment begun = now();
            draw_rect(kBeside, kNear);
            glEndConditionalRender();
            is_as_expected = drawn_pixels(kBeside) == kBeside.area();
            // What is done after Begin takes its time, and does not matter.
            return end + (now() - begun);
        });
    }
}

TEST_F(Conditions, without_wait_the_result_is_obeyed_once_it_is_due) {
    for (const Mode& mode : kNotWaiting) {
        if (!has(mode)) continue;
        for (const bool is_visible : {false, true}) {
            const bool is_drawn = is_visible != mode.is_inverted;
            if (is_drawn && mode.name == GL_QUERY_BY_REGION_NO_WAIT) continue;  // may be left out by region
            const Query query;
            ask(query, is_visible);
            let_pass();
            glFinish();
            glBeginConditionalRender(query.name(), mode.name);
            draw_rect(kBeside, kNear);
            glEndConditionalRender();
            EXPECT_EQ(drawn_pixels(kBeside), is_drawn ? kBeside.area() : 0) << mode.name;
        }
    }
}

// The program asks for nothing and finishes nothing: the result is obeyed from the call or frame on at which
// it is due, and under wall time as soon as the driver has it too.
TEST_F(Conditions, without_wait_time_alone_brings_the_result) {
    const Query query;
    ask(query, false);
    glFlush();
    let_pass();
    const bool is_deterministic = latency().kind != Latency::kNone && latency().kind != Latency::kWall;
    const auto deadline = now() + std::chrono::seconds(is_deterministic ? 0 : 20);
    int pixels = -1;
    do {
        clear();
        glBeginConditionalRender(query.name(), GL_QUERY_NO_WAIT);
        draw_rect(kBeside, kNear);
        glEndConditionalRender();
        pixels = drawn_pixels(kBeside);
    } while (pixels != 0 && now() < deadline);
    EXPECT_EQ(pixels, 0);
}

TEST_F(Conditions, what_begin_decided_holds_for_the_whole_block) {
    if (!latency().can_be_seen()) GTEST_SKIP() << "needs a latency to see something pending in";
    while_pending([&](bool& is_as_expected) {
        const Query query;
        const Moment end = ask(query, false);
        let_driver_finish();
        glBeginConditionalRender(query.name(), GL_QUERY_NO_WAIT);
        const Moment begun = now();
        let_pass();
        draw_rect(kBeside, kNear);
        is_as_expected = drawn_pixels(kBeside) == kBeside.area();
        glEndConditionalRender();
        return end + (now() - begun);
    });
}

TEST_F(Conditions, a_block_in_a_list_sees_the_clock_of_its_call) {
    const GLuint list = glGenLists(1);
    const Query query;
    query.count(draw_hidden);
    glNewList(list, GL_COMPILE);
    glBeginConditionalRender(query.name(), GL_QUERY_NO_WAIT);
    draw_rect(kBeside, kNear);
    glEndConditionalRender();
    glEndList();
    glCallList(list);  // what it compiles late is compiled now
    glFinish();
    if (latency().can_be_seen()) {
        while_pending([&](bool& is_as_expected) {
            const Moment end = ask(query, false);
            let_driver_finish();
            glCallList(list);
            const Moment called = now();
            is_as_expected = drawn_pixels(kBeside) == kBeside.area();
            return end + (now() - called);
        });
    }
    ask(query, false);
    let_pass();
    glFinish();
    glCallList(list);
    EXPECT_EQ(drawn_pixels(kBeside), 0);
    glDeleteLists(list, 1);
}

}  // namespace
}  // namespace clock_tests
