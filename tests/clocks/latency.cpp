// SPDX-License-Identifier: MIT
#include "latency.h"

#include <cstdio>
#include <cstdlib>
#include <string>
#include <thread>

// After glext.h with its prototypes, which it includes without.
#include <GL/glext_emu.h>

namespace clock_tests {
namespace {

using conformance::Query;

std::chrono::microseconds wall_latency() {
    return std::chrono::microseconds(latency().kind == Latency::kWall ? latency().amount : 0);
}

Latency parse(const std::string& text) {
    const auto number = [&](const char* prefix) -> std::uint64_t {
        return std::strtoull(text.c_str() + std::string(prefix).size(), nullptr, 10);
    };
    if (text == "none") return {};
    if (text.starts_with("wall=")) return {Latency::kWall, number("wall=")};
    if (text.starts_with("calls=")) return {Latency::kCalls, number("calls=")};
    if (text.starts_with("frames=")) return {Latency::kFrames, number("frames=")};
    if (text == "device") return {Latency::kDevice, 0};
    std::fprintf(stderr, "CLOCK=%s: none, wall=US, calls=N, frames=N or device expected\n", text.c_str());
    std::exit(2);
}

}  // namespace

const Latency& latency() {
    static const Latency value = [] {
        const char* const text = std::getenv("CLOCK");
        return parse(text ? text : "none");
    }();
    return value;
}

::testing::AssertionResult is_not_early(Moment before, Moment after) {
    const auto taken = std::chrono::duration_cast<std::chrono::nanoseconds>(after - before);
    if (taken >= wall_latency()) return ::testing::AssertionSuccess();
    return ::testing::AssertionFailure() << "after " << taken.count() << " ns";
}

void ClockTest::let_pass() const {
    switch (latency().kind) {
        case Latency::kNone:
            break;
        case Latency::kWall:
            std::this_thread::sleep_for(wall_latency());
            break;
        case Latency::kCalls: {
            // Whatever is asked of an object is a call that counts.
            const Query query;
            query.count([] {});
            GLuint value = 0;
            for (std::uint64_t i = 0; i < latency().amount; ++i) {
                glGetQueryObjectuiv(query.name(), GL_QUERY_RESULT_AVAILABLE, &value);
            }
            break;
        }
        case Latency::kFrames:
            for (std::uint64_t i = 0; i < latency().amount; ++i) surface().swap();
            break;
        case Latency::kDevice: {
            constexpr GLuint64 kOneSecond =
                1'000'000'000;  // nanoseconds; no machine of these tests is so late
            const auto work = reinterpret_cast<PFNGLDEVICEWORKEMUPROC>(
                conformance::platform().get_proc_address("glDeviceWorkEMU"));
            ASSERT_NE(work, nullptr);
            work(kOneSecond);
            break;
        }
    }
}

void ClockTest::while_pending(const std::function<Moment(bool& is_as_expected)>& look) const {
    constexpr int kMostTries = 50;
    for (int i = 0; i < kMostTries; ++i) {
        bool is_as_expected = false;
        const Moment end = look(is_as_expected);
        const bool was_pending = latency().kind != Latency::kWall || now() - end < wall_latency();
        if (!was_pending) continue;
        EXPECT_TRUE(is_as_expected);
        return;
    }
    GTEST_SKIP() << "this machine is too slow to see anything pending";
}

void let_driver_finish() {
    conformance::read_colours({0, 0, 1, 1});
}

void draw_visible() {
    conformance::draw_rect({0, 0, 8, 8}, conformance::kNear);
}

}  // namespace clock_tests
