// SPDX-License-Identifier: MIT
// The occlusion test of HP overlapped with an occlusion query of any kind: one counter under both (MIX-01 to
// MIX-08, MIX-13 to MIX-16).
//
// NV_occlusion_query 4.1.6A: "Whenever a fragment reaches this stage and OCCLUSION_TEST_HP is enabled or an
// occlusion query is active, the occlusion test result is set to TRUE and the pixel counter is incremented."
// ARB_occlusion_query, Dependencies on HP_occlusion_test: "Sample counting is active [...] whenever either an
// occlusion query is active *or* OCCLUSION_TEST_HP is enabled." ARB_occlusion_query2 says nothing of HP;
// decided: the boolean targets are occlusion queries like the others (MIX-03).
#include "overlap/overlap_test.h"

namespace conformance {
namespace {

class OverlapCounting : public OverlapTest {};

// MIX-01, MIX-02, MIX-03. As above: "or an occlusion query is active".
TEST_P(OverlapCounting, an_active_query_sets_the_result_of_a_disabled_test) {
    const AnyQuery query(way());
    EXPECT_EQ(query.count([] { draw_columns(8); }), way().of(64));
    EXPECT_TRUE(read_result());
    EXPECT_EQ(query.count([] {}), 0u);
    EXPECT_FALSE(read_result());
    draw_occluder();
    EXPECT_EQ(query.count([] { draw_rect(kWhole, kFar); }), 0u);
    EXPECT_FALSE(read_result());
}

// MIX-04, MIX-05. NV 4.1.6A: "BeginOcclusionQueryNV resets the pixel counter to zero and the occlusion test
// result to FALSE." ARB, issues: "BeginQueryARB, not EndQueryARB, resets the sample count (and therefore the
// occlusion test result)."
TEST_P(OverlapCounting, begin_resets_the_result) {
    const AnyQuery query(way());
    pass_one_fragment();
    query.begin();
    EXPECT_FALSE(read_result());
    query.end();
    EXPECT_EQ(query.result(), 0u);

    const AnyQuery next(way());
    EXPECT_EQ(query.count([] { draw_columns(8); }), way().of(64));
    next.begin();
    EXPECT_FALSE(read_result()) << "what an earlier query counted";
    next.end();

    glEnable(GL_OCCLUSION_TEST_HP);
    draw_columns(1);
    query.begin();
    query.end();
    EXPECT_FALSE(read_result()) << "what an enabled test counted before the query";
}

// MIX-06. As above: "not EndQueryARB"; NV, issues, has the same sentence of its own Begin and End.
TEST_P(OverlapCounting, end_does_not_reset_the_result) {
    const AnyQuery query(way());
    query.begin();
    draw_columns(8);
    query.end();
    EXPECT_TRUE(read_result());
    EXPECT_FALSE(read_result());
}

// MIX-07. As of MIX-04: Begin resets the counter.
TEST_P(OverlapCounting, what_was_counted_before_begin_is_not_in_the_query) {
    const AnyQuery query(way());
    glEnable(GL_OCCLUSION_TEST_HP);
    draw_columns(8);
    EXPECT_EQ(query.count([] {}), 0u);
}

// MIX-08. NV, issues: a query's pixel count has to correspond "to the pixels rendered during the occlusion
// query."
TEST_P(OverlapCounting, queries_under_an_enabled_test_count_their_own_samples) {
    const AnyQuery first(way());
    const AnyQuery second(way());
    const AnyQuery nothing(way());
    glEnable(GL_OCCLUSION_TEST_HP);
    draw_columns(1);
    EXPECT_EQ(first.count([] { draw_columns(2); }), way().of(16));
    draw_columns(4);
    EXPECT_EQ(nothing.count([] {}), 0u);
    draw_columns(4);
    EXPECT_EQ(second.count([] { draw_columns(8); }), way().of(64));
    draw_columns(16);
    EXPECT_EQ(first.result(), way().of(16));
    EXPECT_EQ(nothing.result(), 0u);
    EXPECT_TRUE(read_result());
}

// MIX-13, MIX-14. As at the head of this file: either of the two keeps counting on, and there is one counter.
TEST_P(OverlapCounting, toggling_the_test_inside_a_query_neither_stops_nor_doubles_the_count) {
    const AnyQuery query(way());
    glEnable(GL_OCCLUSION_TEST_HP);
    EXPECT_EQ(query.count([] {
        draw_columns(1);
        glDisable(GL_OCCLUSION_TEST_HP);
        draw_columns(2);
        glEnable(GL_OCCLUSION_TEST_HP);
        draw_columns(4);
        glEnable(GL_OCCLUSION_TEST_HP);
        draw_columns(8);
    }),
              way().of(8 * (1 + 2 + 4 + 8)));
    EXPECT_TRUE(read_result());
}

// MIX-13. The only draws come while the test is disabled.
TEST_P(OverlapCounting, disabling_the_test_does_not_end_the_counting_of_a_query) {
    const AnyQuery query(way());
    EXPECT_EQ(query.count([] {
        glEnable(GL_OCCLUSION_TEST_HP);
        glDisable(GL_OCCLUSION_TEST_HP);
        draw_columns(2);
    }),
              way().of(16));
    EXPECT_TRUE(read_result());
}

// MIX-15. NV and ARB, issues: "The alternative (producing an error) does not work -- it would require that
// glPopAttrib be capable of producing an error".
TEST_P(OverlapCounting, the_attribute_stack_toggling_the_test_inside_a_query_does_not_alter_the_count) {
    const AnyQuery query(way());
    EXPECT_EQ(query.count([] {
        glPushAttrib(GL_ENABLE_BIT);
        glEnable(GL_OCCLUSION_TEST_HP);
        draw_columns(1);
        glPopAttrib();
        draw_columns(2);
    }),
              way().of(8 * (1 + 2)));
    EXPECT_TRUE(no_error());
    EXPECT_FALSE(test_enabled());
    EXPECT_TRUE(read_result());
}

// MIX-16. ARB, Dependencies: "The occlusion test result is TRUE when the samples-passed count is nonzero, and
// FALSE when it is zero."
TEST_P(OverlapCounting, the_result_is_true_exactly_when_the_count_is_not_zero) {
    const AnyQuery query(way());
    for (const int width : {0, 1, 0, 0, 64, 3}) {
        const GLuint count = query.count([width] { draw_columns(width); });
        EXPECT_EQ(count, way().of(static_cast<GLuint>(width * 8)));
        EXPECT_EQ(read_result(), count != 0);
    }
}

INSTANTIATE_TEST_SUITE_P(Of, OverlapCounting, ::testing::ValuesIn(kWays), way_name);

}  // namespace
}  // namespace conformance
