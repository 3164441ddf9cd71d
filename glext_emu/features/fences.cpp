// SPDX-License-Identifier: MIT
// GL 4.6, 2.3.2 and 4.1: Finish and fences say that everything before them is complete, queries included. So
// under a clock they complete when the results of the queries before them are due. A fence is followed in the
// context that made it, where those queries are.
#include "features/features.h"
#include "features/stall.h"

namespace glext_emu::features {
namespace {

std::optional<occlusion_unit::Tick> due_of(const Context& ctx, GLsync sync) {
    const auto found = ctx.fences.find(sync);
    return found == ctx.fences.end() ? std::nullopt : std::optional(found->second);
}

// A deterministic clock does not depend on when the driver happens to be ready.
void let_driver_finish(const Context& ctx, GLsync sync) {
    constexpr GLuint64 kForEver = ~GLuint64{0};
    if (ctx.clock.is_deterministic()) ctx.real->glClientWaitSync(sync, GL_SYNC_FLUSH_COMMANDS_BIT, kForEver);
}

}  // namespace

void finish(Context& ctx) {
    ctx.real->glFinish();
    if (!ctx.inside_begin_end) ctx.clock.wait_until(ctx.clock.latest_due());
}

GLsync fence_sync(Context& ctx, GLenum condition, GLbitfield flags) {
    GLsync sync = ctx.real->glFenceSync(condition, flags);
    if (sync != nullptr && ctx.clock.delays()) ctx.fences[sync] = ctx.clock.latest_due();
    return sync;
}

GLenum client_wait_sync(Context& ctx, GLsync sync, GLbitfield flags, GLuint64 timeout_ns) {
    const auto due = due_of(ctx, sync);
    const bool is_due = !due || (timeout_ns == 0 ? ctx.clock.poll(*due) : ctx.clock.reached(*due));
    if (due && (is_due || timeout_ns != 0)) let_driver_finish(ctx, sync);
    const GLenum answer = ctx.real->glClientWaitSync(sync, flags, timeout_ns);
    const bool is_signalled = answer == GL_ALREADY_SIGNALED || answer == GL_CONDITION_SATISFIED;
    if (is_due || !is_signalled) return answer;
    if (timeout_ns == 0) return GL_TIMEOUT_EXPIRED;
    const StallScope stall(ctx);
    return ctx.clock.wait_for(*due, timeout_ns) ? GL_CONDITION_SATISFIED : GL_TIMEOUT_EXPIRED;
}

void get_synciv(Context& ctx, GLsync sync, GLenum pname, GLsizei count, GLsizei* length, GLint* values) {
    const auto due = due_of(ctx, sync);
    const bool is_asked = due && pname == GL_SYNC_STATUS && count > 0 && values != nullptr;
    const bool is_due = is_asked && ctx.clock.poll(*due);
    if (is_due) let_driver_finish(ctx, sync);
    ctx.real->glGetSynciv(sync, pname, count, length, values);
    if (is_asked && !is_due) *values = GL_UNSIGNALED;
}

void delete_sync(Context& ctx, GLsync sync) {
    ctx.fences.erase(sync);
    ctx.real->glDeleteSync(sync);
}

}  // namespace glext_emu::features
