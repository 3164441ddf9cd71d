// SPDX-License-Identifier: MIT
#include "occlusion_unit/clock.h"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <thread>

namespace occlusion_unit {
namespace {

using std::chrono::nanoseconds;
using Steady = std::chrono::steady_clock;

constexpr unsigned kPollsPerFrame = 1000;
// A sleep may return this much late; the rest of a wait is spun.
constexpr nanoseconds kSleepSlack{100'000};
// One day: a longer latency is a slip of the pen, and the sum of two stays far from overflow.
constexpr std::uint64_t kLongestAmount = 86'400'000'000;

struct Name {
    std::string_view text;
    ClockKind kind;
};
constexpr Name kNames[] = {
    {"wall", ClockKind::kWall}, {"calls", ClockKind::kCalls}, {"frames", ClockKind::kFrames}};

}  // namespace

std::optional<Latency> Latency::parse(std::string_view text) {
    if (text == "none") return Latency{};
    if (text == "device") return Latency{ClockKind::kDevice};
    const auto equals = text.find('=');
    if (equals == std::string_view::npos) return std::nullopt;
    const auto name = std::ranges::find(kNames, text.substr(0, equals), &Name::text);
    if (name == std::end(kNames)) return std::nullopt;

    const std::string_view digits = text.substr(equals + 1);
    std::uint64_t amount = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), amount);
    if (error != std::errc{} || end != digits.data() + digits.size() || amount > kLongestAmount) {
        return std::nullopt;
    }
    return Latency{name->kind, amount};
}

std::string Latency::text() const {
    if (kind == ClockKind::kDevice) return "device";
    const auto name = std::ranges::find(kNames, kind, &Name::kind);
    if (name == std::end(kNames)) return "none";
    return std::string(name->text) + "=" + std::to_string(amount);
}

Tick Clock::now() const {
    switch (latency_.kind) {
        case ClockKind::kWall:
            return static_cast<Tick>(nanoseconds(Steady::now().time_since_epoch()).count());
        case ClockKind::kCalls:
            return calls_;
        case ClockKind::kFrames:
            return frames_;
        case ClockKind::kNone:
        case ClockKind::kDevice:
            break;
    }
    return 0;
}

Tick Clock::span() const {
    return latency_.kind == ClockKind::kWall ? latency_.amount * 1000 : latency_.amount;
}

void Clock::count_swap() {
    ++frames_;
    polls_since_swap_ = 0;
}

Tick Clock::due() {
    return latest_due_ = is_device() ? device_->end_query() : now() + span();
}

bool Clock::reached(Tick due) const {
    return is_device() ? device_->has_come(due) : now() >= due;
}

Tick Clock::latest_due() const {
    return is_device() ? device_->last_ticket() : latest_due_;
}

bool Clock::poll(Tick due) {
    if (is_device()) return device_->poll(due);
    if (latency_.kind == ClockKind::kFrames && ++polls_since_swap_ == kPollsPerFrame) {
        ++frames_;
        polls_since_swap_ = 0;
    }
    return reached(due);
}

void Clock::wait_until(Tick due) {
    if (is_device()) return device_->wait_for(due);
    if (reached(due)) return;
    if (latency_.kind == ClockKind::kCalls) {
        calls_ = due;
    } else if (latency_.kind == ClockKind::kFrames) {
        frames_ = due;
    } else {
        const Steady::time_point end{nanoseconds(due)};
        if (end - Steady::now() > 2 * kSleepSlack) std::this_thread::sleep_until(end - kSleepSlack);
        while (!reached(due)) {
        }
    }
}

bool Clock::wait_for(Tick due, std::uint64_t most_ns) {
    if (is_device()) return device_->wait_for(due, most_ns);
    // So long that the sum does not overflow: no latency comes near a century.
    constexpr std::uint64_t kForEver = std::uint64_t{3'000'000'000} * 1'000'000'000;
    const bool is_long_enough =
        latency_.kind != ClockKind::kWall || now() + std::min(most_ns, kForEver) >= due;
    wait_until(is_long_enough ? due : now() + most_ns);
    return reached(due);
}

}  // namespace occlusion_unit
