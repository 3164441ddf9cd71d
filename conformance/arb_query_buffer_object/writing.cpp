// SPDX-License-Identifier: MIT
// What is written into a query buffer, where, and what is refused (QBO-03 to QBO-09).
#include <chrono>

#include "arb_query_buffer_object/query_buffer_test.h"

namespace conformance {
namespace {

class QueryBufferWriting : public QueryBufferTest {};

constexpr int kSamples = 1234;

void draw_samples() {
    draw_rect({0, 0, kSurfaceSize, 19}, kNear);
    draw_rect({0, 19, 18, 1}, kNear);
}

// Asks until an answer of <parameter> is written into the bound buffer, or until no sane machine would still
// work.
bool becomes_written(const Query& query, GLenum parameter, const QueryBuffer& buffer, GLuint expected) {
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    while (std::chrono::steady_clock::now() < deadline) {
        write_object<GLuint>(query.name(), parameter, 0);
        const auto value = buffer.value_at<GLuint>(0);
        if (value == expected) return true;
        const GLuint pending = parameter == GL_QUERY_RESULT_AVAILABLE ? GL_FALSE : poisoned<GLuint>();
        if (value != pending) return false;
    }
    return false;
}

// QBO-03, QBO-04. 4.2.1: "if a non-zero buffer object is bound as the current query result buffer [...], then
// <params> is treated as an offset into the designated buffer object."
TEST_F(QueryBufferWriting, every_get_writes_its_type_at_the_offset_and_nothing_else) {
    const Query query;
    EXPECT_EQ(query.count(draw_samples), GLuint{kSamples});
    const QueryBuffer buffer;
    for_each_type([&](auto type) {
        using Type = decltype(type);
        for (const std::size_t offset :
             {std::size_t{0}, std::size_t{8}, std::size_t{24}, 64 - sizeof(Type)}) {
            buffer.poison();
            write_object<Type>(query.name(), GL_QUERY_RESULT, static_cast<std::intptr_t>(offset));
            EXPECT_TRUE(no_error());
            EXPECT_EQ(buffer.value_at<Type>(offset), Type{kSamples});
            EXPECT_TRUE(buffer.is_poisoned_but(offset, sizeof(Type)));
        }
    });
}

// QBO-03. The same: "Initially, zero is bound to the QUERY_BUFFER binding point, indicating that <params> is
// a pointer into client memory."
TEST_F(QueryBufferWriting, without_a_buffer_the_client_s_memory_is_written_again) {
    const Query query;
    EXPECT_EQ(query.count(draw_samples), GLuint{kSamples});
    { const QueryBuffer buffer; }
    for_each_type([&](auto type) {
        decltype(type) value = 0;
        get_object(query.name(), GL_QUERY_RESULT, &value);
        EXPECT_EQ(value, decltype(type){kSamples});
    });
}

// QBO-03. The result of a query that nobody has waited for: QUERY_RESULT into a buffer is what it will be.
TEST_F(QueryBufferWriting, a_pending_result_is_written_as_it_will_be) {
    const QueryBuffer buffer;
    for (int round = 1; round <= 5; ++round) {
        const Query query;
        query.begin();
        draw_rect({0, 0, round, 1}, kNear);
        query.end();
        write_object<GLuint>(query.name(), GL_QUERY_RESULT, 4 * round);
    }
    for (GLuint round = 1; round <= 5; ++round) EXPECT_EQ(buffer.value_at<GLuint>(4 * round), round);
    EXPECT_TRUE(buffer.is_poisoned_but(4, 20));
}

// QBO-05. Errors: INVALID_OPERATION "if the command would cause data to be written beyond the bounds of the
// buffer currently bound to the QUERY_BUFFER target."
TEST_F(QueryBufferWriting, an_offset_past_the_end_is_refused) {
    const Query query;
    EXPECT_EQ(query.count(draw_samples), GLuint{kSamples});
    const QueryBuffer buffer;
    for_each_type([&](auto type) {
        using Type = decltype(type);
        constexpr auto kSize = static_cast<std::intptr_t>(sizeof(Type));
        for (const auto offset :
             {std::intptr_t{64}, std::intptr_t{65}, std::intptr_t{1} << 40, 65 - kSize, std::intptr_t{63}}) {
            for (const GLenum parameter :
                 {GL_QUERY_RESULT, GL_QUERY_RESULT_NO_WAIT, GL_QUERY_RESULT_AVAILABLE}) {
                write_object<Type>(query.name(), parameter, offset);
                EXPECT_TRUE(error_is(GL_INVALID_OPERATION)) << offset;
            }
        }
    });
    EXPECT_TRUE(buffer.is_untouched());
}

// QBO-05. A negative offset is beyond the bounds by the same words, and INVALID_VALUE as GetQueryBufferObject
// has it (GL 4.5, 4.2.3). Decided: either.
TEST_F(QueryBufferWriting, a_negative_offset_is_refused) {
    const Query query;
    EXPECT_EQ(query.count(draw_samples), GLuint{kSamples});
    const QueryBuffer buffer;
    for_each_type([&](auto type) {
        using Type = decltype(type);
        for (const auto offset : {-static_cast<std::intptr_t>(sizeof(Type)), std::intptr_t{-1}}) {
            for (const GLenum parameter :
                 {GL_QUERY_RESULT, GL_QUERY_RESULT_NO_WAIT, GL_QUERY_RESULT_AVAILABLE}) {
                write_object<Type>(query.name(), parameter, offset);
                const GLenum error = glGetError();
                EXPECT_TRUE(error == GL_INVALID_OPERATION || error == GL_INVALID_VALUE) << error_name(error);
            }
        }
    });
    EXPECT_TRUE(buffer.is_untouched());
}

// QBO-06. Issue 2: QUERY_RESULT_NO_WAIT is accepted without a buffer too; 4.2.1: "the query object's result
// value is returned as a single integer in <params> if the result is available at the time of the state
// query."
TEST_F(QueryBufferWriting, without_waiting_an_available_result_is_written) {
    const Query query;
    EXPECT_EQ(query.count(draw_samples), GLuint{kSamples});
    for_each_type([&](auto type) {
        decltype(type) value = 0;
        get_object(query.name(), GL_QUERY_RESULT_NO_WAIT, &value);
        EXPECT_EQ(value, decltype(type){kSamples});
    });
    const QueryBuffer buffer;
    for_each_type([&](auto type) {
        using Type = decltype(type);
        buffer.poison();
        write_object<Type>(query.name(), GL_QUERY_RESULT_NO_WAIT, 8);
        EXPECT_EQ(buffer.value_at<Type>(8), Type{kSamples});
        EXPECT_TRUE(buffer.is_poisoned_but(8, sizeof(Type)));
    });
}

// QBO-06, QBO-07. 4.2.1: "If the result is not available then the destination memory location is not
// overwritten."
TEST_F(QueryBufferWriting, without_waiting_the_result_is_written_or_nothing_is) {
    const QueryBuffer buffer;
    for (int round = 0; round < 10; ++round) {
        buffer.poison();
        const Query query;
        query.begin();
        draw_samples();
        query.end();
        EXPECT_TRUE(becomes_written(query, GL_QUERY_RESULT_NO_WAIT, buffer, kSamples));
        EXPECT_TRUE(buffer.is_poisoned_but(0, 4));
    }
    glBindBuffer(GL_QUERY_BUFFER, 0);
    const Query query;
    query.begin();
    draw_samples();
    query.end();
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    GLuint value = kUntouched;
    while (value == kUntouched && std::chrono::steady_clock::now() < deadline) {
        get_object(query.name(), GL_QUERY_RESULT_NO_WAIT, &value);
    }
    EXPECT_EQ(value, GLuint{kSamples});
}

// QBO-07. GL 4.5, 2.3.3: Finish returns when everything before it is complete, and with it the result.
TEST_F(QueryBufferWriting, once_all_is_finished_the_result_is_written_without_waiting) {
    const QueryBuffer buffer;
    const Query query;
    query.begin();
    draw_samples();
    query.end();
    glFinish();
    write_object<GLuint>(query.name(), GL_QUERY_RESULT_NO_WAIT, 0);
    EXPECT_EQ(buffer.value_at<GLuint>(0), GLuint{kSamples});
}

// QBO-08. 4.2.1: QUERY_RESULT_AVAILABLE is FALSE or TRUE, into a buffer as into memory.
TEST_F(QueryBufferWriting, availability_is_written_as_zero_or_one) {
    const QueryBuffer buffer;
    const Query query;
    query.begin();
    draw_samples();
    query.end();
    EXPECT_TRUE(becomes_written(query, GL_QUERY_RESULT_AVAILABLE, buffer, GL_TRUE));
    for_each_type([&](auto type) {
        using Type = decltype(type);
        buffer.poison();
        write_object<Type>(query.name(), GL_QUERY_RESULT_AVAILABLE, 16);
        EXPECT_EQ(buffer.value_at<Type>(16), Type{1});
        EXPECT_TRUE(buffer.is_poisoned_but(16, sizeof(Type)));
    });
    write_object<GLuint>(query.name(), GL_QUERY_RESULT, 0);
    EXPECT_EQ(buffer.value_at<GLuint>(0), GLuint{kSamples}) << "available means that the result is there";
}

// QBO-09. Errors: "INVALID_ENUM error is generated if <pname> is not QUERY_RESULT, QUERY_RESULT_NO_WAIT or
// QUERY_RESULT_AVAILABLE", and INVALID_OPERATION for what is no query object or is active, as before.
TEST_F(QueryBufferWriting, the_errors_are_as_without_a_buffer) {
    const Query query;
    EXPECT_EQ(query.count(draw_samples), GLuint{kSamples});
    const Query active(GL_ANY_SAMPLES_PASSED);
    active.begin();
    const Query generated;
    const QueryBuffer buffer;
    for_each_type([&](auto type) {
        using Type = decltype(type);
        for (const GLenum parameter : {GL_QUERY_COUNTER_BITS, GL_CURRENT_QUERY, GL_QUERY_BUFFER}) {
            write_object<Type>(query.name(), parameter, 0);
            EXPECT_TRUE(error_is(GL_INVALID_ENUM)) << parameter;
        }
        for (const GLuint name : {GLuint{0}, GLuint{0x7000}, generated.name(), active.name()}) {
            for (const GLenum parameter :
                 {GL_QUERY_RESULT, GL_QUERY_RESULT_NO_WAIT, GL_QUERY_RESULT_AVAILABLE}) {
                write_object<Type>(name, parameter, 0);
                EXPECT_TRUE(error_is(GL_INVALID_OPERATION)) << name;
            }
        }
    });
    EXPECT_TRUE(buffer.is_untouched());
    active.end();
}

}  // namespace
}  // namespace conformance
