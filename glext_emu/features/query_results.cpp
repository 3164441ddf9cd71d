// SPDX-License-Identifier: MIT
// Results of query objects: seen when the clock says so, never before the driver has them.
#include "context/refusals.h"
#include "context/settings.h"
#include "features/features.h"
#include "features/list_recorder.h"
#include "features/stall.h"

#include <limits>

namespace glext_emu::features {
namespace {

// A result that goes into a query buffer is the driver's to write.
bool has_query_buffer_bound(Context& ctx) {
    if (!ctx.kind.has_query_buffer) return false;
    GLint buffer = 0;
    ctx.real->glGetIntegerv(GL_QUERY_BUFFER_BINDING, &buffer);
    return buffer != 0;
}

// ARB_occlusion_query, issues: a counter that overflows stays at 2^n-1.
template <class T>
void saturate(const QueryRecord& record, T& value) {
    const std::optional<int> bits = settings().device.counter_bits;
    if (!bits || record.target != GL_SAMPLES_PASSED || *bits >= std::numeric_limits<T>::digits) return;
    value = std::min(value, static_cast<T>((T{1} << *bits) - 1));
}

template <class T>
void get_query_object(Context& ctx, GLuint id, GLenum pname, T* params, void (*real)(GLuint, GLenum, T*)) {
    if (ctx.inside_begin_end) return real(id, pname, params);
    // Name zero raises what a name of nobody's raises.
    if (ctx.slot.is_hidden(id)) return real(0, pname, params);
    const auto found = ctx.slot.records.find(id);
    if (found == ctx.slot.records.end() || !found->second.has_ended || params == nullptr ||
        has_query_buffer_bound(ctx)) {
        return real(id, pname, params);
    }

    QueryRecord& record = found->second;
    switch (pname) {
        case GL_QUERY_RESULT_AVAILABLE:
            ctx.frame.polls++;
            if (ctx.clock.delays() && !ctx.clock.poll(record.due)) {
                *params = GL_FALSE;
                return;
            }
            // A deterministic clock does not depend on when the driver happens to be ready.
            if (ctx.clock.is_deterministic()) has_passed(ctx, id);
            real(id, pname, params);
            record.was_seen_available = *params != GL_FALSE;
            return;
        case GL_QUERY_RESULT: {
            std::optional<StallScope> stall;
            if (!record.was_seen_available) stall.emplace(ctx);
            real(id, pname, params);
            saturate(record, *params);
            ctx.clock.wait_until(record.due);
            record.was_seen_available = true;
            ctx.frame.results++;
            return;
        }
        case GL_QUERY_RESULT_NO_WAIT:
            ctx.frame.polls++;
            if (ctx.clock.delays() && !ctx.clock.poll(record.due)) return;
            if (ctx.clock.is_deterministic()) has_passed(ctx, id);
            real(id, pname, params);
            saturate(record, *params);
            return;
        default:
            return real(id, pname, params);
    }
}

// A name that the program may use; zero, which the driver refuses, for one of the layer's.
GLuint visible_name(const Context& ctx, GLuint id) {
    return ctx.slot.is_hidden(id) ? 0 : id;
}

}  // namespace

void get_query_objectiv(Context& ctx, GLuint id, GLenum pname, GLint* params) {
    get_query_object(ctx, id, pname, params, ctx.real->glGetQueryObjectiv);
}

void get_query_objectuiv(Context& ctx, GLuint id, GLenum pname, GLuint* params) {
    get_query_object(ctx, id, pname, params, ctx.real->glGetQueryObjectuiv);
}

void get_query_objecti64v(Context& ctx, GLuint id, GLenum pname, GLint64* params) {
    get_query_object(ctx, id, pname, params, ctx.real->glGetQueryObjecti64v);
}

void get_query_objectui64v(Context& ctx, GLuint id, GLenum pname, GLuint64* params) {
    get_query_object(ctx, id, pname, params, ctx.real->glGetQueryObjectui64v);
}

void get_query_buffer_objectiv(Context& ctx, GLuint id, GLuint buffer, GLenum pname, GLintptr offset) {
    ctx.real->glGetQueryBufferObjectiv(visible_name(ctx, id), buffer, pname, offset);
}

void get_query_buffer_objectuiv(Context& ctx, GLuint id, GLuint buffer, GLenum pname, GLintptr offset) {
    ctx.real->glGetQueryBufferObjectuiv(visible_name(ctx, id), buffer, pname, offset);
}

void get_query_buffer_objecti64v(Context& ctx, GLuint id, GLuint buffer, GLenum pname, GLintptr offset) {
    ctx.real->glGetQueryBufferObjecti64v(visible_name(ctx, id), buffer, pname, offset);
}

void get_query_buffer_objectui64v(Context& ctx, GLuint id, GLuint buffer, GLenum pname, GLintptr offset) {
    ctx.real->glGetQueryBufferObjectui64v(visible_name(ctx, id), buffer, pname, offset);
}

void begin_conditional_render(Context& ctx, GLuint id, GLenum mode) {
    if (refuses_conditional_render(ctx)) return ctx.raise(GL_INVALID_OPERATION);
    ctx.real->glBeginConditionalRender(visible_name(ctx, id), mode);
}

void begin_conditional_render_nvx(Context& ctx, GLuint id) {
    if (refuses_conditional_render(ctx)) return ctx.raise(GL_INVALID_OPERATION);
    ctx.real->glBeginConditionalRenderNVX(visible_name(ctx, id));
}

void end_conditional_render(Context& ctx) {
    if (refuses_conditional_render(ctx)) return ctx.raise(GL_INVALID_OPERATION);
    ctx.real->glEndConditionalRender();
}

}  // namespace glext_emu::features
