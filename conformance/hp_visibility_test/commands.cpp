// SPDX-License-Identifier: MIT
// GL_HP_visibility_test: its enable, errors, display lists, and other queries (HPV-01, HPV-06).
#include "harness/query.h"
#include "hp_visibility_test/visibility_test.h"

namespace conformance {
namespace {

class VisibilityCommands : public VisibilityTest {};

// HPV-01. The capability is one for glEnable, glDisable and glIsEnabled.
TEST_F(VisibilityCommands, the_test_is_disabled_at_first) {
    EXPECT_FALSE(glIsEnabled(kVisibilityTest));
    define();
    EXPECT_FALSE(glIsEnabled(kVisibilityTest));
    glEnable(kVisibilityTest);
    EXPECT_TRUE(glIsEnabled(kVisibilityTest));
    glEnable(kVisibilityTest);
    glDisable(kVisibilityTest);
    EXPECT_FALSE(glIsEnabled(kVisibilityTest));
    glDisable(kVisibilityTest);
    EXPECT_TRUE(no_error());
}

// HPV-01, decided: no source names an attribute group, and a pop that begins or ends a batch would surprise.
TEST_F(VisibilityCommands, no_attribute_group_saves_the_enable) {
    define();
    glPushAttrib(GL_ALL_ATTRIB_BITS);
    glEnable(kVisibilityTest);
    glPopAttrib();
    EXPECT_TRUE(glIsEnabled(kVisibilityTest));
    glDisable(kVisibilityTest);
}

// HPV-06. "GL_INVALID_VALUE is generated if 'size' is negative."
TEST_F(VisibilityCommands, a_negative_size_is_refused_and_changes_nothing) {
    define();
    std::array<GLboolean, 4> other{};
    visibility_buffer(-1, other.data(), GL_TRUE);
    EXPECT_TRUE(error_is(GL_INVALID_VALUE));
    glEnable(kVisibilityTest);
    see();
    glDisable(kVisibilityTest);
    get_all();
    EXPECT_EQ(results[0], GL_TRUE) << "the old buffer stands";
}

// HPV-06. "GL_INVALID_OPERATION is generated if glVisibilityBufferhp is called while GL_VISIBILITY_TEST_hp is
// enabled".
TEST_F(VisibilityCommands, the_buffer_cannot_change_while_the_test_is_enabled) {
    define();
    glEnable(kVisibilityTest);
    std::array<GLboolean, 4> other{};
    visibility_buffer(4, other.data(), GL_TRUE);
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
    see();
    glDisable(kVisibilityTest);
    get_all();
    EXPECT_EQ(results[0], GL_TRUE);
    EXPECT_EQ(other[0], GL_FALSE);
    visibility_buffer(4, other.data(), GL_TRUE);
    EXPECT_TRUE(no_error());
}

// HPV-06. "or if glEnable(GL_VISIBILITY_TEST_hp) is called before glVisibilityBufferhp is called at least
// once."
TEST_F(VisibilityCommands, there_is_no_test_without_a_buffer) {
    glEnable(kVisibilityTest);
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
    EXPECT_FALSE(glIsEnabled(kVisibilityTest));
    visibility_buffer(-1, results.data(), GL_TRUE);
    EXPECT_TRUE(error_is(GL_INVALID_VALUE));
    glEnable(kVisibilityTest);
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION)) << "that call had failed";
}

// HPV-06, decided: a next test needs one that is under way.
TEST_F(VisibilityCommands, the_next_test_needs_one_that_is_enabled) {
    define();
    next_test();
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
    glEnable(kVisibilityTest);
    next_test();
    glDisable(kVisibilityTest);
    EXPECT_TRUE(no_error());
    next_test();
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
}

// HPV-06. "GL_INVALID_OPERATION is generated if glVisibilityBufferhp is called between a call to glBegin and
// the corresponding call to glEnd"; GL 1.1, 2.6.3, of every other command of the kind.
TEST_F(VisibilityCommands, every_command_is_refused_between_begin_and_end) {
    const auto inside = [](auto command) {
        glBegin(GL_POINTS);
        command();
        glEnd();
        return error_is(GL_INVALID_OPERATION);
    };
    EXPECT_TRUE(inside([&] { define(); }));
    glEnable(kVisibilityTest);
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION)) << "the buffer was defined inside";
    define();
    EXPECT_TRUE(inside([] { glEnable(kVisibilityTest); }));
    EXPECT_FALSE(glIsEnabled(kVisibilityTest));
    glEnable(kVisibilityTest);
    EXPECT_TRUE(inside([&] { next_test(); }));
    EXPECT_TRUE(inside([] { glDisable(kVisibilityTest); }));
    EXPECT_TRUE(glIsEnabled(kVisibilityTest));
    see();
    glDisable(kVisibilityTest);
    get_all();
    EXPECT_EQ(results[0], GL_TRUE) << "the next test was begun inside";
    EXPECT_TRUE(inside([] { get(); }));
}

// HPV-01, decided: Enable, Disable and NextVisibilityTest are compiled, as HP's occlusion test is;
// VisibilityBuffer, which hands over client memory, is executed at once, as FeedbackBuffer is (GL 1.1, 5.4).
TEST_F(VisibilityCommands, a_whole_batch_can_be_compiled) {
    occlude();
    const GLuint list = glGenLists(1);
    glNewList(list, GL_COMPILE);
    define();
    glEnable(kVisibilityTest);
    miss();
    next_test();
    see();
    glDisable(kVisibilityTest);
    glEndList();
    EXPECT_FALSE(glIsEnabled(kVisibilityTest));
    for (int call = 0; call < 2; ++call) {
        results.fill(kUnwritten);
        glCallList(list);
        EXPECT_TRUE(no_error()) << "the buffer's definition was compiled, not executed";
        get_all();
        EXPECT_EQ(results[0], GL_FALSE);
        EXPECT_EQ(results[1], GL_TRUE);
        EXPECT_TRUE(is_unwritten(2));
    }
}

TEST_F(VisibilityCommands, a_batch_that_is_compiled_and_executed_is_tested_at_once) {
    occlude();
    define();
    glNewList(glGenLists(1), GL_COMPILE_AND_EXECUTE);
    see();
    glEnable(kVisibilityTest);
    miss();
    next_test();
    see();
    glDisable(kVisibilityTest);
    glEndList();
    get_all();
    EXPECT_EQ(results[0], GL_FALSE);
    EXPECT_EQ(results[1], GL_TRUE);
}

// HPV-03, decided: the occlusion test's flag, where both are enabled, sees the same fragments.
TEST_F(VisibilityCommands, the_occlusion_test_goes_on_beside_a_batch) {
    if (const auto why = lacks("GL_HP_occlusion_test")) GTEST_SKIP() << *why;
    const auto flag = [] {
        GLboolean value = kUnwritten;
        glGetBooleanv(GL_OCCLUSION_TEST_RESULT_HP, &value);
        return value;
    };
    occlude();
    define();
    glEnable(kVisibilityTest);
    see();
    glEnable(GL_OCCLUSION_TEST_HP);
    next_test();
    miss();
    EXPECT_EQ(flag(), GL_FALSE);
    next_test();
    see();
    EXPECT_EQ(flag(), GL_TRUE);
    glDisable(GL_OCCLUSION_TEST_HP);
    see();
    EXPECT_EQ(flag(), GL_FALSE);
    glDisable(kVisibilityTest);
    get_all();
    const std::array<GLboolean, 3> expected = {GL_TRUE, GL_FALSE, GL_TRUE};
    for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_EQ(results[i], expected[i]) << i;
}

// HPV-01, decided: a batch has the machine's one counter, so no query begins in it, nor it in a query.
TEST_F(VisibilityCommands, a_batch_and_a_query_exclude_each_other) {
    if (const auto why = lacks(15)) GTEST_SKIP() << *why;
    define();
    const Query samples;
    samples.begin();
    glEnable(kVisibilityTest);
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
    EXPECT_FALSE(glIsEnabled(kVisibilityTest));
    draw_rect({0, 0, 3, 1}, 0.5f);
    samples.end();
    EXPECT_EQ(samples.result(), 3u);
    glEnable(kVisibilityTest);
    samples.begin();
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
    draw_rect({0, 0, 3, 1}, 0.5f);
    EXPECT_EQ(current_query(GL_SAMPLES_PASSED), 0);
    glDisable(kVisibilityTest);
    get_all();
    EXPECT_EQ(results[0], GL_TRUE);
}

// HPV-01, decided: the same counter that SGI's instruments are started with.
TEST_F(VisibilityCommands, a_batch_and_started_instruments_exclude_each_other) {
    if (const auto why = lacks("GL_SGIX_instruments")) GTEST_SKIP() << *why;
    define();
    std::array<GLint, 8> measured{};
    glInstrumentsBufferSGIX(8, measured.data());
    glStartInstrumentsSGIX();
    glEnable(kVisibilityTest);
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
    glStopInstrumentsSGIX(1);
    glEnable(kVisibilityTest);
    glStartInstrumentsSGIX();
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
    glDisable(kVisibilityTest);
}

}  // namespace
}  // namespace conformance
