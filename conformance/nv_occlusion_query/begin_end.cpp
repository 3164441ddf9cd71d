// SPDX-License-Identifier: MIT
// Begin and End: what they refuse, which query is active, and that a query goes on until its End (NV-18 to
// NV-27).
#include <functional>

#include "harness/objects.h"
#include "nv_occlusion_query/nv_test.h"

namespace conformance {
namespace {

class NvBeginEnd : public NvTest {};

// NV-18, NV-19. NV, Errors: "INVALID_OPERATION is generated if BeginOcclusionQueryNV is called when an
// occlusion query is already active."
TEST_F(NvBeginEnd, a_second_begin_is_refused_and_the_first_goes_on) {
    const NvQuery first;
    const NvQuery second;
    EXPECT_EQ(first.count([&] {
        draw_samples(3);
        for (const GLuint again : {first.name(), second.name(), kUnknownName, 0u}) {
            glBeginOcclusionQueryNV(again);
            EXPECT_TRUE(error_is(GL_INVALID_OPERATION)) << again;
            EXPECT_EQ(active_nv(), first.name());
        }
        draw_samples(4);
    }),
              7u);
    EXPECT_FALSE(glIsOcclusionQueryNV(second.name()));
    EXPECT_FALSE(glIsOcclusionQueryNV(kUnknownName));
}

// NV-20, NV-21. NV, Errors: "INVALID_OPERATION is generated if EndOcclusionQueryNV is called when an
// occlusion query is not active."
TEST_F(NvBeginEnd, an_end_without_begin_is_refused) {
    glEndOcclusionQueryNV();
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
    const NvQuery query;
    EXPECT_EQ(query.count([] { draw_samples(5); }), 5u);
    draw_samples(50);
    glEndOcclusionQueryNV();
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
    EXPECT_EQ(query.result(), 5u);
}

// NV-22. NV 6.1.13: "Which occlusion query is active can be queried using GetBooleanv, GetIntegerv,
// GetFloatv, or GetDoublev with a <pname> of CURRENT_OCCLUSION_QUERY_ID_NV [...] the name of the currently
// active occlusion query if one is active, and zero otherwise."
TEST_F(NvBeginEnd, the_current_query_is_the_active_one_or_zero) {
    const auto expect_current = [](GLuint name) {
        GLboolean boolean = 0xAA;
        GLfloat single = -1.0f;
        GLdouble twice = -1.0;
        glGetBooleanv(GL_CURRENT_OCCLUSION_QUERY_ID_NV, &boolean);
        glGetFloatv(GL_CURRENT_OCCLUSION_QUERY_ID_NV, &single);
        glGetDoublev(GL_CURRENT_OCCLUSION_QUERY_ID_NV, &twice);
        EXPECT_EQ(active_nv(), name);
        EXPECT_EQ(boolean, name ? GL_TRUE : GL_FALSE);
        EXPECT_EQ(single, static_cast<GLfloat>(name));
        EXPECT_EQ(twice, static_cast<GLdouble>(name));
        if (lacks(32, "GL_ARB_sync")) return;
        GLint64 integer = -1;
        glGetInteger64v(GL_CURRENT_OCCLUSION_QUERY_ID_NV, &integer);
        EXPECT_EQ(integer, static_cast<GLint64>(name));
    };
    expect_current(0);
    const NvQuery query;
    expect_current(0);
    for (const GLuint name : {query.name(), kUnknownName}) {
        glBeginOcclusionQueryNV(name);
        expect_current(name);
        glEndOcclusionQueryNV();
        expect_current(0);
    }
    EXPECT_TRUE(no_error());
}

// NV-23. NV, Errors: "INVALID_OPERATION is generated if any of the commands defined in this extension is
// executed between the execution of Begin and the corresponding execution of End."
TEST_F(NvBeginEnd, every_command_is_refused_between_begin_and_end) {
    const NvQuery query;
    EXPECT_EQ(query.count([] { draw_samples(5); }), 5u);
    const auto refused = [](const std::function<void()>& command) {
        glBegin(GL_POINTS);
        command();
        glEnd();
        EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
    };
    const GLuint name = query.name();
    GLuint written = kUntouched;
    auto* signed_written = reinterpret_cast<GLint*>(&written);
    GLboolean is_query = 0xAA;
    refused([&] { glGenOcclusionQueriesNV(1, &written); });
    refused([&] { glDeleteOcclusionQueriesNV(1, &name); });
    refused([&] { is_query = glIsOcclusionQueryNV(name); });
    refused([&] { query.begin(); });
    refused([&] { glGetOcclusionQueryivNV(name, GL_PIXEL_COUNT_NV, signed_written); });
    refused([&] { glGetOcclusionQueryuivNV(name, GL_PIXEL_COUNT_AVAILABLE_NV, &written); });
    refused([&] { glGetIntegerv(GL_CURRENT_OCCLUSION_QUERY_ID_NV, signed_written); });
    refused([&] { glGetIntegerv(GL_PIXEL_COUNTER_BITS_NV, signed_written); });
    EXPECT_EQ(written, kUntouched);
    EXPECT_EQ(is_query, GL_FALSE);
    EXPECT_EQ(active_nv(), 0u);
    EXPECT_EQ(query.result(), 5u);
    EXPECT_EQ(query.count([&] {
        refused([] { glEndOcclusionQueryNV(); });
        draw_samples(6);
    }),
              6u);
}

// NV-24. GL 4.5, 2.3.1: a command that generates an error has no other effect: neither the counter nor the
// result of the occlusion test is reset.
TEST_F(NvBeginEnd, a_refused_begin_resets_neither_the_counter_nor_the_test) {
    const auto test_result = [] { return get_integer(GL_OCCLUSION_TEST_RESULT_HP); };
    const NvQuery query;
    query.begin();
    draw_samples(3);
    query.begin();
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
    glEndOcclusionQueryNV();
    EXPECT_EQ(query.result(), 3u);
    EXPECT_EQ(test_result(), 1);

    glEnable(GL_OCCLUSION_TEST_HP);
    draw_samples(3);
    glDisable(GL_OCCLUSION_TEST_HP);
    glBeginOcclusionQueryNV(0);
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
    EXPECT_EQ(test_result(), 1);
}

// NV-25. NV 4.1.6A: a query is active from Begin to End; nothing else ends it.
TEST_F(NvBeginEnd, a_query_goes_on_over_flush_finish_and_swap) {
    const NvQuery query;
    EXPECT_EQ(query.count([&] {
        draw_samples(1);
        glFlush();
        draw_samples(2);
        glFinish();
        draw_samples(4);
        surface().swap();
        draw_samples(8);
        EXPECT_EQ(active_nv(), query.name());
    }),
              15u);
}

// NV-25, of a framebuffer and a program that come and go.
TEST_F(NvBeginEnd, a_query_goes_on_over_changes_of_framebuffer_and_program) {
    if (const auto why = lacks(30, "GL_ARB_framebuffer_object")) GTEST_SKIP() << *why;
    if (const auto why = lacks(20, "GL_ARB_shading_language_100")) GTEST_SKIP() << *why;
    const NvQuery query;
    EXPECT_EQ(query.count([] {
        draw_samples(1);
        {
            const Framebuffer framebuffer({});
            draw_samples(2);
        }
        draw_samples(4);
        {
            const Program program({.vertex = kFixedVertexSource,
                                   .fragment = "#version 120\nvoid main() { gl_FragColor = vec4(1.0); }\n"});
            draw_samples(8);
        }
        draw_samples(16);
    }),
              31u);
}

// NV-26. A context may die at any time; what was active dies with it.
TEST_F(NvBeginEnd, a_context_may_die_with_its_query_active) {
    for (int i = 0; i < 4; ++i) {
        const Context short_lived;
        ASSERT_TRUE(short_lived.make_current(surface()));
        EXPECT_EQ(active_nv(), 0u);
        use_pixel_coordinates();
        glBeginOcclusionQueryNV(1);
        draw_samples(64);
        EXPECT_TRUE(no_error());
        glFinish();  // Mesa 22.3 frees an active query while its rasteriser still counts into it
        Context::release_current();
    }
    come_back();
    const NvQuery query;
    EXPECT_EQ(query.count([] { draw_samples(5); }), 5u);
}

// NV-27. GL, 2.1: the active query is state of the context.
TEST_F(NvBeginEnd, another_context_neither_ends_the_query_nor_counts_into_it) {
    const NvQuery query;
    const Context other;
    EXPECT_EQ(query.count([&] {
        draw_samples(3);
        ASSERT_TRUE(other.make_current(surface()));
        use_pixel_coordinates();
        draw_rect(kWhole, kMiddle);
        EXPECT_EQ(active_nv(), 0u);
        glEndOcclusionQueryNV();
        EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
        come_back();
        EXPECT_EQ(active_nv(), query.name());
        draw_samples(4);
    }),
              7u);
}

}  // namespace
}  // namespace conformance
