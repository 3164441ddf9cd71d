// SPDX-License-Identifier: MIT
// What Begin and End refuse, and that a refused call changes nothing (ARB-13, ARB-16 to ARB-26).
#include <array>

#include "arb_occlusion_query/arb_test.h"

namespace conformance {
namespace {

class BeginEnd : public ArbTest {};

constexpr GLenum kNoTarget = GL_TEXTURE_2D;

// ARB-16. ARB, Errors: "INVALID_ENUM is generated if BeginQueryARB, EndQueryARB, or GetQueryivARB is called
// where <target> is not SAMPLES_PASSED_ARB."
TEST_F(BeginEnd, an_unknown_target_is_refused) {
    const Query query;
    glBeginQuery(kNoTarget, query.name());
    EXPECT_TRUE(error_is(GL_INVALID_ENUM));
    EXPECT_FALSE(glIsQuery(query.name()));
    glEndQuery(kNoTarget);
    EXPECT_TRUE(error_is(GL_INVALID_ENUM));
}

// ARB-17. GL 4.5, 4.2: TIMESTAMP is a target of QueryCounter, not of BeginQuery; without timer queries it is
// unknown.
TEST_F(BeginEnd, a_time_stamp_is_not_begun) {
    const Query query;
    glBeginQuery(GL_TIMESTAMP, query.name());
    EXPECT_TRUE(error_is(GL_INVALID_ENUM));
    EXPECT_FALSE(glIsQuery(query.name()));
}

// ARB-18. ARB, Errors: "INVALID_OPERATION is generated if BeginQueryARB is called where <id> is zero."
TEST_F(BeginEnd, name_zero_is_refused) {
    glBeginQuery(GL_SAMPLES_PASSED, 0);
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
    EXPECT_EQ(current_query(GL_SAMPLES_PASSED), 0);
}

// ARB-19. ARB, Errors: "INVALID_OPERATION is generated if BeginQueryARB is called when a query of the given
// <target> is already active" and "where <id> is is the name of a query currently in progress."
TEST_F(BeginEnd, a_second_begin_is_refused_and_the_first_goes_on) {
    const Query first;
    const Query second;
    EXPECT_EQ(first.count([&] {
        draw_samples(3);
        for (const Query* again : {&first, &second}) {
            again->begin();
            EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
            EXPECT_EQ(current_query(GL_SAMPLES_PASSED), static_cast<GLint>(first.name()));
        }
        draw_samples(4);
    }),
              7u);
    EXPECT_FALSE(glIsQuery(second.name()));
}

// ARB-13, ARB-20. GL 4.5, 4.2: INVALID_OPERATION "if id is the name of an existing query object whose type
// does not match target" and of a query active on another target.
TEST_F(BeginEnd, an_object_keeps_its_target) {
    if (const auto why = lacks(33, "GL_ARB_timer_query")) GTEST_SKIP() << *why;
    const Query timer(GL_TIME_ELAPSED);
    timer.begin();
    glBeginQuery(GL_SAMPLES_PASSED, timer.name());
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION)) << "active on another target";
    EXPECT_EQ(current_query(GL_SAMPLES_PASSED), 0);
    EXPECT_EQ(current_query(GL_TIME_ELAPSED), static_cast<GLint>(timer.name()));
    timer.end();
    glBeginQuery(GL_SAMPLES_PASSED, timer.name());
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION)) << "of another type";
    EXPECT_EQ(current_query(GL_SAMPLES_PASSED), 0);
}

// ARB-21. GL 4.5, 10.9 (NV_conditional_render 2.14): BeginQuery of the object that conditional rendering is
// using is INVALID_OPERATION.
TEST_F(BeginEnd, the_object_of_the_conditional_rendering_in_progress_is_refused) {
    if (const auto why = lacks(30)) GTEST_SKIP() << *why;
    const Query query;
    query.count([] { draw_samples(5); });
    glBeginConditionalRender(query.name(), GL_QUERY_WAIT);
    query.begin();
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
    EXPECT_EQ(current_query(GL_SAMPLES_PASSED), 0);
    glEndConditionalRender();
}

// ARB-22. ARB, Errors: "INVALID_OPERATION is generated if EndQueryARB is called when a query of the given
// <target> is not active."
TEST_F(BeginEnd, an_end_without_begin_is_refused) {
    glEndQuery(GL_SAMPLES_PASSED);
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
    const Query query;
    EXPECT_EQ(query.count([] { draw_samples(5); }), 5u);
    query.end();
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
    EXPECT_EQ(query.result(), 5u);
}

// ARB-22, of another occlusion target.
TEST_F(BeginEnd, ending_the_wrong_target_is_refused) {
    if (const auto why = lacks(33, "GL_ARB_occlusion_query2")) GTEST_SKIP() << *why;
    const Query query;
    EXPECT_EQ(query.count([] {
        draw_samples(3);
        glEndQuery(GL_ANY_SAMPLES_PASSED);
        EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
        draw_samples(4);
    }),
              7u);
}

// ARB-23, ARB-24. GL 4.5, 4.2: BeginQuery is BeginQueryIndexed of index 0; for SAMPLES_PASSED any other index
// is INVALID_VALUE.
TEST_F(BeginEnd, only_index_zero_of_the_indexed_forms_is_accepted) {
    if (const auto why = lacks(40, "GL_ARB_transform_feedback3")) GTEST_SKIP() << *why;
    const Query query;
    GLint value = -1;
    glBeginQueryIndexed(GL_SAMPLES_PASSED, 1, query.name());
    EXPECT_TRUE(error_is(GL_INVALID_VALUE));
    glGetQueryIndexediv(GL_SAMPLES_PASSED, 1, GL_CURRENT_QUERY, &value);
    EXPECT_TRUE(error_is(GL_INVALID_VALUE));
    EXPECT_EQ(value, -1);

    glBeginQueryIndexed(GL_SAMPLES_PASSED, 0, query.name());
    EXPECT_EQ(current_query(GL_SAMPLES_PASSED), static_cast<GLint>(query.name()));
    glGetQueryIndexediv(GL_SAMPLES_PASSED, 0, GL_CURRENT_QUERY, &value);
    EXPECT_EQ(value, static_cast<GLint>(query.name()));
    draw_samples(5);
    glEndQueryIndexed(GL_SAMPLES_PASSED, 1);
    EXPECT_TRUE(error_is(GL_INVALID_VALUE));
    query.end();
    EXPECT_TRUE(no_error());
    EXPECT_EQ(query.result(), 5u);

    query.begin();
    draw_samples(6);
    glEndQueryIndexed(GL_SAMPLES_PASSED, 0);
    EXPECT_TRUE(no_error());
    EXPECT_EQ(query.result(), 6u);
}

// ARB-25. ARB, Errors: "INVALID_OPERATION is generated if any of the commands defined in this extension is
// executed between the execution of Begin and the corresponding execution of End."
TEST_F(BeginEnd, every_command_is_refused_between_begin_and_end) {
    const Query query;
    EXPECT_EQ(query.count([] { draw_samples(5); }), 5u);
    const auto refused = [](auto command) {
        glBegin(GL_POINTS);
        command();
        glEnd();
        EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
    };
    const GLuint name = query.name();
    GLuint written = kUntouched;
    auto* signed_written = reinterpret_cast<GLint*>(&written);
    GLboolean is_query = 0xAA;
    refused([&] { glGenQueries(1, &written); });
    refused([&] { glDeleteQueries(1, &name); });
    refused([&] { is_query = glIsQuery(name); });
    refused([&] { query.begin(); });
    refused([&] { glGetQueryiv(GL_SAMPLES_PASSED, GL_QUERY_COUNTER_BITS, signed_written); });
    refused([&] { glGetQueryObjectiv(name, GL_QUERY_RESULT, signed_written); });
    refused([&] { glGetQueryObjectuiv(name, GL_QUERY_RESULT, &written); });
    EXPECT_EQ(written, kUntouched);
    EXPECT_EQ(is_query, GL_FALSE);
    EXPECT_TRUE(glIsQuery(name));
    EXPECT_EQ(query.count([&] {
        refused([&] { query.end(); });
        draw_samples(6);
    }),
              6u);
}

// ARB-26. GL 4.5, 2.3.1: a command that generates an error has no other effect.
TEST_F(BeginEnd, a_refused_begin_leaves_an_unknown_name_unknown) {
    glBeginQuery(kNoTarget, kUnknownName);
    EXPECT_TRUE(error_is(GL_INVALID_ENUM));
    EXPECT_FALSE(glIsQuery(kUnknownName));
    const Query active;
    active.count([] {
        glBeginQuery(GL_SAMPLES_PASSED, kUnknownName);
        EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
    });
    EXPECT_FALSE(glIsQuery(kUnknownName));
    EXPECT_EQ(get_object(kUnknownName, GL_QUERY_RESULT_AVAILABLE), kUntouched);
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
}

}  // namespace
}  // namespace conformance
