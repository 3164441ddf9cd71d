// SPDX-License-Identifier: MIT
// The result: when it is TRUE, and that a read, and only a read, clears it (HP-22 to HP-36).
#include "hp_occlusion_test/hp_test.h"

namespace conformance {
namespace {

class Result : public HpTest {};

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
    if (!lacks("GL_NV_occlusion_query")) {
        get_integer(GL_CURRENT_OCCLUSION_QUERY_ID_NV);
        get_integer(GL_PIXEL_COUNTER_BITS_NV);
    }
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

}  // namespace
}  // namespace conformance
