// SPDX-License-Identifier: MIT
// Under the device's clock: ARB_timer_query answers in the device's time, and queries that count primitives
// or invocations take turns with the layer's own. The objects are the driver's, so that names, labels and
// errors are.
#include "context/device_time.h"
#include "features/features.h"

namespace glext_emu::features {
namespace {

GLint current_query(Context& ctx, GLenum target) {
    GLint name = 0;
    ctx.real->glGetQueryiv(target, GL_CURRENT_QUERY, &name);
    return name;
}

}  // namespace

void start_timed_query(Context& ctx, GLenum target, GLuint id) {
    if (ctx.recording.is_open()) return ctx.real->glBeginQuery(target, id);
    if (target != GL_TIME_ELAPSED) {
        ctx.time->pause();
        if (driver_accepts(ctx, [&] { ctx.real->glBeginQuery(target, id); })) {
            ctx.time->leave_to_program(target, true);
            note_object(ctx, id);
        }
        return;
    }
    if (!driver_accepts(ctx, [&] { ctx.real->glBeginQuery(target, id); })) return;
    note_object(ctx, id);
    forget_timer(ctx, id);
    ctx.slot.records[id] = {.target = target, .begun = ctx.time->stamp()};
}

void end_timed_query(Context& ctx, GLenum target) {
    if (ctx.recording.is_open()) return ctx.real->glEndQuery(target);
    if (ctx.time->counters().holds(target)) return ctx.raise(GL_INVALID_OPERATION);
    const auto id = static_cast<GLuint>(target == GL_TIME_ELAPSED ? current_query(ctx, target) : 0);
    if (!driver_accepts(ctx, [&] { ctx.real->glEndQuery(target); })) return;
    if (target != GL_TIME_ELAPSED) return ctx.time->leave_to_program(target, false);
    const auto found = ctx.slot.records.find(id);
    if (found == ctx.slot.records.end()) return;  // begun by a list
    found->second.due = ctx.time->stamp();
    found->second.has_ended = true;
}

void stamp_query(Context& ctx, GLuint id, GLenum target) {
    if (ctx.recording.is_open()) return ctx.real->glQueryCounter(id, target);
    if (!driver_accepts(ctx, [&] { ctx.real->glQueryCounter(id, target); })) return;
    note_object(ctx, id);
    forget_timer(ctx, id);
    ctx.slot.records[id] = {.target = target, .has_ended = true, .due = ctx.time->stamp()};
}

void forget_timer(Context& ctx, GLuint id) {
    const auto found = ctx.slot.records.find(id);
    if (ctx.time == nullptr || found == ctx.slot.records.end() || !is_timer(found->second.target)) return;
    ctx.time->forget_stamp(found->second.begun);
    ctx.time->forget_stamp(found->second.due);
    ctx.slot.records.erase(found);
}

bool is_timer(GLenum target) {
    return target == GL_TIME_ELAPSED || target == GL_TIMESTAMP;
}

std::uint64_t device_nanoseconds(Context& ctx, const QueryRecord& timer) {
    const std::uint64_t end = ctx.time->stamped_ns(timer.due);
    return timer.target == GL_TIMESTAMP ? end : end - ctx.time->stamped_ns(timer.begun);
}

}  // namespace glext_emu::features
