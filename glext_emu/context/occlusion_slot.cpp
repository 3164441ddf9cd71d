// SPDX-License-Identifier: MIT
#include "context/occlusion_slot.h"

#include <algorithm>
#include <utility>

#include "context/context.h"
#include "context/list_pause.h"

namespace glext_emu {
namespace {

// A program that never reads the flag keeps at most this many hidden queries.
constexpr std::size_t kMostUnread = 64;

GLenum segment_target(const Context& ctx) {
    return ctx.kind.has_any_samples ? GL_ANY_SAMPLES_PASSED : GL_SAMPLES_PASSED;
}

GLuint take_name(Context& ctx, std::vector<GLuint>& spare) {
    GLuint name = 0;
    if (spare.empty()) {
        ctx.real->glGenQueries(1, &name);
    } else {
        name = spare.back();
        spare.pop_back();
    }
    return name;
}

// Folds the hidden queries that have ended into the flag.
void fold_segments(Context& ctx) {
    OcclusionSlot& slot = ctx.slot;
    for (const GLuint segment : slot.unread_segments) {
        slot.flag = slot.flag || has_passed(ctx, segment);
        slot.spare.push_back(segment);
    }
    slot.unread_segments.clear();
}

// With a query buffer bound, the driver would take a pointer for an offset into it. Binding another for a
// moment is not the same: where another context has deleted it, its name could not be bound again.
std::uint64_t value_by_buffer(Context& ctx, GLuint query, GLenum pname) {
    GLuint scratch = 0;
    GLuint64 value = 0;
    ctx.real->glCreateBuffers(1, &scratch);
    ctx.real->glNamedBufferData(scratch, sizeof value, nullptr, GL_STREAM_READ);
    ctx.real->glGetQueryBufferObjectui64v(query, scratch, pname, 0);
    ctx.real->glGetNamedBufferSubData(scratch, 0, sizeof value, &value);
    ctx.real->glDeleteBuffers(1, &scratch);
    return value;
}

std::uint64_t driver_value(Context& ctx, GLuint query, GLenum pname) {
    const OwnCalls own(ctx);
    GLint buffer = 0;
    if (ctx.kind.has_query_buffer) ctx.real->glGetIntegerv(GL_QUERY_BUFFER_BINDING, &buffer);
    if (buffer != 0 && ctx.kind.has_named_buffers) return value_by_buffer(ctx, query, pname);
    if (buffer != 0) ctx.real->glBindBuffer(GL_QUERY_BUFFER, 0);
    GLuint64 value = 0;
    if (ctx.kind.has_64_bit_results) {
        ctx.real->glGetQueryObjectui64v(query, pname, &value);
    } else {
        GLuint narrow = 0;
        ctx.real->glGetQueryObjectuiv(query, pname, &narrow);
        value = narrow;
    }
    if (buffer != 0) ctx.real->glBindBuffer(GL_QUERY_BUFFER, static_cast<GLuint>(buffer));
    return value;
}

}  // namespace

bool is_occlusion_target(GLenum target) {
    return target == GL_SAMPLES_PASSED || target == GL_ANY_SAMPLES_PASSED ||
           target == GL_ANY_SAMPLES_PASSED_CONSERVATIVE;
}

GLenum real_target(const Context& ctx, GLenum target) {
    const bool is_either = ctx.follows_text && !ctx.kind.is_es;
    return is_either && target == GL_ANY_SAMPLES_PASSED_CONSERVATIVE ? GL_ANY_SAMPLES_PASSED : target;
}

bool has_passed(Context& ctx, GLuint query) {
    return driver_count(ctx, query) != 0;
}

std::uint64_t driver_count(Context& ctx, GLuint query) {
    return driver_value(ctx, query, GL_QUERY_RESULT);
}

bool is_driver_ready(Context& ctx, GLuint query) {
    return driver_value(ctx, query, GL_QUERY_RESULT_AVAILABLE) != 0;
}

bool OcclusionSlot::is_hidden(GLuint name) const {
    return name != 0 &&
           (name == open_segment || std::ranges::find(unread_segments, name) != unread_segments.end() ||
            std::ranges::find(spare, name) != spare.end() ||
            std::ranges::find(lent_counters, name) != lent_counters.end() ||
            std::ranges::find(spare_counters, name) != spare_counters.end() ||
            (work_counters != nullptr && work_counters->owns(name)));
}

bool OcclusionSlot::is_doomed(GLuint name) const {
    return name != 0 && std::ranges::find(doomed, name) != doomed.end();
}

GLuint take_counter(Context& ctx) {
    const GLuint name = take_name(ctx, ctx.slot.spare_counters);
    ctx.slot.lent_counters.push_back(name);
    return name;
}

void give_back_counter(Context& ctx, GLuint query) {
    std::erase(ctx.slot.lent_counters, query);
    ctx.slot.spare_counters.push_back(query);
}

void open_segment(Context& ctx) {
    OcclusionSlot& slot = ctx.slot;
    const OwnCalls own(ctx);
    if (slot.unread_segments.size() == kMostUnread) fold_segments(ctx);
    // A pipe counts fragments; the flag is content with whether there are any.
    const bool is_counted = slot.counters != 0;
    slot.open_target = is_counted ? GL_SAMPLES_PASSED : segment_target(ctx);
    const GLuint name = is_counted ? take_counter(ctx) : take_name(ctx, slot.spare);
    need_pixels("an occlusion test");
    if (ctx.time != nullptr) ctx.time->begin_query();
    ctx.real->glBeginQuery(slot.open_target, name);
    slot.open_segment = name;
    ctx.frame.queries_begun++;
    ctx.update_hot();
}

void close_segment(Context& ctx) {
    OcclusionSlot& slot = ctx.slot;
    if (slot.open_segment == 0) return;
    const OwnCalls own(ctx);
    ctx.real->glEndQuery(slot.open_target);
    const GLuint ended = std::exchange(slot.open_segment, 0u);
    if (slot.counters == 0) {
        slot.unread_segments.push_back(ended);
    } else {
        slot.flag = (slot.test_enabled && has_passed(ctx, ended)) || slot.flag;
        slot.pipe->add(ctx, ended, slot.counters, slot.samples_per_fragment);
    }
    slot.flag_due = ctx.clock.due();
    ctx.update_hot();
}

void set_samples_per_fragment(Context& ctx, GLuint samples) {
    OcclusionSlot& slot = ctx.slot;
    if (samples == slot.samples_per_fragment) return;
    const ListPause pause(ctx);
    const bool was_open = slot.open_segment != 0;
    close_segment(ctx);
    slot.samples_per_fragment = samples;
    if (was_open) open_segment(ctx);
}

bool is_counter_taken(const Context& ctx) {
    return ctx.slot.app_query != 0 || ctx.slot.pipe != nullptr || ctx.proposed.active_unit != 0;
}

bool take_flag(Context& ctx) {
    OcclusionSlot& slot = ctx.slot;
    close_segment(ctx);
    if (slot.app_query != 0) {
        // NV_occlusion_query 6.1.13: with the result the pixel counter is reset, so the program's query
        // starts anew.
        const OwnCalls own(ctx);
        const GLenum target = real_target(ctx, slot.app_target);
        ctx.real->glEndQuery(target);
        slot.flag = has_passed(ctx, slot.app_query) || slot.flag;
        ctx.real->glBeginQuery(target, slot.app_query);
        slot.records[slot.app_query].earlier = 0;
        slot.flag_due = ctx.clock.due();
    }
    if (slot.ended_app_query != 0) {
        slot.flag = has_passed(ctx, slot.ended_app_query) || slot.flag;
        slot.ended_app_query = 0;
    }
    fold_segments(ctx);
    return std::exchange(slot.flag, false);
}

void reset_flag(Context& ctx) {
    OcclusionSlot& slot = ctx.slot;
    slot.spare.insert(slot.spare.end(), slot.unread_segments.begin(), slot.unread_segments.end());
    slot.unread_segments.clear();
    slot.ended_app_query = 0;
    slot.flag = false;
}

// The driver's count so far goes to the record, and the driver stops counting.
CountPause::CountPause(Context& ctx) : ctx_(ctx) {
    OcclusionSlot& slot = ctx.slot;
    close_segment(ctx);
    if (slot.app_query == 0) return;
    const OwnCalls own(ctx);
    QueryRecord& record = slot.records[slot.app_query];
    ctx.real->glEndQuery(real_target(ctx, slot.app_target));
    record.earlier += record.samples_per_count * driver_count(ctx, slot.app_query);
    slot.flag = slot.flag || (ctx.emulates_test && record.earlier != 0);
}

CountPause::~CountPause() {
    if (ctx_.slot.app_query == 0) return;
    const OwnCalls own(ctx_);
    ctx_.real->glBeginQuery(real_target(ctx_, ctx_.slot.app_target), ctx_.slot.app_query);
}

void set_samples_per_count(Context& ctx, GLuint samples) {
    OcclusionSlot& slot = ctx.slot;
    QueryRecord& record = slot.records[slot.app_query];
    const bool counts_already = record.has_drawn;
    record.has_drawn = true;
    if (samples == record.samples_per_count) return;
    if (counts_already) {
        const ListPause pause(ctx);
        const CountPause cut(ctx);
    }
    record.samples_per_count = samples;
}

bool is_object(Context& ctx, GLuint name) {
    if (ctx.proposed.is_object(name)) return true;
    return !ctx.slot.is_hidden(name) && !ctx.slot.is_doomed(name) && ctx.real->glIsQuery(name) != GL_FALSE;
}

void delete_doomed(Context& ctx) {
    OcclusionSlot& slot = ctx.slot;
    std::erase_if(slot.doomed, [&](GLuint name) {
        if (name == slot.app_query || name == ctx.conditional.query) return false;
        // What counts towards the HP flag is read before its object goes.
        if (name == slot.ended_app_query) {
            slot.flag = has_passed(ctx, name) || slot.flag;
            slot.ended_app_query = 0;
        }
        settle_probe(ctx, name);
        slot.records.erase(name);
        const OwnCalls own(ctx);
        ctx.real->glDeleteQueries(1, &name);
        return true;
    });
}

void yield_name(Context& ctx, GLuint name) {
    OcclusionSlot& slot = ctx.slot;
    if (!slot.is_hidden(name)) return;
    if (name == slot.open_segment) close_segment(ctx);
    if (ctx.time != nullptr && ctx.time->counters().owns(name)) {
        ctx.time->settle();
        return ctx.time->counters().forget(ctx, name);
    }
    fold_segments(ctx);
    ctx.instruments.pipe.settle(ctx);
    ctx.visibility.pipe.settle(ctx);
    drain_all_records(ctx);
    std::erase(slot.spare, name);
    std::erase(slot.spare_counters, name);
    const OwnCalls own(ctx);
    ctx.real->glDeleteQueries(1, &name);
}

}  // namespace glext_emu
