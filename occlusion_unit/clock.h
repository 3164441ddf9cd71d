// SPDX-License-Identifier: MIT
// When a result that the hardware has computed may be seen by the program: the latency of the emulated
// machine.
//
//   none       as soon as the driver has it
//   wall=US    US microseconds after the query's end; a blocking read really stalls
//   calls=N    N hooked calls after it; deterministic, a blocking read returns at once and moves the clock on
//   frames=N   N buffer swaps after it; likewise, and 1,000 polls without a swap count as one
//   device     when the timeline of the device says so; deterministic
//
// Due times never fall, so results become available in the order in which their queries ended.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "occlusion_unit/result_times.h"

namespace occlusion_unit {

enum class ClockKind { kNone, kWall, kCalls, kFrames, kDevice };

struct Latency {
    ClockKind kind = ClockKind::kNone;
    std::uint64_t amount = 0;  // microseconds, calls or frames

    // "none", "wall=50", "calls=10", "frames=2", "device"; nothing if the text is none of these.
    static std::optional<Latency> parse(std::string_view text);
    std::string text() const;
};

// A Tick is a point on the clock: nanoseconds of the steady clock, calls, frames, or a ticket of the
// device's.
class Clock {
  public:
    // <device> answers for the clock of that kind, and outlives this one.
    explicit Clock(Latency latency, ResultTimes* device = nullptr) : latency_(latency), device_(device) {}

    // False where results are seen when the driver has them.
    bool delays() const { return latency_.kind != ClockKind::kNone; }
    // True where the same calls always see the same answers.
    bool is_deterministic() const {
        return latency_.kind == ClockKind::kCalls || latency_.kind == ClockKind::kFrames || is_device();
    }
    bool is_device() const { return latency_.kind == ClockKind::kDevice; }
    bool counts_calls() const { return latency_.kind == ClockKind::kCalls; }

    void count_call() { ++calls_; }
    void count_swap();

    // When a query that ends now is due.
    Tick due();
    // The program asks whether a result is there. Under frames, polling alone moves the clock too, so that a
    // program that waits for a result before it swaps goes on.
    bool poll(Tick due);
    // True once the clock has reached <due>; moves nothing.
    bool reached(Tick due) const;
    // A blocking read: returns when the clock has reached <due>.
    void wait_until(Tick due);
    // Waits for <due> no longer than <most_ns> nanoseconds; true where it was reached. A deterministic clock
    // is moved to it, however short the time.
    bool wait_for(Tick due, std::uint64_t most_ns);
    // When everything is due that has ended so far.
    Tick latest_due() const;

  private:
    Tick now() const;
    Tick span() const;

    Latency latency_;
    ResultTimes* device_;
    Tick calls_ = 0;
    Tick frames_ = 0;
    Tick latest_due_ = 0;
    unsigned polls_since_swap_ = 0;
};

}  // namespace occlusion_unit
