// SPDX-License-Identifier: MIT
// GetQueryBufferObject: results into a buffer that is bound nowhere (DSA-06 to DSA-08).
#include <chrono>
#include <limits>

#include "arb_direct_state_access/queries_test.h"

namespace conformance {
namespace {

constexpr GLenum kParameters[] = {GL_QUERY_RESULT, GL_QUERY_RESULT_NO_WAIT, GL_QUERY_RESULT_AVAILABLE};

class QueryBufferObjects : public CreatedQueriesTest {
  protected:
    void SetUp() override {
        ASSERT_NO_FATAL_FAILURE(CreatedQueriesTest::SetUp());
        if (IsSkipped()) return;
        if (const auto why = lacks(44, "GL_ARB_query_buffer_object")) GTEST_SKIP() << *why;
    }
};

// DSA-06. GL 4.5, 4.2.3: GetQueryBufferObject "returns the result into the buffer object buffer at offset".
TEST_F(QueryBufferObjects, every_get_writes_its_type_at_the_offset_and_nothing_else) {
    const Query query;
    EXPECT_EQ(query.count([] { draw_rect({0, 0, 40, 40}, kNear); }), 1600u);
    const PoisonedBuffer buffer;
    for_each_type([&](auto type) {
        using Type = decltype(type);
        for (const GLintptr offset :
             {GLintptr{0}, GLintptr{24}, PoisonedBuffer::kBytes - GLintptr{sizeof(Type)}}) {
            buffer.poison();
            write_object<Type>(query.name(), buffer.name(), GL_QUERY_RESULT, offset);
            EXPECT_TRUE(no_error());
            EXPECT_EQ(buffer.value_at<Type>(offset), Type{1600});
            EXPECT_TRUE(buffer.is_poisoned_but(offset, sizeof(Type)));
        }
    });
}

// DSA-06. Of a query that nobody has waited for.
TEST_F(QueryBufferObjects, a_pending_result_is_written_as_it_will_be) {
    const PoisonedBuffer buffer;
    for (int round = 1; round <= 5; ++round) {
        const Query query;
        query.begin();
        draw_rect({0, 0, round, 1}, kNear);
        query.end();
        write_object<GLuint>(query.name(), buffer.name(), GL_QUERY_RESULT, 4 * round);
    }
    for (GLint round = 1; round <= 5; ++round) EXPECT_EQ(buffer.value_at<GLint>(4 * round), round);
    EXPECT_TRUE(buffer.is_poisoned_but(4, 20));
}

// DSA-06. Whatever is bound to QUERY_BUFFER is neither used nor changed, and CreateQueries writes to memory.
TEST_F(QueryBufferObjects, the_bound_query_buffer_does_not_matter) {
    const PoisonedBuffer bound;
    const PoisonedBuffer named;
    glBindBuffer(GL_QUERY_BUFFER, bound.name());
    const CreatedQuery created(GL_SAMPLES_PASSED);
    EXPECT_TRUE(glIsQuery(created.name()));
    glBeginQuery(GL_SAMPLES_PASSED, created.name());
    draw_rect({0, 0, 7, 1}, kNear);
    glEndQuery(GL_SAMPLES_PASSED);
    write_object<GLuint>(created.name(), named.name(), GL_QUERY_RESULT, 0);
    EXPECT_EQ(named.value_at<GLuint>(0), 7u);
    EXPECT_TRUE(bound.is_untouched());
    EXPECT_EQ(get_integer(GL_QUERY_BUFFER_BINDING), static_cast<GLint>(bound.name()));
    glBindBuffer(GL_QUERY_BUFFER, 0);
}

// DSA-06. Every target's result is the one that the client reads.
TEST_F(QueryBufferObjects, results_of_every_target_are_written) {
    for (const GLenum target : targets()) {
        const CreatedQuery query(target);
        if (target == GL_TIMESTAMP) {
            glQueryCounter(query.name(), target);
        } else {
            glBeginQuery(target, query.name());
            draw_rect({0, 0, 5, 1}, kNear);
            glEndQuery(target);
        }
        GLuint64 in_memory = kUntouched;
        glGetQueryObjectui64v(query.name(), GL_QUERY_RESULT, &in_memory);
        const PoisonedBuffer buffer;
        write_object<GLuint64>(query.name(), buffer.name(), GL_QUERY_RESULT, 8);
        EXPECT_EQ(buffer.value_at<GLuint64>(8), in_memory) << target;
        write_object<GLuint>(query.name(), buffer.name(), GL_QUERY_TARGET, 0);
        EXPECT_EQ(buffer.value_at<GLuint>(0), target);
        EXPECT_TRUE(no_error()) << target;
    }
}

// DSA-07. GL 4.5, 4.2.3: INVALID_OPERATION "if buffer is not the name of an existing buffer object".
TEST_F(QueryBufferObjects, what_is_no_buffer_is_refused) {
    const Query query;
    EXPECT_EQ(query.count([] { draw_rect({0, 0, 5, 1}, kNear); }), 5u);
    GLuint generated = 0;
    glGenBuffers(1, &generated);
    for (const GLuint buffer : {GLuint{0x7000}, generated}) {
        for (const GLenum parameter : kParameters) {
            write_object<GLuint>(query.name(), buffer, parameter, 0);
            EXPECT_TRUE(error_is(GL_INVALID_OPERATION)) << buffer;
        }
    }
    glDeleteBuffers(1, &generated);
}

// DSA-07. GL 4.5, 4.2.3: INVALID_VALUE "if offset is negative", INVALID_OPERATION if it "would cause data to
// be written beyond the bounds".
TEST_F(QueryBufferObjects, an_offset_outside_the_buffer_is_refused) {
    const Query query;
    EXPECT_EQ(query.count([] { draw_rect({0, 0, 5, 1}, kNear); }), 5u);
    const PoisonedBuffer buffer;
    for_each_type([&](auto type) {
        using Type = decltype(type);
        constexpr GLintptr kSize = sizeof(Type);
        for (const GLenum parameter : kParameters) {
            for (const GLintptr offset : {-kSize, GLintptr{-1}, std::numeric_limits<GLintptr>::min()}) {
                write_object<Type>(query.name(), buffer.name(), parameter, offset);
                EXPECT_TRUE(error_is(GL_INVALID_VALUE)) << offset;
            }
            for (const GLintptr offset : {GLintptr{64}, 65 - kSize, GLintptr{63}, GLintptr{1} << 40}) {
                write_object<Type>(query.name(), buffer.name(), parameter, offset);
                EXPECT_TRUE(error_is(GL_INVALID_OPERATION)) << offset;
            }
        }
    });
    EXPECT_TRUE(buffer.is_untouched());
}

// DSA-07. GL 4.5, 4.2.3: the errors of id and pname are those of GetQueryObject.
TEST_F(QueryBufferObjects, unknown_queries_and_parameters_are_refused) {
    const Query query;
    EXPECT_EQ(query.count([] { draw_rect({0, 0, 5, 1}, kNear); }), 5u);
    const Query generated;
    const Query active(GL_ANY_SAMPLES_PASSED);
    active.begin();
    const PoisonedBuffer buffer;
    for_each_type([&](auto type) {
        using Type = decltype(type);
        for (const GLuint name : {GLuint{0}, GLuint{0x7000}, generated.name(), active.name()}) {
            for (const GLenum parameter : kParameters) {
                write_object<Type>(name, buffer.name(), parameter, 0);
                EXPECT_TRUE(error_is(GL_INVALID_OPERATION)) << name;
            }
        }
        for (const GLenum parameter : {GL_QUERY_COUNTER_BITS, GL_CURRENT_QUERY}) {
            write_object<Type>(query.name(), buffer.name(), parameter, 0);
            EXPECT_TRUE(error_is(GL_INVALID_ENUM)) << parameter;
        }
    });
    EXPECT_TRUE(buffer.is_untouched());
    active.end();
}

// DSA-08. GL 4.5, 4.2.3: QUERY_RESULT_NO_WAIT writes the result or nothing, QUERY_RESULT_AVAILABLE TRUE or
// FALSE.
TEST_F(QueryBufferObjects, availability_and_results_come_without_waiting) {
    const PoisonedBuffer buffer;
    const Query query;
    query.begin();
    draw_rect({0, 0, 9, 9}, kNear);
    query.end();
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    GLuint available = GL_FALSE;
    while (available != GL_TRUE && std::chrono::steady_clock::now() < deadline) {
        write_object<GLuint>(query.name(), buffer.name(), GL_QUERY_RESULT_AVAILABLE, 0);
        available = buffer.value_at<GLuint>(0);
        ASSERT_TRUE(available == GL_TRUE || available == GL_FALSE) << available;
    }
    EXPECT_EQ(available, GLuint{GL_TRUE});
    write_object<GLuint>(query.name(), buffer.name(), GL_QUERY_RESULT_NO_WAIT, 4);
    EXPECT_EQ(buffer.value_at<GLuint>(4), 81u);
    EXPECT_TRUE(buffer.is_poisoned_but(0, 8));

    query.begin();
    draw_rect({0, 0, 3, 3}, kNear);
    query.end();
    buffer.poison();
    const auto untouched = buffer.value_at<GLuint>(8);
    GLuint written = untouched;
    while (written == untouched && std::chrono::steady_clock::now() < deadline) {
        write_object<GLuint>(query.name(), buffer.name(), GL_QUERY_RESULT_NO_WAIT, 8);
        written = buffer.value_at<GLuint>(8);
    }
    EXPECT_EQ(written, 9u);
    EXPECT_TRUE(buffer.is_poisoned_but(8, 4));
}

}  // namespace
}  // namespace conformance
