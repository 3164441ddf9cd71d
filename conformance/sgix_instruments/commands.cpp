// SPDX-License-Identifier: MIT
// SGIX_instruments: the buffer, starting and stopping, errors (SGI-01 to SGI-07, SGI-17).
#include "sgix_instruments/instruments_test.h"

namespace conformance {
namespace {

class InstrumentCommands : public InstrumentTest {
  protected:
    static void* buffer_pointer() {
        void* pointer = &pointer;
        glGetPointerv(GL_INSTRUMENT_BUFFER_POINTER_SGIX, &pointer);
        return pointer;
    }
    static GLint measurements() { return get_integer(GL_INSTRUMENT_MEASUREMENTS_SGIX); }
};

// SGI-17. "Accepted by the <cap> parameter of Enable, Disable and IsEnabled".
TEST_F(InstrumentCommands, each_instrument_is_disabled_at_first_and_enabled_alone) {
    for (const GLenum instrument : {kDepthPass, kOcclusion}) {
        const GLenum other = kDepthPass + kOcclusion - instrument;
        EXPECT_FALSE(glIsEnabled(instrument));
        glEnable(instrument);
        EXPECT_TRUE(glIsEnabled(instrument));
        EXPECT_FALSE(glIsEnabled(other));
        glEnable(instrument);
        glDisable(instrument);
        EXPECT_FALSE(glIsEnabled(instrument)) << "one Disable undoes two Enables";
    }
}

// SGI-17, decided: the text's table names no attribute group, so none saves the enables.
TEST_F(InstrumentCommands, no_attribute_group_saves_the_enables) {
    glPushAttrib(GL_ALL_ATTRIB_BITS);
    glEnable(kDepthPass);
    glEnable(kOcclusion);
    glPopAttrib();
    EXPECT_TRUE(glIsEnabled(kDepthPass));
    EXPECT_TRUE(glIsEnabled(kOcclusion));
}

// SGI-01. "If <size> is negative an INVALID_VALUE is generated."
TEST_F(InstrumentCommands, a_negative_size_is_refused_and_changes_nothing) {
    define();
    glEnable(kDepthPass);
    glStartInstrumentsSGIX();
    std::array<GLint, 4> other{};
    glInstrumentsBufferSGIX(-1, other.data());
    EXPECT_TRUE(error_is(GL_INVALID_VALUE));
    EXPECT_EQ(buffer_pointer(), buffer.data());
    glStopInstrumentsSGIX(3);
    EXPECT_EQ(next_marker(), 3);
}

// SGI-01, SGI-03. "An INVALID_OPERATION is generated if any of the instruments functions or procedures are
// called within Begin/End."
TEST_F(InstrumentCommands, every_command_is_refused_between_begin_and_end) {
    define();
    glEnable(kDepthPass);
    glStartInstrumentsSGIX();
    const auto inside = [](auto command) {
        glBegin(GL_POINTS);
        command();
        glEnd();
        return error_is(GL_INVALID_OPERATION);
    };
    std::array<GLint, 4> other{};
    GLint marker = kUnwritten;
    EXPECT_TRUE(inside([&] { glInstrumentsBufferSGIX(4, other.data()); }));
    EXPECT_TRUE(inside([] { glReadInstrumentsSGIX(1); }));
    EXPECT_TRUE(inside([] { glStopInstrumentsSGIX(2); }));
    EXPECT_TRUE(inside([&] { glPollInstrumentsSGIX(&marker); }));
    EXPECT_TRUE(inside([] { glGetInstrumentsSGIX(); }));
    EXPECT_EQ(buffer_pointer(), buffer.data());
    EXPECT_EQ(measurements(), 0);
    EXPECT_EQ(marker, kUnwritten);

    glStopInstrumentsSGIX(3);
    EXPECT_TRUE(inside([] { glStartInstrumentsSGIX(); }));
    glStopInstrumentsSGIX(4);
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION)) << "the Start inside was no error";
    EXPECT_EQ(next_marker(), 3);
}

// SGI-02. "Executing any of StartInstrumentsSGIX, StopInstrumentsSGIX, ReadInstruments without a successful
// call to InstrumentsBufferSGIX to define a buffer will generate an INVALID_OPERATION."
TEST_F(InstrumentCommands, without_a_buffer_nothing_can_be_started_read_or_stopped) {
    glEnable(kDepthPass);
    const auto refuses_all = [] {
        glStartInstrumentsSGIX();
        EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
        glReadInstrumentsSGIX(1);
        EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
        glStopInstrumentsSGIX(2);
        EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
    };
    refuses_all();
    glInstrumentsBufferSGIX(-4, buffer.data());
    EXPECT_TRUE(error_is(GL_INVALID_VALUE));
    refuses_all();
}

// SGI-02. "An INVALID_OPERATION is generated if StartInstrumentsSGIX is executed twice without an intervening
// execution of StopInstrumentsSGIX or InstrumentsBufferSGIX."
TEST_F(InstrumentCommands, a_second_start_is_refused_until_a_stop_or_another_buffer) {
    define();
    glEnable(kDepthPass);
    glStartInstrumentsSGIX();
    glStartInstrumentsSGIX();
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
    glStopInstrumentsSGIX(1);
    glStartInstrumentsSGIX();
    EXPECT_TRUE(no_error());
    define();
    glStartInstrumentsSGIX();
    EXPECT_TRUE(no_error());
    glStopInstrumentsSGIX(2);
}

// SGI-02. "Symetrically, an INVALID_OPERATION is generated if StopInstrumentsSGIX is executed twice without
// an intervening execution of StartInstrumentsSGIX." Decided: a Read is refused wherever a Stop is, since
// nothing is started that it could measure.
TEST_F(InstrumentCommands, what_is_not_started_can_be_neither_stopped_nor_read) {
    define();
    glEnable(kDepthPass);
    const auto refuses_both = [] {
        glStopInstrumentsSGIX(8);
        EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
        glReadInstrumentsSGIX(9);
        EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
    };
    refuses_both();
    glStartInstrumentsSGIX();
    glStopInstrumentsSGIX(1);
    EXPECT_TRUE(no_error());
    refuses_both();
    glStartInstrumentsSGIX();
    define();
    refuses_both();
    EXPECT_EQ(measurements(), 0)
        << "of those in error none was taken, and the buffer was reset after the other";
}

// SGI-04. "If <buf> is zero, then any resources allocated to prepare the buffer for writing from the graphics
// pipeline from a previous call will be freed."
TEST_F(InstrumentCommands, a_null_buffer_takes_the_old_one_away) {
    define();
    glEnable(kDepthPass);
    glStartInstrumentsSGIX();
    glInstrumentsBufferSGIX(0, nullptr);
    EXPECT_EQ(buffer_pointer(), nullptr);
    glStartInstrumentsSGIX();
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
    glFinish();
    EXPECT_TRUE(is_unwritten(0));
}

// SGI-04. "If <buf> has been previously defined with a prior call, the buffer is reset, that is, measurements
// taken after the call to InstrumentsBufferSGIX will be written to the start of the buffer."
TEST_F(InstrumentCommands, the_same_buffer_again_is_written_from_its_start) {
    glEnable(kDepthPass);
    for (const GLint marker : {5, 6}) {
        define();
        glStartInstrumentsSGIX();
        draw_rect({0, 0, marker, 1}, 0.0f);
        glStopInstrumentsSGIX(marker);
        EXPECT_EQ(next_marker(), marker);
        EXPECT_EQ(response(0), (Response{kDepthPass, 4, static_cast<GLuint>(marker), marker}));
        EXPECT_TRUE(is_unwritten(4));
    }
}

// SGI-04. "If <buf> is non-zero, but is different from a previous call, the old buffer is considered to be
// replaced by the new buffer". Decided: what has not been written to the old one by then is lost.
TEST_F(InstrumentCommands, another_buffer_takes_the_old_ones_place) {
    std::array<GLint, 8> other{};
    glInstrumentsBufferSGIX(8, other.data());
    glEnable(kDepthPass);
    glStartInstrumentsSGIX();
    glStopInstrumentsSGIX(5);
    define();
    glStartInstrumentsSGIX();
    glStopInstrumentsSGIX(6);
    EXPECT_EQ(next_marker(), 6);
    EXPECT_EQ(response(0), (Response{kDepthPass, 4, 0, 6}));
    glFinish();
    EXPECT_EQ(other[4], 0) << "written after it was replaced";
}

// SGI-05. "The buffer address can be queried with glGetPointervEXT using <pname>
// GL_INSTRUMENT_BUFFER_POINTER."
TEST_F(InstrumentCommands, the_buffers_address_can_be_asked_for) {
    EXPECT_EQ(buffer_pointer(), nullptr);
    define();
    EXPECT_EQ(buffer_pointer(), buffer.data());
    EXPECT_TRUE(no_error());
}

// SGI-06. "The number of measurements taken since the buffer was reset can be queried"; the text's example
// asks right after the Stop: "r should be 2".
TEST_F(InstrumentCommands, measurements_are_counted_from_the_buffers_reset) {
    EXPECT_EQ(measurements(), 0);
    define();
    glEnable(kOcclusion);
    for (int round = 1; round <= 2; ++round) {
        glStartInstrumentsSGIX();
        glReadInstrumentsSGIX(14);
        glStopInstrumentsSGIX(15);
        EXPECT_EQ(measurements(), 2 * round);
    }
    GLfloat value = -1.0f;
    glGetFloatv(GL_INSTRUMENT_MEASUREMENTS_SGIX, &value);
    EXPECT_EQ(value, 4.0f);
    define();
    EXPECT_EQ(measurements(), 0);
}

// SGI-07. "If no instruments are enabled, executions of StartInstrumentsSGIX, StopInstrumentsSGIX,
// ReadInstruments will not write measurements to the buffer." Decided: nor are any taken.
TEST_F(InstrumentCommands, without_an_instrument_nothing_is_measured) {
    define();
    glStartInstrumentsSGIX();
    draw_rect(kWhole, 0.0f);
    glReadInstrumentsSGIX(1);
    glStopInstrumentsSGIX(2);
    glFinish();
    GLint marker = kUnwritten;
    EXPECT_EQ(glPollInstrumentsSGIX(&marker), 0);
    EXPECT_EQ(glGetInstrumentsSGIX(), 0);
    EXPECT_EQ(measurements(), 0);
    EXPECT_EQ(marker, kUnwritten);
    EXPECT_TRUE(is_unwritten(0));
}

}  // namespace
}  // namespace conformance
