// SPDX-License-Identifier: MIT
// Enable and Disable compile into display lists, a Get does not (HP-64 to HP-68).
//
// GL 4.5 compatibility, 21.4.1, lists the commands that are executed at once when a list is compiled; among
// them are the queries ("Other queries"). Enable, Disable and drawing are not in that list.
#include <array>

#include "hp_occlusion_test/hp_test.h"

namespace conformance {
namespace {

class DisplayLists : public HpTest {
  protected:
    template <typename Commands>
    static GLuint compile(Commands commands, GLenum mode = GL_COMPILE, GLuint list = glGenLists(1)) {
        glNewList(list, mode);
        commands();
        glEndList();
        EXPECT_TRUE(no_error());
        return list;
    }
};

// HP-64.
TEST_F(DisplayLists, a_compiled_enable_takes_effect_when_the_list_is_called) {
    const GLuint enable = compile([] { glEnable(GL_OCCLUSION_TEST_HP); });
    EXPECT_FALSE(test_enabled());
    glCallList(enable);
    EXPECT_TRUE(test_enabled());
    const GLuint disable = compile([] { glDisable(GL_OCCLUSION_TEST_HP); });
    EXPECT_TRUE(test_enabled());
    glCallList(disable);
    EXPECT_FALSE(test_enabled());
    glCallList(enable);
    EXPECT_TRUE(test_enabled()) << "a list may be called again";
    EXPECT_TRUE(no_error());
}

// HP-64: is_enabled is among the queries that execute at once.
TEST_F(DisplayLists, is_enabled_answers_while_a_list_is_compiled) {
    glEnable(GL_OCCLUSION_TEST_HP);
    compile([] {
        glDisable(GL_OCCLUSION_TEST_HP);
        EXPECT_TRUE(test_enabled());
    });
    EXPECT_TRUE(test_enabled());
}

// HP-65.
TEST_F(DisplayLists, compile_and_execute_does_both) {
    const GLuint list = compile(
        [] {
            glEnable(GL_OCCLUSION_TEST_HP);
            EXPECT_TRUE(test_enabled());
            draw_point(0, 0, 0.0f);
            glDisable(GL_OCCLUSION_TEST_HP);
        },
        GL_COMPILE_AND_EXECUTE);
    EXPECT_FALSE(test_enabled());
    EXPECT_TRUE(read_result());
    glCallList(list);
    EXPECT_TRUE(read_result());
    EXPECT_FALSE(test_enabled());
}

// HP-66.
TEST_F(DisplayLists, a_get_of_the_result_is_executed_at_once_and_not_compiled) {
    pass_one_fragment();
    const GLuint list = compile([] { EXPECT_TRUE(read_result()); });
    EXPECT_FALSE(read_result()) << "the Get in the list did not clear";
    pass_one_fragment();
    glCallList(list);
    EXPECT_TRUE(read_result()) << "the Get was compiled";
}

// HP-66, of a list that is executed too: each Get sees and clears what was drawn up to it.
TEST_F(DisplayLists, a_get_between_commands_that_are_compiled_and_executed_sees_what_they_drew) {
    draw_occluder();
    glDepthMask(GL_FALSE);
    const GLuint list = compile(
        [] {
            glEnable(GL_OCCLUSION_TEST_HP);
            draw_rect(kWhole, kFar);
            EXPECT_FALSE(read_result());
            draw_rect(kWhole, kNear);
            EXPECT_TRUE(read_result());
            draw_rect(kWhole, kFar);
            EXPECT_FALSE(read_result());
            glDisable(GL_OCCLUSION_TEST_HP);
        },
        GL_COMPILE_AND_EXECUTE);
    EXPECT_FALSE(read_result());
    glCallList(list);
    EXPECT_TRUE(read_result());
}

// HP-67.
TEST_F(DisplayLists, draws_in_lists_count_like_direct_ones) {
    draw_occluder();
    glDepthMask(GL_FALSE);
    const GLuint near = compile([] { draw_rect(kWhole, kNear); });
    const GLuint far = compile([] { draw_rect(kWhole, kFar); });
    EXPECT_TRUE(result_of([&] { glCallList(near); }));
    EXPECT_FALSE(result_of([&] { glCallList(far); }));
    glCallList(near);
    EXPECT_FALSE(read_result()) << "the test was disabled";
}

// HP-67.
TEST_F(DisplayLists, a_drawing_that_is_only_compiled_does_not_count) {
    EXPECT_FALSE(result_of([] { compile([] { draw_rect(kWhole, kMiddle); }); }));
}

// HP-67.
TEST_F(DisplayLists, a_whole_test_in_one_list_gives_its_result_outside) {
    draw_occluder();
    glDepthMask(GL_FALSE);
    for (const bool visible : {true, false}) {
        const GLuint list = compile([&] {
            glEnable(GL_OCCLUSION_TEST_HP);
            draw_rect(kWhole, visible ? kNear : kFar);
            glDisable(GL_OCCLUSION_TEST_HP);
            draw_rect(kWhole, kNear);  // after the test
        });
        for (int call = 0; call < 3; ++call) {
            glCallList(list);
            EXPECT_EQ(read_result(), visible) << "call " << call;
        }
        EXPECT_FALSE(test_enabled());
    }
}

// HP-67, of the attribute stack inside a list.
TEST_F(DisplayLists, push_and_pop_in_a_list_save_and_restore_the_enable) {
    const GLuint list = compile([] {
        glPushAttrib(GL_ENABLE_BIT);
        glEnable(GL_OCCLUSION_TEST_HP);
        draw_point(0, 0, 0.0f);
        glPopAttrib();
        draw_point(1, 0, 0.0f);
    });
    glCallList(list);
    EXPECT_FALSE(test_enabled());
    EXPECT_TRUE(read_result());
    draw_point(2, 0, 0.0f);
    EXPECT_FALSE(read_result());
}

// HP-68. GL 4.5 compatibility, 21.4: CallList may itself be compiled; the inner list runs with the outer one.
TEST_F(DisplayLists, nested_lists_behave_like_their_commands) {
    draw_occluder();
    glDepthMask(GL_FALSE);
    const GLuint enable = compile([] { glEnable(GL_OCCLUSION_TEST_HP); });
    const GLuint disable = compile([] { glDisable(GL_OCCLUSION_TEST_HP); });
    for (const bool visible : {true, false}) {
        const GLuint box = compile([&] { draw_rect(kWhole, visible ? kNear : kFar); });
        const GLuint outer = compile([&] {
            draw_rect(kWhole, kNear);  // before the test
            glCallList(enable);
            glCallList(box);
            glCallList(disable);
        });
        glCallList(outer);
        EXPECT_FALSE(test_enabled());
        EXPECT_EQ(read_result(), visible);
    }
}

// HP-68. An inner list is looked up when the outer one is called.
TEST_F(DisplayLists, a_list_that_is_replaced_later_runs_as_replaced) {
    const GLuint inner = compile([] {});
    const GLuint outer = compile([&] { glCallList(inner); });
    compile([] { glEnable(GL_OCCLUSION_TEST_HP); }, GL_COMPILE, inner);
    glCallList(outer);
    EXPECT_TRUE(test_enabled());

    glDisable(GL_OCCLUSION_TEST_HP);
    glDeleteLists(inner, 1);
    glCallList(outer);
    EXPECT_FALSE(test_enabled()) << "a deleted list still ran";
}

// HP-68, of CallLists with a list base.
TEST_F(DisplayLists, call_lists_runs_each_list_in_order) {
    const GLuint base = glGenLists(3);
    compile([] { glEnable(GL_OCCLUSION_TEST_HP); }, GL_COMPILE, base);
    compile([] { draw_rect(kWhole, kMiddle); }, GL_COMPILE, base + 1);
    compile([] { glDisable(GL_OCCLUSION_TEST_HP); }, GL_COMPILE, base + 2);
    glListBase(base);
    const std::array<GLubyte, 3> test = {0, 1, 2};
    glCallLists(test.size(), GL_UNSIGNED_BYTE, test.data());
    EXPECT_FALSE(test_enabled());
    EXPECT_TRUE(read_result());
    const std::array<GLshort, 3> late = {0, 2, 1};
    glCallLists(late.size(), GL_SHORT, late.data());
    EXPECT_FALSE(read_result()) << "the draw came after the disable";
}

// HP-68. Display lists belong to the share group.
TEST_F(DisplayLists, a_list_compiled_in_one_context_works_in_another_that_shares) {
    const GLuint list = compile([] { glEnable(GL_OCCLUSION_TEST_HP); });
    glFinish();
    const Context other({}, &context());
    ASSERT_TRUE(other.make_current(surface()));
    glCallList(list);
    EXPECT_TRUE(test_enabled());
    come_back();
    EXPECT_FALSE(test_enabled());
}

}  // namespace
}  // namespace conformance
