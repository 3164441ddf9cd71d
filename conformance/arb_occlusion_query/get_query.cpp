// SPDX-License-Identifier: MIT
// What a query target says of itself (ARB-44 to ARB-48), and labels of query objects (ARB-15).
#include <algorithm>
#include <array>
#include <cmath>

#include "arb_occlusion_query/arb_test.h"

namespace conformance {
namespace {

class GetQuery : public ArbTest {
  protected:
    static GLint counter_bits() {
        GLint bits = -1;
        glGetQueryiv(GL_SAMPLES_PASSED, GL_QUERY_COUNTER_BITS, &bits);
        return bits;
    }
};

// ARB-44. ARB 6.1.13: "If <pname> is CURRENT_QUERY_ARB, the name of the currently active query for <target>,
// or zero if no query is active, will be placed in <params>."
TEST_F(GetQuery, the_current_query_is_the_active_one_or_zero) {
    EXPECT_EQ(current_query(GL_SAMPLES_PASSED), 0);
    const Query query;
    query.begin();
    EXPECT_EQ(current_query(GL_SAMPLES_PASSED), static_cast<GLint>(query.name()));
    query.end();
    EXPECT_EQ(current_query(GL_SAMPLES_PASSED), 0);
}

// ARB-44. GL 4.5, 4.2: for TIMESTAMP there is no active query.
TEST_F(GetQuery, a_time_stamp_is_never_current) {
    if (const auto why = lacks(33, "GL_ARB_timer_query")) GTEST_SKIP() << *why;
    EXPECT_EQ(current_query(GL_TIMESTAMP), 0);
}

// ARB-45. ARB 6.1.13: "n = (min (32, ceil (log2 (maxViewportWidth x maxViewportHeight x 2) ) ) ) or 0".
TEST_F(GetQuery, the_counter_has_the_bits_that_the_viewport_demands_or_none) {
    std::array<GLint, 2> viewport{};
    glGetIntegerv(GL_MAX_VIEWPORT_DIMS, viewport.data());
    const double pixels = 1.0 * viewport[0] * viewport[1];
    const auto demanded = static_cast<GLint>(std::min(32.0, std::ceil(std::log2(pixels * 2.0))));
    EXPECT_TRUE(counter_bits() == 0 || counter_bits() >= demanded) << counter_bits() << " of " << demanded;
}

// ARB-46. ARB, issues: with 0 bits "the occlusion queries will always return that zero samples passed".
TEST_F(GetQuery, a_counter_without_bits_counts_nothing) {
    if (counter_bits() != 0) GTEST_SKIP() << "the counter has " << counter_bits() << " bits";
    const Query query;
    EXPECT_EQ(query.count([] { draw_samples(100); }), 0u);
}

// ARB-50. ARB 4.1.6A: "It is recommended, but not required, that implementations handle this overflow case by
// saturating at 2^n-1 and incrementing no further." Judged where an overflow takes less than a second.
TEST_F(GetQuery, a_counter_that_overflows_saturates) {
    const GLint bits = counter_bits();
    if (bits == 0 || bits > 20) GTEST_SKIP() << "a counter of " << bits << " bits takes too long to overflow";
    const Query query;
    const GLuint largest = (GLuint{1} << bits) - 1;
    const GLuint count = query.count([largest] {
        for (GLuint drawn = 0; drawn <= largest; drawn += 4096) draw_rect(kWhole, 0.0f);
        draw_samples(1);
    });
    EXPECT_EQ(count, largest);
}

// ARB-47. ARB, Errors: INVALID_ENUM for another target, or "<pname> is not QUERY_COUNTER_BITS_ARB or
// CURRENT_QUERY_ARB".
TEST_F(GetQuery, an_unknown_target_or_parameter_is_refused) {
    GLint value = -1;
    glGetQueryiv(GL_TEXTURE_2D, GL_QUERY_COUNTER_BITS, &value);
    EXPECT_TRUE(error_is(GL_INVALID_ENUM));
    glGetQueryiv(GL_SAMPLES_PASSED, GL_QUERY_RESULT, &value);
    EXPECT_TRUE(error_is(GL_INVALID_ENUM));
    EXPECT_EQ(value, -1);
}

// ARB-15. KHR_debug: a label belongs to an existing object and goes with it.
TEST_F(GetQuery, a_query_object_can_be_labelled) {
    if (const auto why = lacks(43, "GL_KHR_debug")) GTEST_SKIP() << *why;
    const Query query;
    query.count([] {});
    glObjectLabel(GL_QUERY, query.name(), -1, "box");
    EXPECT_TRUE(no_error());
    std::array<char, 16> label{};
    glGetObjectLabel(GL_QUERY, query.name(), label.size(), nullptr, label.data());
    EXPECT_STREQ(label.data(), "box");

    GLuint name = 0;
    glGenQueries(1, &name);
    glBeginQuery(GL_SAMPLES_PASSED, name);
    glEndQuery(GL_SAMPLES_PASSED);
    glObjectLabel(GL_QUERY, name, -1, "gone");
    glDeleteQueries(1, &name);
    glObjectLabel(GL_QUERY, name, -1, "none");
    EXPECT_TRUE(error_is(GL_INVALID_VALUE));
}

// ARB-15. KHR_debug: "INVALID_VALUE if <name> is not the name of a valid object of the type specified by
// <identifier>": a generated name is none before its first Begin.
TEST_F(GetQuery, a_name_without_object_cannot_be_labelled) {
    if (const auto why = lacks(43, "GL_KHR_debug")) GTEST_SKIP() << *why;
    const Query query;
    glObjectLabel(GL_QUERY, query.name(), -1, "none");
    EXPECT_TRUE(error_is(GL_INVALID_VALUE));
}

}  // namespace
}  // namespace conformance
