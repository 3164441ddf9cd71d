// SPDX-License-Identifier: MIT
// Occlusion queries beside the query objects of ARB_occlusion_query and GL 1.5: one name space, one kind of
// object (NV-17). No text says so; decided, as NVIDIA's implementation had it, and as the tokens of the two,
// which have the same values, suggest.
#include <array>

#include "nv_occlusion_query/nv_test.h"

namespace conformance {
namespace {

class NvCommonNames : public NvTest {
  protected:
    void SetUp() override {
        ASSERT_NO_FATAL_FAILURE(NvTest::SetUp());
        if (IsSkipped()) return;
        if (const auto why = lacks(15, "GL_ARB_occlusion_query")) GTEST_SKIP() << *why;
    }
};

GLuint get_object(GLuint name, GLenum parameter) {
    GLuint value = kUntouched;
    glGetQueryObjectuiv(name, parameter, &value);
    return value;
}

// NV-17.
TEST_F(NvCommonNames, what_either_generates_the_other_does_not) {
    std::array<GLuint, 20> names{};
    for (std::size_t i = 0; i < names.size(); i += 2) {
        glGenQueries(1, &names[i]);
        glGenOcclusionQueriesNV(1, &names[i + 1]);
    }
    for (std::size_t i = 0; i < names.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) EXPECT_NE(names[i], names[j]);
    }
}

// NV-17.
TEST_F(NvCommonNames, both_agree_on_what_is_a_query) {
    const NvQuery nv;
    const Query arb;
    for (const GLuint name : {nv.name(), arb.name(), kUnknownName, 0u}) {
        EXPECT_FALSE(glIsQuery(name));
        EXPECT_FALSE(glIsOcclusionQueryNV(name));
    }
    nv.count([] {});
    arb.count([] {});
    for (const GLuint name : {nv.name(), arb.name()}) {
        EXPECT_TRUE(glIsQuery(name));
        EXPECT_TRUE(glIsOcclusionQueryNV(name));
    }
}

// NV-17.
TEST_F(NvCommonNames, either_reads_what_the_other_counted) {
    const NvQuery nv;
    const Query arb;
    nv.count([] { draw_samples(50); });
    arb.count([] { draw_samples(7); });
    EXPECT_EQ(get_object(nv.name(), GL_QUERY_RESULT), 50u);
    EXPECT_EQ(get_object(nv.name(), GL_QUERY_RESULT_AVAILABLE), GLuint{GL_TRUE});
    EXPECT_EQ(get_nv(arb.name(), GL_PIXEL_COUNT_NV), 7u);
    EXPECT_EQ(get_nv(arb.name(), GL_PIXEL_COUNT_AVAILABLE_NV), GLuint{GL_TRUE});
}

// NV-17.
TEST_F(NvCommonNames, either_begins_the_objects_of_the_other_anew) {
    const NvQuery nv;
    const Query arb;
    nv.count([] { draw_samples(50); });
    arb.count([] { draw_samples(7); });
    glBeginQuery(GL_SAMPLES_PASSED, nv.name());
    draw_samples(3);
    glEndQuery(GL_SAMPLES_PASSED);
    EXPECT_TRUE(no_error());
    EXPECT_EQ(nv.result(), 3u);
    glBeginOcclusionQueryNV(arb.name());
    draw_samples(4);
    glEndOcclusionQueryNV();
    EXPECT_TRUE(no_error());
    EXPECT_EQ(arb.result(), 4u);
}

// NV-17. GL 4.5, 4.2: INVALID_OPERATION "if id is the name of an existing query object whose type does not
// match target": an occlusion query is an object of SAMPLES_PASSED.
TEST_F(NvCommonNames, an_occlusion_query_is_an_object_of_samples_passed) {
    if (const auto why = lacks(33, "GL_ARB_occlusion_query2")) GTEST_SKIP() << *why;
    const NvQuery nv;
    nv.count([] { draw_samples(5); });
    glBeginQuery(GL_ANY_SAMPLES_PASSED, nv.name());
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
    EXPECT_EQ(current_query(GL_ANY_SAMPLES_PASSED), 0);
    EXPECT_EQ(nv.result(), 5u);
    for (const GLenum target : {GL_ANY_SAMPLES_PASSED, GL_TIME_ELAPSED}) {
        const Query other(target);
        other.count([] { draw_samples(5); });
        other.begin();
        other.end();
        glBeginOcclusionQueryNV(other.name());
        EXPECT_TRUE(error_is(GL_INVALID_OPERATION)) << target;
        EXPECT_EQ(active_nv(), 0u);
    }
    if (lacks(45, "GL_ARB_direct_state_access")) return;
    GLint target = -1;
    glGetQueryObjectiv(nv.name(), GL_QUERY_TARGET, &target);
    EXPECT_EQ(target, GL_SAMPLES_PASSED);
}

// NV-17. The active query is the same, however it is asked for and ended.
TEST_F(NvCommonNames, the_active_query_shows_in_both) {
    const NvQuery nv;
    nv.begin();
    EXPECT_EQ(current_query(GL_SAMPLES_PASSED), static_cast<GLint>(nv.name()));
    EXPECT_EQ(get_object(nv.name(), GL_QUERY_RESULT), kUntouched);
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
    glEndOcclusionQueryNV();
    EXPECT_EQ(current_query(GL_SAMPLES_PASSED), 0);

    const Query arb;
    arb.begin();
    EXPECT_EQ(active_nv(), arb.name());
    EXPECT_EQ(get_nv(arb.name(), GL_PIXEL_COUNT_NV), kUntouched);
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
    arb.end();
    EXPECT_EQ(active_nv(), 0u);
}

// NV-17.
TEST_F(NvCommonNames, either_deletes_what_the_other_made) {
    GLuint name = 0;
    glGenOcclusionQueriesNV(1, &name);
    glBeginOcclusionQueryNV(name);
    glEndOcclusionQueryNV();
    glDeleteQueries(1, &name);
    EXPECT_FALSE(glIsOcclusionQueryNV(name));
    EXPECT_EQ(get_nv(name, GL_PIXEL_COUNT_NV), kUntouched);
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION));

    glBeginQuery(GL_SAMPLES_PASSED, name);
    glEndQuery(GL_SAMPLES_PASSED);
    glDeleteOcclusionQueriesNV(1, &name);
    EXPECT_TRUE(no_error());
    EXPECT_FALSE(glIsQuery(name));
}

}  // namespace
}  // namespace conformance
