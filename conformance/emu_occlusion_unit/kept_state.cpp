// SPDX-License-Identifier: MIT
// Reading back what a query has seen takes state, and may take a drawing: neither shows to the program.
// 17.3.5.1: "Queries on all other targets may be active meanwhile; they are not affected by the unit".
#include <optional>

#include "emu_occlusion_unit/unit_test.h"

#ifndef GL_PACK_INVERT_MESA
#define GL_PACK_INVERT_MESA 0x8758
#endif

namespace conformance {
namespace {

// Of fixed function first, then by a program: two ways for whoever has to look at the fragments.
void see_half_hidden_in_both_ways() {
    draw_left_occluder();
    expect_seen(kHalfHidden, draw_half_hidden);
    draw_left_occluder();
    const Program program({.vertex = kFixedVertexSource});
    expect_seen(kHalfHidden, draw_half_hidden);
}

class UnitKeptState : public UnitTest {};

TEST_F(UnitKeptState, the_alignment_of_packed_rows_is_kept) {
    for (const GLint alignment : {1, 2, 4, 8}) {
        glPixelStorei(GL_PACK_ALIGNMENT, alignment);
        see_half_hidden_in_both_ways();
        EXPECT_EQ(get_integer(GL_PACK_ALIGNMENT), alignment);
    }
}

TEST_F(UnitKeptState, rows_that_are_packed_elsewhere_do_not_matter) {
    glPixelStorei(GL_PACK_ROW_LENGTH, 7);
    glPixelStorei(GL_PACK_SKIP_ROWS, 3);
    glPixelStorei(GL_PACK_SKIP_PIXELS, 5);
    see_half_hidden_in_both_ways();
    EXPECT_EQ(get_integer(GL_PACK_ROW_LENGTH), 7);
    EXPECT_EQ(get_integer(GL_PACK_SKIP_ROWS), 3);
    EXPECT_EQ(get_integer(GL_PACK_SKIP_PIXELS), 5);
}

TEST_F(UnitKeptState, rows_that_are_packed_upside_down_do_not_matter) {
    if (const auto why = lacks("GL_MESA_pack_invert")) GTEST_SKIP() << *why;
    glPixelStorei(GL_PACK_INVERT_MESA, GL_TRUE);
    see_half_hidden_in_both_ways();
    EXPECT_EQ(get_integer(GL_PACK_INVERT_MESA), GL_TRUE);
}

// GL 4.6, 14.9.2: each viewport has a scissor test of its own.
TEST_F(UnitKeptState, the_scissor_tests_of_other_viewports_are_kept) {
    if (const auto why = lacks(41)) GTEST_SKIP() << *why;
    glEnablei(GL_SCISSOR_TEST, 0);
    glScissorIndexed(0, 0, 0, kSize, kSize);
    draw_left_occluder();
    expect_seen(kHalfHidden, draw_half_hidden);
    EXPECT_TRUE(glIsEnabledi(GL_SCISSOR_TEST, 0));
    EXPECT_FALSE(glIsEnabledi(GL_SCISSOR_TEST, 1));
}

TEST_F(UnitKeptState, what_moves_or_masks_fragments_does_not_move_a_record) {
    draw_left_occluder();
    const Query unit;
    begin_unit(kAllRegisters, unit.name());
    draw_half_hidden();
    end_unit();
    glDepthRange(0.25, 0.5);
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(3.0f, 100.0f);
    glEnable(GL_COLOR_LOGIC_OP);
    glLogicOp(GL_XOR);
    Record record{};
    get_records(unit.name(), 0, 1, &record);
    expect_record(record, kAllRegisters, kHalfHidden);
    EXPECT_EQ(get_integer(GL_LOGIC_OP_MODE), GL_XOR);
}

// A record is read for the first time while something else counts: then it is asked how the buffer holds
// depths.
class UnitReading : public UnitTest {
  protected:
    void SetUp() override {
        ASSERT_NO_FATAL_FAILURE(UnitTest::SetUp());
        if (IsSkipped()) return;
        unit_.emplace();
        draw_left_occluder();
        begin_unit(kAllRegisters, unit_->name());
        draw_half_hidden();
        end_unit();
        draw_left_occluder();
    }
    void TearDown() override {
        unit_.reset();
        UnitTest::TearDown();
    }

    void read() const {
        Record record{};
        get_records(unit_->name(), 0, 1, &record);
        expect_record(record, kAllRegisters, kHalfHidden);
    }

  private:
    std::optional<Query> unit_;
};

TEST_F(UnitReading, an_occlusion_query_does_not_count_it) {
    for (const GLenum target : {GL_SAMPLES_PASSED, GL_ANY_SAMPLES_PASSED}) {
        const Query samples(target);
        EXPECT_EQ(samples.count([this] { read(); }), 0u);
    }
}

TEST_F(UnitReading, what_an_occlusion_query_has_counted_stays) {
    const Query samples;
    samples.begin();
    draw_half_hidden();
    read();
    draw_rect({0, 0, 2, 2}, kNear);
    samples.end();
    EXPECT_EQ(samples.result(), kHalfHidden.visible + 4);
}

TEST_F(UnitReading, a_query_of_the_unit_does_not_see_it) {
    for (const GLbitfield registers : {GLbitfield{GL_VISIBLE_HITS_BIT_EMU}, kAllRegisters}) {
        draw_left_occluder();
        expect_record(ask(registers,
                          [this] {
                              draw_half_hidden();
                              read();
                          }),
                      registers, kHalfHidden);
    }
}

TEST_F(UnitReading, a_query_of_primitives_does_not_count_it) {
    const Query primitives(GL_PRIMITIVES_GENERATED);
    EXPECT_EQ(primitives.count([this] { read(); }), 0u);
}

TEST_F(UnitReading, the_hp_test_does_not_see_it) {
    if (const auto why = lacks("GL_HP_occlusion_test")) GTEST_SKIP() << *why;
    glEnable(GL_OCCLUSION_TEST_HP);
    draw_rect({0, 0, 4, 4}, kFar);  // hidden
    read();
    GLboolean result = GL_TRUE;
    glGetBooleanv(GL_OCCLUSION_TEST_RESULT_HP, &result);
    EXPECT_EQ(result, GL_FALSE);
    read();
    draw_rect({0, 0, 4, 4}, kNear);
    glGetBooleanv(GL_OCCLUSION_TEST_RESULT_HP, &result);
    EXPECT_EQ(result, GL_TRUE);
    glDisable(GL_OCCLUSION_TEST_HP);
}

TEST_F(UnitReading, transform_feedback_does_not_record_it) {
    if (const auto why = lacks(40)) GTEST_SKIP() << *why;
    const GLuint program = use_recording_program(kFixedVertexSource, "gl_Position");
    GLuint buffer = 0;
    glGenBuffers(1, &buffer);
    std::array<GLfloat, 64> untouched{};
    untouched.fill(-7.0f);
    glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffer);
    glBufferData(GL_TRANSFORM_FEEDBACK_BUFFER, sizeof(untouched), untouched.data(), GL_STATIC_READ);
    glBeginTransformFeedback(GL_TRIANGLES);
    read();
    glEndTransformFeedback();
    glFinish();
    auto recorded = untouched;
    glGetBufferSubData(GL_TRANSFORM_FEEDBACK_BUFFER, 0, sizeof(recorded), recorded.data());
    EXPECT_EQ(recorded, untouched);
    glUseProgram(0);
    glDeleteProgram(program);
    glDeleteBuffers(1, &buffer);
}

}  // namespace
}  // namespace conformance
