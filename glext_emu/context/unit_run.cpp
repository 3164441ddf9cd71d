// SPDX-License-Identifier: MIT
#include "context/unit_run.h"

#include <algorithm>

#include "context/context.h"
#include "context/settings.h"

namespace glext_emu {
namespace {

// A query of many draws keeps at most this many of the driver's.
constexpr std::size_t kMostSegments = 64;

}  // namespace

UnitRun::UnitRun(GLbitfield armed, occlusion_unit::FarEnd far_end, VisibleHitsBy counter)
    : armed_(armed),
      far_end_(far_end),
      counter_(counter),
      counted_(occlusion_unit::empty_record(occlusion_unit::kAllRegisters, far_end)) {
}

void UnitRun::count_for(Context& ctx, GLbitfield registers, GLuint samples_per_count) {
    if (is_open_) {
        const Segment& open = segments_.back();
        if (open.registers == registers && open.samples_per_count == samples_per_count) return;
        close_segment(ctx);
    }
    if (registers == 0) return;
    const OwnCalls own(ctx);
    if (segments_.size() == kMostSegments) fold(ctx);
    segments_.push_back({take_counter(ctx), samples_per_count, registers});
    is_open_ = true;
    ctx.real->glBeginQuery(GL_SAMPLES_PASSED, segments_.back().query);
}

void UnitRun::close_segment(Context& ctx) {
    if (!is_open_) return;
    const OwnCalls own(ctx);
    ctx.real->glEndQuery(GL_SAMPLES_PASSED);
    is_open_ = false;
}

void UnitRun::fold(Context& ctx) {
    close_segment(ctx);
    for (const Segment& segment : segments_) {
        const std::uint64_t samples = segment.samples_per_count * driver_count(ctx, segment.query);
        occlusion_unit::Record part = occlusion_unit::empty_record(occlusion_unit::kAllRegisters, far_end_);
        if ((segment.registers & GL_PROJECTED_HITS_BIT_EMU) != 0) part.projected_hits = samples;
        if ((segment.registers & GL_VISIBLE_HITS_BIT_EMU) != 0) part.visible_hits = samples;
        counted_ = merged(counted_, part, far_end_);
        give_back_counter(ctx, segment.query);
    }
    segments_.clear();
}

bool UnitRun::is_ready(Context& ctx) {
    const bool has_counted = segments_.empty() || is_driver_ready(ctx, segments_.back().query);
    return has_counted && (driver_marks_ == nullptr || driver_marks_->is_ready(ctx));
}

void UnitRun::drain(Context& ctx, std::vector<occlusion_unit::Record>& records) {
    fold(ctx);
    if (driver_marks_ != nullptr) {
        mark(driver_marks_->drain(ctx));
        driver_marks_.reset();
    }
    occlusion_unit::Record record = counted_;
    record.registers &= armed_ & determined_;
    records.push_back(narrowed(ctx, finished(record, far_end_), far_end_));
}

void UnitRun::drop(Context& ctx) {
    close_segment(ctx);
    for (const Segment& segment : segments_) give_back_counter(ctx, segment.query);
    segments_.clear();
    if (driver_marks_ != nullptr) driver_marks_->drop(ctx);
    driver_marks_.reset();
}

}  // namespace glext_emu
