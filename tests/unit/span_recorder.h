// SPDX-License-Identifier: MIT
// Keeps what a timeline tells, and a machine with round numbers to try it on.
#pragma once

#include <vector>

#include "occlusion_unit/timeline.h"

namespace occlusion_unit {

class SpanRecorder final : public TimelineListener {
  public:
    struct Frame {
        std::uint64_t index = 0;
        Picoseconds end = 0;
        TimeSums sums;
    };

    void span(const Span& span) override { spans.push_back(span); }
    void result(std::uint64_t query, Picoseconds done, Picoseconds available) override {
        results.push_back({query, done, available});
    }
    void frame(std::uint64_t index, Picoseconds end, const TimeSums& sums) override {
        frames.push_back({index, end, sums});
    }

    std::vector<Span> of(Lane lane) const {
        std::vector<Span> found;
        for (const Span& span : spans)
            if (span.lane == lane) found.push_back(span);
        return found;
    }
    // How long the spans of <activity> are together.
    Picoseconds time_of(Lane lane, Activity activity) const {
        Picoseconds time = 0;
        for (const Span& span : of(lane))
            if (span.activity == activity) time += span.end - span.begin;
        return time;
    }

    std::vector<Span> spans;
    std::vector<ResultTime> results;
    std::vector<Frame> frames;
};

// In picoseconds, and for the small things in thousands of femtoseconds, which are the same.
inline Profile round_machine() {
    constexpr Femtoseconds kPicosecond = 1000;
    Profile profile;
    profile.swap = 10;
    profile.batch = 7;
    profile.query = 5;
    profile.poll = 1;
    profile.read = 3;
    profile.copied_triangle = 2 * kPicosecond;
    profile.triangle = 1 * kPicosecond;
    profile.fragment = 4 * kPicosecond;
    profile.depth_fragment = 2 * kPicosecond;
    profile.cleared_pixel = 1 * kPicosecond;
    profile.swapped_pixel = 1 * kPicosecond;
    profile.gpu_query = 2;
    profile.result_latency = 20;
    profile.region_pixel = 3 * kPicosecond;
    profile.fifo = 100;
    profile.read_pixel = 5 * kPicosecond;
    return profile;
}

inline Effects without(Effect effect) {
    return all_effects().reset(static_cast<std::size_t>(effect));
}

// Draw commands, and what a query asks about.
inline DrawWork triangles(std::uint64_t count, std::uint64_t fragments = 0, std::uint32_t samples = 1) {
    return {.triangles = count, .fragments = {.count = fragments, .samples = samples}};
}
inline DrawWork copied(std::uint64_t count) {
    return {.triangles = count, .copied_triangles = count};
}
inline Fragments volume(std::uint64_t count, std::uint32_t samples = 1) {
    return {.count = count, .samples = samples, .is_depth_only = true};
}

}  // namespace occlusion_unit
