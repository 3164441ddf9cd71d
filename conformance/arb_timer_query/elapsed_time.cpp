// SPDX-License-Identifier: MIT
// TIME_ELAPSED beside occlusion queries, alone, and beside time stamps (TIMER-01 to TIMER-04, TIMER-10).
#include <algorithm>
#include <limits>

#include "arb_timer_query/timer_test.h"

namespace conformance {
namespace {

class ElapsedTime : public TimerTest {};

constexpr GLuint64 kAnHour = 3'600'000'000'000;  // nanoseconds; no test lasts that long

// The least time that <layers> have taken in some runs, nanoseconds.
GLuint64 fastest(int layers) {
    GLuint64 least = std::numeric_limits<GLuint64>::max();
    for (int run = 0; run < 5; ++run) {
        const Query timer(GL_TIME_ELAPSED);
        timer.begin();
        work(layers);
        timer.end();
        least = std::min(least, nanoseconds_of(timer));
    }
    return least;
}

// TIMER-01. GL 4.5, 4.2: one query of each target may be active.
TEST_F(ElapsedTime, a_timer_and_an_occlusion_query_run_at_once) {
    const Query timer(GL_TIME_ELAPSED);
    const Query samples;
    timer.begin();
    draw_rect({0, 0, 3, 1}, kNear);
    samples.begin();
    EXPECT_EQ(current_query(GL_TIME_ELAPSED), static_cast<GLint>(timer.name()));
    EXPECT_EQ(current_query(GL_SAMPLES_PASSED), static_cast<GLint>(samples.name()));
    draw_rect({0, 1, 5, 1}, kNear);
    timer.end();
    draw_rect({0, 2, 7, 1}, kNear);
    samples.end();
    EXPECT_EQ(samples.result(), 12u);
    EXPECT_GT(nanoseconds_of(timer), 0u);
    EXPECT_LT(nanoseconds_of(timer), kAnHour);
    EXPECT_TRUE(no_error());
}

// TIMER-02. 5.4: "When the timer query timer is finally stopped, the elapsed time (in nanoseconds) is written
// to the corresponding query object as the query result value".
TEST_F(ElapsedTime, more_work_takes_more_time) {
    work(1);
    glFinish();
    const GLint64 before = now_in_nanoseconds();
    const GLuint64 little = fastest(1);
    const GLuint64 much = fastest(300);
    const auto all = static_cast<GLuint64>(now_in_nanoseconds() - before);
    EXPECT_GT(little, 0u);
    EXPECT_GT(much, little);
    EXPECT_LE(5 * (little + much), all) << "the runs have taken more than the time around them";
}

// TIMER-03. GL 4.5, 4.2: INVALID_OPERATION "if the active query object name for target is non-zero".
TEST_F(ElapsedTime, a_second_timer_is_refused_and_the_first_goes_on) {
    const Query first(GL_TIME_ELAPSED);
    const Query second(GL_TIME_ELAPSED);
    first.begin();
    work(10);
    second.begin();
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
    first.begin();
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
    EXPECT_EQ(current_query(GL_TIME_ELAPSED), static_cast<GLint>(first.name()));
    EXPECT_FALSE(glIsQuery(second.name()));
    first.end();
    EXPECT_GT(nanoseconds_of(first), 0u);
    first.end();
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
}

// TIMER-04. 5.4: "QueryCounter timer queries can be used within a BeginQuery / EndQuery block where the
// <target> is TIME_ELAPSED and it does not affect the result of that query object."
TEST_F(ElapsedTime, time_stamps_inside_do_not_disturb_it) {
    const Query timer(GL_TIME_ELAPSED);
    const Query first;
    const Query last;
    const GLint64 before = now_in_nanoseconds();
    timer.begin();
    glQueryCounter(first.name(), GL_TIMESTAMP);
    work(50);
    glQueryCounter(last.name(), GL_TIMESTAMP);
    EXPECT_EQ(current_query(GL_TIME_ELAPSED), static_cast<GLint>(timer.name()));
    timer.end();
    EXPECT_TRUE(no_error());
    const GLuint64 elapsed = nanoseconds_of(timer);
    const GLuint64 between = nanoseconds_of(last) - nanoseconds_of(first);
    const auto around = static_cast<GLuint64>(now_in_nanoseconds() - before);
    EXPECT_GT(nanoseconds_of(last), nanoseconds_of(first));
    EXPECT_LT(between, kAnHour);
    EXPECT_GE(elapsed, between);
    EXPECT_LE(elapsed, around);
}

// TIMER-10. HP_occlusion_test and NV_occlusion_query know nothing of timers: one around their work stays the
// same object, active, and valid.
TEST_F(ElapsedTime, occlusion_tests_of_old_do_not_disturb_it) {
    constexpr GLenum kOcclusionTest = 0x8165;
    constexpr GLenum kOcclusionTestResult = 0x8166;
    if (const auto why = lacks("GL_HP_occlusion_test")) GTEST_SKIP() << *why;
    const Query timer(GL_TIME_ELAPSED);
    const Query stamp;
    const auto expect_active = [&] {
        EXPECT_EQ(current_query(GL_TIME_ELAPSED), static_cast<GLint>(timer.name()));
    };
    const GLint64 before = now_in_nanoseconds();
    timer.begin();
    glEnable(kOcclusionTest);
    for (int round = 0; round < 5; ++round) {
        work(5);
        GLboolean flag = 0xAA;
        glGetBooleanv(kOcclusionTestResult, &flag);
        EXPECT_EQ(flag, GL_TRUE);
        glGetBooleanv(kOcclusionTestResult, &flag);
        EXPECT_EQ(flag, GL_FALSE);
        expect_active();
    }
    glDisable(kOcclusionTest);
    if (has_extension("GL_NV_occlusion_query")) {
        const auto generate = reinterpret_cast<PFNGLGENOCCLUSIONQUERIESNVPROC>(
            platform().get_proc_address("glGenOcclusionQueriesNV"));
        const auto begin = reinterpret_cast<PFNGLBEGINOCCLUSIONQUERYNVPROC>(
            platform().get_proc_address("glBeginOcclusionQueryNV"));
        const auto end = reinterpret_cast<PFNGLENDOCCLUSIONQUERYNVPROC>(
            platform().get_proc_address("glEndOcclusionQueryNV"));
        const auto get = reinterpret_cast<PFNGLGETOCCLUSIONQUERYUIVNVPROC>(
            platform().get_proc_address("glGetOcclusionQueryuivNV"));
        GLuint name = 0;
        GLuint count = kUntouched;
        generate(1, &name);
        begin(name);
        draw_rect({0, 0, 5, 1}, kNear);
        end();
        get(name, GL_PIXEL_COUNT_NV, &count);
        EXPECT_EQ(count, 5u);
        expect_active();
        glDeleteQueries(1, &name);
    }
    glQueryCounter(stamp.name(), GL_TIMESTAMP);
    timer.end();
    EXPECT_TRUE(no_error());
    EXPECT_TRUE(glIsQuery(timer.name()));
    EXPECT_EQ(current_query(GL_TIME_ELAPSED), 0);
    EXPECT_GT(nanoseconds_of(timer), 0u);
    EXPECT_LE(nanoseconds_of(timer), static_cast<GLuint64>(now_in_nanoseconds() - before));
    EXPECT_GE(nanoseconds_of(stamp), static_cast<GLuint64>(before));
}

}  // namespace
}  // namespace conformance
