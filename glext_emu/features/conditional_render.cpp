// SPDX-License-Identifier: MIT
// Conditional rendering: the driver decides by the result it has, the layer by when the machine would have
// it.
#include "context/refusals.h"
#include "features/features.h"
#include "features/list_recorder.h"
#include "features/stall.h"

namespace glext_emu::features {
namespace {

bool waits(GLenum mode) {
    return mode == GL_QUERY_WAIT || mode == GL_QUERY_BY_REGION_WAIT || mode == GL_QUERY_WAIT_INVERTED ||
           mode == GL_QUERY_BY_REGION_WAIT_INVERTED;
}

bool is_inverted(GLenum mode) {
    return mode >= GL_QUERY_WAIT_INVERTED && mode <= GL_QUERY_BY_REGION_NO_WAIT_INVERTED;
}

// True where the layer has to know which object decides, and when.
bool is_followed(const Context& ctx) {
    return ctx.follows_text || ctx.clock.delays() || ctx.probe.is_wanted;
}

// From here on everything is drawn.
void draw_all(Context& ctx) {
    ctx.real->glEndConditionalRender();
    ctx.conditional.is_in_driver = false;
}

// The condition of a query that counted before the driver's last count, which alone the driver knows.
void correct(Context& ctx, GLuint id, GLenum mode) {
    if (!is_inverted(mode)) return draw_all(ctx);
    if (has_passed(ctx, id)) return;
    const OwnCalls own(ctx);
    ctx.real->glEndConditionalRender();
    ctx.real->glBeginConditionalRender(id, GL_QUERY_WAIT);
    ctx.conditional.mode = GL_QUERY_WAIT;
}

// A query around nothing: its result is zero, as that of an object that was created and never begun. Mesa
// draws everything by such an object.
void count_nothing(Context& ctx, GLuint id, const QueryRecord& record) {
    const CountPause pause(ctx);
    const OwnCalls own(ctx);
    const GLenum target = real_target(ctx, record.target);
    ctx.real->glBeginQuery(target, id);
    ctx.real->glEndQuery(target);
}

// What was drawn between glBegin and glEnd before the block is not part of it. Mesa collects such vertices,
// and keeps them over its Begin; asking for a list makes it draw them.
void draw_collected_vertices(Context& ctx) {
    if (ctx.kind.is_compatibility()) ctx.real->glIsList(0);
}

// Begin by whichever extension's command.
void start(Context& ctx, GLuint id, GLenum mode) {
    if (ctx.recording.is_open() && ctx.records_operations) {
        return record(ctx,
                      {[](Context& c, const ListOperation& op) { start(c, op.first, op.second); }, id, mode});
    }
    if (ctx.conditional.query != 0 && !ctx.conditional.is_in_driver) return ctx.raise(GL_INVALID_OPERATION);
    // NV_conditional_render, Errors: INVALID_VALUE "if <id> is not the name of an existing query object"; a
    // generated name becomes one at its first begin.
    const bool is_nobodys = ctx.slot.is_hidden(id) || (ctx.follows_text && !is_object(ctx, id));
    if (is_nobodys) return ctx.raise(ctx.conditional.query != 0 ? GL_INVALID_OPERATION : GL_INVALID_VALUE);
    if (ctx.proposed.is_object(id)) return ctx.raise(GL_INVALID_OPERATION);
    const auto found = ctx.slot.records.find(id);
    const bool is_ended = found != ctx.slot.records.end() && found->second.has_ended;
    // A deterministic clock does not depend on when the driver happens to be ready.
    if (is_ended && ctx.clock.is_deterministic()) has_passed(ctx, id);
    if (!is_followed(ctx)) return ctx.real->glBeginConditionalRender(id, mode);
    if (ctx.follows_text) draw_collected_vertices(ctx);
    if (is_ended && !found->second.was_begun) count_nothing(ctx, id, found->second);
    if (!driver_accepts(ctx, [&] { ctx.real->glBeginConditionalRender(id, mode); })) return;

    ctx.conditional = {.query = id, .is_in_driver = true, .mode = mode};
    if (!is_ended) return;
    QueryRecord& record = found->second;
    if (waits(mode)) {
        const StallScope stall(ctx);
        wait_in_pipe(ctx, record.due);
    } else if (ctx.clock.delays() && !ctx.clock.poll(record.due)) {
        // ARB_conditional_render_inverted, issue 3: the condition is inverted, not what happens without a
        // result.
        return draw_all(ctx);
    }
    if (record.earlier != 0) correct(ctx, id, mode);
}

}  // namespace

void begin_conditional_render(Context& ctx, GLuint id, GLenum mode) {
    if (refuses_conditional_render(ctx)) return ctx.raise(GL_INVALID_OPERATION);
    if (refuses_conditional_mode(ctx, mode)) return ctx.raise(GL_INVALID_ENUM);
    start(ctx, id, mode);
}

void begin_conditional_render_nvx(Context& ctx, GLuint id) {
    // NV_conditional_render, Dependencies on NVX_conditional_render.
    start(ctx, id, GL_QUERY_WAIT);
}

void end_conditional_render(Context& ctx) {
    if (refuses_conditional_render(ctx) && !ctx.emulates_nvx_render) return ctx.raise(GL_INVALID_OPERATION);
    if (ctx.recording.is_open() && ctx.records_operations) {
        return record(ctx, {[](Context& c, const ListOperation&) { end_conditional_render(c); }});
    }
    const bool is_ours_alone = ctx.conditional.query != 0 && !ctx.conditional.is_in_driver;
    if (!is_ours_alone) ctx.real->glEndConditionalRender();
    ctx.conditional = {};
    delete_doomed(ctx);
}

}  // namespace glext_emu::features
