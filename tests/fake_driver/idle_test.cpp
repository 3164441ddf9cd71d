// SPDX-License-Identifier: MIT
// Nothing that a program does not use is emulated or paid for: while no query of the layer's own is active, a
// command that draws makes one call of the driver's, itself, and a swap makes none.
#include <EGL/egl.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "fake_driver.h"

namespace {

using fake_driver::clear_log;
using fake_driver::find;
using Strings = std::vector<std::string>;

class idle : public testing::Test {
  protected:
    // Made anew for each test: state, queries and hot words of an earlier one are of another context.
    void SetUp() override {
        ASSERT_NE(fake_driver::make_context(), nullptr);
        clear_log();
    }

    // Every command of <hooks_class>, with nothing but zeros for arguments: no array to read, no list to
    // call.
    void each_makes_one_call(std::string_view hooks_class) {
        using AnyCommand =
            void (*)(std::intptr_t, std::intptr_t, std::intptr_t, std::intptr_t, std::intptr_t, std::intptr_t,
                     std::intptr_t, std::intptr_t, std::intptr_t, std::intptr_t);
        int found = 0;
        for (const fake_driver::Command& command : fake_driver::commands()) {
            if (command.hooked_as != hooks_class || !command.has_driver) continue;
            const auto call = find<AnyCommand>(command.name);
            ASSERT_NE(call, nullptr) << command.name;
            clear_log();
            call(0, 0, 0, 0, 0, 0, 0, 0, 0, 0);
            EXPECT_EQ(fake_driver::log(), Strings{command.name});
            ++found;
        }
        EXPECT_GT(found, 0) << "hooks.list has no class " << hooks_class;
    }
};

// FAKE_DRIVER_EXPECT=bare: the program runs without the layer, to show that what is counted is the layer's.
TEST_F(idle, the_layer_stands_before_the_driver_for_what_it_hooks_and_nothing_else) {
    const char* const expect = std::getenv("FAKE_DRIVER_EXPECT");
    const bool has_layer = expect == nullptr || std::string_view(expect) != "bare";
    EXPECT_EQ(find<void*>("glDrawArrays") != fake_driver::own_function("glDrawArrays"), has_layer);
    EXPECT_EQ(find<void*>("glUniform1i"), fake_driver::own_function("glUniform1i"));
}

TEST_F(idle, every_command_that_draws_makes_one_call) {
    each_makes_one_call("draw");
    each_makes_one_call("pixels");
}

TEST_F(idle, immediate_mode_makes_the_programs_calls) {
    find<void (*)(GLenum)>("glBegin")(GL_TRIANGLES);
    find<void (*)(GLfloat, GLfloat)>("glVertex2f")(0, 0);
    find<void (*)()>("glEnd")();
    EXPECT_EQ(fake_driver::log(), (Strings{"glBegin", "glVertex2f", "glEnd"}));
}

TEST_F(idle, a_swap_makes_no_gl_call) {
    find<void (*)(GLenum, GLint, GLsizei)>("glDrawArrays")(GL_TRIANGLES, 0, 3);
    clear_log();
    find<decltype(&eglSwapBuffers)>("eglSwapBuffers")(nullptr, nullptr);
    EXPECT_EQ(fake_driver::log(), Strings{});
}

TEST_F(idle, draws_after_an_occlusion_query_make_one_call_again) {
    GLuint query = 0;
    find<void (*)(GLsizei, GLuint*)>("glGenQueries")(1, &query);
    find<void (*)(GLenum, GLuint)>("glBeginQuery")(GL_SAMPLES_PASSED, query);
    find<void (*)(GLenum, GLint, GLsizei)>("glDrawArrays")(GL_TRIANGLES, 0, 3);
    find<void (*)(GLenum)>("glEndQuery")(GL_SAMPLES_PASSED);
    GLuint samples = 0;
    find<void (*)(GLuint, GLenum, GLuint*)>("glGetQueryObjectuiv")(query, GL_QUERY_RESULT, &samples);
    EXPECT_EQ(samples, 7u);
    each_makes_one_call("draw");
}

// A machine that follows the text counts samples where the driver counts pixels (CNT-34), so in a program's
// query it asks one thing before a draw; a machine that passes through asks nothing.
TEST_F(idle, in_a_query_of_the_programs_a_draw_asks_for_nothing_but_multisample) {
    GLuint query = 0;
    find<void (*)(GLsizei, GLuint*)>("glGenQueries")(1, &query);
    find<void (*)(GLenum, GLuint)>("glBeginQuery")(GL_SAMPLES_PASSED, query);
    clear_log();
    find<void (*)(GLenum, GLint, GLsizei)>("glDrawArrays")(GL_TRIANGLES, 0, 3);
    const Strings drawn = fake_driver::log();
    find<void (*)(GLenum)>("glEndQuery")(GL_SAMPLES_PASSED);
    const char* const expect = std::getenv("FAKE_DRIVER_EXPECT");
    const bool asks_multisample = expect != nullptr && std::string_view(expect) == "asks_multisample";
    EXPECT_EQ(drawn, asks_multisample ? (Strings{"glIsEnabled", "glDrawArrays"}) : (Strings{"glDrawArrays"}));
}

TEST_F(idle, making_a_context_current_again_makes_no_call) {
    const auto make_current = find<decltype(&eglMakeCurrent)>("eglMakeCurrent");
    void* const context = fake_driver::make_context();
    clear_log();
    make_current(nullptr, nullptr, nullptr, context);
    EXPECT_EQ(fake_driver::log(), Strings{});
}

}  // namespace
