// SPDX-License-Identifier: MIT
// GL_EMU_occlusion_unit, one query at a time: begin and end. What happens to the draws between them is in
// unit_draws.cpp, the parallel form in occlusion_shapes.cpp.
#include "context/settings.h"
#include "context/unit_run.h"
#include "features/features.h"
#include "features/list_recorder.h"

namespace glext_emu::features {

GLint max_occlusion_shapes() {
    return settings().device.unit_max_shapes.value_or(65536);
}

GLint unit_counter_bits() {
    return settings().device.unit_counter_bits.value_or(64);
}

// Errors of both forms of the query. The unit and the occlusion queries share the machine's one counter.
bool refuses_unit_query(Context& ctx, GLbitfield registers, GLuint id) {
    if (registers == 0 || (registers & ~GLbitfield{GL_ALL_REGISTERS_EMU}) != 0) {
        ctx.raise(GL_INVALID_VALUE);
        return true;
    }
    if (is_counter_taken(ctx) || ctx.slot.test_enabled) {
        ctx.raise(GL_INVALID_OPERATION);
        return true;
    }
    return refuses_proposed_name(ctx, id, GL_OCCLUSION_UNIT_EMU);
}

void begin_occlusion_unit_emu(Context& ctx, GLbitfield registers, GLuint id) {
    if (ctx.recording.is_open()) {
        return record(ctx, {[](Context& c, const ListOperation& op) {
                                begin_occlusion_unit_emu(c, op.first, op.second);
                            },
                            registers, id});
    }
    if (refuses_unit_query(ctx, registers, id)) return;

    need_pixels("a query of the Occlusion Unit");
    ProposedQuery& query = renew_proposed_query(ctx, id, GL_OCCLUSION_UNIT_EMU);
    query.armed = registers;
    query.record_count = 1;
    ctx.proposed.active_unit = id;
    ctx.proposed.run =
        std::make_unique<UnitRun>(registers, ctx.proposed.unit_far_end(), VisibleHitsBy::kUnit);
    ctx.frame.queries_begun++;
    ctx.update_hot();
}

void end_occlusion_unit_emu(Context& ctx) {
    if (ctx.recording.is_open()) {
        return record(ctx, {[](Context& c, const ListOperation&) { end_occlusion_unit_emu(c); }});
    }
    if (ctx.proposed.active_unit == 0) return ctx.raise(GL_INVALID_OPERATION);

    ProposedQuery& query = ctx.proposed.objects.at(ctx.proposed.active_unit);
    ctx.proposed.run->close_segment(ctx);
    query.pending = std::move(ctx.proposed.run);
    query.has_ended = true;
    query.due = ctx.clock.due();
    ctx.proposed.active_unit = 0;
    ctx.update_hot();
}

}  // namespace glext_emu::features
