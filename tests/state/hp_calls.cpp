// SPDX-License-Identifier: MIT
// Each call of GL_HP_occlusion_test changes what its text says and no other gettable state, with and without
// an error pending.
#include "state_test.h"

namespace tests {
namespace {

using conformance::draw_rect;
using conformance::kFar;
using conformance::kNear;
using conformance::kWhole;

class HpCalls : public StateTest {
  protected:
    void SetUp() override {
        ASSERT_NO_FATAL_FAILURE(StateTest::SetUp());
        if (const auto why = conformance::lacks("GL_HP_occlusion_test")) GTEST_SKIP() << *why;
    }
};

const Rows kEnable = enable_of("GL_OCCLUSION_TEST_HP");

void enable() {
    glEnable(GL_OCCLUSION_TEST_HP);
}
void disable() {
    glDisable(GL_OCCLUSION_TEST_HP);
}

bool read_result() {
    GLboolean result = 0xAA;
    glGetBooleanv(GL_OCCLUSION_TEST_RESULT_HP, &result);
    return result == GL_TRUE;
}

TEST_F(HpCalls, the_reader_itself_changes_nothing) {
    enable();
    expect_nothing([] {});
    draw_rect(kWhole, kNear);
    expect_nothing([] {});
    EXPECT_TRUE(read_result()) << "reading all state cleared the result";
}

TEST_F(HpCalls, enable_and_disable_change_the_enable_alone) {
    expect_changes(kEnable, enable);
    expect_nothing(enable);
    expect_changes(kEnable, disable);
    expect_nothing(disable);
    expect_changes_with_error_pending(kEnable, enable);
    expect_changes_with_error_pending(kEnable, disable);
}

TEST_F(HpCalls, drawing_under_the_test_changes_nothing_gettable) {
    enable();
    expect_nothing([] { draw_rect(kWhole, kNear); });
    expect_nothing([] { draw_rect(kWhole, kFar); });
    expect_nothing([] { glRecti(1, 1, 9, 9); });
    disable();
    expect_nothing([] { draw_rect(kWhole, kNear); });
}

TEST_F(HpCalls, every_form_of_reading_changes_nothing_else) {
    for (const bool enabled : {true, false}) {
        SCOPED_TRACE(enabled);
        enable();
        draw_rect(kWhole, kNear);
        if (!enabled) disable();
        expect_nothing([] { read_result(); });
        expect_nothing([] { conformance::get_integer(GL_OCCLUSION_TEST_RESULT_HP); });
        expect_nothing([] {
            GLfloat value = 0.0f;
            glGetFloatv(GL_OCCLUSION_TEST_RESULT_HP, &value);
        });
        expect_nothing([] {
            GLdouble value = 0.0;
            glGetDoublev(GL_OCCLUSION_TEST_RESULT_HP, &value);
        });
        disable();
    }
}

TEST_F(HpCalls, a_whole_test_changes_nothing_gettable) {
    expect_nothing([] {
        enable();
        draw_rect(kWhole, kNear);
        disable();
        read_result();
    });
    expect_nothing([] {
        for (int i = 0; i < 50; ++i) {
            enable();
            draw_rect(kWhole, kNear);
            read_result();
            disable();
        }
    });
}

TEST_F(HpCalls, the_attribute_stack_changes_its_depth_and_what_it_restores) {
    const Rows depth = number("GL_ATTRIB_STACK_DEPTH");  // one level is pushed already
    expect_changes(depth, [] { glPushAttrib(GL_ENABLE_BIT); });
    expect_changes(kEnable, enable);
    expect_changes(depth + kEnable, [] { glPopAttrib(); });
    expect_nothing([] {
        glPushAttrib(GL_ALL_ATTRIB_BITS);
        enable();
        draw_rect(kWhole, kNear);
        glPopAttrib();
    });
    read_result();
}

TEST_F(HpCalls, display_lists_change_what_their_commands_change) {
    const GLuint list = glGenLists(2);
    glNewList(list, GL_COMPILE);
    enable();
    draw_rect(kWhole, kNear);
    glEndList();
    glNewList(list + 1, GL_COMPILE);
    disable();
    glEndList();
    const Rows compiling = number_from_or_to_zero("GL_LIST_INDEX") + number_from_or_to_zero("GL_LIST_MODE");
    expect_changes(kEnable, [=] { glCallList(list); });
    expect_nothing([=] { glCallList(list); });
    expect_changes(kEnable, [=] { glCallList(list + 1); });
    expect_changes(compiling, [=] { glNewList(list, GL_COMPILE); });
    expect_nothing(enable);
    expect_nothing([] { draw_rect(kWhole, kNear); });
    expect_changes(compiling, [] { glEndList(); });
    // The second redefines nothing: the list exists already.
    expect_nothing([=] {
        glNewList(list, GL_COMPILE);
        enable();
        glEndList();
    });
    read_result();
}

TEST_F(HpCalls, refused_calls_change_nothing) {
    expect_refusal(GL_INVALID_ENUM, [] { glEnable(GL_OCCLUSION_TEST_RESULT_HP); });
    expect_refusal(GL_INVALID_ENUM, [] { glIsEnabled(GL_OCCLUSION_TEST_RESULT_HP); });
    expect_refusal(GL_INVALID_OPERATION, [] {
        glBegin(GL_POINTS);
        enable();
        glEnd();
    });
    enable();
    expect_refusal(GL_INVALID_ENUM, [] { glBegin(GL_TEXTURE_2D); });
    expect_refusal(GL_INVALID_OPERATION, [] { glEnd(); });
}

TEST_F(HpCalls, flush_finish_swap_and_losing_the_context_change_nothing) {
    enable();
    draw_rect(kWhole, kNear);
    expect_nothing([] { glFlush(); });
    expect_nothing([] { glFinish(); });
    expect_nothing([this] { surface().swap(); });
    expect_nothing([this] {
        conformance::Context::release_current();
        come_back();
    });
    EXPECT_TRUE(read_result());
}

}  // namespace
}  // namespace tests
