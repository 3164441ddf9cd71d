// SPDX-License-Identifier: MIT
// Time stamps, what timer queries refuse, and their state (TIMER-05 to TIMER-09).
#include "arb_timer_query/timer_test.h"

namespace conformance {
namespace {

class TimeStamps : public TimerTest {};

// TIMER-05. Errors: INVALID_ENUM "if QueryCounter is called where <target> is not TIMESTAMP";
// INVALID_OPERATION of "a query object that is already in use inside a BeginQuery/EndQuery" and of "a query
// object whose type is not TIMESTAMP".
TEST_F(TimeStamps, other_targets_and_other_objects_are_refused) {
    const Query unused;
    for (const GLenum target : {GL_TIME_ELAPSED, GL_SAMPLES_PASSED, GL_TEXTURE_2D}) {
        glQueryCounter(unused.name(), target);
        EXPECT_TRUE(error_is(GL_INVALID_ENUM)) << target;
    }
    EXPECT_FALSE(glIsQuery(unused.name()));
    glQueryCounter(0, GL_TIMESTAMP);
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION));

    const Query samples;
    EXPECT_EQ(samples.count([&] {
        draw_rect({0, 0, 5, 1}, kNear);
        glQueryCounter(samples.name(), GL_TIMESTAMP);
        EXPECT_TRUE(error_is(GL_INVALID_OPERATION)) << "active";
    }),
              5u);
    glQueryCounter(samples.name(), GL_TIMESTAMP);
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION)) << "of another type";
    EXPECT_EQ(samples.result(), 5u);
    const Query timer(GL_TIME_ELAPSED);
    timer.begin();
    glQueryCounter(timer.name(), GL_TIMESTAMP);
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION)) << "active";
    timer.end();
}

// TIMER-05. GL 4.5, 10.7.5: between Begin and End it is INVALID_OPERATION.
TEST_F(TimeStamps, none_is_taken_between_begin_and_end) {
    const Query stamp;
    glBegin(GL_POINTS);
    glQueryCounter(stamp.name(), GL_TIMESTAMP);
    glEnd();
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
    EXPECT_FALSE(glIsQuery(stamp.name()));
}

// TIMER-06. 5.4: GetInteger64v(TIMESTAMP) returns "the GL time after all previous commands have reached the
// GL server", QueryCounter records it "after all previous commands [...] have been fully realized".
TEST_F(TimeStamps, the_time_of_a_get_is_not_later_than_that_of_a_later_stamp) {
    GLuint64 last = 0;
    for (int round = 0; round < 10; ++round) {
        const GLint64 got = now_in_nanoseconds();
        work(2);
        const Query stamp;
        glQueryCounter(stamp.name(), GL_TIMESTAMP);
        EXPECT_TRUE(glIsQuery(stamp.name()));
        EXPECT_GE(got, 0);
        EXPECT_GE(static_cast<GLuint64>(got), last);
        last = nanoseconds_of(stamp);
        EXPECT_LE(static_cast<GLuint64>(got), last);
        GLuint available = GL_FALSE;
        glGetQueryObjectuiv(stamp.name(), GL_QUERY_RESULT_AVAILABLE, &available);
        EXPECT_EQ(available, GLuint{GL_TRUE});
    }
}

// TIMER-07. 6.1.6: "if the number of bits is non-zero, the minimum number of bits allowed is 30".
TEST_F(TimeStamps, the_counters_have_no_bits_or_enough) {
    for (const GLenum target : {GL_TIME_ELAPSED, GL_TIMESTAMP}) {
        GLint bits = -1;
        glGetQueryiv(target, GL_QUERY_COUNTER_BITS, &bits);
        EXPECT_TRUE(bits == 0 || (bits >= 30 && bits <= 64)) << bits;
    }
}

// TIMER-08. 6.1.6: CURRENT_QUERY is the active query's name; a time stamp is never active.
TEST_F(TimeStamps, none_is_ever_current) {
    EXPECT_EQ(current_query(GL_TIMESTAMP), 0);
    const Query stamp;
    glQueryCounter(stamp.name(), GL_TIMESTAMP);
    EXPECT_EQ(current_query(GL_TIMESTAMP), 0);
    EXPECT_EQ(current_query(GL_TIME_ELAPSED), 0);
    glBeginQuery(GL_TIMESTAMP, stamp.name());
    EXPECT_TRUE(error_is(GL_INVALID_ENUM));
}

// TIMER-09. Errors of GetQueryObjecti64v and GetQueryObjectui64v: INVALID_OPERATION for what is no query
// object or is active, INVALID_ENUM for another <pname>; the commands of EXT_timer_query are the same by
// other names.
TEST_F(TimeStamps, the_64_bit_gets_refuse_what_the_others_refuse) {
    const auto refuses = [](auto get64, auto getu64) {
        const Query timer(GL_TIME_ELAPSED);
        const Query generated;
        GLint64 value = -5;
        GLuint64 unsigned_value = kUntouched;
        for (const GLuint name : {GLuint{0}, GLuint{0x7000}, generated.name()}) {
            get64(name, GL_QUERY_RESULT, &value);
            EXPECT_TRUE(error_is(GL_INVALID_OPERATION)) << name;
            getu64(name, GL_QUERY_RESULT, &unsigned_value);
            EXPECT_TRUE(error_is(GL_INVALID_OPERATION)) << name;
        }
        timer.begin();
        get64(timer.name(), GL_QUERY_RESULT, &value);
        EXPECT_TRUE(error_is(GL_INVALID_OPERATION)) << "active";
        getu64(timer.name(), GL_QUERY_RESULT, &unsigned_value);
        EXPECT_TRUE(error_is(GL_INVALID_OPERATION)) << "active";
        timer.end();
        get64(timer.name(), GL_QUERY_COUNTER_BITS, &value);
        EXPECT_TRUE(error_is(GL_INVALID_ENUM));
        getu64(timer.name(), GL_QUERY_COUNTER_BITS, &unsigned_value);
        EXPECT_TRUE(error_is(GL_INVALID_ENUM));
        EXPECT_EQ(value, -5);
        EXPECT_EQ(unsigned_value, kUntouched);
        get64(timer.name(), GL_QUERY_RESULT, &value);
        getu64(timer.name(), GL_QUERY_RESULT, &unsigned_value);
        EXPECT_GE(value, 0);
        EXPECT_EQ(static_cast<GLuint64>(value), unsigned_value);
        EXPECT_TRUE(no_error());
    };
    refuses(glGetQueryObjecti64v, glGetQueryObjectui64v);
    if (!has_extension("GL_EXT_timer_query")) return;
    const auto get64 = reinterpret_cast<PFNGLGETQUERYOBJECTI64VEXTPROC>(
        platform().get_proc_address("glGetQueryObjecti64vEXT"));
    const auto getu64 = reinterpret_cast<PFNGLGETQUERYOBJECTUI64VEXTPROC>(
        platform().get_proc_address("glGetQueryObjectui64vEXT"));
    ASSERT_NE(get64, nullptr);
    ASSERT_NE(getu64, nullptr);
    refuses(get64, getu64);
}

}  // namespace
}  // namespace conformance
