// SPDX-License-Identifier: MIT
// The enable on the attribute stack, and the result off it (HP-12 to HP-21).
//
// NV_occlusion_query, New State, gives OCCLUSION_TEST_HP the attribute group "enable" and
// OCCLUSION_TEST_RESULT_HP the group "-". The group is decided to be that one only; Mesa of old also kept the
// enable in its depth group.
#include "hp_occlusion_test/hp_test.h"

namespace conformance {
namespace {

class AttributeStack : public HpTest {};

void set_test(bool enabled) {
    (enabled ? glEnable : glDisable)(GL_OCCLUSION_TEST_HP);
}

// HP-12, HP-13. NV, New State: attribute "enable"; GL 4.5 compatibility, 21.5: ALL_ATTRIB_BITS holds every
// group.
TEST_F(AttributeStack, the_enable_group_saves_and_restores_the_enable) {
    for (const GLbitfield mask : {GLbitfield{GL_ENABLE_BIT}, GLbitfield{GL_ALL_ATTRIB_BITS}}) {
        for (const bool saved : {false, true}) {
            SCOPED_TRACE(saved ? "saved enabled" : "saved disabled");
            set_test(saved);
            glPushAttrib(mask);
            EXPECT_EQ(test_enabled(), saved) << "the push changed the enable";
            set_test(!saved);
            glPopAttrib();
            EXPECT_EQ(test_enabled(), saved);
            EXPECT_TRUE(no_error());
        }
    }
}

// HP-14. NV, New State: "enable" is the only group of OCCLUSION_TEST_HP.
TEST_F(AttributeStack, no_other_group_saves_the_enable) {
    for (int bit = 0; bit < 20; ++bit) {
        const GLbitfield mask = GLbitfield{1} << bit;
        if (mask == GL_ENABLE_BIT) continue;
        SCOPED_TRACE(bit);
        set_test(false);
        glPushAttrib(mask);
        set_test(true);
        glPopAttrib();
        EXPECT_TRUE(test_enabled());
    }
    EXPECT_TRUE(no_error());
}

// HP-15. Every GL since 1.0 has an attribute stack of at least 16 levels (MAX_ATTRIB_STACK_DEPTH).
TEST_F(AttributeStack, sixteen_nested_pushes_restore_level_by_level) {
    constexpr int kLevels = 16;
    const auto state_of = [](int level) { return level % 3 == 0; };
    for (int level = 0; level < kLevels; ++level) {
        set_test(state_of(level));
        glPushAttrib(level % 2 == 0 ? GL_ENABLE_BIT : GL_ALL_ATTRIB_BITS);
    }
    EXPECT_TRUE(no_error());
    set_test(!state_of(kLevels - 1));
    for (int level = kLevels - 1; level >= 0; --level) {
        glPopAttrib();
        EXPECT_EQ(test_enabled(), state_of(level)) << "level " << level;
    }
    EXPECT_TRUE(no_error());
}

// HP-16. NV, issue on overlap: an error "would require that PopAttrib be capable of producing an error".
TEST_F(AttributeStack, a_pop_that_toggles_the_test_is_no_error) {
    for (const bool saved : {false, true}) {
        set_test(saved);
        glPushAttrib(GL_ENABLE_BIT);
        set_test(!saved);
        draw_rect(kWhole, kMiddle);
        glPopAttrib();
        EXPECT_TRUE(no_error());
    }
}

// HP-17. NV, New State: the attribute of OCCLUSION_TEST_RESULT_HP is "-".
TEST_F(AttributeStack, a_pop_does_not_bring_a_read_result_back) {
    pass_one_fragment();
    glPushAttrib(GL_ALL_ATTRIB_BITS);
    EXPECT_TRUE(read_result());
    glPopAttrib();
    EXPECT_FALSE(read_result());

    glPushAttrib(GL_ALL_ATTRIB_BITS);
    pass_one_fragment();
    glPopAttrib();
    EXPECT_TRUE(read_result()) << "the pop restored an older result";
}

// HP-18. PopAttrib restores the enable as Enable and Disable would set it.
TEST_F(AttributeStack, a_pop_starts_and_stops_counting) {
    set_test(true);
    glPushAttrib(GL_ENABLE_BIT);
    set_test(false);
    draw_rect(kWhole, kMiddle);
    EXPECT_FALSE(read_result());
    glPopAttrib();
    draw_rect(kWhole, kMiddle);
    EXPECT_TRUE(read_result()) << "the pop enabled the test, but nothing was counted";

    set_test(false);
    glPushAttrib(GL_ENABLE_BIT);
    set_test(true);
    glPopAttrib();
    draw_rect(kWhole, kMiddle);
    EXPECT_FALSE(read_result()) << "the pop disabled the test, but counting went on";
}

// HP-19. HP, expected usage, in the order that a scene graph uses it: the result outlives the pop of its
// state.
TEST_F(AttributeStack, the_result_can_be_read_after_the_state_was_popped) {
    for (const bool visible : {true, false}) {
        draw_occluder();
        glPushAttrib(GL_ENABLE_BIT | GL_DEPTH_BUFFER_BIT | GL_COLOR_BUFFER_BIT);
        glDepthMask(GL_FALSE);
        glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
        set_test(true);
        draw_rect(kWhole, visible ? kNear : kFar);
        set_test(false);
        glPopAttrib();
        EXPECT_EQ(read_result(), visible);
    }
}

// HP-20. The client stack holds pixel store and vertex array state; NV, New State, puts the enable in
// "enable".
TEST_F(AttributeStack, the_client_stack_touches_neither_enable_nor_result) {
    pass_one_fragment();
    glPushClientAttrib(GL_CLIENT_ALL_ATTRIB_BITS);
    set_test(true);
    glPopClientAttrib();
    EXPECT_TRUE(test_enabled());
    EXPECT_TRUE(read_result());
}

// HP-21. GL 4.5, 2.3.1: a command that generates an error has no other effect.
TEST_F(AttributeStack, an_overflow_or_underflow_changes_neither_enable_nor_result) {
    const int depth = get_integer(GL_MAX_ATTRIB_STACK_DEPTH);
    set_test(true);
    for (int level = 0; level < depth; ++level) glPushAttrib(GL_ENABLE_BIT);
    EXPECT_TRUE(no_error());
    pass_one_fragment();
    glPushAttrib(GL_ENABLE_BIT);
    EXPECT_TRUE(error_is(GL_STACK_OVERFLOW));
    EXPECT_FALSE(test_enabled());
    EXPECT_TRUE(read_result());

    for (int level = 0; level < depth; ++level) glPopAttrib();
    EXPECT_TRUE(no_error());
    EXPECT_TRUE(test_enabled()) << "the refused push was popped";
    set_test(false);
    pass_one_fragment();
    glPopAttrib();
    EXPECT_TRUE(error_is(GL_STACK_UNDERFLOW));
    EXPECT_FALSE(test_enabled());
    EXPECT_TRUE(read_result());
}

}  // namespace
}  // namespace conformance
