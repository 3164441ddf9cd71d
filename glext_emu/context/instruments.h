// SPDX-License-Identifier: MIT
// What the layer remembers of GL_SGIX_instruments: the program's buffer, what is enabled and started, and how
// far measurements have come. docs/decisions/0010 says what the texts leave open.
#pragma once

#include <deque>

#include "context/count_pipe.h"

namespace glext_emu {

struct Instruments {
    GLint* buffer = nullptr;  // the program's; null: none
    GLsizei size = 0;         // of it, in ints
    Counters enabled = 0;
    bool has_started = false;
    CountPipe pipe;

    // Since InstrumentsBuffer, in ints:
    GLsizei requested = 0;  // what all measurements that fit will take
    GLsizei written = 0;
    GLsizei told = 0;  // by GetInstruments

    // Since InstrumentsBuffer, in measurements:
    GLint measurements = 0;
    std::deque<GLint> markers;  // of those written and not polled yet
    GLint lost = 0;             // did not fit, and were not polled yet
    bool has_overflowed = false;
    bool overflow_is_news = false;  // to GetInstruments
};

}  // namespace glext_emu
