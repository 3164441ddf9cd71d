// SPDX-License-Identifier: MIT
// What the tests of GL_SGIX_instruments share: the fixture, which skips where the extension is absent, a
// buffer with a guarded end, and the ways to get at a measurement.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "harness/gl_test.h"

namespace conformance {

// glext.h has them not: gl.xml, SGIX_depth_pass_instrument; the text of SGIX_occlusion_instrument.
inline constexpr GLenum kDepthPass = 0x8310;
inline constexpr GLenum kDepthPassCounters = 0x8311;
inline constexpr GLenum kDepthPassMax = 0x8312;
inline constexpr GLenum kOcclusion = 0x6060;

// A word that no measurement holds.
inline constexpr GLint kUnwritten = -77;

// "The format of the measured occlusion instrument consists of four words"; that of the depth pass instrument
// too.
struct Response {
    GLenum instrument;
    GLint size;
    GLuint value;
    GLint marker;
    bool operator==(const Response&) const = default;
};

class InstrumentTest : public GlTest {
  protected:
    static constexpr GLsizei kSize = 64;  // ints

    void SetUp() override {
        ASSERT_NO_FATAL_FAILURE(GlTest::SetUp());
        for (const char* name :
             {"GL_SGIX_instruments", "GL_SGIX_depth_pass_instrument", "GL_SGIX_occlusion_instrument"}) {
            if (const auto why = lacks(name)) GTEST_SKIP() << *why;
        }
        buffer.fill(kUnwritten);
    }

    // The program's memory: kSize ints, and as many that no one may write.
    std::array<GLint, 2 * std::size_t{kSize}> buffer{};

    void define(GLsizei size = kSize) { glInstrumentsBufferSGIX(size, buffer.data()); }

    Response response(int index) const {
        const GLint* const words = buffer.data() + 4 * index;
        return {static_cast<GLenum>(words[0]), words[1], static_cast<GLuint>(words[2]), words[3]};
    }
    bool is_unwritten(int from) const {
        return std::all_of(buffer.begin() + from, buffer.end(),
                           [](GLint word) { return word == kUnwritten; });
    }

    // The marker of the next measurement, -1 for an overflow. Polls as the text's example does, but not for
    // ever.
    static GLint next_marker() {
        GLint marker = kUnwritten;
        for (int polls = 0; polls < 10'000'000; ++polls) {
            const GLint answer = glPollInstrumentsSGIX(&marker);
            if (answer == 1) return marker;
            if (answer == -1) return -1;
            EXPECT_EQ(answer, 0);
        }
        ADD_FAILURE() << "no measurement has come";
        return kUnwritten;
    }

    // What <instrument> alone says of what <draw> draws. Defines the buffer anew.
    template <typename Draw>
    GLuint value_of(GLenum instrument, Draw draw) {
        define();
        glEnable(instrument);
        glStartInstrumentsSGIX();
        draw();
        glStopInstrumentsSGIX(1);
        glDisable(instrument);
        EXPECT_EQ(next_marker(), 1);
        EXPECT_EQ(response(0).instrument, instrument);
        return response(0).value;
    }
};

}  // namespace conformance
