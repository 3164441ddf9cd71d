// SPDX-License-Identifier: MIT
// The result: when it is TRUE, and that a read, and only a read, clears it (HP-22 to HP-38).
#include "hp_occlusion_test/hp_test.h"

namespace conformance {
namespace {

class Result : public HpTest {};

// One Get form each; the value comes back as 0, 1 or whatever else was written.
using Read = double (*)();

double read_boolean() {
    GLboolean value = 0xAA;
    glGetBooleanv(GL_OCCLUSION_TEST_RESULT_HP, &value);
    return value;
}

double read_integer() {
    GLint value = -1;
    glGetIntegerv(GL_OCCLUSION_TEST_RESULT_HP, &value);
    return value;
}

double read_float() {
    GLfloat value = -1.0f;
    glGetFloatv(GL_OCCLUSION_TEST_RESULT_HP, &value);
    return static_cast<double>(value);
}

double read_double() {
    GLdouble value = -1.0;
    glGetDoublev(GL_OCCLUSION_TEST_RESULT_HP, &value);
    return value;
}

double read_integer64() {
    GLint64 value = -1;
    glGetInteger64v(GL_OCCLUSION_TEST_RESULT_HP, &value);
    return static_cast<double>(value);
}

std::vector<Read> reads() {
    std::vector<Read> forms = {read_boolean, read_integer, read_float, read_double};
    if (!lacks(32, "GL_ARB_sync")) forms.push_back(read_integer64);
    return forms;
}

// HP-22. HP, New State: "Boolean result of occlusion test, initial value of FALSE."
TEST_F(Result, a_new_context_has_the_result_false) {
    EXPECT_FALSE(read_result());
    EXPECT_TRUE(no_error());
}

// HP-23, HP-24. HP, Overview: "to determine if any of the geometry could or did modify the depth buffer, ie.
// a depth buffer test succeeded".
TEST_F(Result, the_result_is_true_exactly_when_a_fragment_passes) {
    draw_occluder();
    EXPECT_TRUE(result_of([] { draw_rect({8, 8, 16, 16}, kNear); }));
    EXPECT_EQ(drawn_pixels(), 16 * 16);

    draw_occluder();
    EXPECT_FALSE(result_of([] { draw_rect({8, 8, 16, 16}, kFar); }));
    EXPECT_EQ(drawn_pixels(), 0);
}

// HP-25. HP, Overview: no geometry, hence none "could or did modify the depth buffer".
TEST_F(Result, drawing_nothing_gives_false) {
    EXPECT_FALSE(result_of([] {}));
    EXPECT_FALSE(result_of([] {
        glBegin(GL_TRIANGLES);
        glEnd();
    }));
}

// HP-26. NV 4.1.6A: the result is set when "OCCLUSION_TEST_HP is enabled or an occlusion query is active".
TEST_F(Result, drawing_while_disabled_gives_false) {
    draw_rect(kWhole, kMiddle);
    EXPECT_FALSE(read_result());
}

// HP-27. HP, Overview: "if any of the geometry could or did modify the depth buffer": order is no matter.
TEST_F(Result, one_visible_primitive_among_many_gives_true_wherever_it_stands) {
    constexpr int kPrimitives = 64;
    for (const int visible : {0, kPrimitives / 2, kPrimitives - 1}) {
        SCOPED_TRACE(visible);
        draw_occluder();
        EXPECT_TRUE(result_of([visible] {
            for (int i = 0; i < kPrimitives; ++i) draw_rect({i, 0, 1, 1}, i == visible ? kNear : kFar);
        }));
        EXPECT_EQ(drawn_pixels(), 1);
    }
}

// HP-28. HP, New Tokens: the result is "Accepted by the <pname> of GetBooleanv, GetIntegerv, GetFloatv, and
// GetDoublev"; GL 4.5, 2.2.2 gives boolean state as 1 or 0.
TEST_F(Result, every_get_returns_true_as_one_and_false_as_zero) {
    const auto forms = reads();
    for (std::size_t form = 0; form < forms.size(); ++form) {
        SCOPED_TRACE(form);
        pass_one_fragment();
        EXPECT_EQ(forms[form](), 1.0);
        EXPECT_TRUE(no_error());
    }
    for (const Read read : forms) EXPECT_EQ(read(), 0.0);
}

// HP-29. HP, New State: "The result is set to FALSE as a side effect of reading it (executing a Get call)."
TEST_F(Result, every_get_clears_the_result_for_every_get) {
    const auto forms = reads();
    for (std::size_t first = 0; first < forms.size(); ++first) {
        for (std::size_t second = 0; second < forms.size(); ++second) {
            pass_one_fragment();
            EXPECT_EQ(forms[first](), 1.0);
            EXPECT_EQ(forms[second](), 0.0) << "form " << second << " after form " << first;
        }
    }
}

// HP-30. As above: FALSE stays FALSE.
TEST_F(Result, reading_false_leaves_false) {
    for (int i = 0; i < 4; ++i) EXPECT_FALSE(read_result());
    EXPECT_TRUE(no_error());
}

// HP-31. HP, New State: reading *it* clears it; no other Get does.
TEST_F(Result, reading_other_state_does_not_clear_the_result) {
    pass_one_fragment();
    GLboolean boolean = GL_FALSE;
    GLdouble twice = 0.0;
    GLfloat single = 0.0f;
    glGetBooleanv(GL_OCCLUSION_TEST_HP, &boolean);
    glGetDoublev(GL_OCCLUSION_TEST_HP, &twice);
    glGetFloatv(GL_DEPTH_CLEAR_VALUE, &single);
    get_integer(GL_OCCLUSION_TEST_HP);
    get_integer(GL_DEPTH_TEST);
    glIsEnabled(GL_OCCLUSION_TEST_HP);
    glIsEnabled(GL_DEPTH_TEST);
    glGetString(GL_EXTENSIONS);
    EXPECT_TRUE(read_result());
}

// HP-32. As above, of commands that are no Get.
TEST_F(Result, no_other_command_clears_or_sets_the_result) {
    for (const bool pending : {true, false}) {
        if (pending) pass_one_fragment();
        glGetError();
        glFlush();
        glFinish();
        read_colours();
        read_depths();
        surface().swap();
        EXPECT_EQ(read_result(), pending);
    }
}

// HP-33. HP, Overview: reading the result clears it, "setting it up for a new bounding box test"; the enable
// is not touched, so a loop of draw and Get under one Enable gives one answer a box.
TEST_F(Result, a_read_while_enabled_starts_the_next_test) {
    draw_occluder();
    glDepthMask(GL_FALSE);
    glEnable(GL_OCCLUSION_TEST_HP);
    for (int box = 0; box < 32; ++box) {
        const bool visible = box % 3 == 0;
        draw_rect({box, box, 8, 8}, visible ? kNear : kFar);
        EXPECT_EQ(read_result(), visible) << "box " << box;
    }
    EXPECT_TRUE(test_enabled());
}

// HP-34. HP, expected usage: the result is read after "disable occlusion test".
TEST_F(Result, disable_does_not_clear_the_result) {
    pass_one_fragment();
    glDisable(GL_OCCLUSION_TEST_HP);
    EXPECT_TRUE(read_result());
}

// HP-35. HP, New State: only reading clears.
TEST_F(Result, enable_does_not_clear_the_result) {
    draw_occluder();
    pass_one_fragment();
    glEnable(GL_OCCLUSION_TEST_HP);
    draw_rect(kWhole, kFar);
    glDisable(GL_OCCLUSION_TEST_HP);
    EXPECT_TRUE(read_result());
}

// HP-36. NV 4.1.6A: counting needs the enable.
TEST_F(Result, drawing_between_disable_and_read_does_not_alter_false) {
    draw_occluder();
    glEnable(GL_OCCLUSION_TEST_HP);
    draw_rect(kWhole, kFar);
    glDisable(GL_OCCLUSION_TEST_HP);
    draw_rect(kWhole, kNear);
    EXPECT_FALSE(read_result());
    EXPECT_EQ(drawn_pixels(), kWhole.area());
}

// HP-37. NV, Errors: INVALID_OPERATION between Begin and End; GL 4.5, 2.3.1: then the command has no other
// effect.
TEST_F(Result, a_get_between_begin_and_end_neither_writes_nor_clears) {
    pass_one_fragment();
    GLboolean result = 0xAA;
    glBegin(GL_POINTS);
    glGetBooleanv(GL_OCCLUSION_TEST_RESULT_HP, &result);
    glEnd();
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
    EXPECT_EQ(result, 0xAA);
    EXPECT_TRUE(read_result());
}

}  // namespace
}  // namespace conformance
