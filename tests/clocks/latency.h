// SPDX-License-Identifier: MIT
// The clock that a test runs under, as the test sees it from outside: when something cannot be seen yet, how
// to let the latency pass, and what must not have taken less time.
//
// The variable CLOCK repeats what the layer was told. Under wall time a test that was too slow to see
// something pending proves nothing, so it tries again.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>

#include "harness/gl_test.h"
#include "harness/query.h"

namespace clock_tests {

using Moment = std::chrono::steady_clock::time_point;

inline Moment now() {
    return std::chrono::steady_clock::now();
}

struct Latency {
    enum Kind { kNone, kWall, kCalls, kFrames, kDevice };
    Kind kind = kNone;
    std::uint64_t amount = 0;  // microseconds, calls or frames

    // Long enough to do a few things in it and see that a result is not there yet.
    bool can_be_seen() const {
        switch (kind) {
            case kNone:
                return false;
            case kWall:
                return amount >= 3000;
            case kCalls:
                return amount >= 20;
            case kFrames:
                return amount >= 1;
            case kDevice:
                return true;
        }
        return false;
    }
};

// Of $CLOCK: "none", "wall=US", "calls=N", "frames=N" or "device". Anything else ends the program.
const Latency& latency();

// As EXPECT: <after> may not come before <before> plus the latency of wall time.
::testing::AssertionResult is_not_early(Moment before, Moment after);

class ClockTest : public conformance::GlTest {
  protected:
    // Lets the latency pass for everything that has ended, by doing nothing but what moves the clock.
    void let_pass() const;

    // Runs <look> until it was quick enough to have seen something pending. It returns the moment before the
    // query's end, and notes in <is_as_expected> what it saw.
    void while_pending(const std::function<Moment(bool& is_as_expected)>& look) const;
};

// Reads a pixel: then the driver has every result, and only the clock stands between it and the program.
void let_driver_finish();

// The pixels of a query that passes, and of one that draws nothing.
void draw_visible();
inline void draw_hidden() {
}

}  // namespace clock_tests
