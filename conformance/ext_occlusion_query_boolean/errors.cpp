// SPDX-License-Identifier: MIT
// What is refused, and that a refusal changes nothing (EXTB-02 to EXTB-07).
#include "ext_occlusion_query_boolean/es_query_test.h"

namespace conformance {
namespace {

class EsErrors : public EsQueryTest {
  protected:
    void expect_refused_begin(GLenum target, GLuint name, GLenum error = GL_INVALID_OPERATION) const {
        const GLint before = current(kAny);
        begin_query(target, name);
        EXPECT_TRUE(error_is(error));
        EXPECT_EQ(current(kAny), before);
    }
};

INSTANTIATE_TEST_SUITE_P(In, EsErrors, ::testing::Values(2, 3), es_version);

// EXTB-02. "INVALID_OPERATION is generated if <id> is not a name returned from a previous call to
// GenQueriesEXT, or if such a name has since been deleted with DeleteQueriesEXT."
TEST_P(EsErrors, a_name_that_was_not_generated_is_not_begun) {
    const GLuint name = new_name();
    expect_refused_begin(kAny, name + 1000);
    EXPECT_FALSE(is_query(name + 1000));
    delete_queries(1, &name);
    expect_refused_begin(kAny, name);
    EXPECT_FALSE(is_query(name));
}

// EXTB-03. "If BeginQueryEXT is called with an <id> of zero, [...] the error INVALID_OPERATION is generated."
TEST_P(EsErrors, name_zero_is_not_begun) {
    for (const GLenum target : kTargets) expect_refused_begin(target, 0);
}

// EXTB-03. "... if the active query object name for <target> is non-zero (for the targets
// ANY_SAMPLES_PASSED_EXT and ANY_SAMPLES_PASSED_CONSERVATIVE_EXT, if the active query for either target is
// non-zero) ... or if <id> is the active query object name for any query type".
TEST_P(EsErrors, a_second_begin_is_refused_and_the_first_goes_on) {
    for (const GLenum first : kTargets) {
        for (const GLenum second : kTargets) {
            const GLuint name = new_name();
            const GLuint other = new_name();
            begin_query(first, name);
            ASSERT_TRUE(no_error());
            draw_rect(kWhole, kMiddle);
            begin_query(second, other);
            EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
            begin_query(second, name);
            EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
            EXPECT_EQ(current(first), static_cast<GLint>(name));
            EXPECT_FALSE(is_query(other)) << "a refused begin has made an object";
            end_query(first);
            EXPECT_EQ(get(name), 1u);
        }
    }
}

// EXTB-03. "... if <id> is the name of an existing query object whose type does not match <target>".
TEST_P(EsErrors, an_object_keeps_its_target) {
    const GLuint any = new_object(kAny);
    const GLuint conservative = new_object(kConservative);
    ASSERT_TRUE(no_error());
    expect_refused_begin(kConservative, any);
    expect_refused_begin(kAny, conservative);
}

// EXTB-04. "If the active query object name for <target> is zero when EndQueryEXT is called, the error
// INVALID_OPERATION is generated."
TEST_P(EsErrors, an_end_without_begin_is_refused) {
    for (const GLenum target : kTargets) {
        end_query(target);
        EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
    }
    const GLuint name = new_name();
    begin_query(kAny, name);
    end_query(kConservative);
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
    EXPECT_EQ(current(kAny), static_cast<GLint>(name));
    end_query(kAny);
}

// EXTB-04. "INVALID_ENUM is generated if BeginQueryEXT, EndQueryEXT, or GetQueryivEXT is called where
// <target> is not ANY_SAMPLES_PASSED_EXT or ANY_SAMPLES_PASSED_CONSERVATIVE_EXT."
TEST_P(EsErrors, other_targets_are_refused) {
    const GLuint name = new_name();
    for (const GLenum target : {static_cast<GLenum>(GL_SAMPLES_PASSED), static_cast<GLenum>(GL_TEXTURE_2D)}) {
        expect_refused_begin(target, name, GL_INVALID_ENUM);
        end_query(target);
        EXPECT_TRUE(error_is(GL_INVALID_ENUM));
        EXPECT_EQ(current(target), -1);
        EXPECT_TRUE(error_is(GL_INVALID_ENUM));
    }
    EXPECT_FALSE(is_query(name));
}

// EXTB-05. "INVALID_ENUM is generated if GetQueryivEXT is called where <pname> is not CURRENT_QUERY_EXT."
TEST_P(EsErrors, other_parameters_of_a_target_are_refused) {
    for (const GLenum parameter : {GL_QUERY_RESULT, GL_QUERY_RESULT_AVAILABLE, GL_TEXTURE_2D}) {
        GLint value = -1;
        get_query(kAny, parameter, &value);
        EXPECT_TRUE(error_is(GL_INVALID_ENUM)) << std::hex << parameter;
        EXPECT_EQ(value, -1);
    }
}

// EXTB-05. As above, but EXT_disjoint_timer_query, 6.1.9, where it is supported: "If <pname> is
// QUERY_COUNTER_BITS_EXT, the implementation-dependent number of bits used to hold the query result for
// <target>".
TEST_P(EsErrors, the_counters_bits_are_told_only_with_timer_queries) {
    for (const GLenum target : kTargets) {
        GLint bits = -1;
        get_query(target, GL_QUERY_COUNTER_BITS, &bits);
        if (has_extension("GL_EXT_disjoint_timer_query")) {
            EXPECT_TRUE(no_error());
            EXPECT_GE(bits, 0) << "nothing was written";
        } else {
            EXPECT_TRUE(error_is(GL_INVALID_ENUM));
            EXPECT_EQ(bits, -1);
        }
    }
}

// EXTB-06. "INVALID_OPERATION is generated if GetQueryObjectuivEXT is called where <id> is not the name of a
// query object", "... of a currently active query object".
TEST_P(EsErrors, what_is_no_ended_query_is_not_read) {
    const GLuint generated = new_name();
    const GLuint deleted = new_object();
    delete_queries(1, &deleted);
    const GLuint active = new_name();
    begin_query(kAny, active);
    for (const GLuint name : {0u, generated, deleted, active + 1000, active}) {
        for (const GLenum parameter : {GL_QUERY_RESULT, GL_QUERY_RESULT_AVAILABLE}) {
            EXPECT_EQ(get(name, parameter), kUntouched) << name;
            EXPECT_TRUE(error_is(GL_INVALID_OPERATION)) << name;
        }
    }
    end_query(kAny);
}

// EXTB-06. "INVALID_ENUM is generated if GetQueryObjectuivEXT is called where <pname> is not QUERY_RESULT_EXT
// or QUERY_RESULT_AVAILABLE_EXT."
TEST_P(EsErrors, an_unknown_parameter_of_an_object_is_refused) {
    const GLuint name = new_object();
    for (const GLenum parameter : {GL_CURRENT_QUERY, GL_QUERY_COUNTER_BITS, GL_TEXTURE_2D}) {
        EXPECT_EQ(get(name, parameter), kUntouched);
        EXPECT_TRUE(error_is(GL_INVALID_ENUM)) << std::hex << parameter;
    }
}

// EXTB-07. "INVALID_VALUE is generated if GenQueriesEXT [DeleteQueriesEXT] is called where <n> is negative."
TEST_P(EsErrors, a_negative_count_is_refused) {
    GLuint untouched = kUntouched;
    gen_queries(-1, &untouched);
    EXPECT_TRUE(error_is(GL_INVALID_VALUE));
    EXPECT_EQ(untouched, kUntouched);
    const GLuint name = new_object();
    delete_queries(-1, &name);
    EXPECT_TRUE(error_is(GL_INVALID_VALUE));
    EXPECT_TRUE(is_query(name));
}

}  // namespace
}  // namespace conformance
