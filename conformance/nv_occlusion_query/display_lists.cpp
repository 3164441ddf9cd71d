// SPDX-License-Identifier: MIT
// Begin and End compile into display lists; the other five commands do not (NV-49, NV-50).
//
// NV 5.4: "DeleteOcclusionQueriesNV, GenOcclusionQueriesNV, IsOcclusionQueryNV, GetOcclusionQueryivNV, and
// GetOcclusionQueryuivNV are not complied into display lists but are executed immediately."
#include "nv_occlusion_query/list_test.h"

namespace conformance {
namespace {

class NvLists : public ListTest {};

// NV-49. NV 5.4 does not name Begin and End.
TEST_F(NvLists, a_query_that_is_only_compiled_does_not_run) {
    const NvQuery query;
    EXPECT_EQ(query.count([] { draw_samples(5); }), 5u);
    compile([&] {
        query.begin();
        EXPECT_EQ(active_nv(), 0u);
        draw_samples(50);
        glEndOcclusionQueryNV();
    });
    EXPECT_EQ(active_nv(), 0u);
    EXPECT_EQ(query.result(), 5u);
}

// NV-49.
TEST_F(NvLists, a_compiled_query_counts_at_each_call) {
    const NvQuery query;
    const GLuint list = compile([&] {
        query.begin();
        draw_samples(50);
        glEndOcclusionQueryNV();
        draw_samples(400);
    });
    EXPECT_FALSE(glIsOcclusionQueryNV(query.name()));
    for (int call = 0; call < 3; ++call) {
        glCallList(list);
        EXPECT_EQ(active_nv(), 0u);
        EXPECT_EQ(query.result(), 50u) << "call " << call;
    }
}

// NV-49. Several queries of one list, with state between them.
TEST_F(NvLists, several_queries_of_one_list_count_apart) {
    const NvQuery first;
    const NvQuery second;
    const NvQuery third;
    draw_occluder();
    glDepthMask(GL_FALSE);
    const GLuint list = compile([&] {
        first.begin();
        draw_rect({0, 0, 8, 8}, kNear);
        glEndOcclusionQueryNV();
        second.begin();
        draw_rect({0, 0, 8, 8}, kFar);
        glEndOcclusionQueryNV();
        glDisable(GL_DEPTH_TEST);
        third.begin();
        draw_rect({0, 0, 4, 4}, kFar);
        glEndOcclusionQueryNV();
    });
    glCallList(list);
    EXPECT_EQ(first.result(), 64u);
    EXPECT_EQ(second.result(), 0u);
    EXPECT_EQ(third.result(), 16u);
}

// NV-49. NV 4.1.6A: Begin of an unused name makes it an object; when the list is called, not before.
TEST_F(NvLists, a_compiled_begin_makes_the_object_when_the_list_is_called) {
    const GLuint list = compile([] {
        glBeginOcclusionQueryNV(kUnknownName);
        draw_samples(50);
        glEndOcclusionQueryNV();
    });
    EXPECT_FALSE(glIsOcclusionQueryNV(kUnknownName));
    for (int call = 0; call < 2; ++call) {
        glCallList(list);
        EXPECT_TRUE(glIsOcclusionQueryNV(kUnknownName));
        EXPECT_EQ(get_nv(kUnknownName, GL_PIXEL_COUNT_NV), 50u);
        glDeleteOcclusionQueriesNV(1, &kUnknownName);  // the second call makes it anew
    }
}

// NV-50.
TEST_F(NvLists, names_and_gets_are_executed_at_once) {
    const NvQuery query;
    EXPECT_EQ(query.count([] { draw_samples(5); }), 5u);
    GLuint name = 0;
    GLuint doomed = kUnknownName;
    glBeginOcclusionQueryNV(doomed);
    glEndOcclusionQueryNV();
    const GLuint list = compile([&] {
        draw_samples(1);
        glGenOcclusionQueriesNV(1, &name);
        EXPECT_NE(name, 0u);
        EXPECT_TRUE(glIsOcclusionQueryNV(query.name()));
        EXPECT_EQ(query.result(), 5u);
        GLint integer = -1;
        glGetOcclusionQueryivNV(query.name(), GL_PIXEL_COUNT_NV, &integer);
        EXPECT_EQ(integer, 5);
        glDeleteOcclusionQueriesNV(1, &doomed);
        EXPECT_FALSE(glIsOcclusionQueryNV(doomed));
        glGetOcclusionQueryivNV(kUnknownName, GL_PIXEL_COUNT_NV, &integer);
        EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
    });
    const GLuint generated = name;
    doomed = query.name();  // what a compiled Delete would take away
    name = 0;
    glCallList(list);
    EXPECT_EQ(name, 0u) << "the Gen was compiled";
    EXPECT_TRUE(glIsOcclusionQueryNV(query.name())) << "the Delete was compiled";
    EXPECT_FALSE(glIsOcclusionQueryNV(generated));
    EXPECT_TRUE(no_error());
}

}  // namespace
}  // namespace conformance
