// SPDX-License-Identifier: MIT
// Names generated and deleted while a query is active, of all things its own (ARB-10 to ARB-12).
#include <array>
#include <set>

#include "arb_occlusion_query/arb_test.h"

namespace conformance {
namespace {

class NamesInUse : public ArbTest {};

// ARB-10. GL 3.0 took the two errors of the text of 2003 back: GL 4.5, 4.2, has none.
TEST_F(NamesInUse, names_are_generated_and_deleted_while_a_query_is_active) {
    if (const auto why = lacks(30)) GTEST_SKIP() << *why;
    const Query active;
    const Query other;
    other.count([] {});
    EXPECT_EQ(active.count([&] {
        draw_samples(3);
        GLuint name = 0;
        glGenQueries(1, &name);
        EXPECT_NE(name, 0u);
        const GLuint unneeded = other.name();
        glDeleteQueries(1, &unneeded);
        EXPECT_TRUE(no_error());
        EXPECT_FALSE(glIsQuery(unneeded));
        draw_samples(4);
    }),
              7u);
}

// ARB-10. ARB 4.1.6A, and GL 1.5 to 2.1, 4.1.7: "Calling either GenQueriesARB or DeleteQueriesARB while any
// query of any target is active causes an INVALID_OPERATION error to be generated."
TEST_F(NamesInUse, before_gl_3_names_are_neither_generated_nor_deleted_while_a_query_is_active) {
    if (!lacks(30)) GTEST_SKIP() << "GL 3.0 allows both";
    const Query active;
    const Query other;
    EXPECT_EQ(other.count([] { draw_samples(5); }), 5u);
    EXPECT_EQ(active.count([&] {
        draw_samples(3);
        GLuint generated = kUntouched;
        glGenQueries(1, &generated);
        EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
        EXPECT_EQ(generated, kUntouched);
        for (const GLuint name : {other.name(), active.name(), kUnknownName}) {
            glDeleteQueries(1, &name);
            EXPECT_TRUE(error_is(GL_INVALID_OPERATION)) << name;
        }
        EXPECT_TRUE(glIsQuery(active.name()));
        EXPECT_TRUE(glIsQuery(other.name()));
        EXPECT_EQ(current_query(GL_SAMPLES_PASSED), static_cast<GLint>(active.name()));
        draw_samples(4);
    }),
              7u);
    EXPECT_EQ(other.result(), 5u);
}

// ARB-11. GL 4.5, 5.1.3: the name of an object in use becomes unused at once, the object goes when it is no
// longer in use; for a query (4.2) that is when it is no longer active. Decided: until then CURRENT_QUERY is
// the name that it had.
TEST_F(NamesInUse, deleting_the_active_object_leaves_it_active_until_its_end) {
    if (const auto why = lacks(30)) GTEST_SKIP() << *why;
    GLuint name = 0;
    glGenQueries(1, &name);
    glBeginQuery(GL_SAMPLES_PASSED, name);
    draw_samples(3);
    glDeleteQueries(1, &name);
    EXPECT_TRUE(no_error());
    EXPECT_FALSE(glIsQuery(name));
    EXPECT_EQ(get_object(name, GL_QUERY_RESULT_AVAILABLE), kUntouched);
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
    EXPECT_EQ(current_query(GL_SAMPLES_PASSED), static_cast<GLint>(name));
    const Query other;
    other.begin();
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION)) << "the deleted object is active still";
    if (!lacks(33, "GL_ARB_timer_query")) {
        glBeginQuery(GL_TIME_ELAPSED, name);
        EXPECT_TRUE(error_is(GL_INVALID_OPERATION)) << "the name is taken until the end";
        EXPECT_EQ(current_query(GL_TIME_ELAPSED), 0);
    }
    glEndQuery(GL_SAMPLES_PASSED);
    EXPECT_TRUE(no_error());
    EXPECT_EQ(current_query(GL_SAMPLES_PASSED), 0);
    EXPECT_FALSE(glIsQuery(name));
    EXPECT_EQ(get_object(name, GL_QUERY_RESULT), kUntouched);
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION)) << "its result went with it";
}

// ARB-12. Whatever became of the deleted object, the target is free after the end, and the name.
TEST_F(NamesInUse, another_query_runs_after_the_active_object_was_deleted) {
    if (const auto why = lacks(30)) GTEST_SKIP() << *why;
    GLuint name = 0;
    glGenQueries(1, &name);
    glBeginQuery(GL_SAMPLES_PASSED, name);
    draw_samples(3);
    glDeleteQueries(1, &name);
    glEndQuery(GL_SAMPLES_PASSED);
    glGetError();  // the previous test judges it
    {
        const Query next;
        EXPECT_EQ(next.count([] { draw_samples(9); }), 9u);
        EXPECT_EQ(next.name() == name, glIsQuery(name) == GL_TRUE);
    }
    glBeginQuery(GL_SAMPLES_PASSED, name);
    EXPECT_TRUE(no_error());
    draw_samples(4);
    glEndQuery(GL_SAMPLES_PASSED);
    EXPECT_EQ(get_object(name, GL_QUERY_RESULT), 4u) << "an object of its own";
    glDeleteQueries(1, &name);
}

// ARB-11, ARB-12. The name is unused at once, so it may name another object while the first is active still.
TEST_F(NamesInUse, the_name_of_a_deleted_active_object_may_be_generated_again) {
    if (const auto why = lacks(30)) GTEST_SKIP() << *why;
    GLuint name = 0;
    glGenQueries(1, &name);
    glBeginQuery(GL_SAMPLES_PASSED, name);
    draw_samples(3);
    glDeleteQueries(1, &name);
    std::array<GLuint, 8> names{};
    glGenQueries(names.size(), names.data());
    EXPECT_EQ(std::set(names.begin(), names.end()).size(), names.size());
    glEndQuery(GL_SAMPLES_PASSED);
    glGetError();  // as above
    for (const GLuint other : names) {
        EXPECT_FALSE(glIsQuery(other)) << "the End gave its result to a new name";
        glBeginQuery(GL_SAMPLES_PASSED, other);
        draw_samples(5);
        glEndQuery(GL_SAMPLES_PASSED);
        EXPECT_EQ(get_object(other, GL_QUERY_RESULT), 5u);
    }
    EXPECT_TRUE(no_error());
    glDeleteQueries(names.size(), names.data());
}

}  // namespace
}  // namespace conformance
