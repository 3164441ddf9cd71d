// SPDX-License-Identifier: MIT
// SGIX_instruments beside other occlusion queries, of which its texts say nothing. Decided: instruments that
// are started have the machine's one counter, so that no query begins then; the HP test's flag sees the same
// fragments as they do.
#include "harness/query.h"
#include "sgix_instruments/instruments_test.h"

#include <GL/glext_emu.h>

namespace conformance {
namespace {

class InstrumentsAndQueries : public InstrumentTest {
  protected:
    void SetUp() override {
        ASSERT_NO_FATAL_FAILURE(InstrumentTest::SetUp());
        if (IsSkipped()) return;
        if (const auto why = lacks(15)) GTEST_SKIP() << *why;
        define();
        glEnable(kDepthPass);
    }
};

// SGI-13, decided.
TEST_F(InstrumentsAndQueries, a_query_cannot_begin_while_instruments_are_started) {
    const Query samples;
    glStartInstrumentsSGIX();
    samples.begin();
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
    EXPECT_EQ(current_query(GL_SAMPLES_PASSED), 0);
    draw_rect({0, 0, 7, 1}, 0.5f);
    EXPECT_EQ(current_query(GL_SAMPLES_PASSED), 0) << "the layer's own shows";
    glEndQuery(GL_SAMPLES_PASSED);
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
    glStopInstrumentsSGIX(1);
    EXPECT_EQ(next_marker(), 1);
    EXPECT_EQ(response(0).value, 7u);
    EXPECT_EQ(samples.count([] { draw_rect({0, 0, 5, 1}, 0.5f); }), 5u);
}

// SGI-13, decided.
TEST_F(InstrumentsAndQueries, instruments_cannot_start_while_a_query_is_active) {
    const Query samples;
    samples.begin();
    glStartInstrumentsSGIX();
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
    draw_rect({0, 0, 5, 1}, 0.5f);
    samples.end();
    EXPECT_EQ(samples.result(), 5u);
    glStartInstrumentsSGIX();
    EXPECT_TRUE(no_error());
    glStopInstrumentsSGIX(1);
    EXPECT_EQ(next_marker(), 1);
}

// SGI-13, decided, of the query of EMU_occlusion_unit.
TEST_F(InstrumentsAndQueries, instruments_and_the_occlusion_unit_exclude_each_other) {
    if (const auto why = lacks("GL_EMU_occlusion_unit")) GTEST_SKIP() << *why;
    const auto begin_unit = reinterpret_cast<PFNGLBEGINOCCLUSIONUNITEMUPROC>(
        platform().get_proc_address("glBeginOcclusionUnitEMU"));
    const auto end_unit =
        reinterpret_cast<PFNGLENDOCCLUSIONUNITEMUPROC>(platform().get_proc_address("glEndOcclusionUnitEMU"));
    const Query unit;
    glStartInstrumentsSGIX();
    begin_unit(GL_VISIBLE_HITS_BIT_EMU, unit.name());
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
    draw_rect({0, 0, 7, 1}, 0.5f);
    glStopInstrumentsSGIX(1);
    EXPECT_EQ(next_marker(), 1);
    EXPECT_EQ(response(0).value, 7u);
    begin_unit(GL_VISIBLE_HITS_BIT_EMU, unit.name());
    glStartInstrumentsSGIX();
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
    draw_rect({0, 0, 5, 1}, 0.5f);
    end_unit();
    EXPECT_EQ(unit.result(), 5u);
}

// SGI-13, decided.
TEST_F(InstrumentsAndQueries, the_hp_test_sees_the_fragments_that_are_counted) {
    if (const auto why = lacks("GL_HP_occlusion_test")) GTEST_SKIP() << *why;
    const auto flag = [] {
        GLboolean value = 0xAA;
        glGetBooleanv(GL_OCCLUSION_TEST_RESULT_HP, &value);
        return value;
    };
    glStartInstrumentsSGIX();
    draw_rect({0, 0, 3, 1}, 0.5f);
    glEnable(GL_OCCLUSION_TEST_HP);
    EXPECT_EQ(flag(), GL_FALSE) << "drawn before the test";
    draw_rect({0, 0, 4, 1}, 0.5f);
    EXPECT_EQ(flag(), GL_TRUE);
    EXPECT_EQ(flag(), GL_FALSE);
    glDisable(GL_OCCLUSION_TEST_HP);
    draw_rect({0, 0, 5, 1}, 0.5f);
    EXPECT_EQ(flag(), GL_FALSE) << "drawn after the test";
    glStopInstrumentsSGIX(1);
    EXPECT_EQ(next_marker(), 1);
    EXPECT_EQ(response(0).value, 12u);
}

// SGI-13: names that instruments count with do not show.
TEST_F(InstrumentsAndQueries, no_name_is_a_query_that_the_program_did_not_make) {
    for (int i = 0; i < 3; ++i) {
        glStartInstrumentsSGIX();
        draw_rect({0, 0, 7, 1}, 0.5f);
        glStopInstrumentsSGIX(i);
    }
    glStartInstrumentsSGIX();
    draw_rect({0, 0, 7, 1}, 0.5f);
    for (GLuint name = 0; name < 64; ++name) EXPECT_FALSE(glIsQuery(name)) << name;
    glStopInstrumentsSGIX(3);
    // A name that the program picks for itself is its own, whatever counted under it.
    for (GLuint name = 1; name < 8; ++name) {
        glBeginQuery(GL_SAMPLES_PASSED, name);
        draw_rect({0, 0, 2, 2}, 0.5f);
        glEndQuery(GL_SAMPLES_PASSED);
        GLuint count = kUntouched;
        glGetQueryObjectuiv(name, GL_QUERY_RESULT, &count);
        EXPECT_EQ(count, 4u);
    }
    for (int i = 0; i <= 3; ++i) {
        EXPECT_EQ(next_marker(), i);
        EXPECT_EQ(response(i).value, 7u);
    }
}

// A context that is left while its instruments count goes on where it was.
TEST_F(InstrumentsAndQueries, counting_goes_on_in_a_context_that_is_current_again) {
    glStartInstrumentsSGIX();
    draw_rect({0, 0, 7, 1}, 0.5f);
    const Context other;
    ASSERT_TRUE(other.make_current(surface()));
    draw_rect({0, 0, 20, 1}, 0.5f);
    come_back();
    draw_rect({0, 0, 5, 1}, 0.5f);
    glStopInstrumentsSGIX(1);
    EXPECT_EQ(next_marker(), 1);
    EXPECT_EQ(response(0).value, 12u);
}

}  // namespace
}  // namespace conformance
