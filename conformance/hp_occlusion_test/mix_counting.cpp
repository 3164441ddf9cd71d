// SPDX-License-Identifier: MIT
// HP overlapped with an occlusion query: one samples-passed count under both (MIX-02 to MIX-17).
//
// ARB_occlusion_query, Dependencies on HP_occlusion_test: "When GetIntegerv is called with <pname> of
// OCCLUSION_TEST_RESULT_HP, the current samples-passed count is reset to zero. The occlusion test result is
// TRUE when the samples-passed count is nonzero, and FALSE when it is zero. Sample counting is active [...]
// whenever either an occlusion query is active *or* OCCLUSION_TEST_HP is enabled."
#include "hp_occlusion_test/mix_test.h"

namespace conformance {
namespace {

class MixCounting : public MixTest {};

void draw_area(int pixels_wide) {
    draw_rect({0, 0, pixels_wide, 8}, kMiddle);
}

// MIX-02. Dependencies: counting is active when "an occlusion query is active".
TEST_F(MixCounting, an_active_query_sets_the_result_of_a_disabled_test) {
    const Query query;
    EXPECT_EQ(query.count([] { draw_area(8); }), 64u);
    EXPECT_TRUE(read_result());
    EXPECT_EQ(query.count([] {}), 0u);
    EXPECT_FALSE(read_result());
}

// MIX-03. ARB_occlusion_query2 says nothing of HP; decided: the boolean targets are occlusion queries too.
TEST_F(MixCounting, an_active_boolean_query_sets_the_result_too) {
    if (const auto why = lacks(33, "GL_ARB_occlusion_query2")) GTEST_SKIP() << *why;
    const Query query(GL_ANY_SAMPLES_PASSED);
    EXPECT_EQ(query.count([] { draw_area(8); }), 1u);
    EXPECT_TRUE(read_result());
    EXPECT_EQ(query.count([] {}), 0u);
    EXPECT_FALSE(read_result());
}

// MIX-05. ARB, issues: "Note that BeginQueryARB, not EndQueryARB, resets the sample count (and therefore the
// occlusion test result)."
TEST_F(MixCounting, begin_resets_the_result) {
    const Query query;
    pass_one_fragment();
    query.begin();
    EXPECT_FALSE(read_result());
    query.end();
    EXPECT_EQ(query.result(), 0u);

    const Query next;
    EXPECT_EQ(query.count([] { draw_area(8); }), 64u);
    next.begin();
    EXPECT_FALSE(read_result()) << "what an earlier query counted";
    next.end();
}

// MIX-06. As above: "not EndQueryARB".
TEST_F(MixCounting, end_does_not_reset_the_result) {
    const Query query;
    query.begin();
    draw_area(8);
    query.end();
    EXPECT_TRUE(read_result());
    EXPECT_FALSE(read_result());
}

// MIX-07. ARB 4.1.6A: "BeginQueryARB with a <target> of SAMPLES_PASSED_ARB resets the current samples-passed
// count".
TEST_F(MixCounting, what_was_counted_before_begin_is_not_in_the_query) {
    const Query query;
    glEnable(GL_OCCLUSION_TEST_HP);
    draw_area(8);
    EXPECT_EQ(query.count([] {}), 0u);
}

// MIX-08. ARB, issues: a query's count has "to correspond to the samples rendered during the occlusion
// query".
TEST_F(MixCounting, queries_under_an_enabled_test_count_their_own_samples) {
    const Query first;
    const Query second;
    glEnable(GL_OCCLUSION_TEST_HP);
    draw_area(1);
    EXPECT_EQ(first.count([] { draw_area(2); }), 16u);
    draw_area(4);
    EXPECT_EQ(second.count([] { draw_area(8); }), 64u);
    draw_area(16);
    EXPECT_EQ(first.result(), 16u);
}

// MIX-10. Dependencies: the read resets "the current samples-passed count" of the running query. The text
// names GetIntegerv; NV 6.1.13 has all four Gets do so; decided: all.
TEST_F(MixCounting, reading_the_result_inside_a_query_resets_its_count) {
    const Query query;
    void (*const reads[])() = {
        [] { EXPECT_EQ(get_integer(GL_OCCLUSION_TEST_RESULT_HP), 1); },
        [] { EXPECT_TRUE(read_result()); },
        [] {
            GLfloat value = -1.0f;
            glGetFloatv(GL_OCCLUSION_TEST_RESULT_HP, &value);
            EXPECT_EQ(value, 1.0f);
        },
        [] {
            GLdouble value = -1.0;
            glGetDoublev(GL_OCCLUSION_TEST_RESULT_HP, &value);
            EXPECT_EQ(value, 1.0);
        },
    };
    for (const auto read : reads) {
        EXPECT_EQ(query.count([read] {
            draw_area(8);
            read();
            draw_area(2);
        }),
                  16u);
        EXPECT_TRUE(read_result());
    }
}

// MIX-11. As above; there was nothing to reset.
TEST_F(MixCounting, reading_a_false_result_inside_a_query_does_no_harm) {
    const Query query;
    EXPECT_EQ(query.count([] {
        EXPECT_FALSE(read_result());
        draw_area(8);
    }),
              64u);
}

// MIX-12. ARB 4.1.6A: EndQuery copies the count into the object; what becomes of the count is no matter
// afterwards.
TEST_F(MixCounting, reading_the_result_after_end_does_not_alter_the_query) {
    const Query query;
    query.begin();
    draw_area(8);
    query.end();
    EXPECT_TRUE(read_result());
    EXPECT_EQ(query.result(), 64u);
}

// MIX-13, MIX-14. Dependencies: either of the two keeps counting on, and there is one count.
TEST_F(MixCounting, toggling_the_test_inside_a_query_neither_stops_nor_doubles_the_count) {
    const Query query;
    glEnable(GL_OCCLUSION_TEST_HP);
    EXPECT_EQ(query.count([] {
        draw_area(1);
        glDisable(GL_OCCLUSION_TEST_HP);
        draw_area(2);
        glEnable(GL_OCCLUSION_TEST_HP);
        draw_area(4);
        glEnable(GL_OCCLUSION_TEST_HP);
        draw_area(8);
    }),
              8u * (1 + 2 + 4 + 8));
    EXPECT_TRUE(read_result());
}

// MIX-15. ARB, issues: "The alternative (producing an error) does not work -- it would require that PopAttrib
// be capable of producing an error".
TEST_F(MixCounting, the_attribute_stack_toggling_the_test_inside_a_query_does_not_alter_the_count) {
    const Query query;
    EXPECT_EQ(query.count([] {
        glPushAttrib(GL_ENABLE_BIT);
        glEnable(GL_OCCLUSION_TEST_HP);
        draw_area(1);
        glPopAttrib();
        draw_area(2);
    }),
              8u * (1 + 2));
    EXPECT_TRUE(no_error());
    EXPECT_FALSE(test_enabled());
}

// MIX-16. Dependencies: "The occlusion test result is TRUE when the samples-passed count is nonzero".
TEST_F(MixCounting, the_result_is_true_exactly_when_the_count_is_not_zero) {
    const Query query;
    for (const int width : {0, 1, 0, 0, 64, 3}) {
        const GLuint count = query.count([width] { draw_area(width); });
        EXPECT_EQ(count, static_cast<GLuint>(width * 8));
        EXPECT_EQ(read_result(), count != 0);
    }
}

// MIX-17. GL 4.5, 2.3.1: a command that generates an error has no other effect.
TEST_F(MixCounting, a_refused_begin_resets_neither_count_nor_result) {
    const Query query;
    const Query other;
    EXPECT_EQ(query.count([&] {
        draw_area(8);
        other.begin();
        EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
        draw_area(2);
    }),
              8u * (8 + 2));
    EXPECT_TRUE(read_result());

    pass_one_fragment();
    glBeginQuery(GL_SAMPLES_PASSED, 0);
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
    EXPECT_TRUE(read_result()) << "a Begin of id 0 reset the result";
}

}  // namespace
}  // namespace conformance
