// SPDX-License-Identifier: MIT
#include "context/context.h"

#include "context/settings.h"

namespace glext_emu {

RealGl default_real{};
thread_local constinit Current current{0, &default_real, nullptr};

Context& enter() {
    Context& ctx = *current.context;
    ctx.clock.count_call();
    if (ctx.share_group->has_seen_complete) [[unlikely]]
        ctx.catch_up();
    return ctx;
}

namespace {

int next_number() {
    static std::atomic<int> contexts{0};
    return ++contexts;
}

std::unique_ptr<DeviceTime> make_time(Context& ctx) {
    return settings().latency.kind == occlusion_unit::ClockKind::kDevice ? std::make_unique<DeviceTime>(ctx)
                                                                         : nullptr;
}

}  // namespace

Context::Context(const char* platform_name, const RealGl* real_gl, std::shared_ptr<ShareGroup> group)
    : platform(platform_name),
      real(real_gl),
      number(next_number()),
      share_group(std::move(group)),
      time(make_time(*this)),
      clock(settings().latency, time.get()) {
}

void Context::update_hot() {
    hot = always_hot;
    if (pending_error != GL_NO_ERROR) hot |= kHotError;
    if (slot.wants_segment()) hot |= kHotDraw | kHotPixels;
    if (follows_text && slot.counts_samples()) hot |= kHotDraw;
    if ((slot.counters & kDepthPassCounter) != 0) hot |= kHotDraw;  // MULTISAMPLE
    if (instruments.pipe.has_reading()) hot |= kHotSync;            // Finish
    if (follows_text && (slot.app_query != 0 || slot.open_segment != 0)) hot |= kHotPixels;
    if (proposed.run != nullptr || (repeats_draws && recording.name != 0)) hot |= kHotDraw | kHotPixels;
    if (recording.name != 0) hot |= kHotGet;                                  // LIST_INDEX
    if (recording.name != 0 && follows_text) hot |= kHotEnable | kHotAttrib;  // MULTISAMPLE
    // Where nobody asks for them, Begin and End cost nothing.
    const bool has_own_lists = recording.name != 0 || share_group->has_own_lists;
    if (inside_begin_end || (hot & kHotDraw) != 0 || (records_operations && has_own_lists))
        hot |= kHotImmediate;
    tracks_begin_end = (hot & kHotImmediate) != 0;
    if (current.context == this) current.hot = hot;
}

void Context::raise(GLenum code) {
    if (kind.is_no_error) return;
    keep_error();
    if (pending_error == GL_NO_ERROR) pending_error = code;
    update_hot();
}

void Context::keep_error() {
    const GLenum error = real->glGetError();
    if (pending_error == GL_NO_ERROR) pending_error = error;
}

void Context::set_inside_begin_end(bool is_inside) {
    inside_begin_end = is_inside;
    update_hot();
}

// A Begin may fail for many reasons, and nothing tells but that a Get is answered.
bool Context::confirm_begin_end() {
    if (collected_primitive != 0) return true;  // the driver compiles it, and answers
    GLint nesting = -1;
    real->glGetIntegerv(GL_MAX_LIST_NESTING, &nesting);
    const bool is_inside = nesting < 0;
    if (tracks_begin_end && !is_inside) set_inside_begin_end(false);
    return is_inside;
}

void Context::catch_up() {
    const std::lock_guard lock(share_group->mutex);
    const auto seen = share_group->seen_complete.find(number);
    if (seen == share_group->seen_complete.end()) return;
    clock.wait_until(seen->second);
    share_group->seen_complete.erase(seen);
    share_group->has_seen_complete = !share_group->seen_complete.empty();
}

OwnCalls::OwnCalls(Context& ctx) : ctx_(ctx) {
    if (ctx_.own_calls++ == 0) ctx_.keep_error();
}

OwnCalls::~OwnCalls() {
    if (--ctx_.own_calls != 0) return;
    // A lost context repeats its error for ever.
    for (int i = 0; i < 8 && ctx_.real->glGetError() != GL_NO_ERROR; ++i) {
    }
    if (ctx_.pending_error != GL_NO_ERROR) ctx_.update_hot();
}

}  // namespace glext_emu
