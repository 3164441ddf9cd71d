// SPDX-License-Identifier: MIT
// The enable OCCLUSION_TEST_HP: who may set it, who may ask for it, and who is refused (HP-01 to HP-11).
#include "hp_occlusion_test/hp_test.h"

namespace conformance {
namespace {

class EnableState : public HpTest {};

// HP-01. NV_occlusion_query, New State: "OCCLUSION_TEST_HP  B  IsEnabled  FALSE".
TEST_F(EnableState, the_test_is_disabled_in_a_new_context) {
    EXPECT_EQ(glIsEnabled(GL_OCCLUSION_TEST_HP), GL_FALSE);
    EXPECT_TRUE(no_error());
}

// HP-02, HP-06. HP, New Tokens: "Accepted by the <cap> parameter of Enable, Disable, and IsEnabled ...
// OCCLUSION_TEST_HP".
TEST_F(EnableState, enable_and_disable_are_seen_by_is_enabled) {
    glEnable(GL_OCCLUSION_TEST_HP);
    EXPECT_TRUE(no_error());
    EXPECT_EQ(glIsEnabled(GL_OCCLUSION_TEST_HP), GL_TRUE);
    EXPECT_TRUE(no_error());

    glDisable(GL_OCCLUSION_TEST_HP);
    EXPECT_TRUE(no_error());
    EXPECT_EQ(glIsEnabled(GL_OCCLUSION_TEST_HP), GL_FALSE);
    EXPECT_TRUE(no_error());
}

// HP-03, HP-06. HP, New Tokens: "... by the <pname> of GetBooleanv, GetIntegerv, GetFloatv, and GetDoublev :
// OCCLUSION_TEST_HP".
TEST_F(EnableState, the_four_gets_return_the_enable_in_their_own_type) {
    for (const bool enabled : {true, false}) {
        SCOPED_TRACE(enabled ? "enabled" : "disabled");
        (enabled ? glEnable : glDisable)(GL_OCCLUSION_TEST_HP);

        GLboolean boolean = 0xAA;
        GLint integer = -1;
        GLfloat single = -1.0f;
        GLdouble twice = -1.0;
        glGetBooleanv(GL_OCCLUSION_TEST_HP, &boolean);
        glGetIntegerv(GL_OCCLUSION_TEST_HP, &integer);
        glGetFloatv(GL_OCCLUSION_TEST_HP, &single);
        glGetDoublev(GL_OCCLUSION_TEST_HP, &twice);

        EXPECT_EQ(boolean, enabled ? GL_TRUE : GL_FALSE);
        EXPECT_EQ(integer, enabled ? 1 : 0);
        EXPECT_EQ(single, enabled ? 1.0f : 0.0f);
        EXPECT_EQ(twice, enabled ? 1.0 : 0.0);
        EXPECT_TRUE(no_error());
    }
}

// HP-04. GL 4.5, 2.2.2: a state variable may be had by any Get; the value is converted to the type of the
// command.
TEST_F(EnableState, the_64_bit_get_returns_the_enable) {
    if (const auto why = lacks(32, "GL_ARB_sync")) GTEST_SKIP() << *why;
    GLint64 value = -1;
    glEnable(GL_OCCLUSION_TEST_HP);
    glGetInteger64v(GL_OCCLUSION_TEST_HP, &value);
    EXPECT_EQ(value, 1);
    glDisable(GL_OCCLUSION_TEST_HP);
    glGetInteger64v(GL_OCCLUSION_TEST_HP, &value);
    EXPECT_EQ(value, 0);
}

// HP-05. The enable is one bit (NV, New State: type B): enables do not nest.
TEST_F(EnableState, one_disable_undoes_two_enables) {
    glEnable(GL_OCCLUSION_TEST_HP);
    glEnable(GL_OCCLUSION_TEST_HP);
    glDisable(GL_OCCLUSION_TEST_HP);
    EXPECT_FALSE(test_enabled());
}

// HP-07. HP, New Tokens: OCCLUSION_TEST_RESULT_HP is accepted "by the <pname> of" the Gets and by nothing
// else.
TEST_F(EnableState, the_result_token_is_no_capability) {
    pass_one_fragment();
    glEnable(GL_OCCLUSION_TEST_RESULT_HP);
    EXPECT_TRUE(error_is(GL_INVALID_ENUM));
    glDisable(GL_OCCLUSION_TEST_RESULT_HP);
    EXPECT_TRUE(error_is(GL_INVALID_ENUM));
    EXPECT_EQ(glIsEnabled(GL_OCCLUSION_TEST_RESULT_HP), GL_FALSE);
    EXPECT_TRUE(error_is(GL_INVALID_ENUM));

    EXPECT_FALSE(test_enabled());
    EXPECT_TRUE(read_result()) << "a refused call cleared the result";
}

// HP-08. HP names Enable, Disable and IsEnabled only; GL 4.5, 2.2.1: an indexed form that does not know its
// target generates INVALID_ENUM.
TEST_F(EnableState, the_indexed_forms_do_not_know_the_test) {
    if (const auto why = lacks(30)) GTEST_SKIP() << *why;
    glEnablei(GL_OCCLUSION_TEST_HP, 0);
    EXPECT_TRUE(error_is(GL_INVALID_ENUM));
    EXPECT_FALSE(test_enabled());

    glEnable(GL_OCCLUSION_TEST_HP);
    glDisablei(GL_OCCLUSION_TEST_HP, 0);
    EXPECT_TRUE(error_is(GL_INVALID_ENUM));
    EXPECT_TRUE(test_enabled());
    EXPECT_EQ(glIsEnabledi(GL_OCCLUSION_TEST_HP, 0), GL_FALSE);
    EXPECT_TRUE(error_is(GL_INVALID_ENUM));
}

// HP-09. HP names Enable and Disable only; EnableClientState takes the names of arrays and nothing else.
TEST_F(EnableState, the_test_is_no_client_state) {
    glEnableClientState(GL_OCCLUSION_TEST_HP);
    EXPECT_TRUE(error_is(GL_INVALID_ENUM));
    EXPECT_FALSE(test_enabled());

    glEnable(GL_OCCLUSION_TEST_HP);
    glDisableClientState(GL_OCCLUSION_TEST_HP);
    EXPECT_TRUE(error_is(GL_INVALID_ENUM));
    EXPECT_TRUE(test_enabled());
}

// HP-10. GL 4.5 compatibility, 10.7.5: the commands allowed within Begin and End are listed there; any other
// is INVALID_OPERATION. NV, Errors, says the same of all it defines.
TEST_F(EnableState, enable_and_disable_are_refused_between_begin_and_end) {
    glBegin(GL_POINTS);
    glEnable(GL_OCCLUSION_TEST_HP);
    glEnd();
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
    EXPECT_FALSE(test_enabled());

    glEnable(GL_OCCLUSION_TEST_HP);
    glBegin(GL_POINTS);
    glDisable(GL_OCCLUSION_TEST_HP);
    glEnd();
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
    EXPECT_TRUE(test_enabled());
}

// HP-11. As above; GL 4.5, 2.3.1: a command in error that returns a value returns zero.
TEST_F(EnableState, is_enabled_is_refused_between_begin_and_end_and_returns_false) {
    glEnable(GL_OCCLUSION_TEST_HP);
    glBegin(GL_POINTS);
    const GLboolean enabled = glIsEnabled(GL_OCCLUSION_TEST_HP);
    glEnd();
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
    EXPECT_EQ(enabled, GL_FALSE);
    EXPECT_TRUE(test_enabled());
}

}  // namespace
}  // namespace conformance
