// SPDX-License-Identifier: MIT
// The registers of the Occlusion Unit from a query's begin to the moment when its record is read. The hits
// are counted by the driver's queries, a segment after the other; the marks, nearest depth and screen box, by
// whoever looks at the fragments of a draw.
#pragma once

#include <GL/gl.h>
#include <GL/glext.h>
#include <GL/glext_emu.h>

#include <cstdint>
#include <memory>
#include <vector>

#include "context/proposed_queries.h"
#include "occlusion_unit/record.h"
#include "occlusion_unit/record_arithmetic.h"

namespace glext_emu {

// Who counts the visible hits: the unit itself, or a query of the program's that the unit watches. Then the
// unit leaves the driver's slot to it, and counts by itself only what it draws once more.
enum class VisibleHitsBy { kUnit, kWatchedQuery };

// What a count of the driver's stands for.
struct Segment {
    GLuint query = 0;
    GLuint samples_per_count = 1;
    GLbitfield registers = 0;  // PROJECTED_HITS_BIT_EMU, VISIBLE_HITS_BIT_EMU
};

// Marks that lie in the driver's memory.
struct DriverMarks {
    virtual ~DriverMarks() = default;
    virtual bool is_ready(Context& ctx) = 0;
    // Waits. Nearest depth and screen box of what was marked, as far as its registers say.
    virtual occlusion_unit::Record drain(Context& ctx) = 0;
    virtual void drop(Context& ctx) = 0;
};

class UnitRun final : public PendingRecords {
  public:
    UnitRun(GLbitfield armed, occlusion_unit::FarEnd far_end, VisibleHitsBy counter);

    GLbitfield armed() const { return armed_; }
    occlusion_unit::FarEnd far_end() const { return far_end_; }
    bool watches() const { return counter_ == VisibleHitsBy::kWatchedQuery; }
    // True while <registers>, or some of them, are armed and still exact.
    bool wants(GLbitfield registers) const { return (armed_ & determined_ & registers) != 0; }
    GLbitfield wanted(GLbitfield registers) const { return armed_ & determined_ & registers; }
    // True where the unit's own queries count the visible hits.
    bool counts_visible() const { return !watches() && wants(GL_VISIBLE_BIT_EMU | GL_VISIBLE_HITS_BIT_EMU); }
    // From here on <registers> cannot be told exactly.
    void give_up(GLbitfield registers) { determined_ &= ~registers; }

    // The driver counts for <registers> until the segment is closed, each count as <samples_per_count>
    // samples.
    void count_for(Context& ctx, GLbitfield registers, GLuint samples_per_count);
    void close_segment(Context& ctx);
    // Adds marks that are known already.
    void mark(const occlusion_unit::Record& marks) { counted_ = merged(counted_, marks, far_end_); }
    std::unique_ptr<DriverMarks>& driver_marks() { return driver_marks_; }

    // Reads what has been counted so far, and frees the driver's queries.
    void fold(Context& ctx);

    bool is_ready(Context& ctx) override;
    void drain(Context& ctx, std::vector<occlusion_unit::Record>& records) override;
    void drop(Context& ctx) override;

  private:
    GLbitfield armed_;
    GLbitfield determined_ = GL_ALL_REGISTERS_EMU;
    occlusion_unit::FarEnd far_end_;
    VisibleHitsBy counter_;
    bool is_open_ = false;  // the last segment
    std::vector<Segment> segments_;
    occlusion_unit::Record counted_;  // by segments that are folded, and marks that are known
    std::unique_ptr<DriverMarks> driver_marks_;
};

}  // namespace glext_emu
