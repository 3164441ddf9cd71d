// SPDX-License-Identifier: MIT
// 21.4: "BeginOcclusionUnitEMU and EndOcclusionUnitEMU are compiled into display lists. FarDepthEMU,
// OcclusionUnitShapesEMU and GetOcclusionRecordsEMU are executed immediately."
#include "emu_occlusion_unit/unit_test.h"

namespace conformance {
namespace {

class UnitLists : public UnitTest {
  protected:
    void SetUp() override {
        ASSERT_NO_FATAL_FAILURE(UnitTest::SetUp());
        if (IsSkipped()) return;
        lists_ = glGenLists(4);
        draw_left_occluder();
    }
    void TearDown() override {
        if (lists_ != 0) glDeleteLists(lists_, 4);
        UnitTest::TearDown();
    }

    GLuint list(GLuint index) const { return lists_ + index; }
    void compile(GLuint index, const Draw& draw, GLenum mode = GL_COMPILE) const {
        glNewList(list(index), mode);
        draw();
        glEndList();
    }
    static void expect_half_hidden(const Query& query) {
        Record record{};
        get_records(query.name(), 0, 1, &record);
        expect_record(record, kAllRegisters, kHalfHidden);
    }

  private:
    GLuint lists_ = 0;
};

TEST_F(UnitLists, a_list_that_was_compiled_before_is_seen) {
    compile(0, draw_half_hidden);
    expect_seen(kHalfHidden, [&] { glCallList(list(0)); });
}

TEST_F(UnitLists, lists_called_by_their_numbers_and_by_lists_are_seen) {
    compile(0, [] { draw_rect({8, 8, 24, 16}, kFar); });
    compile(1, [] { draw_rect({32, 8, 24, 16}, kFar); });
    compile(2, [&] {
        glCallList(list(0));
        glCallList(list(1));
    });
    glDepthMask(GL_FALSE);
    expect_seen(kHalfHidden, [&] {
        const std::array<GLubyte, 2> offsets = {1, 0};
        glListBase(list(0));
        glCallLists(2, GL_UNSIGNED_BYTE, offsets.data());
        glListBase(0);
    });
    expect_seen(kHalfHidden, [&] { glCallList(list(2)); });
    glDepthMask(GL_TRUE);
}

// A list that draws and changes state in turn: each draw has the state of its place.
TEST_F(UnitLists, a_list_with_states_between_its_drawings_is_seen) {
    compile(0, [] {
        glDisable(GL_DEPTH_TEST);
        draw_rect({0, 40, 4, 4}, kFar);
        glEnable(GL_DEPTH_TEST);
        draw_rect({0, 44, 4, 4}, kFar);
        glDepthMask(GL_FALSE);
        draw_rect({40, 44, 4, 4}, kNear);
        glDepthMask(GL_TRUE);
        draw_rect({40, 44, 4, 4}, kFar);
    });
    expect_seen({.projected = 64, .visible = 48, .nearest = kNear, .box = {0, 40, 43, 47}},
                [&] { glCallList(list(0)); });
}

TEST_F(UnitLists, a_list_compiled_and_executed_within_a_query_is_seen_once) {
    expect_seen(kHalfHidden, [&] { compile(0, draw_half_hidden, GL_COMPILE_AND_EXECUTE); });
    draw_left_occluder();
    expect_seen({}, [&] { compile(1, draw_half_hidden); });
    expect_seen(kHalfHidden, [&] { glCallList(list(0)); });
}

TEST_F(UnitLists, begin_and_end_are_compiled) {
    const Query query;
    compile(0, [&] {
        begin_unit(kAllRegisters, query.name());
        draw_half_hidden();
        end_unit();
    });
    EXPECT_FALSE(glIsQuery(query.name())) << "compiled only";
    EXPECT_TRUE(no_error());
    for (int time = 0; time < 2; ++time) {
        draw_left_occluder();
        glCallList(list(0));
        EXPECT_TRUE(no_error());
        expect_half_hidden(query);
    }
}

TEST_F(UnitLists, begin_and_end_may_stand_in_lists_of_their_own) {
    const Query query;
    compile(0, [&] { begin_unit(kAllRegisters, query.name()); });
    compile(1, [] { end_unit(); });
    glCallList(list(0));
    EXPECT_TRUE(glIsQuery(query.name()));
    draw_half_hidden();
    glCallList(list(1));
    expect_half_hidden(query);
    draw_left_occluder();
    glCallList(list(0));
    draw_half_hidden();
    end_unit();
    expect_half_hidden(query);
}

TEST_F(UnitLists, compiled_and_executed_a_query_is_executed) {
    const Query query;
    compile(
        0,
        [&] {
            begin_unit(kAllRegisters, query.name());
            draw_half_hidden();
            end_unit();
        },
        GL_COMPILE_AND_EXECUTE);
    expect_half_hidden(query);
}

// An error belongs to the execution.
TEST_F(UnitLists, a_compiled_misuse_is_an_error_when_it_is_executed) {
    compile(0, [] { end_unit(); });
    compile(1, [] { begin_unit(kAllRegisters, 0); });
    compile(2, [] { begin_unit(0, 1); });
    EXPECT_TRUE(no_error());
    glCallList(list(0));
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
    glCallList(list(1));
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
    glCallList(list(2));
    EXPECT_TRUE(error_is(GL_INVALID_VALUE));
}

TEST_F(UnitLists, the_other_commands_are_executed_at_once) {
    const Query ended;
    const Query shapes;
    begin_unit(kAllRegisters, ended.name());
    draw_half_hidden();
    end_unit();
    draw_left_occluder();
    compile(0, [&] {
        expect_half_hidden(ended);
        const std::array<GLfloat, 12> quad = {8, 8, kFar, 56, 8, kFar, 56, 24, kFar, 8, 24, kFar};
        unit_shapes(kAllRegisters, GL_QUAD_EMU, 1, quad.data(), nullptr, shapes.name());
        expect_half_hidden(shapes);
        far_depth(GL_ZERO);
    });
    EXPECT_EQ(get_integer(GL_FAR_DEPTH_EMU), GL_ZERO);
    far_depth(GL_ONE);
    glCallList(list(0));
    EXPECT_EQ(get_integer(GL_FAR_DEPTH_EMU), GL_ONE);
}

}  // namespace
}  // namespace conformance
