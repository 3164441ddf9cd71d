// SPDX-License-Identifier: MIT
// The program's own queries, conditional rendering and transform feedback while the HP test is enabled
// (XPAR-05 to XPAR-08).
#include <array>

#include "harness/objects.h"
#include "transparency/transparency_test.h"

namespace conformance {
namespace {

class OtherQueries : public TransparencyTest {
  protected:
    // A query under the enabled test: its own result, and the test's after it.
    static void expect_both_right(GLenum target, float depth, GLuint result) {
        draw_occluder();  // counts for the test, as something visible
        const Query query(target);
        query.begin();
        EXPECT_TRUE(no_error()) << "the implementation's own query does not give way";
        draw_rect({0, 0, 7, 1}, depth);
        query.end();
        EXPECT_EQ(query.result(), result);
        EXPECT_EQ(visible(), result != 0) << "since the query began";
        draw_rect({0, 2, 7, 1}, depth);
        EXPECT_EQ(visible(), result != 0) << "after the query";
        glDisable(GL_DEPTH_TEST);
    }
};

// XPAR-05. NV_occlusion_query 4.1.6A and ARB_occlusion_query, Dependencies on HP_occlusion_test: both use one
// counter, which a query resets when it begins.
TEST_F(OtherQueries, a_query_of_samples_runs_under_the_test) {
    expect_both_right(GL_SAMPLES_PASSED, kNear, 7);
    expect_both_right(GL_SAMPLES_PASSED, kFar, 0);
}

// XPAR-06. ARB_occlusion_query2: the boolean targets use the same counter.
TEST_F(OtherQueries, a_boolean_query_runs_under_the_test) {
    if (const auto why = lacks(33, "GL_ARB_occlusion_query2")) GTEST_SKIP() << *why;
    expect_both_right(GL_ANY_SAMPLES_PASSED, kNear, 1);
    expect_both_right(GL_ANY_SAMPLES_PASSED, kFar, 0);
}

// XPAR-07. GL 4.5, 10.9: what is drawn between the two commands is discarded where the result is zero, and
// only that.
TEST_F(OtherQueries, conditional_rendering_goes_on_under_the_test) {
    if (const auto why = lacks(30)) GTEST_SKIP() << *why;
    const Query none;
    const Query some;
    EXPECT_EQ(none.count([] {}), 0u);
    EXPECT_EQ(some.count([] { draw_rect({0, 0, 7, 1}, kMiddle); }), 7u);
    clear();
    visible();

    glBeginConditionalRender(none.name(), GL_QUERY_WAIT);
    draw_rect(kWhole, kMiddle);
    EXPECT_FALSE(visible()) << "read inside the block";
    glDisable(GL_OCCLUSION_TEST_HP);
    glEnable(GL_OCCLUSION_TEST_HP);
    draw_rect(kWhole, kMiddle);
    glEndConditionalRender();
    EXPECT_FALSE(visible());
    EXPECT_EQ(drawn_pixels(), 0);

    glBeginConditionalRender(some.name(), GL_QUERY_WAIT);
    draw_rect({0, 0, 5, 1}, kMiddle);
    EXPECT_TRUE(visible());
    draw_rect({0, 1, 5, 1}, kMiddle);
    glEndConditionalRender();
    EXPECT_TRUE(visible());
    EXPECT_EQ(drawn_pixels(), 10);
}

constexpr const char* kCapturingSource =
    "#version 130\n"
    "out vec2 captured;\n"
    "void main() {\n"
    "    gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex;\n"
    "    captured = gl_Vertex.xy;\n"
    "}\n";

// XPAR-08. GL 4.5, 13.2: transform feedback captures the vertices of the program's draws.
TEST_F(OtherQueries, transform_feedback_captures_what_it_does_without_the_test) {
    if (const auto why = lacks(30)) GTEST_SKIP() << *why;
    const Program program({.vertex = kCapturingSource});
    const char* const varying = "captured";
    glTransformFeedbackVaryings(program.name(), 1, &varying, GL_INTERLEAVED_ATTRIBS);
    glLinkProgram(program.name());
    glUseProgram(program.name());
    std::array<GLfloat, 8> untouched{};
    untouched.fill(-1.0f);
    GLuint buffer = 0;
    glGenBuffers(1, &buffer);
    glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffer);
    glBufferData(GL_TRANSFORM_FEEDBACK_BUFFER, sizeof untouched, untouched.data(), GL_STREAM_READ);

    const Query written(GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN);
    written.begin();
    glBeginTransformFeedback(GL_POINTS);
    draw_point(3, 4, kMiddle);
    EXPECT_TRUE(visible());
    draw_point(5, 6, kMiddle);
    glEndTransformFeedback();
    written.end();
    EXPECT_TRUE(visible());
    EXPECT_EQ(written.result(), 2u);
    std::array<GLfloat, 8> captured{};
    glGetBufferSubData(GL_TRANSFORM_FEEDBACK_BUFFER, 0, sizeof captured, captured.data());
    EXPECT_EQ(captured, (std::array<GLfloat, 8>{3.5f, 4.5f, 5.5f, 6.5f, -1.0f, -1.0f, -1.0f, -1.0f}));
    glDeleteBuffers(1, &buffer);
}

// XPAR-08. GL 4.5, 4.3: a time query runs from its begin to its end, whatever else does.
TEST_F(OtherQueries, a_time_query_runs_under_the_test) {
    if (const auto why = lacks(33, "GL_ARB_timer_query")) GTEST_SKIP() << *why;
    const Query time(GL_TIME_ELAPSED);
    time.begin();
    draw_rect(kWhole, kMiddle);
    EXPECT_TRUE(visible());
    glDisable(GL_OCCLUSION_TEST_HP);
    glEnable(GL_OCCLUSION_TEST_HP);
    draw_rect(kWhole, kMiddle);
    EXPECT_EQ(current_query(GL_TIME_ELAPSED), static_cast<GLint>(time.name()));
    time.end();
    EXPECT_GT(time.result(), 0u);
    EXPECT_TRUE(visible());
}

// XPAR-08. ARB_pipeline_statistics_query: the counters are of the program's own draws.
TEST_F(OtherQueries, pipeline_statistics_are_those_without_the_test) {
    if (const auto why = lacks(46, "GL_ARB_pipeline_statistics_query")) GTEST_SKIP() << *why;
    for (const GLenum target : {GL_VERTICES_SUBMITTED_ARB, GL_PRIMITIVES_SUBMITTED_ARB,
                                GL_CLIPPING_INPUT_PRIMITIVES_ARB, GL_FRAGMENT_SHADER_INVOCATIONS_ARB}) {
        SCOPED_TRACE(target);
        const auto count = [target](bool test) {
            const Query statistics(target);
            statistics.begin();
            for (int i = 0; i < 3; ++i) {
                draw_triangle(kMiddle);
                if (test) visible();
            }
            statistics.end();
            return statistics.result();
        };
        const GLuint with = count(true);
        glDisable(GL_OCCLUSION_TEST_HP);
        EXPECT_EQ(with, count(false));
        EXPECT_GT(with, 0u);
        glEnable(GL_OCCLUSION_TEST_HP);
    }
}

}  // namespace
}  // namespace conformance
