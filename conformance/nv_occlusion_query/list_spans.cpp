// SPDX-License-Identifier: MIT
// Queries that span lists, stand in nested ones, or are refused in them (NV-51 to NV-53).
#include <array>

#include "nv_occlusion_query/list_test.h"

namespace conformance {
namespace {

class NvListSpans : public ListTest {};

// NV-51. GL 4.5 compatibility, 21.4: a list may hold any part of a sequence.
TEST_F(NvListSpans, a_query_may_span_lists) {
    const NvQuery query;
    const GLuint begin = compile([&] { query.begin(); });
    const GLuint draw = compile([] { draw_samples(50); });
    const GLuint end = compile([] { glEndOcclusionQueryNV(); });
    for (int round = 0; round < 2; ++round) {
        glCallList(begin);
        EXPECT_EQ(active_nv(), query.name());
        glCallList(draw);
        draw_samples(3);
        glCallList(draw);
        glCallList(end);
        EXPECT_EQ(active_nv(), 0u);
        glCallList(draw);
        EXPECT_EQ(query.result(), 103u) << "round " << round;
    }
    const std::array<GLuint, 4> lists = {draw, begin, draw, end};
    glCallLists(lists.size(), GL_UNSIGNED_INT, lists.data());
    EXPECT_EQ(query.result(), 50u);
}

// NV-51. A list begins what the program ends, and the reverse.
TEST_F(NvListSpans, a_list_and_the_program_may_share_a_query) {
    const NvQuery query;
    const GLuint begin = compile([&] {
        draw_samples(400);
        query.begin();
        draw_samples(50);
    });
    const GLuint end = compile([] {
        draw_samples(7);
        glEndOcclusionQueryNV();
        draw_samples(400);
    });
    glCallList(begin);
    draw_samples(3);
    glEndOcclusionQueryNV();
    EXPECT_EQ(query.result(), 53u);
    query.begin();
    draw_samples(3);
    glCallList(end);
    EXPECT_EQ(query.result(), 10u);
}

// NV-51. GL 4.5 compatibility, 21.4: an outer list runs its inner ones in order, looked up when it is called.
TEST_F(NvListSpans, a_query_may_stand_in_nested_lists) {
    const NvQuery query;
    const GLuint begin = compile([&] {
        query.begin();
        draw_samples(50);
    });
    const GLuint end = compile([] { glEndOcclusionQueryNV(); });
    const GLuint middle = compile([&] {
        glCallList(begin);
        draw_samples(3);
    });
    const GLuint outer = compile([&] {
        draw_samples(400);
        glCallList(middle);
        draw_samples(2);
        glCallList(end);
        draw_samples(400);
    });
    glCallList(outer);
    EXPECT_EQ(query.result(), 55u);

    compile([&] { query.begin(); }, GL_COMPILE, begin);
    glCallList(outer);
    EXPECT_EQ(query.result(), 5u) << "the replaced inner list";
}

// NV-52. GL 4.5 compatibility, 21.4: the errors of a compiled command arise when it is executed.
TEST_F(NvListSpans, compiled_errors_arise_at_the_call) {
    const NvQuery query;
    const NvQuery other;
    const GLuint begin = compile([&] { other.begin(); });
    const GLuint begin_zero = compile([] { glBeginOcclusionQueryNV(0); });
    const GLuint end = compile([] { glEndOcclusionQueryNV(); });
    EXPECT_EQ(query.count([&] {
        draw_samples(3);
        compile([&] { other.begin(); });  // while another is active: no error yet
        glCallList(begin);
        EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
        EXPECT_EQ(active_nv(), query.name());
        draw_samples(4);
    }),
              7u);
    EXPECT_FALSE(glIsOcclusionQueryNV(other.name()));
    glCallList(begin_zero);
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
    glCallList(end);
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
    glCallList(begin);
    EXPECT_TRUE(no_error()) << "the same list, with no query active";
    EXPECT_EQ(active_nv(), other.name());
    glCallList(end);
}

// NV-52. What a list holds after the command in error still runs.
TEST_F(NvListSpans, a_list_goes_on_after_a_command_in_error) {
    const NvQuery query;
    const GLuint list = compile([&] {
        glEndOcclusionQueryNV();  // in error
        query.begin();
        draw_samples(5);
        query.begin();  // in error
        draw_samples(2);
        glEndOcclusionQueryNV();
    });
    glCallList(list);
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
    EXPECT_TRUE(no_error());
    EXPECT_EQ(query.result(), 7u);
}

// NV-52, NV-23. GL 4.5 compatibility, 10.7.5: CallList is legal between Begin and End, the query's commands
// are not; the primitive is the worse for it in nothing.
TEST_F(NvListSpans, a_compiled_query_called_inside_a_primitive_is_in_error) {
    const NvQuery query;
    const GLuint list = compile([&] {
        query.begin();
        glVertex3f(0.5f, 0.5f, 0.0f);
        glEndOcclusionQueryNV();
    });
    glBegin(GL_POINTS);
    glCallList(list);
    glEnd();
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
    EXPECT_TRUE(no_error());
    EXPECT_EQ(active_nv(), 0u);
    EXPECT_FALSE(glIsOcclusionQueryNV(query.name()));
    EXPECT_EQ(drawn_pixels(), 1);
}

// NV-52, NV-23. The same of a primitive that stands in the list itself.
TEST_F(NvListSpans, a_query_compiled_inside_a_primitive_is_in_error_at_the_call) {
    const NvQuery query;
    const GLuint list = compile([&] {
        glBegin(GL_POINTS);
        query.begin();
        glVertex3f(0.5f, 0.5f, 0.0f);
        glEndOcclusionQueryNV();
        glEnd();
    });
    glCallList(list);
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
    EXPECT_TRUE(no_error());
    EXPECT_EQ(active_nv(), 0u);
    EXPECT_EQ(drawn_pixels(), 1);
}

// NV-51. Display lists belong to the share group, queries do not: a list begins the query of the context that
// calls it.
TEST_F(NvListSpans, a_list_begins_the_query_of_the_context_that_calls_it) {
    const GLuint list = compile([] {
        glBeginOcclusionQueryNV(kUnknownName);
        draw_samples(50);
        glEndOcclusionQueryNV();
    });
    glFinish();
    const Context other({}, &context());
    ASSERT_TRUE(other.make_current(surface()));
    use_pixel_coordinates();
    glCallList(list);
    EXPECT_TRUE(no_error());
    EXPECT_EQ(get_nv(kUnknownName, GL_PIXEL_COUNT_NV), 50u);
    come_back();
    EXPECT_FALSE(glIsOcclusionQueryNV(kUnknownName));
    glCallList(list);
    EXPECT_EQ(get_nv(kUnknownName, GL_PIXEL_COUNT_NV), 50u);
}

// NV-53. GL 4.5 compatibility, 21.4: COMPILE_AND_EXECUTE executes each command as it is compiled.
TEST_F(NvListSpans, compile_and_execute_does_both) {
    const NvQuery query;
    const GLuint list = compile(
        [&] {
            query.begin();
            EXPECT_EQ(active_nv(), query.name());
            draw_samples(50);
            EXPECT_EQ(get_nv(query.name(), GL_PIXEL_COUNT_NV), kUntouched);
            EXPECT_TRUE(error_is(GL_INVALID_OPERATION)) << "of the Get of the active query";
            glEndOcclusionQueryNV();
            EXPECT_EQ(query.result(), 50u);
            draw_samples(400);
        },
        GL_COMPILE_AND_EXECUTE);
    EXPECT_EQ(query.result(), 50u);
    EXPECT_EQ(query.count([] {}), 0u);
    glCallList(list);
    EXPECT_EQ(query.result(), 50u);
}

// NV-53. A Begin that is in error when it is executed is compiled all the same.
TEST_F(NvListSpans, compile_and_execute_compiles_what_it_refuses) {
    const NvQuery query;
    const NvQuery active;
    const GLuint list = glGenLists(1);
    EXPECT_EQ(active.count([&] {
        glNewList(list, GL_COMPILE_AND_EXECUTE);
        query.begin();
        EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
        draw_samples(5);
        glEndList();
    }),
              5u);
    glCallList(list);
    EXPECT_TRUE(no_error());
    EXPECT_EQ(active_nv(), query.name());
    glEndOcclusionQueryNV();
    EXPECT_EQ(query.result(), 5u);
}

}  // namespace
}  // namespace conformance
