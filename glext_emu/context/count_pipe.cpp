// SPDX-License-Identifier: MIT
#include "context/count_pipe.h"

#include <algorithm>
#include <bit>
#include <utility>

#include "context/context.h"

namespace glext_emu {
namespace {

// A program that never asks keeps at most this many hidden queries.
constexpr std::size_t kMostUnsettled = 64;

}  // namespace

std::uint64_t Reading::of(Counters counter) const {
    return fragments[static_cast<std::size_t>(std::countr_zero(counter))];
}

// A fragment of a multisampled framebuffer counts once, however many of its samples pass; the driver counts
// samples. The quotient, rounded up, is exact where whole pixels pass, and 0 exactly where nothing does.
void CountPipe::settle(Context& ctx, Step& step) {
    if (step.query == 0) return;
    step.fragments += (driver_count(ctx, step.query) + step.samples - 1) / step.samples;
    give_back(ctx, step);
    step.query = 0;
}

void CountPipe::give_back(Context& ctx, const Step& step) {
    if (step.query != 0) give_back_counter(ctx, step.query);
}

// Counts of the same counters become one, so that the pipe does not grow.
void CountPipe::settle(Context& ctx) {
    std::deque<Step> settled;
    for (Step& step : steps_) {
        settle(ctx, step);
        const bool is_more = step.kind == Kind::kCounted && !settled.empty() &&
                             settled.back().kind == Kind::kCounted &&
                             settled.back().counters == step.counters;
        if (is_more) {
            settled.back().fragments += step.fragments;
        } else {
            settled.push_back(step);
        }
    }
    steps_ = std::move(settled);
    unsettled_ = 0;
}

// What was counted since the last reading, nobody will read.
void CountPipe::restart(Context& ctx) {
    while (!steps_.empty() && steps_.back().kind != Kind::kReading) {
        if (steps_.back().query != 0) --unsettled_;
        give_back(ctx, steps_.back());
        steps_.pop_back();
    }
    if (steps_.empty()) {
        fragments_ = {};
    } else {
        steps_.push_back({});
    }
}

void CountPipe::add(Context& ctx, GLuint query, Counters counters, GLuint samples) {
    if (unsettled_ == kMostUnsettled) settle(ctx);
    steps_.push_back({.kind = Kind::kCounted, .query = query, .samples = samples, .counters = counters});
    ++unsettled_;
}

void CountPipe::read(GLint marker, Counters counters, occlusion_unit::Tick due) {
    steps_.push_back({.kind = Kind::kReading, .counters = counters, .marker = marker, .due = due});
    ++readings_;
}

bool CountPipe::advance(Context& ctx, bool waits) {
    while (!steps_.empty() && steps_.front().kind != Kind::kReading) {
        Step& step = steps_.front();
        if (step.kind == Kind::kRestart) {
            fragments_ = {};
        } else {
            if (step.query != 0) {
                if (!waits && !is_driver_ready(ctx, step.query)) return false;
                settle(ctx, step);
                --unsettled_;
            }
            for (std::size_t i = 0; i < kCounterCount; ++i) {
                if ((step.counters >> i & 1u) != 0) fragments_[i] += step.fragments;
            }
        }
        steps_.pop_front();
    }
    return true;
}

std::optional<Reading> CountPipe::take(Context& ctx, bool waits) {
    if (readings_ == 0) return std::nullopt;
    const auto oldest = std::ranges::find(steps_, Kind::kReading, &Step::kind);
    if (waits) {
        ctx.clock.wait_until(oldest->due);
    } else if (!ctx.clock.poll(oldest->due)) {
        return std::nullopt;
    }
    // A deterministic clock does not depend on when the driver happens to be ready.
    if (!advance(ctx, waits || ctx.clock.is_deterministic())) return std::nullopt;
    const Step step = steps_.front();
    steps_.pop_front();
    --readings_;
    return Reading{.marker = step.marker, .counters = step.counters, .fragments = fragments_};
}

void CountPipe::clear(Context& ctx) {
    for (const Step& step : steps_) give_back(ctx, step);
    steps_.clear();
    fragments_ = {};
    readings_ = 0;
    unsettled_ = 0;
}

}  // namespace glext_emu
