// SPDX-License-Identifier: MIT
// Core profiles and OpenGL ES, and contexts that are left or go in the midst of what they do (DEVT-22,
// DEVT-23).
#include <thread>

#include "emu_device_time/device_time_test.h"
#include "harness/es_test.h"
#include "harness/objects.h"

namespace conformance {
namespace {

class CoreDeviceTime : public DeviceTimeTest {
    ContextWish wish() const override { return {.api = Api::kCore, .major = 3, .minor = 3}; }
    void prepare() override {}
};

// DEVT-22. "OpenGL 1.1 is required": any later one will do.
TEST_F(CoreDeviceTime, a_core_profile_has_clocks) {
    const Program program({.vertex = R"(#version 330
        void main() {
            vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0;
            gl_Position = vec4(corner, 0.0, 1.0);
        })",
                           .fragment = R"(#version 330
        out vec4 colour;
        void main() { colour = vec4(1.0); })"});
    GLuint vertices = 0;
    glGenVertexArrays(1, &vertices);
    glBindVertexArray(vertices);
    const auto draw = [] { glDrawArrays(GL_TRIANGLES, 0, 3); };
    const GLint64 start = cpu_time();
    device_work(11);
    EXPECT_EQ(cpu_time(), start + 11);
    const Query timer(GL_TIME_ELAPSED);
    const Query samples;
    timer.begin();
    draw();
    timer.end();
    EXPECT_GT(time_of(timer), 0);
    EXPECT_EQ(samples.count(draw), static_cast<GLuint>(kWhole.area()));
    samples.begin();
    draw();
    samples.end();
    for (int polls = 0; !is_there(samples); ++polls) ASSERT_LT(polls, 1'000'000);
    glDeleteVertexArrays(1, &vertices);
}

class EsDeviceTime : public EsTest {};

// DEVT-22. EXT_occlusion_query_boolean, and a program that polls.
TEST_P(EsDeviceTime, polling_ends_in_es) {
    if (const auto why = lacks(30, "GL_EXT_occlusion_query_boolean")) GTEST_SKIP() << *why;
    const auto command = [](const char* name) { return platform().get_proc_address(name); };
    const auto generate = reinterpret_cast<PFNGLGENQUERIESPROC>(command("glGenQueriesEXT"));
    const auto begin = reinterpret_cast<PFNGLBEGINQUERYPROC>(command("glBeginQueryEXT"));
    const auto end = reinterpret_cast<PFNGLENDQUERYPROC>(command("glEndQueryEXT"));
    const auto get = reinterpret_cast<PFNGLGETQUERYOBJECTUIVPROC>(command("glGetQueryObjectuivEXT"));
    const auto remove = reinterpret_cast<PFNGLDELETEQUERIESPROC>(command("glDeleteQueriesEXT"));
    GLuint name = 0;
    generate(1, &name);
    for (int round = 0; round < 3; ++round) {
        draw_rect(kWhole, kNear);
        begin(GL_ANY_SAMPLES_PASSED, name);
        draw_rect(kWhole, kNear);
        end(GL_ANY_SAMPLES_PASSED);
        GLuint value = GL_FALSE;
        for (int polls = 0; value == GL_FALSE; ++polls) {
            ASSERT_LT(polls, 1'000'000);
            get(name, GL_QUERY_RESULT_AVAILABLE, &value);
        }
        get(name, GL_QUERY_RESULT, &value);
        EXPECT_EQ(value, GLuint{GL_TRUE});
    }
    remove(1, &name);
}

INSTANTIATE_TEST_SUITE_P(In, EsDeviceTime, ::testing::Values(2, 3), ::testing::PrintToStringParamName());

class LeftContexts : public DeviceTimeTest {};

// DEVT-23. GL 4.5, 5.1: a context that is not current keeps its state, and another thread may take it.
TEST_F(LeftContexts, time_goes_on_in_another_thread) {
    if (const auto why = lacks(15)) GTEST_SKIP() << *why;
    const Query query;
    query.begin();
    draw_layers(3);
    Context::release_current();
    std::thread([this, &query] {
        come_back();
        draw_layers(2);
        query.end();
        EXPECT_GT(cpu_time(), 0);
        draw_layers(1);
        Context::release_current();
    }).join();
    come_back();
    for (int polls = 0; !is_there(query); ++polls) ASSERT_LT(polls, 1'000'000);
    EXPECT_EQ(query.result(), static_cast<GLuint>(5 * kWhole.area()));
}

// DEVT-23. One that goes with work under way takes nothing else with it.
TEST_F(LeftContexts, one_may_go_in_the_midst_of_anything) {
    const bool has_queries = !lacks(15);
    const GLint64 before = cpu_time();
    for (int round = 0; round < 4; ++round) {
        const Surface surface;
        const Context other({}, round % 2 == 0 ? &context() : nullptr);
        ASSERT_TRUE(other.make_current(surface));
        prepare();
        draw_layers(3);
        GLuint name = 0;
        if (has_queries && round >= 1) {
            glGenQueries(1, &name);
            glBeginQuery(GL_SAMPLES_PASSED, name);
            draw_layers(1);
        }
        if (has_queries && round >= 2) glEndQuery(GL_SAMPLES_PASSED);
        if (round == 3) {
            glNewList(glGenLists(1), GL_COMPILE);
            draw_layers(1);
        }
        glFlush();
        Context::release_current();
        come_back();
    }
    EXPECT_EQ(cpu_time(), before);
    draw_layers(1);
    EXPECT_GT(cpu_time(), before);
}

}  // namespace
}  // namespace conformance
