// SPDX-License-Identifier: MIT
// The occlusion test and occlusion queries overlapped in display lists: ARB 5.4 and NV 5.4 compile Begin and
// End, HP's Enable and Disable compile like every Enable, Gets do not (MIX-04, MIX-05, MIX-09, MIX-10,
// MIX-23).
#include "overlap/overlap_test.h"

namespace conformance {
namespace {

class OverlapLists : public OverlapTest {
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

// MIX-23, of a query in a display list: ARB 5.4 and NV 5.4 compile Begin and End; HP's Enable is among them.
TEST_P(OverlapLists, a_compiled_query_and_the_test_do_not_disturb_each_other) {
    const AnyQuery query(way());
    const GLuint list = glGenLists(1);
    glNewList(list, GL_COMPILE);
    query.begin();
    draw_columns(8);
    glEnable(GL_OCCLUSION_TEST_HP);
    draw_rect({8, 0, 8, 8}, kMiddle);
    query.end();
    draw_rect({16, 0, 8, 8}, kMiddle);
    glEndList();
    for (int call = 0; call < 3; ++call) {
        draw_point(0, 0, 0.0f);
        glCallList(list);
        EXPECT_EQ(active_name(way()), 0);
        EXPECT_EQ(query.result(), way().of(128)) << "call " << call;
        EXPECT_TRUE(test_enabled());
        EXPECT_TRUE(read_result());
        EXPECT_FALSE(read_result());
        draw_point(0, 0, 0.0f);
        EXPECT_TRUE(read_result()) << "the list ended the test";
    }
    EXPECT_EQ(query.count([] { draw_point(0, 0, 0.0f); }), way().of(1));
    EXPECT_TRUE(no_error());
}

// MIX-23. A list enables and disables the test inside the program's query.
TEST_P(OverlapLists, a_compiled_test_inside_a_query_does_not_alter_the_count) {
    const AnyQuery query(way());
    const GLuint list = glGenLists(1);
    glNewList(list, GL_COMPILE);
    draw_columns(1);
    glEnable(GL_OCCLUSION_TEST_HP);
    draw_columns(2);
    glDisable(GL_OCCLUSION_TEST_HP);
    draw_columns(4);
    glEndList();
    EXPECT_EQ(query.count([list] {
        glCallList(list);
        draw_columns(8);
        glCallList(list);
    }),
              way().of(8 * (7 + 8 + 7)));
    EXPECT_TRUE(read_result());
    EXPECT_TRUE(no_error());
}

// MIX-09, MIX-10. GL 4.5 compatibility, 21.4.1: a Get is executed at once. While a list is compiled and
// executed it resets the count of the query that is running; it is not in the list.
TEST_P(OverlapLists, a_read_while_a_query_is_compiled_and_executed_resets_its_count_once) {
    const AnyQuery query(way());
    const GLuint list = compile(
        [&] {
            query.begin();
            draw_columns(8);
            EXPECT_TRUE(read_result());
            EXPECT_FALSE(read_result());
            draw_columns(2);
            query.end();
        },
        GL_COMPILE_AND_EXECUTE);
    EXPECT_EQ(query.result(), way().of(16));
    EXPECT_TRUE(read_result());
    glCallList(list);
    EXPECT_EQ(query.result(), way().of(8 * (8 + 2)));
    EXPECT_TRUE(read_result());
}

// MIX-09. A read while a list is only compiled concerns the query that is active outside it.
TEST_P(OverlapLists, a_read_while_a_list_is_compiled_resets_the_query_around_it) {
    const AnyQuery query(way());
    EXPECT_EQ(query.count([&] {
        draw_columns(8);
        const GLuint list = compile([] {
            draw_columns(1);
            EXPECT_TRUE(read_result());
            EXPECT_FALSE(read_result());
        });
        EXPECT_FALSE(read_result());
        glCallList(list);
        draw_columns(4);
    }),
              way().of(8 * (1 + 4)));
}

// MIX-04, MIX-05. A compiled Begin resets HP's result when the list is called.
TEST_P(OverlapLists, a_compiled_begin_resets_the_result_at_the_call) {
    const AnyQuery query(way());
    const GLuint begin_in_list = compile([&] { query.begin(); });
    pass_one_fragment();
    compile([&] { query.begin(); });
    EXPECT_TRUE(read_result()) << "a Begin that was only compiled";
    pass_one_fragment();
    glCallList(begin_in_list);
    EXPECT_FALSE(read_result());
    query.end();
}

// MIX-13, MIX-14. Begin in one list, draws in a second, the test's Enable and Disable in a third, End in a
// fourth.
TEST_P(OverlapLists, a_query_and_a_test_may_span_lists) {
    const AnyQuery query(way());
    const GLuint begin_in_list = compile([&] { query.begin(); });
    const GLuint draw = compile([] { draw_columns(2); });
    const GLuint enable = compile([] { glEnable(GL_OCCLUSION_TEST_HP); });
    const GLuint disable = compile([] { glDisable(GL_OCCLUSION_TEST_HP); });
    const GLuint end_in_list = compile([&] { query.end(); });
    const GLuint outer = compile([&] {
        for (const GLuint list : {enable, draw, begin_in_list, draw, disable, draw, end_in_list, draw}) {
            glCallList(list);
        }
    });
    for (int call = 0; call < 2; ++call) {
        glCallList(outer);
        EXPECT_FALSE(test_enabled());
        EXPECT_EQ(query.result(), way().of(8 * (2 + 2))) << "call " << call;
        EXPECT_TRUE(read_result());
        draw_columns(1);
        EXPECT_FALSE(read_result()) << "nothing is enabled nor active";
    }
}

INSTANTIATE_TEST_SUITE_P(Of, OverlapLists, ::testing::ValuesIn(kWays), way_name);

}  // namespace
}  // namespace conformance
