// SPDX-License-Identifier: MIT
// The four inverted modes of conditional rendering: what they draw, and what they refuse (INV-01 to INV-06).
#include <array>

#include "harness/gl_test.h"
#include "harness/objects.h"
#include "harness/query.h"

namespace conformance {
namespace {

constexpr std::array<GLenum, 4> kInvertedModes = {GL_QUERY_WAIT_INVERTED, GL_QUERY_NO_WAIT_INVERTED,
                                                  GL_QUERY_BY_REGION_WAIT_INVERTED,
                                                  GL_QUERY_BY_REGION_NO_WAIT_INVERTED};

bool is_supported() {
    return !lacks(45, "GL_ARB_conditional_render_inverted");
}

class Inverted : public GlTest {
  protected:
    void SetUp() override {
        ASSERT_NO_FATAL_FAILURE(GlTest::SetUp());
        if (!is_supported()) GTEST_SKIP() << "needs GL_ARB_conditional_render_inverted";
    }
};

class WithoutInverted : public GlTest {
  protected:
    void SetUp() override {
        ASSERT_NO_FATAL_FAILURE(GlTest::SetUp());
        if (const auto why = lacks(30, "GL_NV_conditional_render")) GTEST_SKIP() << *why;
        if (is_supported()) GTEST_SKIP() << "needs a machine without GL_ARB_conditional_render_inverted";
    }
};

// A query of some samples or of none; nobody waits for it.
void ask(const Query& query, bool is_visible) {
    query.begin();
    if (is_visible) draw_rect({0, 0, 8, 8}, kNear);
    query.end();
}

// Pixels that a rectangle over everything leaves under a query.
int pixels_under(const Query& query, GLenum mode) {
    clear();
    glBeginConditionalRender(query.name(), mode);
    draw_rect(kWhole, kNear);
    glEndConditionalRender();
    return drawn_pixels();
}

// INV-01. New Tokens: the four are "Accepted by the <mode> parameter of BeginConditionalRender", and by its
// name of before.
TEST_F(Inverted, the_four_modes_are_accepted) {
    const auto begin_nv = reinterpret_cast<PFNGLBEGINCONDITIONALRENDERNVPROC>(
        platform().get_proc_address("glBeginConditionalRenderNV"));
    ASSERT_NE(begin_nv, nullptr);
    const Query query;
    query.count([] { draw_rect(kWhole, kNear); });
    for (const GLenum mode : kInvertedModes) {
        glBeginConditionalRender(query.name(), mode);
        EXPECT_TRUE(no_error()) << mode;
        glEndConditionalRender();
        EXPECT_TRUE(no_error()) << mode;
        if (lacks("GL_NV_conditional_render")) continue;
        begin_nv(query.name(), mode);
        EXPECT_TRUE(no_error()) << mode;
        glEndConditionalRender();
        EXPECT_TRUE(no_error()) << mode;
    }
}

// INV-01. GL 3.0, 2.14: INVALID_ENUM for what is no mode, as the four are not without the extension.
TEST_F(WithoutInverted, the_four_modes_are_refused) {
    const Query query;
    query.count([] { draw_rect(kWhole, kNear); });
    for (const GLenum mode : kInvertedModes) {
        glBeginConditionalRender(query.name(), mode);
        EXPECT_TRUE(error_is(GL_INVALID_ENUM)) << mode;
        glEndConditionalRender();
        EXPECT_TRUE(error_is(GL_INVALID_OPERATION)) << "a refused block was begun";
    }
}

// INV-02. 10.10: with QUERY_WAIT_INVERTED "the condition used to determine whether or not to render
// subsequent drawing commands is negated with respect to QUERY_WAIT".
TEST_F(Inverted, with_wait_all_is_drawn_if_and_only_if_the_result_is_zero) {
    for (const bool is_visible : {false, true}) {
        const Query query;
        ask(query, is_visible);
        EXPECT_EQ(pixels_under(query, GL_QUERY_WAIT_INVERTED), is_visible ? 0 : kWhole.area());
        EXPECT_EQ(query.result(), is_visible ? 64u : 0u);
        EXPECT_EQ(pixels_under(query, GL_QUERY_WAIT_INVERTED), is_visible ? 0 : kWhole.area()) << "once more";
        EXPECT_EQ(pixels_under(query, GL_QUERY_WAIT), is_visible ? kWhole.area() : 0) << "not inverted";
    }
}

// INV-02, of the other mode without regions, once nothing is left to wait for.
TEST_F(Inverted, without_wait_an_available_result_is_obeyed) {
    for (const bool is_visible : {false, true}) {
        const Query query;
        ask(query, is_visible);
        query.result();
        EXPECT_EQ(pixels_under(query, GL_QUERY_NO_WAIT_INVERTED), is_visible ? 0 : kWhole.area());
    }
}

// INV-03. Issue 3: "Inverted condition, in which case the GL renders subsequent primitives if the query is
// not complete yet."
TEST_F(Inverted, without_wait_a_pending_result_is_obeyed_or_all_is_drawn) {
    for (const GLenum mode : {GL_QUERY_NO_WAIT_INVERTED, GL_QUERY_BY_REGION_NO_WAIT_INVERTED}) {
        for (int round = 0; round < 20; ++round) {
            const bool is_visible = round % 2 == 0;
            const Query query;
            ask(query, is_visible);
            const int pixels = pixels_under(query, mode);
            EXPECT_TRUE(pixels == kWhole.area() || (is_visible && pixels == 0)) << pixels;
        }
    }
}

// INV-04. 10.10: QUERY_BY_REGION_WAIT_INVERTED and its like are "negated with respect to
// QUERY_BY_REGION_WAIT": what contributed to no sample is drawn. Where every sample or none contributed the
// regions leave no choice.
TEST_F(Inverted, by_region_the_negation_is_drawn) {
    for (const GLenum mode : {GL_QUERY_BY_REGION_WAIT_INVERTED, GL_QUERY_BY_REGION_NO_WAIT_INVERTED}) {
        const Query everywhere;
        EXPECT_EQ(everywhere.count([] { draw_rect(kWhole, kNear); }), static_cast<GLuint>(kWhole.area()));
        EXPECT_EQ(pixels_under(everywhere, mode), 0) << mode;
        const Query nowhere;
        EXPECT_EQ(nowhere.count([] {}), 0u);
        EXPECT_EQ(pixels_under(nowhere, mode), kWhole.area()) << mode;
    }
}

// INV-05. GL 4.5, 10.9: the condition is the result's, whichever occlusion target counted it.
TEST_F(Inverted, boolean_queries_decide_too) {
    for (const GLenum target : {GL_ANY_SAMPLES_PASSED, GL_ANY_SAMPLES_PASSED_CONSERVATIVE}) {
        if (target == GL_ANY_SAMPLES_PASSED_CONSERVATIVE && lacks(43, "GL_ARB_ES3_compatibility")) continue;
        for (const bool is_visible : {false, true}) {
            const Query query(target);
            ask(query, is_visible);
            EXPECT_EQ(query.result(), is_visible ? 1u : 0u);
            for (const GLenum mode : kInvertedModes) {
                if (is_visible && mode != GL_QUERY_WAIT_INVERTED && mode != GL_QUERY_NO_WAIT_INVERTED)
                    continue;
                EXPECT_EQ(pixels_under(query, mode), is_visible ? 0 : kWhole.area()) << mode;
            }
        }
    }
}

// INV-05. ARB_transform_feedback_overflow_query: its targets are accepted, "it's not obvious whether
// conditional rendering should discard drawing if a transform feedback buffer overflow occurs [...] This
// extension allows both".
TEST_F(Inverted, overflow_queries_decide_too) {
    if (const auto why = lacks(46, "GL_ARB_transform_feedback_overflow_query")) GTEST_SKIP() << *why;
    const Program program({.vertex = kFixedVertexSource});
    const char* const varying = "gl_Position";
    glTransformFeedbackVaryings(program.name(), 1, &varying, GL_INTERLEAVED_ATTRIBS);
    glLinkProgram(program.name());
    glUseProgram(program.name());
    GLuint buffer = 0;
    glGenBuffers(1, &buffer);
    glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffer);
    constexpr GLsizeiptr kVertex = 4 * sizeof(GLfloat);
    for (const bool overflows : {false, true}) {
        glBufferData(GL_TRANSFORM_FEEDBACK_BUFFER, overflows ? kVertex : 3 * kVertex, nullptr,
                     GL_STATIC_DRAW);
        const Query query(GL_TRANSFORM_FEEDBACK_OVERFLOW);
        query.begin();
        glBeginTransformFeedback(GL_TRIANGLES);
        draw_triangle(kNear);
        glEndTransformFeedback();
        query.end();
        EXPECT_EQ(pixels_under(query, GL_QUERY_WAIT_INVERTED), overflows ? 0 : kWhole.area());
        EXPECT_EQ(pixels_under(query, GL_QUERY_WAIT), overflows ? kWhole.area() : 0);
        EXPECT_EQ(query.result(), overflows ? 1u : 0u);
    }
    glDeleteBuffers(1, &buffer);
}

// INV-06. NV_conditional_render, Errors, for the new modes alike.
TEST_F(Inverted, the_errors_are_those_of_the_other_modes) {
    const Query query;
    query.count([] {});
    const Query primitives(GL_PRIMITIVES_GENERATED);
    primitives.count([] {});
    for (const GLenum mode : kInvertedModes) {
        for (const GLuint name : {GLuint{0}, GLuint{0x7000}}) {
            glBeginConditionalRender(name, mode);
            EXPECT_TRUE(error_is(GL_INVALID_VALUE)) << name;
        }
        glBeginConditionalRender(primitives.name(), mode);
        EXPECT_TRUE(error_is(GL_INVALID_OPERATION)) << "of another target";
        query.begin();
        glBeginConditionalRender(query.name(), mode);
        EXPECT_TRUE(error_is(GL_INVALID_OPERATION)) << "active";
        query.end();
        glBeginConditionalRender(query.name(), mode);
        glBeginConditionalRender(query.name(), mode);
        EXPECT_TRUE(error_is(GL_INVALID_OPERATION)) << "two at once";
        glEndConditionalRender();
        glEndConditionalRender();
        EXPECT_TRUE(error_is(GL_INVALID_OPERATION)) << "none";
    }
}

}  // namespace
}  // namespace conformance
