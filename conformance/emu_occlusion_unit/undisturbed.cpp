// SPDX-License-Identifier: MIT
// 17.3.5.1: "Queries on all other targets may be active meanwhile; they are not affected by the unit, nor are
// the results of transform feedback and of shaders that write to memory." 17.3.5.2: registers that need not
// be determined then.
#include "emu_occlusion_unit/unit_test.h"

namespace conformance {
namespace {

class UnitUndisturbed : public UnitTest {};

TEST_F(UnitUndisturbed, primitive_queries_count_what_the_program_draws) {
    draw_left_occluder();
    const Query primitives(GL_PRIMITIVES_GENERATED);
    primitives.begin();
    expect_seen_or_undetermined(kMayBeUndetermined, kHalfHidden, draw_half_hidden_strip);
    primitives.end();
    EXPECT_EQ(primitives.result(), 2u);
    // Begun and ended inside.
    draw_left_occluder();
    expect_seen_or_undetermined(kMayBeUndetermined, kHalfHidden, [&] {
        primitives.begin();
        draw_half_hidden_strip();
        primitives.end();
    });
    EXPECT_EQ(primitives.result(), 2u);
}

TEST_F(UnitUndisturbed, pipeline_statistics_count_what_the_program_draws) {
    if (const auto why = lacks(46, "GL_ARB_pipeline_statistics_query")) GTEST_SKIP() << *why;
    const std::array targets = {GL_VERTICES_SUBMITTED, GL_PRIMITIVES_SUBMITTED, GL_CLIPPING_INPUT_PRIMITIVES};
    for (const GLenum target : targets) {
        const Query statistics(target);
        draw_left_occluder();
        const GLuint without = statistics.count(draw_half_hidden_strip);
        draw_left_occluder();
        statistics.begin();
        expect_seen_or_undetermined(kMayBeUndetermined, kHalfHidden, draw_half_hidden_strip);
        statistics.end();
        EXPECT_EQ(statistics.result(), without) << target;
        EXPECT_GT(without, 0u);
    }
}

TEST_F(UnitUndisturbed, a_time_query_may_be_active) {
    draw_left_occluder();
    const Query time(GL_TIME_ELAPSED);
    time.begin();
    expect_seen(kHalfHidden, draw_half_hidden);
    time.end();
    time.result();
}

TEST_F(UnitUndisturbed, transform_feedback_records_each_vertex_once) {
    if (const auto why = lacks(30)) GTEST_SKIP() << *why;
    const GLuint program = use_recording_program(kFixedVertexSource, "gl_Position");
    constexpr std::size_t kFloats = 64;  // 16 vertices
    GLuint buffer = 0;
    glGenBuffers(1, &buffer);
    draw_left_occluder();
    const auto record = [&](bool is_inside) {
        std::array<GLfloat, kFloats> values{};
        values.fill(-7.0f);
        glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffer);
        glBufferData(GL_TRANSFORM_FEEDBACK_BUFFER, sizeof(values), values.data(), GL_STATIC_READ);
        const Query written(GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN);
        glDepthMask(GL_FALSE);
        const auto draw = [&] {
            written.begin();
            glBeginTransformFeedback(GL_TRIANGLES);
            draw_half_hidden_strip();
            draw_half_hidden_strip();
            glEndTransformFeedback();
            written.end();
        };
        if (is_inside) {
            Seen twice = kHalfHidden;
            twice.projected *= 2;
            twice.visible *= 2;
            expect_seen_or_undetermined(kMayBeUndetermined, twice, draw);
        } else {
            draw();
        }
        EXPECT_EQ(written.result(), 4u);
        glFinish();
        glGetBufferSubData(GL_TRANSFORM_FEEDBACK_BUFFER, 0, sizeof(values), values.data());
        return values;
    };
    const auto without = record(false);
    EXPECT_EQ(without[4 * 12], -7.0f) << "four triangles of three vertices";
    EXPECT_NE(without[4 * 11], -7.0f);
    EXPECT_EQ(record(true), without);
    glUseProgram(0);
    glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 0);
    glDeleteBuffers(1, &buffer);
    glDeleteProgram(program);
}

// A recorded vertex without any query of primitives: only the recording is at stake.
TEST_F(UnitUndisturbed, a_paused_transform_feedback_stays_paused) {
    if (const auto why = lacks(40)) GTEST_SKIP() << *why;
    draw_left_occluder();
    GLuint feedback = 0;
    GLuint buffer = 0;
    glGenTransformFeedbacks(1, &feedback);
    glGenBuffers(1, &buffer);
    glBindTransformFeedback(GL_TRANSFORM_FEEDBACK, feedback);
    const GLuint program = use_recording_program(kFixedVertexSource, "gl_Position");
    glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffer);
    glBufferData(GL_TRANSFORM_FEEDBACK_BUFFER, 1024, nullptr, GL_STATIC_READ);
    glBeginTransformFeedback(GL_TRIANGLES);
    glPauseTransformFeedback();
    glUseProgram(0);
    expect_seen(kHalfHidden, draw_half_hidden);
    EXPECT_EQ(get_integer(GL_TRANSFORM_FEEDBACK_PAUSED), GL_TRUE);
    EXPECT_EQ(get_integer(GL_TRANSFORM_FEEDBACK_ACTIVE), GL_TRUE);
    glUseProgram(program);
    glResumeTransformFeedback();
    glEndTransformFeedback();
    glUseProgram(0);
    EXPECT_TRUE(no_error());
    glBindTransformFeedback(GL_TRANSFORM_FEEDBACK, 0);
    glDeleteTransformFeedbacks(1, &feedback);
    glDeleteBuffers(1, &buffer);
    glDeleteProgram(program);
}

// Conditional rendering: what it discards steps nothing; what it draws is seen.
TEST_F(UnitUndisturbed, what_conditional_rendering_discards_steps_nothing) {
    const Query nothing;
    const Query something;
    nothing.count([] {});
    something.count([] { draw_rect({0, 0, 1, 1}, kNear); });
    draw_left_occluder();
    expect_seen_or_undetermined(kMayBeUndetermined, {}, [&] {
        glBeginConditionalRender(nothing.name(), GL_QUERY_WAIT);
        draw_half_hidden();
        glEndConditionalRender();
    });
    EXPECT_EQ(drawn_pixels(kRight), 0);
    expect_seen_or_undetermined(kMayBeUndetermined, kHalfHidden, [&] {
        glBeginConditionalRender(something.name(), GL_QUERY_WAIT);
        draw_half_hidden();
        glEndConditionalRender();
    });
}

// Dependencies on HP_occlusion_test: "A query of the unit neither sets nor resets OCCLUSION_TEST_RESULT_HP."
TEST_F(UnitUndisturbed, the_hp_flag_is_left_alone) {
    if (const auto why = lacks("GL_HP_occlusion_test")) GTEST_SKIP() << *why;
    GLboolean flag = GL_TRUE;
    glGetBooleanv(GL_OCCLUSION_TEST_RESULT_HP, &flag);  // clears it
    ask(kAllRegisters, [] { draw_rect({0, 0, 4, 4}, kNear); });
    glGetBooleanv(GL_OCCLUSION_TEST_RESULT_HP, &flag);
    EXPECT_FALSE(flag);
    glEnable(GL_OCCLUSION_TEST_HP);
    draw_rect({0, 0, 4, 4}, kNear);
    glDisable(GL_OCCLUSION_TEST_HP);
    ask(kAllRegisters, [] {});
    glGetBooleanv(GL_OCCLUSION_TEST_RESULT_HP, &flag);
    EXPECT_TRUE(flag);
}

}  // namespace
}  // namespace conformance
