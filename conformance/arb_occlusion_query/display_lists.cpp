// SPDX-License-Identifier: MIT
// Begin and End compile into display lists; the other six commands do not (ARB-48, ARB-55 to ARB-59).
//
// ARB 5.4: "DeleteQueriesARB, GenQueriesARB, IsQueryARB, GetQueryivARB, GetQueryObjectivARB, and
// GetQueryObjectuivARB are not compiled into display lists but are executed immediately."
#include "arb_occlusion_query/arb_test.h"

namespace conformance {
namespace {

class QueryLists : public ArbTest {
  protected:
    template <typename Commands>
    static GLuint compile(Commands commands, GLenum mode = GL_COMPILE) {
        const GLuint list = glGenLists(1);
        glNewList(list, mode);
        commands();
        glEndList();
        EXPECT_TRUE(no_error());
        return list;
    }
};

// ARB-48, ARB-55.
TEST_F(QueryLists, names_and_gets_are_executed_at_once) {
    const Query query;
    EXPECT_EQ(query.count([] { draw_samples(5); }), 5u);
    GLuint name = 0;
    const GLuint list = compile([&] {
        glGenQueries(1, &name);
        EXPECT_NE(name, 0u);
        EXPECT_TRUE(glIsQuery(query.name()));
        EXPECT_EQ(query.result(), 5u);
        GLint bits = -1;
        glGetQueryiv(GL_SAMPLES_PASSED, GL_QUERY_COUNTER_BITS, &bits);
        EXPECT_NE(bits, -1);
        const GLuint unneeded = query.name();
        glDeleteQueries(1, &unneeded);
        EXPECT_FALSE(glIsQuery(unneeded));
    });
    GLuint second = name;
    glCallList(list);
    EXPECT_EQ(second, name) << "the Gen was compiled";
}

// ARB-56.
TEST_F(QueryLists, a_query_that_is_only_compiled_does_not_run) {
    const Query query;
    EXPECT_EQ(query.count([] { draw_samples(5); }), 5u);
    compile([&] {
        query.begin();
        EXPECT_EQ(current_query(GL_SAMPLES_PASSED), 0);
        draw_samples(50);
        query.end();
    });
    EXPECT_EQ(current_query(GL_SAMPLES_PASSED), 0);
    EXPECT_EQ(query.result(), 5u);
}

// ARB-57.
TEST_F(QueryLists, a_compiled_query_counts_at_each_call) {
    const Query query;
    const GLuint list = compile([&] {
        query.begin();
        draw_samples(50);
        query.end();
    });
    EXPECT_FALSE(glIsQuery(query.name()));
    for (int call = 0; call < 3; ++call) {
        glCallList(list);
        EXPECT_EQ(query.result(), 50u) << "call " << call;
    }
}

// ARB-57. Begin, draws and End may stand in different lists.
TEST_F(QueryLists, a_query_may_span_lists) {
    const Query query;
    const GLuint begin = compile([&] { query.begin(); });
    const GLuint draw = compile([] { draw_samples(50); });
    const GLuint end = compile([&] { query.end(); });
    glCallList(begin);
    EXPECT_EQ(current_query(GL_SAMPLES_PASSED), static_cast<GLint>(query.name()));
    glCallList(draw);
    draw_samples(3);
    glCallList(end);
    EXPECT_EQ(current_query(GL_SAMPLES_PASSED), 0);
    glCallList(draw);
    EXPECT_EQ(query.result(), 53u);
}

// ARB-57. An outer list runs its inner ones in order.
TEST_F(QueryLists, a_query_may_stand_in_nested_lists) {
    const Query query;
    const GLuint inner = compile([&] {
        query.begin();
        draw_samples(50);
    });
    const GLuint outer = compile([&] {
        glCallList(inner);
        draw_samples(3);
        query.end();
        draw_samples(400);
    });
    glCallList(outer);
    EXPECT_EQ(query.result(), 53u);
}

// ARB-57. GL 4.5 compatibility, 21.4: COMPILE_AND_EXECUTE executes each command as it is compiled.
TEST_F(QueryLists, compile_and_execute_does_both) {
    const Query query;
    const GLuint list = compile(
        [&] {
            query.begin();
            EXPECT_EQ(current_query(GL_SAMPLES_PASSED), static_cast<GLint>(query.name()));
            draw_samples(50);
            query.end();
        },
        GL_COMPILE_AND_EXECUTE);
    EXPECT_EQ(query.result(), 50u);
    EXPECT_EQ(query.count([] {}), 0u);
    glCallList(list);
    EXPECT_EQ(query.result(), 50u);
}

// ARB-55. GL 4.5 compatibility, 21.4: errors of a compiled command arise when it is executed.
TEST_F(QueryLists, a_compiled_error_arises_at_the_call) {
    const GLuint list = compile([] { glBeginQuery(GL_SAMPLES_PASSED, 0); });
    glCallList(list);
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
    const GLuint end = compile([] { glEndQuery(GL_SAMPLES_PASSED); });
    glCallList(end);
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
}

// ARB-58.
TEST_F(QueryLists, conditional_rendering_compiles) {
    if (const auto why = lacks(30)) GTEST_SKIP() << *why;
    const Query query;
    const GLuint list = compile([&] {
        glBeginConditionalRender(query.name(), GL_QUERY_WAIT);
        draw_rect(kWhole, kMiddle);
        glEndConditionalRender();
    });
    EXPECT_EQ(query.count([] {}), 0u);
    glCallList(list);
    EXPECT_EQ(drawn_pixels(), 0);
    EXPECT_EQ(query.count([] { draw_point(0, 0, kMiddle); }), 1u);
    glCallList(list);
    EXPECT_EQ(drawn_pixels(), kWhole.area());
}

// ARB-59. ARB 4.1.6A: Begin of an unused name associates it "with a new query object".
TEST_F(QueryLists, a_compiled_begin_creates_an_object_for_a_name_deleted_since) {
    GLuint name = 0;
    glGenQueries(1, &name);
    const GLuint list = compile([name] {
        glBeginQuery(GL_SAMPLES_PASSED, name);
        draw_samples(50);
        glEndQuery(GL_SAMPLES_PASSED);
    });
    glDeleteQueries(1, &name);
    glCallList(list);
    EXPECT_TRUE(no_error());
    EXPECT_TRUE(glIsQuery(name));
    EXPECT_EQ(get_object(name, GL_QUERY_RESULT), 50u);
    glDeleteQueries(1, &name);
}

}  // namespace
}  // namespace conformance
