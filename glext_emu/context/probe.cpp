// SPDX-License-Identifier: MIT
#include "context/probe.h"

#include <algorithm>
#include <utility>

#include "context/context.h"
#include "context/report.h"
#include "context/settings.h"

namespace glext_emu {
namespace {

using occlusion_unit::FarEnd;

// GREATER and GEQUAL keep what lies nearer only where depth is reversed.
FarEnd far_end_of_depth_function(Context& ctx) {
    GLint function = GL_LESS;
    ctx.real->glGetIntegerv(GL_DEPTH_FUNC, &function);
    return function == GL_GREATER || function == GL_GEQUAL ? FarEnd::kZero : FarEnd::kOne;
}

void start_run(Context& ctx) {
    ctx.proposed.run = std::make_unique<UnitRun>(GL_ALL_REGISTERS_EMU, far_end_of_depth_function(ctx),
                                                 VisibleHitsBy::kWatchedQuery);
}

// The visible hits are the program's own count; of a boolean query only whether there are any.
void add_programs_count(Context& ctx, const ProbedQuery& query, occlusion_unit::Record& record) {
    const QueryRecord& counted = ctx.slot.records[query.name];
    const std::uint64_t count = counted.earlier + counted.samples_per_count * driver_count(ctx, query.name);
    record.visible = count != 0 ? 1 : 0;
    if (query.target == GL_SAMPLES_PASSED) {
        record.visible_hits = count;
    } else {
        record.registers &= ~GLbitfield{GL_VISIBLE_HITS_BIT_EMU};
    }
    record = narrowed(ctx, record, query.run->far_end());
}

void tell(Context& ctx, ProbedQuery& query) {
    std::vector<occlusion_unit::Record> records;
    query.run->drain(ctx, records);
    add_programs_count(ctx, query, records.front());
    if (ctx.probe.told_of_frame++ < ProbeLog::kMostOfFrame) {
        Report::instance().add_probe(ctx, query, records.front());
    } else {
        ctx.frame.unprobed++;
    }
}

void tell_oldest(Context& ctx) {
    // Taken out first: what is asked of the driver may come back here.
    ProbedQuery query = std::move(ctx.probe.unread.front());
    ctx.probe.unread.pop_front();
    tell(ctx, query);
}

bool is_ready(Context& ctx, const ProbedQuery& query) {
    return is_driver_ready(ctx, query.name) && query.run->is_ready(ctx);
}

}  // namespace

void begin_probe(Context& ctx, GLenum target, GLuint name) {
    ProbeLog& probe = ctx.probe;
    if (!probe.is_wanted) return;
    probe.active = {.name = name, .target = target, .frame = ctx.frame.index, .draws = 0, .run = nullptr};
    probe.draws_before = ctx.frame.draws;
    probe.is_unaimed = true;
    start_run(ctx);
    ctx.update_hot();
}

void aim_probe(Context& ctx) {
    if (!std::exchange(ctx.probe.is_unaimed, false)) return;
    const OwnCalls own(ctx);
    start_run(ctx);
}

void end_probe(Context& ctx) {
    ProbeLog& probe = ctx.probe;
    if (probe.active.name == 0) return;
    ctx.proposed.run->close_segment(ctx);
    probe.active.run = std::move(ctx.proposed.run);
    probe.active.draws += ctx.frame.draws - probe.draws_before;
    probe.is_unaimed = false;
    probe.unread.push_back(std::exchange(probe.active, {}));
    if (probe.unread.size() > ProbeLog::kMostUnread) tell_oldest(ctx);
    ctx.update_hot();
}

void settle_probe(Context& ctx, GLuint name) {
    ProbeLog& probe = ctx.probe;
    if (name == 0 || !probe.is_wanted) return;
    if (name == probe.active.name) {
        ctx.proposed.run->drop(ctx);
        ctx.proposed.run.reset();
        probe.active = {};
        probe.is_unaimed = false;
        ctx.frame.unprobed++;
        ctx.update_hot();
    }
    const auto is_it = [name](const ProbedQuery& query) { return query.name == name; };
    // In the order of their ends, as every reader of the report finds them.
    while (std::ranges::any_of(probe.unread, is_it)) tell_oldest(ctx);
}

void settle_probes(Context& ctx) {
    while (!ctx.probe.unread.empty()) tell_oldest(ctx);
}

void end_probes_frame(Context& ctx) {
    ProbeLog& probe = ctx.probe;
    if (!probe.is_wanted) return;
    while (!probe.unread.empty() && is_ready(ctx, probe.unread.front())) tell_oldest(ctx);
    if (probe.active.name != 0) probe.active.draws += ctx.frame.draws - probe.draws_before;
    probe.draws_before = 0;
    probe.told_of_frame = 0;
}

}  // namespace glext_emu
