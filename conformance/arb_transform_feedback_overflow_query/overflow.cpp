// SPDX-License-Identifier: MIT
// Queries for the overflow of transform feedback buffers, and rendering that depends on them (TFO-01 to
// TFO-03).
#include <string>

#include "harness/gl_test.h"
#include "harness/objects.h"
#include "harness/query.h"

namespace conformance {
namespace {

constexpr GLsizeiptr kTriangle = 3 * 4 * sizeof(GLfloat);  // gl_Position of three vertices

class Overflow : public GlTest {
  protected:
    void SetUp() override {
        ASSERT_NO_FATAL_FAILURE(GlTest::SetUp());
        if (const auto why = lacks(46, "GL_ARB_transform_feedback_overflow_query")) GTEST_SKIP() << *why;
        program_ = glCreateProgram();
        const GLuint shader = glCreateShader(GL_VERTEX_SHADER);
        const char* const varying = "gl_Position";
        glShaderSource(shader, 1, &kFixedVertexSource, nullptr);
        glCompileShader(shader);
        glAttachShader(program_, shader);
        glDeleteShader(shader);
        glTransformFeedbackVaryings(program_, 1, &varying, GL_INTERLEAVED_ATTRIBS);
        glLinkProgram(program_);
        glGenBuffers(1, &buffer_);
        ASSERT_TRUE(no_error());
    }

    void TearDown() override {
        if (buffer_) {
            glDeleteBuffers(1, &buffer_);
            glDeleteProgram(program_);
        }
        GlTest::TearDown();
    }

    // Captures <drawn> triangles into room for <room>.
    void capture(int drawn, int room) const {
        glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffer_);
        glBufferData(GL_TRANSFORM_FEEDBACK_BUFFER, room * kTriangle, nullptr, GL_STREAM_COPY);
        glUseProgram(program_);
        glBeginTransformFeedback(GL_TRIANGLES);
        for (int i = 0; i < drawn; ++i) draw_triangle(kNear);
        glEndTransformFeedback();
        glUseProgram(0);
    }

  private:
    GLuint program_ = 0;
    GLuint buffer_ = 0;
};

// TFO-01. The text: the result of TRANSFORM_FEEDBACK_OVERFLOW is TRUE if the buffers of any vertex stream
// overflowed, of TRANSFORM_FEEDBACK_STREAM_OVERFLOW if that stream's did.
TEST_F(Overflow, the_result_is_whether_there_was_no_room) {
    for (const GLenum target : {GL_TRANSFORM_FEEDBACK_OVERFLOW, GL_TRANSFORM_FEEDBACK_STREAM_OVERFLOW}) {
        const Query query(target);
        EXPECT_EQ(query.count([] {}), 0u);
        EXPECT_EQ(query.count([&] { capture(2, 2); }), 0u);
        EXPECT_EQ(query.count([&] { capture(2, 1); }), 1u);
        EXPECT_EQ(query.count([&] { capture(9, 1); }), 1u);
        EXPECT_EQ(query.count([&] { capture(1, 1); }), 0u);
        EXPECT_TRUE(no_error());
    }
    const Query other(GL_TRANSFORM_FEEDBACK_STREAM_OVERFLOW);
    glBeginQueryIndexed(GL_TRANSFORM_FEEDBACK_STREAM_OVERFLOW, 1, other.name());
    capture(2, 1);
    glEndQueryIndexed(GL_TRANSFORM_FEEDBACK_STREAM_OVERFLOW, 1);
    EXPECT_EQ(other.result(), 0u) << "nothing was captured from stream 1";
}

// TFO-01. The text: BeginConditionalRender takes both targets; without overflow, all is discarded.
TEST_F(Overflow, both_targets_decide_conditional_rendering) {
    for (const GLenum target : {GL_TRANSFORM_FEEDBACK_OVERFLOW, GL_TRANSFORM_FEEDBACK_STREAM_OVERFLOW}) {
        for (const bool overflows : {false, true}) {
            const Query query(target);
            query.begin();
            capture(2, overflows ? 1 : 2);
            query.end();
            clear();
            glBeginConditionalRender(query.name(), GL_QUERY_WAIT);
            draw_rect(kWhole, kNear);
            glEndConditionalRender();
            EXPECT_TRUE(no_error());
            EXPECT_EQ(drawn_pixels(), overflows ? kWhole.area() : 0);
            EXPECT_EQ(query.result(), overflows ? 1u : 0u);
        }
    }
}

// TFO-01, beside an occlusion query.
TEST_F(Overflow, an_occlusion_query_runs_beside_it) {
    const Query query(GL_TRANSFORM_FEEDBACK_OVERFLOW);
    const Query samples;
    const GLuint triangle = samples.count([] { draw_triangle(kNear); });
    EXPECT_EQ(query.count([&] {
        EXPECT_EQ(samples.count([&] {
            capture(2, 1);
            draw_rect({0, 0, 5, 1}, kNear);
        }),
                  2 * triangle + 5);
    }),
              1u);
}

// TFO-02. GL 4.6, 4.2: INVALID_VALUE for an index of TRANSFORM_FEEDBACK_OVERFLOW other than zero, and for one
// of TRANSFORM_FEEDBACK_STREAM_OVERFLOW that is no stream.
TEST_F(Overflow, an_index_that_is_no_stream_is_refused) {
    const auto streams = static_cast<GLuint>(get_integer(GL_MAX_VERTEX_STREAMS));
    const Query query(GL_TRANSFORM_FEEDBACK_OVERFLOW);
    glBeginQueryIndexed(GL_TRANSFORM_FEEDBACK_OVERFLOW, 1, query.name());
    EXPECT_TRUE(error_is(GL_INVALID_VALUE));
    EXPECT_FALSE(glIsQuery(query.name()));
    glBeginQueryIndexed(GL_TRANSFORM_FEEDBACK_STREAM_OVERFLOW, streams, query.name());
    EXPECT_TRUE(error_is(GL_INVALID_VALUE));
    EXPECT_FALSE(glIsQuery(query.name()));
    glEndQueryIndexed(GL_TRANSFORM_FEEDBACK_STREAM_OVERFLOW, streams);
    EXPECT_TRUE(error_is(GL_INVALID_VALUE));
    glBeginQueryIndexed(GL_TRANSFORM_FEEDBACK_STREAM_OVERFLOW, streams - 1, query.name());
    EXPECT_TRUE(no_error());
    glEndQueryIndexed(GL_TRANSFORM_FEEDBACK_STREAM_OVERFLOW, streams - 1);
    EXPECT_TRUE(no_error());
}

// TFO-03. GL 4.6, 4.2.1: a boolean needs one bit.
TEST_F(Overflow, the_counters_have_a_bit) {
    for (const GLenum target : {GL_TRANSFORM_FEEDBACK_OVERFLOW, GL_TRANSFORM_FEEDBACK_STREAM_OVERFLOW}) {
        GLint bits = -1;
        glGetQueryiv(target, GL_QUERY_COUNTER_BITS, &bits);
        EXPECT_GE(bits, 1);
        EXPECT_LE(bits, 64);
    }
}

}  // namespace
}  // namespace conformance
