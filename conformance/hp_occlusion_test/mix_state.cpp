// SPDX-License-Identifier: MIT
// HP beside other queries, conditional rendering and a query buffer: neither disturbs the other (MIX-19 to
// MIX-25).
#include "hp_occlusion_test/mix_test.h"

namespace conformance {
namespace {

class MixState : public MixTest {};

// MIX-19. ARB, Dependencies, speaks of "an occlusion query"; the others do not count samples.
TEST_F(MixState, a_query_of_another_kind_neither_sets_nor_resets_the_result) {
    if (const auto why = lacks(33)) GTEST_SKIP() << *why;
    for (const GLenum target : {GL_TIME_ELAPSED, GL_PRIMITIVES_GENERATED}) {
        SCOPED_TRACE(target);
        const Query query(target);
        query.count([] { draw_rect(kWhole, kMiddle); });
        EXPECT_FALSE(read_result());

        pass_one_fragment();
        query.count([] {});
        EXPECT_TRUE(read_result());

        query.begin();
        EXPECT_TRUE(result_of([] { draw_triangle(kMiddle); }));
        EXPECT_FALSE(result_of([] {}));
        query.end();
        const GLuint result = query.result();
        if (target == GL_PRIMITIVES_GENERATED) {
            EXPECT_EQ(result, 1u);
        }
    }
    EXPECT_TRUE(no_error());
}

// MIX-21, MIX-25. GL 4.5, 10.9: what conditional rendering discards makes no fragments; what it draws does.
TEST_F(MixState, conditional_rendering_decides_what_can_count) {
    if (const auto why = lacks(30)) GTEST_SKIP() << *why;
    const Query hidden;
    const Query visible;
    ASSERT_EQ(hidden.count([] {}), 0u);
    ASSERT_EQ(visible.count([] { draw_rect(kWhole, kMiddle); }), 4096u);
    EXPECT_TRUE(read_result());

    glBeginConditionalRender(hidden.name(), GL_QUERY_WAIT);
    EXPECT_FALSE(result_of([] { draw_rect(kWhole, kMiddle); }));
    glEndConditionalRender();
    glBeginConditionalRender(visible.name(), GL_QUERY_WAIT);
    EXPECT_TRUE(result_of([] { draw_rect(kWhole, kMiddle); }));
    glEndConditionalRender();
    EXPECT_TRUE(no_error());
    EXPECT_EQ(hidden.result(), 0u);
    EXPECT_EQ(visible.result(), 4096u);
}

// MIX-21. The test runs across the whole block.
TEST_F(MixState, a_test_around_a_conditional_block_counts_what_is_drawn_outside_it) {
    if (const auto why = lacks(30)) GTEST_SKIP() << *why;
    const Query hidden;
    ASSERT_EQ(hidden.count([] {}), 0u);
    const auto block = [&] {
        glBeginConditionalRender(hidden.name(), GL_QUERY_WAIT);
        draw_rect(kWhole, kMiddle);
        glEndConditionalRender();
    };
    EXPECT_FALSE(result_of(block));
    EXPECT_TRUE(result_of([&] {
        block();
        draw_point(0, 0, 0.0f);
    }));
    EXPECT_TRUE(no_error());
}

// MIX-22. GL, 2.1: state belongs to the context.
TEST_F(MixState, tests_and_queries_of_two_contexts_do_not_mix) {
    const Query query;
    const Context other;
    ASSERT_TRUE(other);
    query.begin();
    draw_rect({0, 0, 8, 8}, kMiddle);

    ASSERT_TRUE(other.make_current(surface()));
    use_pixel_coordinates();
    EXPECT_EQ(current_query(GL_SAMPLES_PASSED), 0);
    EXPECT_TRUE(result_of([] { draw_rect(kWhole, kMiddle); }));
    EXPECT_FALSE(read_result());
    EXPECT_TRUE(no_error());

    come_back();
    EXPECT_EQ(current_query(GL_SAMPLES_PASSED), static_cast<GLint>(query.name()));
    query.end();
    EXPECT_EQ(query.result(), 64u);
    EXPECT_TRUE(read_result());
}

// MIX-23. The application's query shows as active and counts, whatever HP does meanwhile; no query of the
// implementation's own shows.
TEST_F(MixState, the_applications_query_looks_as_it_does_without_the_test) {
    const Query query;
    glEnable(GL_OCCLUSION_TEST_HP);
    draw_point(0, 0, 0.0f);
    EXPECT_EQ(current_query(GL_SAMPLES_PASSED), 0) << "HP shows a query of its own";
    query.begin();
    EXPECT_TRUE(no_error());
    EXPECT_EQ(current_query(GL_SAMPLES_PASSED), static_cast<GLint>(query.name()));
    draw_rect({0, 0, 8, 8}, kMiddle);
    glDisable(GL_OCCLUSION_TEST_HP);
    EXPECT_EQ(current_query(GL_SAMPLES_PASSED), static_cast<GLint>(query.name()));
    query.end();
    EXPECT_EQ(current_query(GL_SAMPLES_PASSED), 0);

    EXPECT_EQ(query.result(), 64u);
    GLint available = -1;
    glGetQueryObjectiv(query.name(), GL_QUERY_RESULT_AVAILABLE, &available);
    EXPECT_EQ(available, GL_TRUE);
    glEndQuery(GL_SAMPLES_PASSED);
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION)) << "HP left a query active";
}

// MIX-23, of every target that would share a slot of the driver with HP.
TEST_F(MixState, boolean_queries_are_right_under_an_enabled_test) {
    if (const auto why = lacks(33, "GL_ARB_occlusion_query2")) GTEST_SKIP() << *why;
    std::vector<GLenum> targets = {GL_ANY_SAMPLES_PASSED};
    if (!lacks(43, "GL_ARB_ES3_compatibility")) targets.push_back(GL_ANY_SAMPLES_PASSED_CONSERVATIVE);
    for (const GLenum target : targets) {
        SCOPED_TRACE(target);
        glEnable(GL_OCCLUSION_TEST_HP);
        const Query query(target);
        draw_point(0, 0, 0.0f);
        EXPECT_EQ(query.count([] {}), 0u);
        EXPECT_EQ(query.count([] { draw_point(1, 1, 0.0f); }), 1u);
        glDisable(GL_OCCLUSION_TEST_HP);
        EXPECT_TRUE(read_result());
    }
    EXPECT_TRUE(no_error());
}

// MIX-23, of a query in a display list: ARB 5.4 compiles Begin and End; HP's Enable is around them or among
// them.
TEST_F(MixState, a_compiled_query_and_the_test_do_not_disturb_each_other) {
    const Query query;
    const GLuint list = glGenLists(1);
    glNewList(list, GL_COMPILE);
    query.begin();
    draw_rect({0, 0, 8, 8}, kMiddle);
    glEnable(GL_OCCLUSION_TEST_HP);
    draw_rect({8, 0, 8, 8}, kMiddle);
    query.end();
    draw_rect({16, 0, 8, 8}, kMiddle);
    glEndList();
    for (int call = 0; call < 3; ++call) {
        draw_point(0, 0, 0.0f);
        glCallList(list);
        EXPECT_EQ(current_query(GL_SAMPLES_PASSED), 0);
        EXPECT_EQ(query.result(), 128u) << "call " << call;
        EXPECT_TRUE(test_enabled());
        EXPECT_TRUE(read_result());
        EXPECT_FALSE(read_result());
        draw_point(0, 0, 0.0f);
        EXPECT_TRUE(read_result()) << "the list ended the test";
    }
    EXPECT_EQ(query.count([] { draw_point(0, 0, 0.0f); }), 1u);
    EXPECT_TRUE(no_error());
}

// MIX-24. HP, New State: the result is had by a Get, which writes to client memory; ARB_query_buffer_object
// redirects GetQueryObject only.
TEST_F(MixState, a_bound_query_buffer_is_not_written_by_a_read_of_the_result) {
    if (const auto why = lacks(44, "GL_ARB_query_buffer_object")) GTEST_SKIP() << *why;
    const std::vector<GLubyte> pattern(64, 0x5A);
    GLuint buffer = 0;
    glGenBuffers(1, &buffer);
    glBindBuffer(GL_QUERY_BUFFER, buffer);
    glBufferData(GL_QUERY_BUFFER, 64, pattern.data(), GL_STATIC_DRAW);
    for (int i = 0; i < 3; ++i) {
        EXPECT_TRUE(result_of([] { draw_rect(kWhole, kMiddle); }));
        EXPECT_FALSE(result_of([] {}));
    }
    EXPECT_EQ(get_integer(GL_QUERY_BUFFER_BINDING), static_cast<GLint>(buffer));
    std::vector<GLubyte> content(64);
    glGetBufferSubData(GL_QUERY_BUFFER, 0, 64, content.data());
    EXPECT_EQ(content, pattern);
    glBindBuffer(GL_QUERY_BUFFER, 0);
    glDeleteBuffers(1, &buffer);
    EXPECT_TRUE(no_error());
}

}  // namespace
}  // namespace conformance
