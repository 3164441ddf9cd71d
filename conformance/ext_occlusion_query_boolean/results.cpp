// SPDX-License-Identifier: MIT
// What a query tells, and when (EXTB-09 to EXTB-11).
#include "ext_occlusion_query_boolean/es_query_test.h"

namespace conformance {
namespace {

constexpr int kMostPolls = 1'000'000;  // thousands are needed at most, on any machine at hand

class EsResults : public EsQueryTest {
  protected:
    template <typename Draw>
    GLuint ask(GLenum target, Draw draw) const {
        const GLuint name = new_name();
        begin_query(target, name);
        draw();
        end_query(target);
        const GLuint result = get(name);
        delete_queries(1, &name);
        return result;
    }
};

INSTANTIATE_TEST_SUITE_P(In, EsResults, ::testing::Values(2, 3), es_version);

// EXTB-09. "Repeatedly querying the QUERY_RESULT_AVAILABLE_EXT state for any given query object is guaranteed
// to return true eventually."
TEST_P(EsResults, polling_alone_brings_the_result) {
    for (const GLenum target : kTargets) {
        const GLuint name = new_name();
        begin_query(target, name);
        draw_rect(kWhole, kMiddle);
        end_query(target);
        int polls = 0;
        GLuint available = GL_FALSE;
        while (available == GL_FALSE && polls < kMostPolls) {
            available = get(name, GL_QUERY_RESULT_AVAILABLE);
            ++polls;
        }
        EXPECT_EQ(available, static_cast<GLuint>(GL_TRUE)) << "after " << polls << " polls";
        EXPECT_EQ(get(name), 1u);
        EXPECT_EQ(get(name, GL_QUERY_RESULT_AVAILABLE), static_cast<GLuint>(GL_TRUE));
    }
}

// EXTB-09. "If any query object returns a result available of TRUE, all queries of the same type issued prior
// to that query must also return TRUE."
TEST_P(EsResults, when_a_query_is_available_all_earlier_ones_are) {
    std::array<GLuint, 20> names{};
    gen_queries(static_cast<GLsizei>(names.size()), names.data());
    for (const GLuint name : names) {
        begin_query(kAny, name);
        draw_rect(kWhole, kMiddle);
        end_query(kAny);
    }
    EXPECT_EQ(get(names.back()), 1u);
    for (const GLuint name : names) {
        EXPECT_EQ(get(name, GL_QUERY_RESULT_AVAILABLE), static_cast<GLuint>(GL_TRUE)) << name;
    }
}

// EXTB-10. "In the initial state of a query object, the result is available and its value is zero", where the
// state table has FALSE. An object exists only after its first begin, and then that query's state is what can
// be read.
TEST_P(EsResults, a_query_around_nothing_gives_false_and_becomes_available) {
    for (const GLenum target : kTargets) {
        const GLuint name = new_object(target);
        EXPECT_EQ(get(name), 0u);
        EXPECT_EQ(get(name, GL_QUERY_RESULT_AVAILABLE), static_cast<GLuint>(GL_TRUE));
    }
}

// EXTB-11. "The samples-boolean state is set to TRUE if any fragment or sample passes the depth test."
TEST_P(EsResults, the_result_is_one_exactly_when_a_fragment_passes) {
    draw_occluder();
    for (const GLenum target : kTargets) {
        EXPECT_EQ(ask(target, [] { draw_rect(kWhole, kNear); }), 1u);
        draw_occluder();
        EXPECT_EQ(ask(target, [] { draw_rect({17, 40, 1, 1}, kNear); }), 1u) << "one pixel";
        EXPECT_EQ(ask(target, [] {}), 0u) << "nothing drawn";
    }
    // Conservative may also say TRUE; that it never says FALSE of what is visible is judged above.
    EXPECT_EQ(ask(kAny, [] { draw_rect(kWhole, kFar); }), 0u);
    EXPECT_LE(ask(kConservative, [] { draw_rect(kWhole, kFar); }), 1u);
}

// EXTB-11. "If multiple queries are issued using the same object name [...] the result [...] will always be
// from the last query issued."
TEST_P(EsResults, of_queries_on_one_object_the_last_one_counts) {
    draw_occluder();
    const GLuint name = new_name();
    for (const float depth : {kNear, kFar}) {
        begin_query(kAny, name);
        draw_rect(kWhole, depth);
        end_query(kAny);
        draw_occluder();
    }
    EXPECT_EQ(get(name), 0u);
}

// EXTB-11. Issue 4: with multisampling the query is TRUE if any sample passes.
TEST_P(EsResults, one_sample_of_many_is_enough) {
    if (const auto why = lacks(30)) GTEST_SKIP() << *why;
    if (get_integer(GL_MAX_SAMPLES) < 4) GTEST_SKIP() << "needs 4 samples";
    const Framebuffer framebuffer({.samples = 4});
    clear();
    glEnable(GL_SAMPLE_COVERAGE);
    for (const GLenum target : kTargets) {
        glSampleCoverage(0.25f, GL_FALSE);  // one sample of each fragment
        EXPECT_EQ(ask(target, [] { draw_rect({17, 40, 1, 1}, kMiddle); }), 1u);
    }
    glSampleCoverage(0.0f, GL_FALSE);
    EXPECT_EQ(ask(kAny, [] { draw_rect(kWhole, kMiddle); }), 0u);
}

}  // namespace
}  // namespace conformance
