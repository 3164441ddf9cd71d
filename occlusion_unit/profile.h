// SPDX-License-Identifier: MIT
// What things cost on a machine: the numbers of a device's [time] table, as integers, so that adding them up
// gives the same time everywhere. A cost of many small things is in femtoseconds each, everything else in
// picoseconds. The model that uses them is timeline.h.
#pragma once

#include <cstdint>

namespace occlusion_unit {

// A point of device time, or a span of it; 2^63 of them are 106 days.
using Picoseconds = std::int64_t;
using Femtoseconds = std::int64_t;

constexpr Picoseconds kPicosecondsPerMicrosecond = 1'000'000;

// <count> things at <each>, rounded down to a picosecond.
constexpr Picoseconds cost_of(std::uint64_t count, Femtoseconds each) {
    __extension__ using Wide = __int128;
    constexpr Wide kLongest = std::int64_t{1} << 60;  // two weeks; the sum of a few stays far from overflow
    const Wide cost = static_cast<Wide>(count) * each / 1000;
    return static_cast<Picoseconds>(cost < kLongest ? cost : kLongest);
}

struct Profile {
    // The processor, and the driver that runs on it.
    Picoseconds swap = 0;        // once a frame
    Picoseconds batch = 0;       // a draw command, with the program's way to it
    Picoseconds query = 0;       // begin and end of a query, with the bounding volume between them
    Picoseconds poll = 100'000;  // asking whether a result is there; never free, or polling would not end
    Picoseconds read = 0;        // a command that reads pixels back, beside its pixels
    Femtoseconds copied_triangle = 0;  // of vertices that the driver copies, not being in video memory

    // The graphics processor.
    Picoseconds gpu_batch = 0;        // a draw command
    Femtoseconds triangle = 0;        // through the vertex stage
    Femtoseconds fragment = 0;        // a sample of one, with its colour
    Femtoseconds depth_fragment = 0;  // a sample of one where no colour is written
    Femtoseconds cleared_pixel = 0;   // a sample of one, colour and depth
    Femtoseconds swapped_pixel = 0;   // where a swap copies the window
    Picoseconds gpu_query = 0;        // a query, beside its fragments
    Picoseconds result_latency = 0;   // from the end of a query's work until the processor may see its result
    Femtoseconds region_pixel = 0;    // a pixel of a depth region query

    // Between them.
    Picoseconds fifo = 0;         // of work that the command FIFO holds before a draw has to wait; 0: no end
    Femtoseconds read_pixel = 0;  // a pixel on its way back
    std::int64_t video_memory = 0;  // bytes; 0: no end
};

}  // namespace occlusion_unit
