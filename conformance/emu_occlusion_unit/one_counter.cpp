// SPDX-License-Identifier: MIT
// The machine has one samples-passed counter: occlusion queries and the unit exclude each other.
#include "emu_occlusion_unit/unit_test.h"

namespace conformance {
namespace {

class OneCounter : public UnitTest {};

// 17.3.5.1: "or one on SAMPLES_PASSED, ANY_SAMPLES_PASSED, ANY_SAMPLES_PASSED_CONSERVATIVE".
TEST_F(OneCounter, an_active_occlusion_query_excludes_the_unit) {
    for (const GLenum target :
         {GL_SAMPLES_PASSED, GL_ANY_SAMPLES_PASSED, GL_ANY_SAMPLES_PASSED_CONSERVATIVE}) {
        const Query samples(target);
        const Query unit;
        samples.begin();
        expect_refused(GL_INVALID_OPERATION, kAllRegisters, unit.name());
        draw_rect({0, 0, 4, 4}, kNear);
        samples.end();
        EXPECT_EQ(samples.result(), target == GL_SAMPLES_PASSED ? 16u : 1u);
    }
}

// 17.3.5.1: "While one is active, BeginQuery ... generate[s] INVALID_OPERATION."
TEST_F(OneCounter, an_active_query_of_the_unit_excludes_occlusion_queries) {
    glEnable(GL_DEPTH_TEST);
    expect_seen(seen(16, {8, 8, 4, 4}, kNear), [] {
        for (const GLenum target :
             {GL_SAMPLES_PASSED, GL_ANY_SAMPLES_PASSED, GL_ANY_SAMPLES_PASSED_CONSERVATIVE}) {
            const Query samples(target);
            samples.begin();
            EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
            EXPECT_EQ(current_query(target), 0);
            samples.end();
            EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
            glBeginQueryIndexed(target, 0, samples.name());
            EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
            EXPECT_FALSE(glIsQuery(samples.name()));
        }
        draw_rect({8, 8, 4, 4}, kNear);
    });
}

// The same of NV_occlusion_query and HP_occlusion_test.
TEST_F(OneCounter, nv_queries_and_the_hp_test_exclude_the_unit_and_are_excluded) {
    if (const auto why = lacks("GL_NV_occlusion_query")) GTEST_SKIP() << *why;
    const Query unit;
    GLuint nv = 0;
    glGenOcclusionQueriesNV(1, &nv);
    glBeginOcclusionQueryNV(nv);
    expect_refused(GL_INVALID_OPERATION, kAllRegisters, unit.name());
    glEndOcclusionQueryNV();
    glEnable(GL_OCCLUSION_TEST_HP);
    expect_refused(GL_INVALID_OPERATION, kAllRegisters, unit.name());
    glDisable(GL_OCCLUSION_TEST_HP);
    begin_unit(kAllRegisters, unit.name());
    glBeginOcclusionQueryNV(nv);
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
    glEnable(GL_OCCLUSION_TEST_HP);
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
    EXPECT_FALSE(glIsEnabled(GL_OCCLUSION_TEST_HP));
    end_unit();
    EXPECT_TRUE(no_error());
    glDeleteOcclusionQueriesNV(1, &nv);
}

}  // namespace
}  // namespace conformance
