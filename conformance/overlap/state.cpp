// SPDX-License-Identifier: MIT
// The occlusion test beside queries of any kind: neither shows in the other's state (MIX-19, MIX-22, MIX-23).
#include "overlap/overlap_test.h"

namespace conformance {
namespace {

class OverlapState : public OverlapTest {};

// MIX-22. GL, 2.1: state belongs to the context.
TEST_P(OverlapState, tests_and_queries_of_two_contexts_do_not_mix) {
    const AnyQuery query(way());
    const Context other;
    ASSERT_TRUE(other);
    query.begin();
    draw_columns(8);

    ASSERT_TRUE(other.make_current(surface()));
    use_pixel_coordinates();
    EXPECT_EQ(active_name(way()), 0);
    EXPECT_FALSE(read_result());
    EXPECT_TRUE(result_of([] { draw_rect(kWhole, kMiddle); }));
    EXPECT_FALSE(read_result());
    EXPECT_TRUE(no_error());

    come_back();
    EXPECT_EQ(active_name(way()), static_cast<GLint>(query.name()));
    query.end();
    EXPECT_EQ(query.result(), way().of(64));
    EXPECT_TRUE(read_result());
}

// MIX-06, MIX-23. Only Begin and a read reset HP's result: not the end of the object that it was counted in.
TEST_P(OverlapState, deleting_the_query_does_not_take_the_result_along) {
    GLuint name = 0;
    {
        const AnyQuery query(way());
        name = query.name();
        query.begin();
        draw_columns(8);
        query.end();
    }
    EXPECT_FALSE(is_query(way(), name));
    EXPECT_TRUE(read_result());
    EXPECT_FALSE(read_result());
}

// MIX-23. The application's query shows as active and counts, whatever HP does meanwhile; no query of the
// implementation's own shows.
TEST_P(OverlapState, the_applications_query_looks_as_it_does_without_the_test) {
    const AnyQuery query(way());
    glEnable(GL_OCCLUSION_TEST_HP);
    draw_point(0, 0, 0.0f);
    EXPECT_EQ(active_name(way()), 0) << "HP shows a query of its own";
    query.begin();
    EXPECT_TRUE(no_error());
    EXPECT_EQ(active_name(way()), static_cast<GLint>(query.name()));
    draw_columns(8);
    glDisable(GL_OCCLUSION_TEST_HP);
    EXPECT_EQ(active_name(way()), static_cast<GLint>(query.name()));
    glEnable(GL_OCCLUSION_TEST_HP);
    query.end();
    EXPECT_EQ(active_name(way()), 0);

    EXPECT_EQ(query.result(), way().of(64));
    EXPECT_TRUE(query.available());
    end(way());
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION)) << "HP left a query active";
}

// MIX-23. Many queries in flight with tests among them: all are right, and in order.
TEST_P(OverlapState, queries_in_flight_are_right_with_tests_among_them) {
    constexpr int kQueries = 20;
    std::vector<std::unique_ptr<AnyQuery>> queries;
    for (int i = 0; i < kQueries; ++i) queries.push_back(std::make_unique<AnyQuery>(way()));
    for (int i = 0; i < kQueries; ++i) {
        queries[static_cast<std::size_t>(i)]->begin();
        draw_columns(i % 3);
        queries[static_cast<std::size_t>(i)]->end();
        if (i % 4 == 0) {
            EXPECT_TRUE(result_of([] { draw_point(0, 0, 0.0f); }));
        }
        if (i % 4 == 1) {
            EXPECT_EQ(read_result(), i % 3 != 0);
        }
    }
    for (int i = kQueries; i-- > 0;) {
        EXPECT_EQ(queries[static_cast<std::size_t>(i)]->result(), way().of(static_cast<GLuint>(8 * (i % 3))))
            << i;
    }
    for (const auto& query : queries) EXPECT_TRUE(query->available());
    EXPECT_TRUE(no_error());
}

INSTANTIATE_TEST_SUITE_P(Of, OverlapState, ::testing::ValuesIn(kWays), way_name);

class OtherQueries : public HpTest, public ::testing::WithParamInterface<GLenum> {
  protected:
    void SetUp() override {
        ASSERT_NO_FATAL_FAILURE(HpTest::SetUp());
        if (IsSkipped()) return;
        if (const auto why = lacks(33)) GTEST_SKIP() << *why;
        if (GetParam() == GL_CLIPPING_INPUT_PRIMITIVES_ARB) {
            if (const auto why = lacks(46, "GL_ARB_pipeline_statistics_query")) GTEST_SKIP() << *why;
        }
    }
};

// MIX-19. ARB, Dependencies, speaks of "an occlusion query"; the others do not count samples.
TEST_P(OtherQueries, neither_set_nor_reset_the_result) {
    const Query query(GetParam());
    query.count([] { draw_rect(kWhole, kMiddle); });
    EXPECT_FALSE(read_result());

    pass_one_fragment();
    query.count([] {});
    EXPECT_TRUE(read_result());
    EXPECT_TRUE(no_error());
}

// MIX-23. A query that counts something else, and is active while tests come and go.
TEST_P(OtherQueries, are_not_disturbed_by_the_test) {
    const Query query(GetParam());
    query.begin();
    glEnable(GL_OCCLUSION_TEST_HP);
    draw_triangle(kMiddle);
    EXPECT_EQ(current_query(GetParam()), static_cast<GLint>(query.name()));
    glDisable(GL_OCCLUSION_TEST_HP);
    EXPECT_TRUE(read_result());
    EXPECT_FALSE(result_of([] {}));
    EXPECT_EQ(current_query(GetParam()), static_cast<GLint>(query.name()));
    glEnable(GL_OCCLUSION_TEST_HP);
    query.end();
    EXPECT_EQ(current_query(GetParam()), 0);
    const GLuint result = query.result();
    if (GetParam() == GL_TIME_ELAPSED) {
        EXPECT_GT(result, 0u);
    } else {
        EXPECT_EQ(result, 1u) << "one triangle was drawn";
    }
    GLint available = -1;
    glGetQueryObjectiv(query.name(), GL_QUERY_RESULT_AVAILABLE, &available);
    EXPECT_EQ(available, GL_TRUE);
    EXPECT_TRUE(no_error());
}

INSTANTIATE_TEST_SUITE_P(Of, OtherQueries,
                         ::testing::Values(GL_TIME_ELAPSED, GL_PRIMITIVES_GENERATED,
                                           GL_CLIPPING_INPUT_PRIMITIVES_ARB),
                         [](const auto& test) -> std::string {
                             if (test.param == GL_TIME_ELAPSED) return "time_elapsed";
                             if (test.param == GL_PRIMITIVES_GENERATED) return "primitives_generated";
                             return "clipping_input_primitives";
                         });

}  // namespace
}  // namespace conformance
