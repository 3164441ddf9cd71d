// SPDX-License-Identifier: MIT
// GL_QUERY_BUFFER as a target of buffer objects (QBO-01, QBO-02, QBO-10, QBO-12).
#include <array>

#include "arb_query_buffer_object/query_buffer_test.h"

namespace conformance {
namespace {

class QueryBufferBinding : public QueryBufferTest {};

// QBO-01. New State: QUERY_BUFFER_BINDING, "Initial Value 0"; GL 4.5, 6.1.1 and 5.1.2: BindBuffer sets it,
// and deleting the buffer resets it.
TEST_F(QueryBufferBinding, the_binding_is_the_bound_name_or_zero) {
    EXPECT_EQ(get_integer(GL_QUERY_BUFFER_BINDING), 0);
    {
        const QueryBuffer buffer;
        EXPECT_EQ(get_integer(GL_QUERY_BUFFER_BINDING), static_cast<GLint>(buffer.name()));
        GLfloat as_float = -1.0f;
        GLdouble as_double = -1.0;
        GLboolean as_boolean = GL_FALSE;
        glGetFloatv(GL_QUERY_BUFFER_BINDING, &as_float);
        glGetDoublev(GL_QUERY_BUFFER_BINDING, &as_double);
        glGetBooleanv(GL_QUERY_BUFFER_BINDING, &as_boolean);
        EXPECT_EQ(as_float, static_cast<GLfloat>(buffer.name()));
        EXPECT_EQ(as_double, static_cast<GLdouble>(buffer.name()));
        EXPECT_EQ(as_boolean, GL_TRUE);
        glBindBuffer(GL_QUERY_BUFFER, 0);
        EXPECT_EQ(get_integer(GL_QUERY_BUFFER_BINDING), 0);
    }
    GLuint name = 0;
    glGenBuffers(1, &name);
    glBindBuffer(GL_QUERY_BUFFER, name);
    glDeleteBuffers(1, &name);
    EXPECT_EQ(get_integer(GL_QUERY_BUFFER_BINDING), 0);
}

// QBO-02. New Tokens: QUERY_BUFFER is "Accepted by the <target> parameter of BindBuffer, BufferData,
// BufferSubData, MapBuffer, UnmapBuffer, MapBufferRange, GetBufferSubData, GetBufferParameteriv,
// GetBufferParameteri64v, GetBufferPointerv, ClearBufferSubData, and the <readtarget> and <writetarget>
// parameters of CopyBufferSubData".
TEST_F(QueryBufferBinding, every_command_of_buffers_takes_the_target) {
    const QueryBuffer buffer;
    const std::array<GLuint, 4> data = {1, 2, 3, 4};
    std::array<GLuint, 4> got{};
    glBufferData(GL_QUERY_BUFFER, sizeof data, data.data(), GL_DYNAMIC_COPY);
    glGetBufferSubData(GL_QUERY_BUFFER, 0, sizeof got, got.data());
    EXPECT_EQ(got, data);
    const GLuint five = 5;
    glBufferSubData(GL_QUERY_BUFFER, 4, sizeof five, &five);
    glCopyBufferSubData(GL_QUERY_BUFFER, GL_QUERY_BUFFER, 4, 12, 4);
    glGetBufferSubData(GL_QUERY_BUFFER, 0, sizeof got, got.data());
    EXPECT_EQ(got, (std::array<GLuint, 4>{1, 5, 3, 5}));

    GLint size = -1;
    GLint64 size64 = -1;
    void* pointer = &size;
    glGetBufferParameteriv(GL_QUERY_BUFFER, GL_BUFFER_SIZE, &size);
    glGetBufferParameteri64v(GL_QUERY_BUFFER, GL_BUFFER_SIZE, &size64);
    glGetBufferPointerv(GL_QUERY_BUFFER, GL_BUFFER_MAP_POINTER, &pointer);
    EXPECT_EQ(size, 16);
    EXPECT_EQ(size64, 16);
    EXPECT_EQ(pointer, nullptr);

    auto* mapped = static_cast<GLuint*>(glMapBuffer(GL_QUERY_BUFFER, GL_READ_WRITE));
    ASSERT_NE(mapped, nullptr);
    EXPECT_EQ(mapped[1], 5u);
    glGetBufferPointerv(GL_QUERY_BUFFER, GL_BUFFER_MAP_POINTER, &pointer);
    EXPECT_EQ(pointer, mapped);
    EXPECT_TRUE(glUnmapBuffer(GL_QUERY_BUFFER));
    mapped = static_cast<GLuint*>(glMapBufferRange(GL_QUERY_BUFFER, 8, 4, GL_MAP_READ_BIT));
    ASSERT_NE(mapped, nullptr);
    EXPECT_EQ(mapped[0], 3u);
    EXPECT_TRUE(glUnmapBuffer(GL_QUERY_BUFFER));

    const GLuint nine = 9;
    glClearBufferSubData(GL_QUERY_BUFFER, GL_R32UI, 0, 8, GL_RED_INTEGER, GL_UNSIGNED_INT, &nine);
    glGetBufferSubData(GL_QUERY_BUFFER, 0, sizeof got, got.data());
    EXPECT_EQ(got, (std::array<GLuint, 4>{9, 9, 3, 5}));
    EXPECT_TRUE(no_error());
}

// QBO-10. GL 4.5, 6.3.2: "Any GL command which attempts to read from, write to, or change the state of a
// buffer object may generate an INVALID_OPERATION error if all or part of the buffer object is mapped [...]
// However, only commands which explicitly describe this error are required to do so." Decided: refused, and
// then nothing is written, or not.
TEST_F(QueryBufferBinding, a_mapped_buffer_is_refused_or_survives) {
    const Query query;
    EXPECT_EQ(query.count([] { draw_rect({0, 0, 5, 1}, kNear); }), 5u);
    const QueryBuffer buffer;
    ASSERT_NE(glMapBuffer(GL_QUERY_BUFFER, GL_READ_WRITE), nullptr);
    bool was_accepted = false;
    for (const GLenum parameter : {GL_QUERY_RESULT, GL_QUERY_RESULT_NO_WAIT, GL_QUERY_RESULT_AVAILABLE}) {
        write_object<GLuint>(query.name(), parameter, 0);
        const GLenum error = glGetError();
        EXPECT_TRUE(error == GL_INVALID_OPERATION || error == GL_NO_ERROR) << error_name(error);
        was_accepted = was_accepted || error == GL_NO_ERROR;
    }
    EXPECT_TRUE(glUnmapBuffer(GL_QUERY_BUFFER));
    EXPECT_TRUE(was_accepted || buffer.is_untouched());
    EXPECT_TRUE(buffer.is_poisoned_but(0, 4));
    buffer.poison();
    write_object<GLuint>(query.name(), GL_QUERY_RESULT, 0);
    EXPECT_TRUE(no_error());
    EXPECT_EQ(buffer.value_at<GLuint>(0), 5u);
}

// QBO-10. GL 4.5, 6.2.1: persistently mapped, "the client [may] use the GL to read from or write to the
// buffer while it is mapped".
TEST_F(QueryBufferBinding, a_persistently_mapped_buffer_is_written) {
    const Query query;
    EXPECT_EQ(query.count([] { draw_rect({0, 0, 5, 1}, kNear); }), 5u);
    GLuint name = 0;
    glGenBuffers(1, &name);
    glBindBuffer(GL_QUERY_BUFFER, name);
    constexpr GLbitfield kFlags = GL_MAP_READ_BIT | GL_MAP_PERSISTENT_BIT | GL_MAP_COHERENT_BIT;
    glBufferStorage(GL_QUERY_BUFFER, 16, nullptr, kFlags);
    const auto* mapped = static_cast<const GLuint*>(glMapBufferRange(GL_QUERY_BUFFER, 0, 16, kFlags));
    ASSERT_NE(mapped, nullptr);
    write_object<GLuint>(query.name(), GL_QUERY_RESULT, 4);
    EXPECT_TRUE(no_error());
    glFinish();
    EXPECT_EQ(mapped[1], 5u);
    glUnmapBuffer(GL_QUERY_BUFFER);
    glBindBuffer(GL_QUERY_BUFFER, 0);
    glDeleteBuffers(1, &name);
}

// QBO-12. New Tokens: QUERY_BUFFER_BARRIER_BIT is "Accepted in the <barriers> bitfield in MemoryBarrier".
TEST_F(QueryBufferBinding, the_barrier_is_accepted) {
    if (const auto why = lacks(42, "GL_ARB_shader_image_load_store")) GTEST_SKIP() << *why;
    glMemoryBarrier(GL_QUERY_BUFFER_BARRIER_BIT);
    EXPECT_TRUE(no_error());
    glMemoryBarrier(GL_QUERY_BUFFER_BARRIER_BIT | GL_COMMAND_BARRIER_BIT);
    EXPECT_TRUE(no_error());
}

}  // namespace
}  // namespace conformance
