// SPDX-License-Identifier: MIT
// GL 4.6, 2.3.2 and 4.1: Finish and fences say that everything before them is complete, queries included. So
// under a clock they complete when the results of the queries before them are due. Fences are shared, and so
// is the wall's time. Calls and frames are counted by context: whoever sees another's fence complete moves
// the other's clock.
#include "features/features.h"
#include "features/stall.h"

#include <algorithm>

namespace glext_emu::features {
namespace {

std::optional<Fence> find(Context& ctx, GLsync sync) {
    if (!ctx.clock.delays()) return std::nullopt;
    const std::lock_guard lock(ctx.share_group->mutex);
    const auto found = ctx.share_group->fences.find(sync);
    return found == ctx.share_group->fences.end() ? std::nullopt : std::optional(found->second);
}

bool is_held_here(const Context& ctx, const Fence& fence) {
    return fence.maker == ctx.number || !ctx.clock.is_deterministic();
}

void see_complete(Context& ctx, const Fence& fence) {
    if (is_held_here(ctx, fence)) return;
    ShareGroup& group = *ctx.share_group;
    const std::lock_guard lock(group.mutex);
    auto& seen = group.seen_complete[fence.maker];
    seen = std::max(seen, fence.due);
    group.has_seen_complete = true;
}

// A deterministic clock does not depend on when the driver happens to be ready.
void let_driver_finish(const Context& ctx, GLsync sync) {
    constexpr GLuint64 kForEver = ~GLuint64{0};
    if (ctx.clock.is_deterministic()) ctx.real->glClientWaitSync(sync, GL_SYNC_FLUSH_COMMANDS_BIT, kForEver);
}

}  // namespace

void finish(Context& ctx) {
    // First: on OSMesa a frame ends with the driver's.
    if (ctx.time != nullptr) ctx.time->finish();
    ctx.real->glFinish();
    ctx.clock.wait_until(ctx.clock.latest_due());
    if (ctx.known_instruments != 0) deliver_measurements(ctx);
}

GLsync fence_sync(Context& ctx, GLenum condition, GLbitfield flags) {
    GLsync sync = ctx.real->glFenceSync(condition, flags);
    if (sync == nullptr || !ctx.clock.delays()) return sync;
    const occlusion_unit::Tick due = ctx.time != nullptr ? ctx.time->mark() : ctx.clock.latest_due();
    const std::lock_guard lock(ctx.share_group->mutex);
    ctx.share_group->fences[sync] = {due, ctx.number};
    return sync;
}

GLenum client_wait_sync(Context& ctx, GLsync sync, GLbitfield flags, GLuint64 timeout_ns) {
    const auto fence = find(ctx, sync);
    if (!fence) return ctx.real->glClientWaitSync(sync, flags, timeout_ns);
    const bool is_due = !is_held_here(ctx, *fence) ||
                        (timeout_ns == 0 ? ctx.clock.poll(fence->due) : ctx.clock.reached(fence->due));
    if (is_due || timeout_ns != 0) let_driver_finish(ctx, sync);
    const GLenum answer = ctx.real->glClientWaitSync(sync, flags, timeout_ns);
    if (answer != GL_ALREADY_SIGNALED && answer != GL_CONDITION_SATISFIED) return answer;
    if (is_due) {
        see_complete(ctx, *fence);
        return answer;
    }
    if (timeout_ns == 0) return GL_TIMEOUT_EXPIRED;
    const StallScope stall(ctx);
    return ctx.clock.wait_for(fence->due, timeout_ns) ? GL_CONDITION_SATISFIED : GL_TIMEOUT_EXPIRED;
}

void get_synciv(Context& ctx, GLsync sync, GLenum pname, GLsizei count, GLsizei* length, GLint* values) {
    const auto fence = find(ctx, sync);
    const bool is_asked = fence && pname == GL_SYNC_STATUS && count > 0 && values != nullptr;
    const bool is_due = is_asked && (!is_held_here(ctx, *fence) || ctx.clock.poll(fence->due));
    if (is_due) let_driver_finish(ctx, sync);
    ctx.real->glGetSynciv(sync, pname, count, length, values);
    if (is_due) see_complete(ctx, *fence);
    if (is_asked && !is_due) *values = GL_UNSIGNALED;
}

void delete_sync(Context& ctx, GLsync sync) {
    {
        const std::lock_guard lock(ctx.share_group->mutex);
        ctx.share_group->fences.erase(sync);
    }
    ctx.real->glDeleteSync(sync);
}

}  // namespace glext_emu::features
