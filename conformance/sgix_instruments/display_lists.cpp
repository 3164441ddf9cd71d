// SPDX-License-Identifier: MIT
// SGIX_instruments and display lists (SGI-11): "The following commands are not included in display lists:
// InstrumentsBufferSGIX, PollInstrumentsSGIX, GetInstrumentsSGIX". So the others are, as are Enable and
// Disable.
#include "sgix_instruments/instruments_test.h"

namespace conformance {
namespace {

class InstrumentLists : public InstrumentTest {
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

// SGI-11.
TEST_F(InstrumentLists, start_read_and_stop_are_compiled) {
    define();
    const GLuint list = compile([] {
        glEnable(kDepthPass);
        glStartInstrumentsSGIX();
        draw_rect({0, 0, 3, 1}, 0.5f);
        glReadInstrumentsSGIX(1);
        draw_rect({0, 0, 4, 1}, 0.5f);
        glStopInstrumentsSGIX(2);
        glDisable(kDepthPass);
    });
    EXPECT_FALSE(glIsEnabled(kDepthPass));
    EXPECT_EQ(get_integer(GL_INSTRUMENT_MEASUREMENTS_SGIX), 0);
    for (int call = 0; call < 2; ++call) {
        glCallList(list);
        EXPECT_EQ(next_marker(), 1);
        EXPECT_EQ(next_marker(), 2);
        EXPECT_EQ(response(2 * call), (Response{kDepthPass, 4, 3, 1}));
        EXPECT_EQ(response(2 * call + 1), (Response{kDepthPass, 4, 7, 2}));
    }
    EXPECT_TRUE(no_error());
}

// SGI-11.
TEST_F(InstrumentLists, a_list_that_is_compiled_and_executed_measures_at_once) {
    define();
    glEnable(kDepthPass);
    const GLuint list = compile(
        [] {
            draw_rect({0, 0, 9, 1}, 0.5f);  // before the Start
            glStartInstrumentsSGIX();
            draw_rect({0, 0, 3, 1}, 0.5f);
            glReadInstrumentsSGIX(1);
            draw_rect({0, 0, 4, 1}, 0.5f);
            glStopInstrumentsSGIX(2);
            draw_rect({0, 0, 9, 1}, 0.5f);
        },
        GL_COMPILE_AND_EXECUTE);
    for (int round = 0; round < 2; ++round) {
        EXPECT_EQ(next_marker(), 1);
        EXPECT_EQ(next_marker(), 2);
        EXPECT_EQ(response(2 * round).value, 3u);
        EXPECT_EQ(response(2 * round + 1).value, 7u);
        if (round == 0) glCallList(list);
    }
}

// SGI-11.
TEST_F(InstrumentLists, buffer_poll_and_get_are_executed_while_a_list_is_compiled) {
    define();
    glEnable(kDepthPass);
    glStartInstrumentsSGIX();
    draw_rect({0, 0, 3, 1}, 0.5f);
    glStopInstrumentsSGIX(1);
    const GLuint list = compile([&] {
        EXPECT_EQ(next_marker(), 1);
        EXPECT_EQ(glGetInstrumentsSGIX(), 4);
        define();
        EXPECT_EQ(get_integer(GL_INSTRUMENT_MEASUREMENTS_SGIX), 0);
    });
    glStartInstrumentsSGIX();
    glStopInstrumentsSGIX(2);
    glCallList(list);
    EXPECT_EQ(get_integer(GL_INSTRUMENT_MEASUREMENTS_SGIX), 1) << "the buffer's definition was compiled";
    EXPECT_EQ(next_marker(), 2) << "the poll was compiled";
}

// SGI-11: a buffer that is replaced while a list is compiled and executed stops what is started.
TEST_F(InstrumentLists, another_buffer_stops_a_list_that_counts) {
    define();
    glEnable(kDepthPass);
    compile(
        [&] {
            glStartInstrumentsSGIX();
            draw_rect({0, 0, 3, 1}, 0.5f);
            define();
            draw_rect({0, 0, 4, 1}, 0.5f);
            glStartInstrumentsSGIX();
            draw_rect({0, 0, 5, 1}, 0.5f);
            glStopInstrumentsSGIX(1);
        },
        GL_COMPILE_AND_EXECUTE);
    EXPECT_EQ(next_marker(), 1);
    EXPECT_EQ(response(0).value, 5u);
}

// SGI-11: a drawing in a list counts like a direct one, once it is executed.
TEST_F(InstrumentLists, draws_in_lists_are_counted_when_they_are_executed) {
    const GLuint box = compile([] { draw_rect({0, 0, 6, 2}, 0.5f); });
    EXPECT_EQ(value_of(kDepthPass, [&] { glCallList(box); }), 12u);
    EXPECT_EQ(value_of(kDepthPass, [] { compile([] { draw_rect(kWhole, 0.5f); }); }), 0u);
    EXPECT_EQ(value_of(kDepthPass,
                       [] {
                           compile([] { draw_rect({0, 0, 5, 1}, 0.5f); }, GL_COMPILE_AND_EXECUTE);
                       }),
              5u);
}

// SGI-11, of the errors, which come when the list is called.
TEST_F(InstrumentLists, an_error_comes_when_the_list_is_called) {
    const GLuint list = compile([] { glStopInstrumentsSGIX(1); });
    glCallList(list);
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
}

}  // namespace
}  // namespace conformance
