// SPDX-License-Identifier: MIT
// What the tests of GL_ARB_query_buffer_object share: the fixture, and a query buffer whose every byte is
// known before something is written into it.
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <type_traits>
#include <vector>

#include "harness/gl_test.h"
#include "harness/query.h"

namespace conformance {

class QueryBufferTest : public GlTest {
  protected:
    void SetUp() override {
        ASSERT_NO_FATAL_FAILURE(GlTest::SetUp());
        if (const auto why = lacks(44, "GL_ARB_query_buffer_object")) GTEST_SKIP() << *why;
    }
};

inline constexpr unsigned char kPoison = 0xAB;

// A buffer of so many poisoned bytes, bound to GL_QUERY_BUFFER while it lives.
class QueryBuffer {
  public:
    explicit QueryBuffer(std::size_t bytes = 64) : bytes_(bytes) {
        glGenBuffers(1, &name_);
        glBindBuffer(GL_QUERY_BUFFER, name_);
        poison();
    }
    ~QueryBuffer() {
        glBindBuffer(GL_QUERY_BUFFER, 0);
        glDeleteBuffers(1, &name_);
    }
    QueryBuffer(const QueryBuffer&) = delete;
    QueryBuffer& operator=(const QueryBuffer&) = delete;

    GLuint name() const { return name_; }
    std::size_t size() const { return bytes_; }

    void poison() const {
        const std::vector<unsigned char> poison(bytes_, kPoison);
        glBindBuffer(GL_COPY_WRITE_BUFFER, name_);
        glBufferData(GL_COPY_WRITE_BUFFER, static_cast<GLsizeiptr>(bytes_), poison.data(), GL_DYNAMIC_COPY);
    }

    std::vector<unsigned char> contents() const {
        std::vector<unsigned char> bytes(bytes_);
        glBindBuffer(GL_COPY_READ_BUFFER, name_);
        glGetBufferSubData(GL_COPY_READ_BUFFER, 0, static_cast<GLsizeiptr>(bytes_), bytes.data());
        return bytes;
    }

    template <typename Value>
    Value value_at(std::size_t offset) const {
        Value value{};
        std::memcpy(&value, contents().data() + offset, sizeof value);
        return value;
    }

    // Nothing but <bytes> bytes from <offset> on has been written.
    ::testing::AssertionResult is_poisoned_but(std::size_t offset, std::size_t bytes) const {
        const auto all = contents();
        for (std::size_t i = 0; i < all.size(); ++i) {
            if ((i < offset || i >= offset + bytes) && all[i] != kPoison) {
                return ::testing::AssertionFailure() << "byte " << i << " was written";
            }
        }
        return ::testing::AssertionSuccess();
    }
    ::testing::AssertionResult is_untouched() const { return is_poisoned_but(0, 0); }

  private:
    std::size_t bytes_;
    GLuint name_ = 0;
};

template <typename Value>
Value poisoned() {
    Value value{};
    std::memset(&value, kPoison, sizeof value);
    return value;
}

inline void* to_offset(std::intptr_t offset) {
    return reinterpret_cast<void*>(offset);
}

// GetQueryObject{i,ui,i64,ui64}v by the type of what it writes.
inline void get_object(GLuint name, GLenum parameter, GLint* to) {
    glGetQueryObjectiv(name, parameter, to);
}
inline void get_object(GLuint name, GLenum parameter, GLuint* to) {
    glGetQueryObjectuiv(name, parameter, to);
}
inline void get_object(GLuint name, GLenum parameter, GLint64* to) {
    glGetQueryObjecti64v(name, parameter, to);
}
inline void get_object(GLuint name, GLenum parameter, GLuint64* to) {
    glGetQueryObjectui64v(name, parameter, to);
}

// The same into the bound query buffer.
template <typename Value>
void write_object(GLuint name, GLenum parameter, std::intptr_t offset) {
    get_object(name, parameter, static_cast<Value*>(to_offset(offset)));
}

// Calls <body> with a value of each of the four types, of which only the type matters.
template <typename Body>
void for_each_type(Body body) {
    body(GLint{});
    body(GLuint{});
    body(GLint64{});
    body(GLuint64{});
}

}  // namespace conformance
