// SPDX-License-Identifier: MIT
// CreateQueries: objects at once, of every target (DSA-01 to DSA-05).
#include <array>
#include <set>

#include "arb_direct_state_access/queries_test.h"

namespace conformance {
namespace {

class CreateQueries : public CreatedQueriesTest {};

// DSA-01, DSA-02, DSA-05. GL 4.5, 4.2: "CreateQueries returns n previously unused query object names in ids,
// each representing a new query object with the specified target"; its state is that of table 23.32: result
// 0, available.
TEST_F(CreateQueries, objects_of_every_target_exist_at_once) {
    for (const GLenum target : targets()) {
        const CreatedQuery query(target);
        EXPECT_TRUE(no_error()) << target;
        ASSERT_NE(query.name(), kUntouched) << target;
        EXPECT_TRUE(glIsQuery(query.name())) << target;
        EXPECT_EQ(get_object(query.name(), GL_QUERY_TARGET), target);
        EXPECT_EQ(get_object(query.name(), GL_QUERY_RESULT_AVAILABLE), GLuint{GL_TRUE}) << target;
        EXPECT_EQ(get_object(query.name(), GL_QUERY_RESULT), 0u) << target;
        EXPECT_TRUE(no_error()) << target;
    }
}

// DSA-01. They are queries like any other.
TEST_F(CreateQueries, created_objects_count) {
    const CreatedQuery query(GL_SAMPLES_PASSED);
    for (const int count : {5, 0, 9}) {
        glBeginQuery(GL_SAMPLES_PASSED, query.name());
        EXPECT_EQ(current_query(GL_SAMPLES_PASSED), static_cast<GLint>(query.name()));
        draw_rect({0, 0, count, 1}, kNear);
        glEndQuery(GL_SAMPLES_PASSED);
        EXPECT_EQ(get_object(query.name(), GL_QUERY_RESULT), static_cast<GLuint>(count));
        EXPECT_EQ(get_object(query.name(), GL_QUERY_TARGET), GLuint{GL_SAMPLES_PASSED});
    }
}

// DSA-01. Names of one space with GenQueries.
TEST_F(CreateQueries, names_are_distinct_and_never_zero) {
    std::set<GLuint> names;
    for (int round = 0; round < 3; ++round) {
        std::array<GLuint, 10> generated{};
        std::array<GLuint, 10> created{};
        glGenQueries(10, generated.data());
        glCreateQueries(GL_SAMPLES_PASSED, 10, created.data());
        names.insert(generated.begin(), generated.end());
        names.insert(created.begin(), created.end());
        for (const GLuint name : created) EXPECT_TRUE(glIsQuery(name));
        for (const GLuint name : generated) EXPECT_FALSE(glIsQuery(name));
    }
    EXPECT_EQ(names.size(), 60u);
    EXPECT_EQ(names.count(0), 0u);
    for (const GLuint name : names) glDeleteQueries(1, &name);
    for (const GLuint name : names) EXPECT_FALSE(glIsQuery(name));
}

// DSA-02. GL 4.5, 4.2: "An INVALID_ENUM error is generated if target is not one of the valid values".
TEST_F(CreateQueries, an_unknown_target_is_refused) {
    for (const GLenum target :
         {GLenum{0}, GLenum{GL_TEXTURE_2D}, GLenum{GL_QUERY_BUFFER}, GLenum{GL_QUERY_RESULT}}) {
        GLuint name = kUntouched;
        glCreateQueries(target, 1, &name);
        EXPECT_TRUE(error_is(GL_INVALID_ENUM)) << target;
        EXPECT_EQ(name, kUntouched);
    }
}

// DSA-03. GL 4.5, 2.3.1: a negative count is INVALID_VALUE.
TEST_F(CreateQueries, creating_none_or_less_writes_nothing) {
    GLuint name = kUntouched;
    glCreateQueries(GL_SAMPLES_PASSED, -1, &name);
    EXPECT_TRUE(error_is(GL_INVALID_VALUE));
    EXPECT_EQ(name, kUntouched);
    glCreateQueries(GL_SAMPLES_PASSED, 0, &name);
    EXPECT_TRUE(no_error());
    EXPECT_EQ(name, kUntouched);
}

// DSA-04. GL 4.5, 4.2: INVALID_OPERATION "if id is the name of an existing query object whose type does not
// match target".
TEST_F(CreateQueries, an_object_is_begun_on_the_target_that_it_was_created_with) {
    const CreatedQuery samples(GL_SAMPLES_PASSED);
    const CreatedQuery timer(GL_TIME_ELAPSED);
    const CreatedQuery stamp(GL_TIMESTAMP);
    glBeginQuery(GL_TIME_ELAPSED, samples.name());
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
    glBeginQuery(GL_ANY_SAMPLES_PASSED, samples.name());
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
    glBeginQuery(GL_SAMPLES_PASSED, timer.name());
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
    glBeginQuery(GL_SAMPLES_PASSED, stamp.name());
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
    glQueryCounter(samples.name(), GL_TIMESTAMP);
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
    for (const GLenum target : {GL_SAMPLES_PASSED, GL_ANY_SAMPLES_PASSED, GL_TIME_ELAPSED}) {
        EXPECT_EQ(current_query(target), 0);
    }
    EXPECT_EQ(get_object(samples.name(), GL_QUERY_TARGET), GLuint{GL_SAMPLES_PASSED});
}

}  // namespace
}  // namespace conformance
