// SPDX-License-Identifier: MIT
// What the tests of the query commands of GL_ARB_direct_state_access share: the fixture, created queries, and
// a buffer that no binding knows.
#pragma once

#include <cstring>
#include <vector>

#include "harness/gl_test.h"
#include "harness/query.h"

namespace conformance {

class CreatedQueriesTest : public GlTest {
  protected:
    void SetUp() override {
        ASSERT_NO_FATAL_FAILURE(GlTest::SetUp());
        if (const auto why = lacks(45, "GL_ARB_direct_state_access")) GTEST_SKIP() << *why;
    }

    // Every target of objects that this machine creates. ARB_pipeline_statistics_query does not name
    // CreateQueries; GL 4.6 does for the targets that it took over.
    static std::vector<GLenum> targets() {
        std::vector<GLenum> all = {GL_SAMPLES_PASSED,       GL_ANY_SAMPLES_PASSED,
                                   GL_PRIMITIVES_GENERATED, GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN,
                                   GL_TIME_ELAPSED,         GL_TIMESTAMP};
        if (!lacks(43, "GL_ARB_ES3_compatibility")) all.push_back(GL_ANY_SAMPLES_PASSED_CONSERVATIVE);
        if (!lacks(46, "GL_ARB_transform_feedback_overflow_query")) {
            all.insert(all.end(), {GL_TRANSFORM_FEEDBACK_OVERFLOW, GL_TRANSFORM_FEEDBACK_STREAM_OVERFLOW});
        }
        if (!lacks(46)) {
            all.insert(all.end(),
                       {GL_VERTICES_SUBMITTED, GL_PRIMITIVES_SUBMITTED, GL_VERTEX_SHADER_INVOCATIONS,
                        GL_TESS_CONTROL_SHADER_PATCHES, GL_TESS_EVALUATION_SHADER_INVOCATIONS,
                        GL_GEOMETRY_SHADER_INVOCATIONS, GL_GEOMETRY_SHADER_PRIMITIVES_EMITTED,
                        GL_FRAGMENT_SHADER_INVOCATIONS, GL_COMPUTE_SHADER_INVOCATIONS,
                        GL_CLIPPING_INPUT_PRIMITIVES, GL_CLIPPING_OUTPUT_PRIMITIVES});
        }
        return all;
    }
};

class CreatedQuery {
  public:
    explicit CreatedQuery(GLenum target) { glCreateQueries(target, 1, &name_); }
    ~CreatedQuery() { glDeleteQueries(1, &name_); }
    CreatedQuery(const CreatedQuery&) = delete;
    CreatedQuery& operator=(const CreatedQuery&) = delete;
    GLuint name() const { return name_; }

  private:
    GLuint name_ = kUntouched;
};

inline GLuint get_object(GLuint name, GLenum parameter) {
    GLuint value = kUntouched;
    glGetQueryObjectuiv(name, parameter, &value);
    return value;
}

// A buffer of 64 bytes of 0xAB that is bound nowhere.
class PoisonedBuffer {
  public:
    static constexpr GLsizeiptr kBytes = 64;
    static constexpr unsigned char kPoison = 0xAB;

    PoisonedBuffer() {
        glCreateBuffers(1, &name_);
        poison();
    }
    ~PoisonedBuffer() { glDeleteBuffers(1, &name_); }
    PoisonedBuffer(const PoisonedBuffer&) = delete;
    PoisonedBuffer& operator=(const PoisonedBuffer&) = delete;

    GLuint name() const { return name_; }

    void poison() const {
        const std::vector<unsigned char> bytes(kBytes, kPoison);
        glNamedBufferData(name_, kBytes, bytes.data(), GL_DYNAMIC_COPY);
    }

    template <typename Value>
    Value value_at(GLintptr offset) const {
        Value value{};
        glGetNamedBufferSubData(name_, offset, sizeof value, &value);
        return value;
    }

    ::testing::AssertionResult is_poisoned_but(GLintptr offset, GLsizeiptr bytes) const {
        std::vector<unsigned char> all(kBytes);
        glGetNamedBufferSubData(name_, 0, kBytes, all.data());
        for (GLsizeiptr i = 0; i < kBytes; ++i) {
            if ((i < offset || i >= offset + bytes) && all[static_cast<std::size_t>(i)] != kPoison) {
                return ::testing::AssertionFailure() << "byte " << i << " was written";
            }
        }
        return ::testing::AssertionSuccess();
    }
    ::testing::AssertionResult is_untouched() const { return is_poisoned_but(0, 0); }

  private:
    GLuint name_ = 0;
};

// GetQueryBufferObject{i,ui,i64,ui64}v by type.
template <typename Value>
void write_object(GLuint query, GLuint buffer, GLenum parameter, GLintptr offset) {
    if constexpr (std::is_same_v<Value, GLint>) glGetQueryBufferObjectiv(query, buffer, parameter, offset);
    if constexpr (std::is_same_v<Value, GLuint>) glGetQueryBufferObjectuiv(query, buffer, parameter, offset);
    if constexpr (std::is_same_v<Value, GLint64>)
        glGetQueryBufferObjecti64v(query, buffer, parameter, offset);
    if constexpr (std::is_same_v<Value, GLuint64>)
        glGetQueryBufferObjectui64v(query, buffer, parameter, offset);
}

template <typename Body>
void for_each_type(Body body) {
    body(GLint{});
    body(GLuint{});
    body(GLint64{});
    body(GLuint64{});
}

}  // namespace conformance
