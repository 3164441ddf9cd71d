// SPDX-License-Identifier: MIT
#include "occlusion_unit/clock.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <vector>

using occlusion_unit::Clock;
using occlusion_unit::ClockKind;
using occlusion_unit::Latency;
using occlusion_unit::Tick;

namespace {

Clock clock_of(const char* text) {
    return Clock(Latency::parse(text).value());
}

// A device whose time is a number: a result is there 10 after its query's end, a poll takes 1.
class TenLater final : public occlusion_unit::ResultTimes {
  public:
    Tick end_query() override {
        ends_.push_back(now);
        return ends_.size();
    }
    Tick last_ticket() const override { return ends_.size(); }
    bool poll(Tick ticket) override {
        ++now;
        return has_come(ticket);
    }
    bool has_come(Tick ticket) override { return now >= time_of(ticket); }
    void wait_for(Tick ticket) override { now = std::max(now, time_of(ticket)); }
    bool wait_for(Tick ticket, std::uint64_t most_ns) override {
        now = std::min(std::max(now, time_of(ticket)), now + most_ns);
        return has_come(ticket);
    }

    std::uint64_t now = 0;

  private:
    std::uint64_t time_of(Tick ticket) const { return ticket == 0 ? 0 : ends_[ticket - 1] + 10; }
    std::vector<std::uint64_t> ends_;
};

TEST(Clock, latencies_are_read_and_written_alike) {
    for (const char* text : {"none", "wall=50", "calls=0", "calls=10000", "frames=2", "device"}) {
        ASSERT_TRUE(Latency::parse(text)) << text;
        EXPECT_EQ(Latency::parse(text)->text(), text);
    }
}

TEST(Clock, what_is_not_a_clock_is_refused) {
    for (const char* text :
         {"", "wall", "wall=", "wall=-1", "wall=5us", "wall= 5", "calls=1.5", "ticks=3", "NONE",
          "frames=99999999999999999999", "wall=86400000001", "none=1", "device=1"}) {
        EXPECT_FALSE(Latency::parse(text)) << text;
    }
}

TEST(Clock, without_a_latency_a_result_is_due_at_once) {
    Clock clock = clock_of("none");
    EXPECT_FALSE(clock.delays());
    EXPECT_TRUE(clock.poll(clock.due()));
}

TEST(Clock, a_result_is_due_after_so_many_calls) {
    Clock clock = clock_of("calls=3");
    const Tick due = clock.due();
    for (int call = 0; call < 3; ++call) {
        EXPECT_FALSE(clock.poll(due)) << "after " << call << " calls";
        clock.count_call();
    }
    EXPECT_TRUE(clock.poll(due));
}

TEST(Clock, a_polling_loop_ends_for_every_latency_in_calls) {
    for (unsigned latency = 0; latency <= 10'000; ++latency) {
        Clock clock(Latency{ClockKind::kCalls, latency});
        const Tick due = clock.due();
        unsigned polls = 1;
        // A poll is a hooked call itself.
        for (clock.count_call(); !clock.poll(due); clock.count_call()) ++polls;
        EXPECT_EQ(polls, std::max(latency, 1u));
    }
}

TEST(Clock, a_blocking_read_moves_a_deterministic_clock_to_due) {
    for (const char* text : {"calls=7", "frames=7"}) {
        Clock clock = clock_of(text);
        const Tick due = clock.due();
        EXPECT_FALSE(clock.reached(due));
        clock.wait_until(due);
        EXPECT_TRUE(clock.reached(due));
    }
}

TEST(Clock, under_frames_a_thousand_polls_count_as_a_swap) {
    Clock clock = clock_of("frames=2");
    const Tick due = clock.due();
    int polls = 1;
    while (!clock.poll(due)) ++polls;
    EXPECT_EQ(polls, 2000);
}

TEST(Clock, a_swap_starts_the_count_of_polls_anew) {
    Clock clock = clock_of("frames=2");
    const Tick due = clock.due();
    for (int i = 0; i < 999; ++i) EXPECT_FALSE(clock.poll(due));
    clock.count_swap();
    for (int i = 0; i < 999; ++i) EXPECT_FALSE(clock.poll(due));
    EXPECT_TRUE(clock.poll(due));
}

TEST(Clock, due_times_never_fall) {
    for (const char* text : {"wall=10", "calls=3", "frames=1"}) {
        Clock clock = clock_of(text);
        Tick last = clock.due();
        for (int i = 0; i < 100; ++i) {
            clock.count_call();
            if (i % 10 == 0) clock.count_swap();
            if (i % 7 == 0) clock.wait_until(last);
            EXPECT_GE(clock.due(), last) << text;
            last = clock.due();
        }
    }
}

TEST(Clock, a_wait_that_is_too_short_ends_before_the_result_is_due) {
    Clock clock = clock_of("wall=2000000");
    const Tick due = clock.due();
    const auto start = std::chrono::steady_clock::now();
    EXPECT_FALSE(clock.wait_for(due, 1'000'000));
    const auto spent = std::chrono::steady_clock::now() - start;
    EXPECT_GE(spent, std::chrono::milliseconds(1));
    EXPECT_LT(spent, std::chrono::seconds(2));
    Clock short_clock = clock_of("wall=300");
    EXPECT_TRUE(short_clock.wait_for(short_clock.due(), ~std::uint64_t{0}));
    for (const char* text : {"calls=3", "frames=2"}) {
        Clock deterministic = clock_of(text);
        EXPECT_TRUE(deterministic.wait_for(deterministic.due(), 0)) << text;
    }
}

TEST(Clock, after_a_wait_for_the_latest_everything_that_has_ended_is_due) {
    for (const char* text : {"wall=30", "calls=3", "frames=2"}) {
        Clock clock = clock_of(text);
        const Tick first = clock.due();
        clock.count_call();
        const Tick second = clock.due();
        EXPECT_FALSE(clock.reached(second)) << text;
        clock.wait_until(clock.latest_due());
        EXPECT_TRUE(clock.reached(first)) << text;
        EXPECT_TRUE(clock.reached(second)) << text;
        EXPECT_FALSE(clock.reached(clock.due())) << text;
    }
}

TEST(Clock, a_blocking_read_on_the_wall_is_never_early) {
    // Short waits are spun, long ones slept.
    for (const char* text : {"wall=30", "wall=1500"}) {
        Clock clock = clock_of(text);
        const auto start = std::chrono::steady_clock::now();
        const Tick due = clock.due();
        EXPECT_FALSE(clock.reached(due));
        clock.wait_until(due);
        const auto spent = std::chrono::steady_clock::now() - start;
        EXPECT_GE(spent, std::chrono::microseconds(Latency::parse(text)->amount)) << text;
    }
}

TEST(Clock, the_device_says_when_its_results_are_there) {
    TenLater device;
    Clock clock(Latency{ClockKind::kDevice}, &device);
    EXPECT_TRUE(clock.delays());
    EXPECT_TRUE(clock.is_deterministic());
    EXPECT_FALSE(clock.counts_calls());
    clock.wait_until(clock.latest_due());  // nothing has ended yet
    EXPECT_EQ(device.now, 0u);
    const Tick first = clock.due();
    for (int polls = 1; polls < 10; ++polls) EXPECT_FALSE(clock.poll(first)) << polls;
    EXPECT_TRUE(clock.poll(first));
    EXPECT_EQ(device.now, 10u);
    const Tick second = clock.due();
    EXPECT_EQ(clock.latest_due(), second);
    // Calls and swaps are no time on it.
    for (int i = 0; i < 100; ++i) {
        clock.count_call();
        clock.count_swap();
        EXPECT_FALSE(clock.reached(second));
    }
    EXPECT_FALSE(clock.wait_for(second, 4));
    EXPECT_EQ(device.now, 14u);
    EXPECT_TRUE(clock.wait_for(second, 100));
    EXPECT_EQ(device.now, 20u);
    clock.wait_until(second);
    EXPECT_TRUE(clock.reached(first));
    EXPECT_EQ(device.now, 20u);
}

}  // namespace
