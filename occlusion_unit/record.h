// SPDX-License-Identifier: MIT
// What the Occlusion Unit reports of one query: Bartz, Meissner, Huettner, "OpenGL-assisted occlusion culling
// for large polygonal models", 1999, section 6.2. Its layout is that of GLocclusionrecordEMU.
#pragma once

#include <cstdint>

namespace occlusion_unit {

// Bits of Record::registers.
inline constexpr std::uint32_t kVisible = 1;        // a flag, as HP_occlusion_test has it
inline constexpr std::uint32_t kProjectedHits = 2;  // the paper's PHC
inline constexpr std::uint32_t kVisibleHits = 4;    // the paper's NOHC
inline constexpr std::uint32_t kNearestDepth = 8;
inline constexpr std::uint32_t kScreenBox = 16;
inline constexpr std::uint32_t kAllRegisters = 31;

// Window coordinates of pixels, all inclusive; empty where right < left.
struct Box {
    std::int32_t left = 0;
    std::int32_t bottom = 0;
    std::int32_t right = -1;
    std::int32_t top = -1;
    bool operator==(const Box&) const = default;
};

struct Record {
    std::uint64_t projected_hits = 0;  // samples after the stencil test, before the depth test
    std::uint64_t visible_hits = 0;    // samples that passed the depth test too
    std::uint32_t visible = 0;         // 1 where visible_hits is not 0
    float nearest_depth = 0;  // of visible samples, as the depth buffer holds it; far where there are none
    Box box;                  // of visible pixels
    std::uint32_t registers = 0;  // those that were armed and are determined
    std::uint32_t reserved = 0;
    bool operator==(const Record&) const = default;
};
static_assert(sizeof(Record) == 48);

}  // namespace occlusion_unit
