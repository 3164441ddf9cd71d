// SPDX-License-Identifier: MIT
// The occlusion test and occlusion queries beside conditional rendering and a query buffer (MIX-20, MIX-21,
// MIX-24, MIX-25).
#include "overlap/overlap_test.h"

namespace conformance {
namespace {

class OverlapConditional : public OverlapTest {
  protected:
    void SetUp() override {
        ASSERT_NO_FATAL_FAILURE(OverlapTest::SetUp());
        if (IsSkipped()) return;
        if (const auto why = lacks(30)) GTEST_SKIP() << *why;
    }
    // Draws the whole in a conditional block of <query>.
    static void draw_if_seen(const AnyQuery& query) {
        glBeginConditionalRender(query.name(), GL_QUERY_WAIT);
        draw_rect(kWhole, kMiddle);
        glEndConditionalRender();
    }
};

// MIX-20. GL 4.5, 10.9: conditional rendering takes the object of an occlusion query; decided: NV's are such
// objects too (NV-17).
TEST_P(OverlapConditional, a_query_of_every_kind_decides_what_is_drawn) {
    const AnyQuery query(way());
    ASSERT_EQ(query.count([] {}), 0u);
    draw_if_seen(query);
    EXPECT_EQ(drawn_pixels(), 0);
    ASSERT_EQ(query.count([] { draw_point(0, 0, kMiddle); }), way().of(1));
    clear();
    draw_if_seen(query);
    EXPECT_EQ(drawn_pixels(), kWhole.area());
    EXPECT_TRUE(no_error());
}

// MIX-20. The result may still be on its way: QUERY_WAIT waits for it.
TEST_P(OverlapConditional, a_query_whose_result_nobody_read_decides_too) {
    const AnyQuery query(way());
    for (const bool visible : {false, true}) {
        clear();
        query.begin();
        if (visible) draw_point(0, 0, kMiddle);
        query.end();
        clear();
        draw_if_seen(query);
        EXPECT_EQ(drawn_pixels(), visible ? kWhole.area() : 0);
    }
    EXPECT_TRUE(no_error());
}

// MIX-20. GL 4.5, 4.2: Begin of the object that conditional rendering uses is INVALID_OPERATION.
TEST_P(OverlapConditional, the_query_in_use_is_not_begun) {
    const AnyQuery query(way());
    ASSERT_EQ(query.count([] { draw_columns(8); }), way().of(64));
    glBeginConditionalRender(query.name(), GL_QUERY_WAIT);
    query.begin();
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
    EXPECT_EQ(active_name(way()), 0);
    glEndConditionalRender();
    EXPECT_EQ(query.result(), way().of(64));
}

// MIX-20. GL 4.5, 5.1.3: an object that is deleted in use is no object at once and lives until it is used no
// more. Decided: until then its name cannot be begun.
TEST_P(OverlapConditional, the_name_of_a_query_deleted_in_use_is_free_after_the_block) {
    const AnyQuery query(way());
    ASSERT_EQ(query.count([] {}), 0u);
    clear();
    glBeginConditionalRender(query.name(), GL_QUERY_WAIT);
    delete_query(way(), query.name());
    EXPECT_TRUE(no_error());
    EXPECT_FALSE(query.exists());
    query.begin();
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
    EXPECT_EQ(active_name(way()), 0);
    draw_columns(8);
    glEndConditionalRender();
    EXPECT_EQ(drawn_pixels(), 0) << "the block goes on by the result that it had";
    EXPECT_FALSE(query.exists());
    EXPECT_EQ(query.count([] { draw_columns(8); }), way().of(64));
    EXPECT_TRUE(no_error());
}

// MIX-21, MIX-25. GL 4.5, 10.9: what conditional rendering discards makes no fragments; what it draws does.
TEST_P(OverlapConditional, the_test_counts_inside_a_block_what_is_drawn) {
    const AnyQuery hidden(way());
    const AnyQuery visible(way());
    ASSERT_EQ(hidden.count([] {}), 0u);
    ASSERT_EQ(visible.count([] { draw_rect(kWhole, kMiddle); }), way().of(4096));
    EXPECT_TRUE(read_result());

    glBeginConditionalRender(hidden.name(), GL_QUERY_WAIT);
    EXPECT_FALSE(result_of([] { draw_rect(kWhole, kMiddle); }));
    glEndConditionalRender();
    glBeginConditionalRender(visible.name(), GL_QUERY_WAIT);
    EXPECT_TRUE(result_of([] { draw_rect(kWhole, kMiddle); }));
    glEndConditionalRender();
    EXPECT_TRUE(no_error());
    EXPECT_EQ(hidden.result(), 0u);
    EXPECT_EQ(visible.result(), way().of(4096));
}

// MIX-21. The test runs across the whole block.
TEST_P(OverlapConditional, a_test_around_a_block_counts_what_is_drawn_outside_it) {
    const AnyQuery hidden(way());
    ASSERT_EQ(hidden.count([] {}), 0u);
    EXPECT_FALSE(result_of([&] { draw_if_seen(hidden); }));
    EXPECT_TRUE(result_of([&] {
        draw_if_seen(hidden);
        draw_point(0, 0, 0.0f);
    }));
    EXPECT_TRUE(no_error());
}

// MIX-25. GL 4.5, 10.9 discards drawing, not queries: one that is begun, reset by a read of the test's
// result, and ended inside a block is right.
TEST_P(OverlapConditional, a_query_inside_a_block_counts_what_is_drawn) {
    const AnyQuery hidden(way());
    const AnyQuery visible(way());
    const AnyQuery inner(way());
    ASSERT_EQ(hidden.count([] {}), 0u);
    ASSERT_EQ(visible.count([] { draw_columns(8); }), way().of(64));
    for (const bool drawn : {true, false}) {
        glBeginConditionalRender((drawn ? visible : hidden).name(), GL_QUERY_WAIT);
        EXPECT_EQ(inner.count([] { draw_columns(4); }), way().of(drawn ? 32 : 0));
        EXPECT_EQ(read_result(), drawn);
        EXPECT_EQ(inner.count([drawn] {
            draw_columns(4);
            EXPECT_EQ(read_result(), drawn);
            draw_columns(2);
        }),
                  way().of(drawn ? 16 : 0));
        glEndConditionalRender();
        EXPECT_EQ(inner.result(), way().of(drawn ? 16 : 0));
    }
    EXPECT_TRUE(no_error());
}

// MIX-25. A query and a block that overlap: the part of the query that lies in a discarded block counts
// nothing.
TEST_P(OverlapConditional, a_query_across_a_block_counts_what_is_drawn) {
    const AnyQuery hidden(way());
    const AnyQuery across(way());
    ASSERT_EQ(hidden.count([] {}), 0u);
    EXPECT_EQ(across.count([&] {
        draw_columns(1);
        draw_if_seen(hidden);
        draw_columns(2);
    }),
              way().of(24));
    EXPECT_EQ(across.count([&] { draw_if_seen(hidden); }), 0u);
    EXPECT_TRUE(no_error());
}

INSTANTIATE_TEST_SUITE_P(Of, OverlapConditional, ::testing::ValuesIn(kWays), way_name);

class OverlapBuffers : public OverlapTest {};

// MIX-24. ARB_query_buffer_object redirects GetQueryObject; HP's result is had by GetBooleanv and its like,
// NV's by GetOcclusionQuery: both write to client memory whatever buffer is bound, also in the midst of a
// query.
TEST_P(OverlapBuffers, a_bound_query_buffer_takes_no_result_of_the_test_nor_of_nv) {
    if (const auto why = lacks(44, "GL_ARB_query_buffer_object")) GTEST_SKIP() << *why;
    const std::vector<GLubyte> pattern(64, 0x5A);
    GLuint buffer = 0;
    const AnyQuery query(way());
    glGenBuffers(1, &buffer);
    glBindBuffer(GL_QUERY_BUFFER, buffer);
    glBufferData(GL_QUERY_BUFFER, 64, pattern.data(), GL_STATIC_DRAW);
    for (int i = 0; i < 3; ++i) {
        EXPECT_TRUE(result_of([] { draw_rect(kWhole, kMiddle); }));
        EXPECT_FALSE(result_of([] {}));
        query.begin();
        draw_columns(8);
        EXPECT_TRUE(read_result());
        draw_columns(2);
        query.end();
        EXPECT_TRUE(read_result());
        if (way().target == 0) {
            EXPECT_EQ(query.result(), 16u);
            EXPECT_TRUE(query.available());
            GLint integer = -1;
            glGetOcclusionQueryivNV(query.name(), GL_PIXEL_COUNT_NV, &integer);
            EXPECT_EQ(integer, 16);
        }
    }
    EXPECT_EQ(get_integer(GL_QUERY_BUFFER_BINDING), static_cast<GLint>(buffer));
    std::vector<GLubyte> content(64);
    glGetBufferSubData(GL_QUERY_BUFFER, 0, 64, content.data());
    EXPECT_EQ(content, pattern);
    glBindBuffer(GL_QUERY_BUFFER, 0);
    EXPECT_EQ(query.result(), way().of(16));
    glDeleteBuffers(1, &buffer);
    EXPECT_TRUE(no_error());
}

INSTANTIATE_TEST_SUITE_P(Of, OverlapBuffers, ::testing::ValuesIn(kWays), way_name);

}  // namespace
}  // namespace conformance
