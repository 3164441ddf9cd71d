// SPDX-License-Identifier: MIT
// The three occlusion targets beside each other: one query at a time, objects and their targets (AOQ2-01,
// AOQ2-04 to AOQ2-07, AOQ2-10, AOQ2-11).
#include "arb_occlusion_query2/any_test.h"

namespace conformance {
namespace {

class AnyTargets : public AnyTest {};
class AnyTarget : public EachAnyTest {};

INSTANTIATE_TEST_SUITE_P(, AnyTarget, ::testing::ValuesIn(kBooleanTargets), target_name);

// AOQ2-01. ARB_occlusion_query2 and ARB_ES3_compatibility, 4.1.7: "An occlusion query can be started and
// finished by calling BeginQuery and EndQuery, respectively, with a target of SAMPLES_PASSED,
// ANY_SAMPLES_PASSED or ANY_SAMPLES_PASSED_CONSERVATIVE."
TEST_P(AnyTarget, begin_end_and_get_accept_the_target) {
    const Query query(target());
    EXPECT_EQ(current_query(target()), 0);
    query.begin();
    EXPECT_TRUE(no_error());
    EXPECT_EQ(current_query(target()), static_cast<GLint>(query.name()));
    query.end();
    EXPECT_TRUE(no_error());
    EXPECT_EQ(current_query(target()), 0);
    EXPECT_TRUE(glIsQuery(query.name()));
}

// AOQ2-07. ARB_occlusion_query2, 6.1.6: "For a target of ANY_SAMPLES_PASSED, if the number of bits is
// non-zero, the minimum number of bits is 1."
TEST_P(AnyTarget, the_counter_has_a_bit_or_none_at_all) {
    GLint bits = -1;
    glGetQueryiv(target(), GL_QUERY_COUNTER_BITS, &bits);
    EXPECT_GE(bits, 0);
    const Query query(target());
    const GLuint visible = query.count([] { draw_rect(kWhole, kMiddle); });
    EXPECT_EQ(visible, bits > 0 ? 1u : 0u);
}

// AOQ2-04. ARB_occlusion_query2, 2.14: BeginQuery is INVALID_OPERATION "for the targets SAMPLES_PASSED or
// ANY_SAMPLES PASSED, if the active query object for either target is non-zero"; GL 4.5, 4.2: the
// conservative target is the third of them.
TEST_F(AnyTargets, one_occlusion_query_at_a_time_whatever_the_two_targets) {
    for (const Target& first : occlusion_targets()) {
        for (const Target& second : occlusion_targets()) {
            SCOPED_TRACE(std::string(second.name) + " inside " + first.name);
            const Query active(first.value);
            const Query refused(second.value);
            active.begin();
            draw_rect({0, 0, 4, 1}, kMiddle);
            refused.begin();
            EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
            EXPECT_FALSE(glIsQuery(refused.name()));
            EXPECT_EQ(current_query(first.value), static_cast<GLint>(active.name()));
            draw_rect({0, 0, 4, 1}, kMiddle);
            active.end();
            EXPECT_TRUE(no_error()) << "the first query is still active";
            EXPECT_EQ(active.result(), first.value == GL_SAMPLES_PASSED ? 8u : 1u);
        }
    }
}

// AOQ2-05. GL 4.5, 4.2: EndQuery is INVALID_OPERATION where no query of its own target is active.
TEST_F(AnyTargets, ending_another_target_than_was_begun_is_refused) {
    for (const Target& begun : occlusion_targets()) {
        const Query query(begun.value);
        query.begin();
        for (const Target& ended : occlusion_targets()) {
            if (ended.value == begun.value) continue;
            SCOPED_TRACE(std::string(ended.name) + " inside " + begun.name);
            glEndQuery(ended.value);
            EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
            EXPECT_EQ(current_query(begun.value), static_cast<GLint>(query.name()));
        }
        draw_rect({0, 0, 1, 1}, kMiddle);
        query.end();
        EXPECT_TRUE(no_error());
        EXPECT_EQ(query.result(), 1u);
    }
}

// AOQ2-06. GL 4.5, 4.2.1: CURRENT_QUERY is "the name of the currently active query for target".
TEST_F(AnyTargets, the_active_query_is_current_on_its_own_target_only) {
    for (const Target& begun : occlusion_targets()) {
        const Query query(begun.value);
        query.begin();
        for (const Target& asked : occlusion_targets()) {
            SCOPED_TRACE(std::string(asked.name) + " inside " + begun.name);
            EXPECT_EQ(current_query(asked.value),
                      asked.value == begun.value ? static_cast<GLint>(query.name()) : 0);
        }
        query.end();
    }
}

// AOQ2-10. ARB_occlusion_query2, 2.14: INVALID_OPERATION "if id is the name of an existing query object whose
// type does not match target": a number is no boolean.
TEST_P(AnyTarget, a_counting_object_is_not_begun_as_a_boolean_nor_the_reverse) {
    for (const bool is_counting : {true, false}) {
        const GLenum made = is_counting ? GL_SAMPLES_PASSED : target();
        const GLenum other = is_counting ? target() : GL_SAMPLES_PASSED;
        const Query query(made);
        const GLuint before = query.count([] { draw_rect({0, 0, 7, 1}, kMiddle); });
        EXPECT_EQ(before, is_counting ? 7u : 1u);
        glBeginQuery(other, query.name());
        EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
        EXPECT_EQ(current_query(other), 0);
        EXPECT_EQ(query.result(), before);
    }
}

// AOQ2-11. GL 4.5, 4.2 (bug 13342): the types of ANY_SAMPLES_PASSED and ANY_SAMPLES_PASSED_CONSERVATIVE
// match: an object made with one is begun with the other.
TEST_P(AnyTarget, a_boolean_object_is_begun_with_the_other_boolean_target_too) {
    if (const auto why = lacks_conservative()) GTEST_SKIP() << *why;
    const GLenum other = is_conservative() ? GL_ANY_SAMPLES_PASSED : GL_ANY_SAMPLES_PASSED_CONSERVATIVE;
    const Query query(target());
    EXPECT_EQ(query.count([] { draw_rect(kWhole, kMiddle); }), 1u);
    glBeginQuery(other, query.name());
    ASSERT_TRUE(no_error());
    EXPECT_EQ(current_query(other), static_cast<GLint>(query.name()));
    EXPECT_EQ(current_query(target()), 0);
    glEndQuery(other);
    EXPECT_TRUE(no_error());
    EXPECT_EQ(query.result(), 0u) << "nothing was drawn";
    glBeginQuery(target(), query.name());
    draw_rect(kWhole, kMiddle);
    glEndQuery(target());
    EXPECT_EQ(query.result(), 1u) << "and back";
}

}  // namespace
}  // namespace conformance
