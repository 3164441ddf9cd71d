// SPDX-License-Identifier: MIT
// The five counters of occlusion hardware, and the fixture that runs every scene once with each of them.
//
// A scene states how many samples pass; what a counter makes of that (a number, a number up to its largest, a
// boolean, a boolean that may err on the visible side) is said once, here. A counter that the GL under test
// has not is skipped.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <optional>
#include <ostream>
#include <string>

#include "harness/gl_test.h"
#include "harness/objects.h"
#include "harness/query.h"

namespace conformance {

using Draw = std::function<void()>;

struct Counter {
    const char* name;
    bool is_boolean;
    bool is_conservative;  // may say that something passed where nothing did
    std::optional<std::string> (*lack)();
    std::uint64_t (*largest)();                // what it saturates at; 1 of a boolean
    std::uint64_t (*count)(const Draw& draw);  // what it says of the samples of <draw>
};

std::ostream& operator<<(std::ostream& out, const Counter& counter);

// Whether <counter> may give <value> where one of the numbers <samples> passed.
bool agrees(const Counter& counter, std::uint64_t value, std::initializer_list<std::uint64_t> samples);

class CountingTest : public GlTest, public ::testing::WithParamInterface<Counter> {
  protected:
    void SetUp() override;

    static std::uint64_t count(const Draw& draw) { return GetParam().count(draw); }

    // Exactly so many samples of <draw> pass.
    static void expect_count(std::uint64_t samples, const Draw& draw) { expect_one_of({samples}, draw); }
    // Where the text leaves a choice.
    static void expect_one_of(std::initializer_list<std::uint64_t> samples, const Draw& draw);
};

// A command of an extension that GL libraries do not export.
template <typename Function>
Function function(const char* name) {
    return reinterpret_cast<Function>(platform().get_proc_address(name));
}

extern const std::array<Counter, 5> kCounters;
std::string counter_name(const ::testing::TestParamInfo<Counter>& info);

// Every suite runs once with each counter: Suite.test/hp_flag, /nv_count, /samples, /any, /any_conservative.
#define COUNT_WITH_EACH(suite) INSTANTIATE_TEST_SUITE_P(, suite, ::testing::ValuesIn(kCounters), counter_name)

inline constexpr int kSize = kSurfaceSize;
inline constexpr int kHalf = kSize / 2;
inline constexpr std::uint64_t kAll = kSize * kSize;  // the samples of kWhole where there is one a pixel
inline constexpr Rect kLeft = {0, 0, kHalf, kSize};
inline constexpr Rect kRight = {kHalf, 0, kHalf, kSize};
inline constexpr Rect kQuarter = {0, 0, kHalf, kHalf};

inline void draw_whole() {
    draw_rect(kWhole, kMiddle);
}

}  // namespace conformance
