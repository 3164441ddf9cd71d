// SPDX-License-Identifier: MIT
// Names of queries and lists that the application picks by hand, as a compatibility context allows: an
// implementation that keeps objects of its own for the test may not be met there (MIX-23, HP-67).
#include "hp_occlusion_test/mix_test.h"

namespace conformance {
namespace {

constexpr GLuint kFirstNames = 16;  // where an implementation's own objects would lie

// A test with one draw enabled still, so that whatever the implementation keeps for it is in use.
void start_test() {
    glEnable(GL_OCCLUSION_TEST_HP);
    draw_point(0, 0, 0.0f);
}

class QueryNamesByHand : public MixTest {};

// MIX-23. ARB 6.1.13: IsQuery "returns TRUE if <id> is the name of a query object", and the application has
// made none.
TEST_F(QueryNamesByHand, no_name_is_a_query_before_the_application_begins_one) {
    start_test();
    for (GLuint name = 1; name < kFirstNames; ++name) {
        GLuint value = kUntouched;
        EXPECT_FALSE(glIsQuery(name)) << name;
        EXPECT_TRUE(no_error());
        glGetQueryObjectuiv(name, GL_QUERY_RESULT, &value);
        EXPECT_TRUE(error_is(GL_INVALID_OPERATION)) << name;
        EXPECT_EQ(value, kUntouched);
    }
    EXPECT_TRUE(read_result());
}

// MIX-23. ARB 4.1.6A: "If BeginQueryARB is called with an unused <id>, that name is marked as used and
// associated with a new query object."
TEST_F(QueryNamesByHand, any_name_can_be_begun_under_the_test) {
    start_test();
    for (GLuint name = 1; name < kFirstNames; ++name) {
        draw_point(0, 0, 0.0f);
        glBeginQuery(GL_SAMPLES_PASSED, name);
        EXPECT_TRUE(no_error()) << name;
        draw_rect({0, 0, static_cast<int>(name), 1}, 0.0f);
        glEndQuery(GL_SAMPLES_PASSED);
    }
    EXPECT_TRUE(read_result());
    for (GLuint name = 1; name < kFirstNames; ++name) {
        GLuint value = kUntouched;
        glGetQueryObjectuiv(name, GL_QUERY_RESULT, &value);
        EXPECT_EQ(value, name);
        EXPECT_TRUE(glIsQuery(name));
    }
    EXPECT_TRUE(no_error());
}

// MIX-23. ARB 4.1.6A: "Unused names in <ids> are silently ignored."
TEST_F(QueryNamesByHand, deleting_unused_names_does_not_end_the_test) {
    start_test();
    for (GLuint name = 1; name < kFirstNames; ++name) glDeleteQueries(1, &name);
    EXPECT_TRUE(no_error());
    EXPECT_TRUE(read_result());
    draw_point(0, 0, 0.0f);
    glDisable(GL_OCCLUSION_TEST_HP);
    EXPECT_TRUE(read_result());
    EXPECT_TRUE(no_error());
}

// MIX-23. ARB, Errors: EndQuery "when a query of the given <target> is not active".
TEST_F(QueryNamesByHand, the_test_is_no_query_that_could_be_ended) {
    std::vector<GLenum> targets = {GL_SAMPLES_PASSED};
    if (!lacks(33, "GL_ARB_occlusion_query2")) targets.push_back(GL_ANY_SAMPLES_PASSED);
    if (!lacks(43, "GL_ARB_ES3_compatibility")) targets.push_back(GL_ANY_SAMPLES_PASSED_CONSERVATIVE);
    start_test();
    for (const GLenum target : targets) {
        EXPECT_EQ(current_query(target), 0);
        glEndQuery(target);
        EXPECT_TRUE(error_is(GL_INVALID_OPERATION)) << target;
    }
    glDisable(GL_OCCLUSION_TEST_HP);
    EXPECT_TRUE(read_result()) << "an End of the application's ended the test";
}

// MIX-23, HP-75. GL 4.5, 2.3.1: the flag keeps the first error, whoever in the implementation found it.
TEST_F(QueryNamesByHand, errors_of_queries_under_the_test_keep_their_order) {
    start_test();
    glEndQuery(GL_SAMPLES_PASSED);  // INVALID_OPERATION: the application has none active
    glLineWidth(-1.0f);             // INVALID_VALUE
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
    EXPECT_TRUE(no_error());

    glLineWidth(-1.0f);
    glEndQuery(GL_SAMPLES_PASSED);
    EXPECT_TRUE(error_is(GL_INVALID_VALUE));
    EXPECT_TRUE(no_error());
}

class ListNamesByHand : public HpTest {
  protected:
    // Of many commands of the test, so that an implementation that splits the list needs several of its own.
    static void compile_test(GLuint list) {
        glNewList(list, GL_COMPILE);
        for (int i = 0; i < 4; ++i) {
            glEnable(GL_OCCLUSION_TEST_HP);
            draw_point(i, 0, 0.0f);
            glDisable(GL_OCCLUSION_TEST_HP);
        }
        glEndList();
    }
};

// HP-67. GL compatibility: IsList is TRUE of the lists that NewList made and the names that GenLists gave.
TEST_F(ListNamesByHand, no_name_is_a_list_before_the_application_makes_one) {
    compile_test(1);
    EXPECT_TRUE(glIsList(1));
    for (GLuint name = 2; name < kFirstNames; ++name) EXPECT_FALSE(glIsList(name)) << name;
    EXPECT_TRUE(no_error());
}

// HP-67. GL compatibility: NewList takes any name; what it had before is replaced.
TEST_F(ListNamesByHand, lists_of_any_name_keep_their_commands) {
    compile_test(1);
    for (GLuint name = 2; name < kFirstNames; ++name) {
        glNewList(name, GL_COMPILE);
        draw_rect({static_cast<int>(name), 8, 1, 1}, 0.0f);
        glEndList();
    }
    glCallList(1);
    EXPECT_TRUE(read_result());
    EXPECT_EQ(drawn_pixels(), 4) << "the test's list runs other commands too";
    EXPECT_FALSE(test_enabled());
    for (GLuint name = 2; name < kFirstNames; ++name) glCallList(name);
    EXPECT_FALSE(read_result());
    EXPECT_EQ(drawn_pixels({0, 8, kSurfaceSize, 1}), static_cast<int>(kFirstNames) - 2);
    EXPECT_TRUE(no_error());
}

// HP-67. GL compatibility: DeleteLists ignores names that are no list; GenLists gives a range of free ones.
TEST_F(ListNamesByHand, deleting_and_generating_other_names_does_not_harm_the_list) {
    compile_test(1);
    glDeleteLists(2, 100);
    const GLuint range = glGenLists(50);
    EXPECT_NE(range, 0u);
    for (GLuint i = 0; i < 50; ++i) EXPECT_TRUE(glIsList(range + i));
    glCallList(1);
    EXPECT_TRUE(read_result());
    EXPECT_EQ(drawn_pixels(), 4);
    glDeleteLists(1, 1);
    glCallList(1);
    EXPECT_FALSE(read_result());
    EXPECT_TRUE(no_error());
}

}  // namespace
}  // namespace conformance
