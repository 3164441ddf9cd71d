// SPDX-License-Identifier: MIT
// Reading a result: its types, its errors, and whether it is there (ARB-27 to ARB-34, ARB-40, ARB-42,
// ARB-43).
#include <chrono>
#include <limits>

#include "arb_occlusion_query/arb_test.h"
#include "harness/objects.h"

namespace conformance {
namespace {

class Results : public ArbTest {};

// Polls without a flush until the result is there, or until no sane machine would still be working.
bool becomes_available(const Query& query) {
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    while (std::chrono::steady_clock::now() < deadline) {
        const GLuint available = get_object(query.name(), GL_QUERY_RESULT_AVAILABLE);
        EXPECT_TRUE(available == GL_TRUE || available == GL_FALSE) << available;
        if (available == GL_TRUE) return true;
    }
    return false;
}

// ARB-27. ARB 6.1.13: "If <pname> is QUERY_RESULT_ARB, then the query object's result value is placed in
// <params>."
TEST_F(Results, every_get_returns_the_same_count) {
    const Query query;
    EXPECT_EQ(query.count([] { draw_samples(1234); }), 1234u);
    GLint integer = -1;
    glGetQueryObjectiv(query.name(), GL_QUERY_RESULT, &integer);
    EXPECT_EQ(integer, 1234);
    if (lacks(33, "GL_ARB_timer_query")) return;
    GLint64 integer64 = -1;
    GLuint64 unsigned64 = kUntouched;
    glGetQueryObjecti64v(query.name(), GL_QUERY_RESULT, &integer64);
    glGetQueryObjectui64v(query.name(), GL_QUERY_RESULT, &unsigned64);
    EXPECT_EQ(integer64, 1234);
    EXPECT_EQ(unsigned64, 1234u);
}

// ARB-27. Each of them waits by itself.
TEST_F(Results, every_get_waits_for_the_count) {
    const Query query;
    const auto draw = [] { draw_samples(77); };
    query.begin();
    draw();
    query.end();
    GLint integer = -1;
    glGetQueryObjectiv(query.name(), GL_QUERY_RESULT, &integer);
    EXPECT_EQ(integer, 77);
    if (lacks(33, "GL_ARB_timer_query")) return;
    query.begin();
    draw();
    query.end();
    GLuint64 unsigned64 = kUntouched;
    glGetQueryObjectui64v(query.name(), GL_QUERY_RESULT, &unsigned64);
    EXPECT_EQ(unsigned64, 77u);
}

// ARB-28. GL 4.5, 4.2.1: a value that the type of <params> cannot hold is given as the nearest that it can.
TEST_F(Results, a_value_too_large_is_given_as_the_largest) {
    if (const auto why = lacks(33, "GL_ARB_timer_query")) GTEST_SKIP() << *why;
    const Query stamp;
    glQueryCounter(stamp.name(), GL_TIMESTAMP);
    GLuint64 nanoseconds = 0;
    glGetQueryObjectui64v(stamp.name(), GL_QUERY_RESULT, &nanoseconds);
    if (nanoseconds <= std::numeric_limits<GLuint>::max()) GTEST_SKIP() << "the clock is too young";
    GLint integer = -1;
    glGetQueryObjectiv(stamp.name(), GL_QUERY_RESULT, &integer);
    EXPECT_EQ(integer, std::numeric_limits<GLint>::max());
    EXPECT_EQ(stamp.result(), std::numeric_limits<GLuint>::max());
}

// ARB-29. ARB, Errors: INVALID_OPERATION "where <id> is the name of a currently active query object."
TEST_F(Results, an_active_object_is_not_read) {
    const Query query;
    EXPECT_EQ(query.count([&] {
        draw_samples(5);
        for (const GLenum parameter : {GL_QUERY_RESULT, GL_QUERY_RESULT_AVAILABLE}) {
            EXPECT_EQ(get_object(query.name(), parameter), kUntouched);
            EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
        }
    }),
              5u);
}

// ARB-30. ARB, Errors: INVALID_OPERATION "where <id> is not the name of a query object."
TEST_F(Results, what_is_no_object_is_not_read) {
    const Query generated;
    for (const GLuint name : {GLuint{0}, kUnknownName, generated.name()}) {
        for (const GLenum parameter : {GL_QUERY_RESULT, GL_QUERY_RESULT_AVAILABLE}) {
            GLint integer = -1;
            EXPECT_EQ(get_object(name, parameter), kUntouched);
            EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
            glGetQueryObjectiv(name, parameter, &integer);
            EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
            EXPECT_EQ(integer, -1);
        }
    }
}

// ARB-31. ARB, Errors: INVALID_ENUM "where <pname> is not QUERY_RESULT_ARB or QUERY_RESULT_AVAILABLE_ARB."
TEST_F(Results, an_unknown_parameter_is_refused) {
    const Query query;
    query.count([] { draw_samples(5); });
    for (const GLenum parameter : {GL_QUERY_COUNTER_BITS, GL_CURRENT_QUERY, GL_TEXTURE_2D}) {
        EXPECT_EQ(get_object(query.name(), parameter), kUntouched);
        EXPECT_TRUE(error_is(GL_INVALID_ENUM));
    }
    EXPECT_EQ(query.result(), 5u);
}

// ARB-32. ARB 6.1.13: "a result of TRUE means no wait would be required": it holds until the object is begun
// again.
TEST_F(Results, availability_comes_with_the_result_and_stays) {
    const Query query;
    EXPECT_EQ(query.count([] { draw_samples(5); }), 5u);
    for (int i = 0; i < 100; ++i) {
        EXPECT_EQ(get_object(query.name(), GL_QUERY_RESULT_AVAILABLE), GLuint{GL_TRUE});
        draw_samples(1);
        if (i % 10 == 0) surface().swap();
    }
}

// ARB-33, ARB-37. ARB 6.1.13: "Querying the state for a given occlusion query forces that occlusion query to
// complete within a finite amount of time." Issues: polling without a flush ends.
TEST_F(Results, polling_alone_brings_the_result) {
    for (const int samples : {5, 0, 4096}) {
        const Query query;
        query.begin();
        draw_samples(samples);
        query.end();
        EXPECT_TRUE(becomes_available(query));
        EXPECT_EQ(query.result(), static_cast<GLuint>(samples));
    }
}

// ARB-34. GL 4.5, 2.1: a Get returns what complete execution of all previous commands gives; no flush is
// asked for.
TEST_F(Results, reading_waits_and_needs_no_flush) {
    clear();
    glEnable(GL_DEPTH_TEST);
    const Query query;
    const GLuint count = query.count([] {
        for (int i = 0; i < 200; ++i) draw_rect(kWhole, 0.9f - 0.004f * static_cast<float>(i));
    });
    EXPECT_EQ(count, 200u * 4096u);
}

// ARB-40. The result is state of the object: reading does not change it.
TEST_F(Results, reading_again_gives_the_same) {
    const Query query;
    EXPECT_EQ(query.count([] { draw_samples(321); }), 321u);
    for (int i = 0; i < 10; ++i) EXPECT_EQ(query.result(), 321u);
}

// ARB-42. ARB 4.1.6A: the count is reset to zero by Begin and copied by End.
TEST_F(Results, a_query_around_nothing_gives_zero) {
    const Query query;
    query.begin();
    query.end();
    EXPECT_TRUE(becomes_available(query));
    EXPECT_EQ(query.result(), 0u);
}

// ARB-43. ARB 4.1.6A: EndQuery "initializes a copy of the current samples-passed count": later rendering is
// not in it.
TEST_F(Results, nothing_after_the_end_alters_the_result) {
    const Query query;
    query.begin();
    draw_samples(55);
    query.end();
    draw_samples(99);
    clear();
    surface().swap();
    draw_samples(11);
    EXPECT_EQ(query.result(), 55u);
    draw_samples(22);
    EXPECT_EQ(query.result(), 55u);
}

// ARB-43, of objects that were in use.
TEST_F(Results, deleting_the_framebuffer_and_the_program_does_not_alter_the_result) {
    if (const auto why = lacks(30)) GTEST_SKIP() << *why;
    const Query query;
    {
        const Framebuffer framebuffer({});
        const Program program({.vertex = kFixedVertexSource,
                               .fragment = "#version 120\nvoid main() { gl_FragColor = vec4(1.0); }\n"});
        query.begin();
        draw_samples(55);
        query.end();
    }
    EXPECT_EQ(query.result(), 55u);
}

}  // namespace
}  // namespace conformance
