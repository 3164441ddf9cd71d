// SPDX-License-Identifier: MIT
// Errors, other state, and robustness of the HP calls (HP-69 to HP-73, HP-75).
#include <array>
#include <cstdio>

#include "hp_occlusion_test/hp_test.h"

namespace conformance {
namespace {

class Errors : public HpTest {};

long resident_kilobytes() {
    long pages = 0;
    if (std::FILE* file = std::fopen("/proc/self/statm", "r")) {
        if (std::fscanf(file, "%*d %ld", &pages) != 1) pages = 0;
        std::fclose(file);
    }
    return pages * 4;
}

// HP-69. GL without a current context is undefined by the texts; the project decides: nothing is written, no
// crash.
TEST_F(Errors, a_read_without_a_context_does_nothing) {
    pass_one_fragment();
    Context::release_current();
    GLboolean result = 0xAA;
    glGetBooleanv(GL_OCCLUSION_TEST_RESULT_HP, &result);
    glEnable(GL_OCCLUSION_TEST_HP);
    EXPECT_EQ(result, 0xAA);
    come_back();
    EXPECT_FALSE(test_enabled());
    EXPECT_TRUE(read_result());
}

// HP-70. HP, New Tokens, names four Gets; the indexed and the pointer forms are not of them.
TEST_F(Errors, indexed_and_pointer_gets_do_not_know_the_result) {
    pass_one_fragment();
    void* pointer = this;
    glGetPointerv(GL_OCCLUSION_TEST_RESULT_HP, &pointer);
    EXPECT_TRUE(error_is(GL_INVALID_ENUM));
    EXPECT_EQ(pointer, this);
    if (!lacks(30)) {
        GLboolean boolean = 0xAA;
        GLint integer = -1;
        glGetBooleani_v(GL_OCCLUSION_TEST_RESULT_HP, 0, &boolean);
        EXPECT_TRUE(error_is(GL_INVALID_ENUM));
        glGetIntegeri_v(GL_OCCLUSION_TEST_RESULT_HP, 0, &integer);
        EXPECT_TRUE(error_is(GL_INVALID_ENUM));
        EXPECT_EQ(boolean, 0xAA);
        EXPECT_EQ(integer, -1);
    }
    EXPECT_TRUE(read_result()) << "a refused Get cleared the result";
}

// HP-71. Other values of the Gets are the driver's, also those of several numbers.
TEST_F(Errors, gets_of_other_state_still_answer) {
    glViewport(3, 5, 7, 11);
    glDepthRange(0.125, 0.75);
    glColorMask(GL_TRUE, GL_FALSE, GL_TRUE, GL_FALSE);
    std::array<GLint, 4> viewport{};
    std::array<GLdouble, 2> range{};
    std::array<GLfloat, 16> matrix{};
    std::array<GLboolean, 4> mask{};
    glGetIntegerv(GL_VIEWPORT, viewport.data());
    glGetDoublev(GL_DEPTH_RANGE, range.data());
    glGetFloatv(GL_MODELVIEW_MATRIX, matrix.data());
    glGetBooleanv(GL_COLOR_WRITEMASK, mask.data());
    EXPECT_EQ(viewport, (std::array<GLint, 4>{3, 5, 7, 11}));
    EXPECT_EQ(range, (std::array<GLdouble, 2>{0.125, 0.75}));
    EXPECT_EQ(mask, (std::array<GLboolean, 4>{GL_TRUE, GL_FALSE, GL_TRUE, GL_FALSE}));
    for (std::size_t i = 0; i < matrix.size(); ++i) EXPECT_EQ(matrix[i], i % 5 == 0 ? 1.0f : 0.0f);
    GLint untouched = -1;
    glGetIntegerv(0xFFFF, &untouched);
    EXPECT_TRUE(error_is(GL_INVALID_ENUM));
    EXPECT_EQ(untouched, -1);
}

// HP-72. The stack's other groups are as before.
TEST_F(Errors, the_attribute_stack_still_holds_all_other_state) {
    glEnable(GL_LIGHTING);
    glDepthFunc(GL_GEQUAL);
    glPushAttrib(GL_ENABLE_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_OCCLUSION_TEST_HP);
    glDisable(GL_LIGHTING);
    glEnable(GL_FOG);
    glDepthFunc(GL_NEVER);
    EXPECT_EQ(get_integer(GL_ATTRIB_STACK_DEPTH), 1);
    glPopAttrib();
    EXPECT_EQ(get_integer(GL_ATTRIB_STACK_DEPTH), 0);
    EXPECT_TRUE(glIsEnabled(GL_LIGHTING));
    EXPECT_FALSE(glIsEnabled(GL_FOG));
    EXPECT_EQ(get_integer(GL_DEPTH_FUNC), GL_GEQUAL);
    EXPECT_FALSE(test_enabled());
}

// HP-73. Enable and Disable are cheap state: a million pairs may not eat memory. 8 MiB is 8 bytes a pair,
// less than any record of one.
TEST_F(Errors, a_million_pairs_of_enable_and_disable_cost_no_memory) {
    pass_one_fragment();
    EXPECT_TRUE(read_result());
    const long before = resident_kilobytes();
    ASSERT_GT(before, 0);
    for (int i = 0; i < 1000000; ++i) {
        glEnable(GL_OCCLUSION_TEST_HP);
        glDisable(GL_OCCLUSION_TEST_HP);
    }
    EXPECT_FALSE(read_result());
    EXPECT_LT(resident_kilobytes() - before, 8 * 1024);
}

// HP-75. GL 4.5, 2.3.1: the flag keeps the first error until GetError returns it; a call without error does
// not touch it.
TEST_F(Errors, an_error_of_the_applications_own_stays_pending_through_hp_calls) {
    glCullFace(0xFFFF);  // INVALID_ENUM, the application's own
    EXPECT_TRUE(result_of([] { draw_rect(kWhole, kMiddle); }));
    glPushAttrib(GL_ENABLE_BIT);
    glEnable(GL_OCCLUSION_TEST_HP);
    glPopAttrib();
    EXPECT_TRUE(error_is(GL_INVALID_ENUM));
    EXPECT_TRUE(no_error());
}

// HP-75. The first of two errors is kept: the application's before HP's, and HP's before the application's.
TEST_F(Errors, the_first_of_two_errors_is_the_one_reported) {
    glLineWidth(-1.0f);                     // INVALID_VALUE
    glEnable(GL_OCCLUSION_TEST_RESULT_HP);  // INVALID_ENUM
    EXPECT_TRUE(error_is(GL_INVALID_VALUE));
    EXPECT_TRUE(no_error());

    glEnable(GL_OCCLUSION_TEST_RESULT_HP);
    glLineWidth(-1.0f);
    EXPECT_TRUE(error_is(GL_INVALID_ENUM));
    EXPECT_TRUE(no_error());
}

// HP-75. No HP call sets an error of its own accord, however often it draws, waits or reads.
TEST_F(Errors, a_valid_sequence_leaves_no_error) {
    for (int i = 0; i < 100; ++i) {
        EXPECT_TRUE(result_of([] { draw_rect(kWhole, kMiddle); }));
        EXPECT_TRUE(no_error());
    }
}

}  // namespace
}  // namespace conformance
