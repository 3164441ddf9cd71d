// SPDX-License-Identifier: MIT
// Names of occlusion queries: generated, used, deleted (NV-01 to NV-16).
#include <algorithm>
#include <array>
#include <set>

#include "nv_occlusion_query/nv_test.h"

namespace conformance {
namespace {

class NvNames : public NvTest {};

// NV-01. NV 4.1.6A: GenOcclusionQueriesNV "returns n previously unused occlusion query names in ids."
TEST_F(NvNames, generated_names_are_distinct_not_zero_and_none_is_in_use) {
    std::array<GLuint, 100> names{};
    glGenOcclusionQueriesNV(names.size(), names.data());
    EXPECT_EQ(std::set(names.begin(), names.end()).size(), names.size());
    EXPECT_EQ(std::count(names.begin(), names.end(), 0u), 0);
    for (const GLuint name : names) EXPECT_FALSE(glIsOcclusionQueryNV(name)) << name;
    glDeleteOcclusionQueriesNV(names.size(), names.data());
}

// NV-02. NV 4.1.6A: "These names are marked as used, but no object is associated with them until the first
// time BeginOcclusionQueryNV is called on them."
TEST_F(NvNames, a_generated_name_is_not_generated_again) {
    std::set<GLuint> seen;
    for (int i = 0; i < 200; ++i) {
        GLuint name = 0;
        glGenOcclusionQueriesNV(1, &name);
        EXPECT_TRUE(seen.insert(name).second) << name;
    }
}

// NV-03, NV-04. NV, Errors: "INVALID_VALUE is generated if GenOcclusionQueriesNV is called where n is
// negative."
TEST_F(NvNames, generating_none_or_less_writes_nothing) {
    GLuint name = kUntouched;
    glGenOcclusionQueriesNV(0, &name);
    EXPECT_TRUE(no_error());
    EXPECT_EQ(name, kUntouched);
    glGenOcclusionQueriesNV(-1, &name);
    EXPECT_TRUE(error_is(GL_INVALID_VALUE));
    EXPECT_EQ(name, kUntouched);
}

// NV-05. NV, Errors: "INVALID_OPERATION is generated if GenOcclusionQueriesNV or DeleteOcclusionQueriesNV is
// called when an occlusion query is active."
TEST_F(NvNames, generating_while_a_query_is_active_is_refused) {
    const NvQuery active;
    GLuint name = kUntouched;
    EXPECT_EQ(active.count([&] {
        draw_samples(3);
        glGenOcclusionQueriesNV(1, &name);
        EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
        EXPECT_EQ(active_nv(), active.name());
        draw_samples(4);
    }),
              7u);
    EXPECT_EQ(name, kUntouched);
}

// NV-06. NV 4.1.6A: "After an occlusion query is deleted, its name is again unused."
TEST_F(NvNames, a_deleted_name_is_unused) {
    GLuint name = 0;
    glGenOcclusionQueriesNV(1, &name);
    glBeginOcclusionQueryNV(name);
    glEndOcclusionQueryNV();
    glDeleteOcclusionQueriesNV(1, &name);
    EXPECT_TRUE(no_error());
    EXPECT_FALSE(glIsOcclusionQueryNV(name));
    for (const GLenum parameter : {GL_PIXEL_COUNT_NV, GL_PIXEL_COUNT_AVAILABLE_NV}) {
        EXPECT_EQ(get_nv(name, parameter), kUntouched);
        EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
    }
    GLuint next = 0;
    glGenOcclusionQueriesNV(1, &next);
    EXPECT_NE(next, 0u);
    EXPECT_FALSE(glIsOcclusionQueryNV(next)) << "the deleted object came back with its name";
}

// NV-07. NV 4.1.6A: "Unused names in ids are silently ignored."
TEST_F(NvNames, delete_ignores_what_is_no_name_and_what_is_named_twice) {
    const NvQuery kept;
    EXPECT_EQ(kept.count([] { draw_samples(5); }), 5u);
    GLuint name = 0;
    glGenOcclusionQueriesNV(1, &name);
    glBeginOcclusionQueryNV(name);
    glEndOcclusionQueryNV();
    const std::array<GLuint, 5> names = {0, kUnknownName, name, kUnknownName + 1, name};
    glDeleteOcclusionQueriesNV(names.size(), names.data());
    EXPECT_TRUE(no_error());
    EXPECT_FALSE(glIsOcclusionQueryNV(name));
    EXPECT_EQ(kept.result(), 5u);
}

// NV-08. NV, Errors: "INVALID_VALUE is generated if DeleteOcclusionQueriesNV is called where n is negative."
TEST_F(NvNames, deleting_none_or_less_deletes_nothing) {
    const NvQuery query;
    EXPECT_EQ(query.count([] { draw_samples(5); }), 5u);
    const GLuint name = query.name();
    glDeleteOcclusionQueriesNV(0, &name);
    EXPECT_TRUE(no_error());
    glDeleteOcclusionQueriesNV(-1, &name);
    EXPECT_TRUE(error_is(GL_INVALID_VALUE));
    EXPECT_TRUE(glIsOcclusionQueryNV(name));
    EXPECT_EQ(query.result(), 5u);
}

// NV-09. NV, Errors, as of NV-05: also of names that are not the active one.
TEST_F(NvNames, deleting_while_a_query_is_active_is_refused) {
    const NvQuery active;
    const NvQuery other;
    EXPECT_EQ(other.count([] { draw_samples(5); }), 5u);
    EXPECT_EQ(active.count([&] {
        draw_samples(3);
        for (const GLuint name : {other.name(), active.name(), kUnknownName}) {
            glDeleteOcclusionQueriesNV(1, &name);
            EXPECT_TRUE(error_is(GL_INVALID_OPERATION)) << name;
        }
        EXPECT_TRUE(glIsOcclusionQueryNV(active.name()));
        EXPECT_EQ(active_nv(), active.name());
        draw_samples(4);
    }),
              7u);
    EXPECT_TRUE(glIsOcclusionQueryNV(other.name()));
    EXPECT_EQ(other.result(), 5u);
}

// NV-10. NV 4.1.6A: "If BeginOcclusionQueryNV is called with an unused id, that id is marked as used and
// associated with a new occlusion query object."
TEST_F(NvNames, begin_creates_an_object_for_a_name_never_generated) {
    glBeginOcclusionQueryNV(kUnknownName);
    EXPECT_TRUE(no_error());
    draw_samples(5);
    glEndOcclusionQueryNV();
    EXPECT_TRUE(glIsOcclusionQueryNV(kUnknownName));
    EXPECT_EQ(get_nv(kUnknownName, GL_PIXEL_COUNT_NV), 5u);
    glDeleteOcclusionQueriesNV(1, &kUnknownName);
}

// NV-11. NV 4.1.6A: Gen returns "previously unused" names, and Begin has marked this one as used.
TEST_F(NvNames, a_name_used_by_begin_is_not_generated) {
    const NvQuery probe;
    const GLuint next = probe.name() + 1;
    glBeginOcclusionQueryNV(next);
    glEndOcclusionQueryNV();
    std::array<GLuint, 16> names{};
    glGenOcclusionQueriesNV(names.size(), names.data());
    EXPECT_EQ(std::count(names.begin(), names.end(), next), 0);
}

// NV-12 to NV-14. The text gives IsOcclusionQueryNV no language; decided: as ARB_occlusion_query 6.1.13 has
// IsQuery, TRUE of "the name of a query object", which a name becomes at its first Begin.
TEST_F(NvNames, a_name_is_an_occlusion_query_from_its_first_begin_on) {
    EXPECT_FALSE(glIsOcclusionQueryNV(0));
    EXPECT_FALSE(glIsOcclusionQueryNV(kUnknownName));
    const NvQuery query;
    EXPECT_FALSE(glIsOcclusionQueryNV(query.name())) << "only generated";
    query.begin();
    EXPECT_TRUE(glIsOcclusionQueryNV(query.name())) << "active";
    glEndOcclusionQueryNV();
    EXPECT_TRUE(glIsOcclusionQueryNV(query.name())) << "ended";
    EXPECT_TRUE(no_error());
}

// NV-15. Only ARB_occlusion_query says it ("INVALID_OPERATION [...] where <id> is zero"); decided: as there.
TEST_F(NvNames, name_zero_is_not_begun) {
    glBeginOcclusionQueryNV(0);
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
    EXPECT_EQ(active_nv(), 0u);
    EXPECT_FALSE(glIsOcclusionQueryNV(0));
    glEndOcclusionQueryNV();
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
}

// NV-16. NV 4.1.6A: "This pixel count result is initialized to zero when the object is created."
TEST_F(NvNames, an_object_made_again_under_the_same_name_has_no_count_left) {
    for (int i = 0; i < 1000; ++i) {
        glBeginOcclusionQueryNV(kUnknownName);
        glEndOcclusionQueryNV();
        ASSERT_EQ(get_nv(kUnknownName, GL_PIXEL_COUNT_NV), 0u) << "round " << i;
        glBeginOcclusionQueryNV(kUnknownName);
        draw_point(i % kSurfaceSize, 0, 0.0f);
        glEndOcclusionQueryNV();
        glDeleteOcclusionQueriesNV(1, &kUnknownName);
    }
}

}  // namespace
}  // namespace conformance
