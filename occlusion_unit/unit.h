// SPDX-License-Identifier: MIT
// The Occlusion Unit of Bartz, Meissner and Huettner (1999), section 6.2 and figure 12, as the hardware would
// be built: a partial unit sits right behind the depth test of each pixel pipe and steps its registers by the
// fragments that come by; End drains the partial units through a merge tree into one record, which waits in
// the report queue until it is read.
//
// This is the reference for the semantics of GL_EMU_occlusion_unit: whatever is asked of the layer has to
// agree with it. Deviations from the paper: a flag and 64-bit counters beside its registers, which it gives
// no width; samples where it speaks of pixels, which are the same without multisampling; and a pipe each has
// its own partial unit, where it draws one.
#pragma once

#include <cstdint>
#include <vector>

#include "occlusion_unit/record_arithmetic.h"
#include "occlusion_unit/report_queue.h"

namespace occlusion_unit {

// What a pipe hands to its partial unit for one pixel: all that the unit ever sees.
struct Fragment {
    std::int32_t x = 0;  // window coordinates of the pixel
    std::int32_t y = 0;
    // In [0, 1], as the depth buffer's format holds it; of several samples that pass, the nearest.
    float depth = 0;
    // Samples that reach the depth test: after ownership, scissor, coverage, alpha and stencil test.
    std::uint32_t samples = 1;
    // Those of them that pass it, the write enable of figure 12; at most <samples>.
    std::uint32_t passing = 1;
};

struct UnitShape {
    int pipes = 1;
    // Of the two counters in a report, 1..64.
    int counter_bits = 64;
    // Of a pipe's own, 1..64. A partial counter that a fragment would overflow drains first.
    int partial_counter_bits = 16;
};

// What the unit's parts did: an unarmed register does nothing, and is not paid for.
struct Work {
    std::uint64_t flag_sets = 0;
    std::uint64_t projected_increments = 0;
    std::uint64_t visible_increments = 0;
    std::uint64_t depth_comparisons = 0;
    std::uint64_t box_comparisons = 0;  // of single coordinates
    std::uint64_t drains = 0;           // of a partial counter, because it was full
    bool operator==(const Work&) const = default;
};

class Unit {
  public:
    explicit Unit(const UnitShape& shape);

    // Arms <registers> and resets them; nearest depth follows <far_end> until the next begin.
    void begin(std::uint32_t registers, FarEnd far_end = FarEnd::kOne);
    // A fragment comes out of the depth test of <pipe>, 0..pipes-1. One of no sample does nothing.
    void step(int pipe, const Fragment& fragment);
    // Merges the partial units: the record as it stands now. Nothing is reset, so that a later one counts on.
    Record drain();
    // Drains into <queue>. False, and nothing has happened, where that is full: the pipes have to wait with
    // what comes after (back-pressure); no record is ever dropped.
    bool end(ReportQueue& queue);

    const Work& work() const { return work_; }

  private:
    // The registers beside one pipe.
    struct Partial {
        bool visible = false;
        std::uint64_t projected_hits = 0;
        std::uint64_t visible_hits = 0;
        float nearest_depth = 0;
        Box box;
    };

    void count(std::uint64_t& partial, std::uint64_t& total, std::uint32_t hits);
    Record as_record(const Partial& partial) const;

    UnitShape shape_;
    std::uint32_t armed_ = 0;
    FarEnd far_end_ = FarEnd::kOne;
    std::vector<Partial> partials_;
    // Where drained partial counters go; 64 bits inside, so that saturation at counter_bits is told only
    // once.
    std::uint64_t projected_hits_ = 0;
    std::uint64_t visible_hits_ = 0;
    Work work_;
};

}  // namespace occlusion_unit
