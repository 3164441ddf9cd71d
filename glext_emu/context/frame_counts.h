// SPDX-License-Identifier: MIT
// What a report tells of one frame of one context; a frame ends at a buffer swap.
#pragma once

#include <cstdint>

namespace glext_emu {

struct FrameCounts {
    std::uint64_t index = 0;
    std::uint64_t queries_begun = 0;  // occlusion queries and segments of the HP test
    std::uint64_t polls = 0;          // QUERY_RESULT_AVAILABLE asked
    std::uint64_t waits = 0;          // blocking reads of a result
    std::uint64_t stall_ns = 0;       // time inside them
    std::uint64_t results = 0;        // results handed to the program
    std::uint64_t unprobed = 0;       // queries beyond those that the probe tells of
    std::uint64_t draws = 0;          // draw commands executed
    std::uint64_t triangles = 0;      // that the calls tell
    std::uint64_t pixels_read = 0;    // of depth buffers, by region queries
    bool triangles_are_known = true;  // false once a draw's triangles cannot be told from its call

    bool is_empty() const { return queries_begun + polls + waits + results + draws + pixels_read == 0; }
    void next_frame() { *this = FrameCounts{.index = index + 1}; }
};

}  // namespace glext_emu
