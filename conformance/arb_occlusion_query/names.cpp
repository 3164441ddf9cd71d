// SPDX-License-Identifier: MIT
// Names of query objects: generated, used, deleted (ARB-01 to ARB-09, ARB-14).
// What becomes of names while a query is active: names_in_use.cpp.
#include <algorithm>
#include <array>
#include <set>

#include "arb_occlusion_query/arb_test.h"

namespace conformance {
namespace {

class Names : public ArbTest {};

// ARB-01. ARB 4.1.6A: GenQueries "returns <n> previously unused query object names in <ids>".
TEST_F(Names, generated_names_are_distinct_and_not_zero) {
    std::array<GLuint, 100> names{};
    glGenQueries(names.size(), names.data());
    EXPECT_EQ(std::set(names.begin(), names.end()).size(), names.size());
    EXPECT_EQ(std::count(names.begin(), names.end(), 0u), 0);
    glDeleteQueries(names.size(), names.data());
}

// ARB-02. ARB, Errors: "INVALID_VALUE is generated if GenQueriesARB is called where <n> is negative."
TEST_F(Names, generating_none_or_less_writes_nothing) {
    GLuint name = kUntouched;
    glGenQueries(0, &name);
    EXPECT_TRUE(no_error());
    EXPECT_EQ(name, kUntouched);
    glGenQueries(-1, &name);
    EXPECT_TRUE(error_is(GL_INVALID_VALUE));
    EXPECT_EQ(name, kUntouched);
}

// ARB-03. ARB 4.1.6A: "These names are marked as used".
TEST_F(Names, a_generated_name_is_not_generated_again) {
    std::set<GLuint> seen;
    for (int i = 0; i < 200; ++i) {
        GLuint name = 0;
        glGenQueries(1, &name);
        EXPECT_TRUE(seen.insert(name).second) << name;
    }
}

// ARB-04, ARB-05. ARB 4.1.6A: "no object is associated with them until the first time they are used by
// BeginQueryARB"; 6.1.13: IsQuery "returns TRUE if <id> is the name of a query object".
TEST_F(Names, a_name_becomes_an_object_at_its_first_begin) {
    const Query query;
    EXPECT_FALSE(glIsQuery(query.name()));
    query.begin();
    EXPECT_TRUE(glIsQuery(query.name()));
    query.end();
    EXPECT_TRUE(glIsQuery(query.name()));
}

// ARB-05. ARB 6.1.13: "If <id> is zero, or if <id> is a non-zero value that is not the name of a query
// object, IsQueryARB returns FALSE."
TEST_F(Names, zero_and_unknown_names_are_no_queries) {
    EXPECT_FALSE(glIsQuery(0));
    EXPECT_FALSE(glIsQuery(kUnknownName));
    EXPECT_TRUE(no_error());
}

// ARB-06. ARB 4.1.6A: "If BeginQueryARB is called with an unused <id>, that name is marked as used and
// associated with a new query object."
TEST_F(Names, begin_creates_an_object_for_a_name_never_generated) {
    glBeginQuery(GL_SAMPLES_PASSED, kUnknownName);
    EXPECT_TRUE(no_error());
    draw_samples(5);
    glEndQuery(GL_SAMPLES_PASSED);
    EXPECT_TRUE(glIsQuery(kUnknownName));
    EXPECT_EQ(get_object(kUnknownName, GL_QUERY_RESULT), 5u);
    glDeleteQueries(1, &kUnknownName);
}

// ARB-06. A name made used by Begin is not generated: 4.1.6A, "previously unused".
TEST_F(Names, a_name_used_by_begin_is_not_generated) {
    const Query probe;
    const GLuint next = probe.name() + 1;
    glBeginQuery(GL_SAMPLES_PASSED, next);
    glEndQuery(GL_SAMPLES_PASSED);
    std::array<GLuint, 16> names{};
    glGenQueries(names.size(), names.data());
    EXPECT_EQ(std::count(names.begin(), names.end(), next), 0);
}

// ARB-06, ARB-09. GL 4.5 core, 4.2: BeginQuery of a name not from GenQueries, or deleted since:
// INVALID_OPERATION.
TEST_F(Names, a_core_profile_begins_generated_names_only) {
    const Context core({.api = Api::kCore, .major = 3, .minor = 2});
    if (!core) GTEST_SKIP() << "no core profile";
    ASSERT_TRUE(core.make_current(surface()));
    glBeginQuery(GL_SAMPLES_PASSED, kUnknownName);
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
    EXPECT_FALSE(glIsQuery(kUnknownName));

    GLuint name = 0;
    glGenQueries(1, &name);
    glDeleteQueries(1, &name);
    glBeginQuery(GL_SAMPLES_PASSED, name);
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
    EXPECT_EQ(current_query(GL_SAMPLES_PASSED), 0);
    come_back();
}

// ARB-07. ARB 4.1.6A: "After a query object is deleted, its name is again unused."
TEST_F(Names, a_deleted_name_is_unused) {
    GLuint name = 0;
    glGenQueries(1, &name);
    glBeginQuery(GL_SAMPLES_PASSED, name);
    glEndQuery(GL_SAMPLES_PASSED);
    glDeleteQueries(1, &name);
    EXPECT_TRUE(no_error());
    EXPECT_FALSE(glIsQuery(name));
    EXPECT_EQ(get_object(name, GL_QUERY_RESULT), kUntouched);
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
}

// ARB-08. ARB 4.1.6A: "Unused names in <ids> are silently ignored"; Errors: negative <n> is INVALID_VALUE.
TEST_F(Names, delete_ignores_what_is_no_name_and_refuses_a_negative_count) {
    const Query query;
    query.count([] {});
    const std::array<GLuint, 4> names = {0, kUnknownName, kUnknownName + 1, kUnknownName};
    glDeleteQueries(names.size(), names.data());
    EXPECT_TRUE(no_error());
    const GLuint name = query.name();
    glDeleteQueries(0, &name);
    EXPECT_TRUE(no_error());
    glDeleteQueries(-1, &name);
    EXPECT_TRUE(error_is(GL_INVALID_VALUE));
    EXPECT_TRUE(glIsQuery(name));
}

// ARB-14. ARB, issues: "Are query objects shareable between multiple contexts? RESOLVED: No."
TEST_F(Names, contexts_that_share_objects_do_not_share_queries) {
    const Query query;
    EXPECT_EQ(query.count([] { draw_samples(5); }), 5u);
    const Context other({}, &context());
    ASSERT_TRUE(other.make_current(surface()));
    EXPECT_FALSE(glIsQuery(query.name()));
    EXPECT_EQ(get_object(query.name(), GL_QUERY_RESULT), kUntouched);
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
    glBeginQuery(GL_SAMPLES_PASSED, query.name());
    glEndQuery(GL_SAMPLES_PASSED);
    EXPECT_EQ(get_object(query.name(), GL_QUERY_RESULT), 0u);
    EXPECT_TRUE(no_error());
    come_back();
    EXPECT_EQ(query.result(), 5u);
}

}  // namespace
}  // namespace conformance
