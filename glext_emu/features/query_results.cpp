// SPDX-License-Identifier: MIT
// Results of query objects: seen when the clock says so, never before the driver has them.
#include "context/refusals.h"
#include "context/settings.h"
#include "features/features.h"
#include "features/proposed_results.h"
#include "features/query_buffers.h"
#include "features/stall.h"

#include <algorithm>
#include <limits>

namespace glext_emu::features {
namespace {

GLuint bound_query_buffer(Context& ctx) {
    GLint buffer = 0;
    if (ctx.kind.has_query_buffer) ctx.real->glGetIntegerv(GL_QUERY_BUFFER_BINDING, &buffer);
    return static_cast<GLuint>(buffer);
}

// True where the program sees what the driver has counted.
bool is_the_drivers(const QueryRecord& record) {
    if (is_timer(record.target)) return false;  // they are known under the device's clock only
    const bool is_counter = record.target == GL_SAMPLES_PASSED;
    return record.is_as_counted() && !(is_counter && settings().device.counter_bits);
}

// GL 4.6, 4.2.3: what does not fit is returned as the nearest value that does.
template <class T>
T nearest(std::uint64_t value) {
    return static_cast<T>(std::min<std::uint64_t>(value, std::numeric_limits<T>::max()));
}

// What the counter of the machine shows.
template <class T>
T seen_count(Context& ctx, const QueryRecord& record, GLuint id) {
    if (is_timer(record.target)) return nearest<T>(device_nanoseconds(ctx, record));
    std::uint64_t count = record.earlier + record.samples_per_count * driver_count(ctx, id);
    // ARB_occlusion_query, issues: a counter that overflows stays at 2^n-1.
    if (record.target != GL_SAMPLES_PASSED) return nearest<T>(std::min<std::uint64_t>(count, 1));
    return nearest<T>(narrowed_count(ctx, count, settings().device.counter_bits.value_or(64)));
}

// <write> makes the driver write <pname> to <offset> of <buffer>.
template <class T, class Write>
void write_to_buffer(Context& ctx, GLuint id, QueryRecord& record, GLenum pname, GLuint buffer,
                     GLintptr offset, Write write) {
    if (!can_correct(ctx, buffer)) {
        // GL 4.6, 6.3.1: commands that write to a mapped buffer may refuse it.
        if (ctx.follows_text && is_mapped(ctx, buffer)) return ctx.raise(GL_INVALID_OPERATION);
        wait_in_pipe(ctx, record.due);
        return write();
    }
    const auto accepts = [&] { return driver_accepts(ctx, write); };
    switch (pname) {
        case GL_QUERY_RESULT_AVAILABLE: {
            ctx.frame.polls++;
            const bool is_due = !ctx.clock.delays() || poll_in_pipe(ctx, record.due);
            if (is_due && ctx.clock.is_deterministic()) has_passed(ctx, id);
            if (accepts() && !is_due) put_in_buffer(ctx, buffer, offset, T{GL_FALSE});
            return;
        }
        case GL_QUERY_RESULT: {
            // The machine's pipeline is in order: whoever reads the buffer gets the result, so it is waited
            // for.
            const StallScope stall(ctx);
            wait_in_pipe(ctx, record.due);
            if (accepts() && !is_the_drivers(record)) {
                put_in_buffer(ctx, buffer, offset, seen_count<T>(ctx, record, id));
            }
            record.was_seen_available = true;
            ctx.frame.results++;
            return;
        }
        case GL_QUERY_RESULT_NO_WAIT: {
            ctx.frame.polls++;
            if (ctx.clock.delays() && !poll_in_pipe(ctx, record.due)) {
                // The call is judged, and leaves nothing.
                const auto before = taken_from_buffer<T>(ctx, buffer, offset);
                if (accepts() && before) put_in_buffer(ctx, buffer, offset, *before);
                return;
            }
            if (ctx.clock.is_deterministic() || !is_the_drivers(record)) has_passed(ctx, id);
            if (accepts() && !is_the_drivers(record)) {
                put_in_buffer(ctx, buffer, offset, seen_count<T>(ctx, record, id));
            }
            return;
        }
        case GL_QUERY_TARGET:
            if (accepts() && record.target != real_target(ctx, record.target)) {
                put_in_buffer(ctx, buffer, offset, static_cast<T>(record.target));
            }
            return;
        default:
            return write();
    }
}

// To client memory. <ask> makes the driver say <pname>.
template <class T, class Ask>
void write_to_client(Context& ctx, GLuint id, QueryRecord& record, GLenum pname, T* params, Ask ask) {
    switch (pname) {
        case GL_QUERY_RESULT_AVAILABLE:
            ctx.frame.polls++;
            if (ctx.clock.delays() && !ctx.clock.poll(record.due)) {
                *params = GL_FALSE;
                return;
            }
            // A deterministic clock does not depend on when the driver happens to be ready.
            if (ctx.clock.is_deterministic()) has_passed(ctx, id);
            ask(params);
            record.was_seen_available = *params != GL_FALSE;
            return;
        case GL_QUERY_RESULT: {
            std::optional<StallScope> stall;
            if (!record.was_seen_available) stall.emplace(ctx);
            if (is_the_drivers(record)) {
                ask(params);
            } else {
                *params = seen_count<T>(ctx, record, id);
            }
            ctx.clock.wait_until(record.due);
            record.was_seen_available = true;
            ctx.frame.results++;
            return;
        }
        case GL_QUERY_RESULT_NO_WAIT:
            ctx.frame.polls++;
            if (ctx.clock.delays() && !ctx.clock.poll(record.due)) return;
            if (ctx.clock.is_deterministic()) has_passed(ctx, id);
            if (is_the_drivers(record)) {
                ask(params);
            } else if (is_driver_ready(ctx, id)) {
                *params = seen_count<T>(ctx, record, id);
            }
            return;
        case GL_QUERY_TARGET:
            ask(params);
            if (record.target != real_target(ctx, record.target)) *params = static_cast<T>(record.target);
            return;
        default:
            return ask(params);
    }
}

template <class T>
void get_query_object(Context& ctx, GLuint id, GLenum pname, T* params, void (*real)(GLuint, GLenum, T*)) {
    if (pname == GL_QUERY_RESULT_NO_WAIT && refuses_query_buffers(ctx)) return ctx.raise(GL_INVALID_ENUM);
    if (pname == GL_QUERY_RESULT_NO_WAIT && !ctx.kind.has_query_buffer) return real(id, pname, params);
    if (ctx.proposed.is_object(id)) return get_proposed_result(ctx, id, pname, params);
    // Name zero raises what a name of nobody's raises.
    if (ctx.slot.is_hidden(id) || ctx.slot.is_doomed(id)) return real(0, pname, params);
    const auto found = ctx.slot.records.find(id);
    if (found == ctx.slot.records.end() || !found->second.has_ended) return real(id, pname, params);
    QueryRecord& record = found->second;
    if (const GLuint buffer = bound_query_buffer(ctx); buffer != 0) {
        return write_to_buffer<T>(ctx, id, record, pname, buffer, reinterpret_cast<GLintptr>(params),
                                  [&] { real(id, pname, params); });
    }
    if (params == nullptr) return real(id, pname, params);
    write_to_client(ctx, id, record, pname, params, [&](T* to) { real(id, pname, to); });
    if (pname == GL_QUERY_RESULT) settle_probe(ctx, id);
}

// NV_occlusion_query: to client memory, whatever query buffer is bound.
template <class T>
void read_count_as(Context& ctx, GLuint id, GLenum pname, T* params) {
    const auto ask = [&](T* to) {
        *to = pname == GL_QUERY_RESULT_AVAILABLE ? T{is_driver_ready(ctx, id)}
                                                 : nearest<T>(driver_count(ctx, id));
    };
    write_to_client(ctx, id, ctx.slot.records.at(id), pname, params, ask);
    if (pname == GL_QUERY_RESULT) settle_probe(ctx, id);
}

// ARB_direct_state_access: the same into any buffer.
template <class T>
void get_query_buffer_object(Context& ctx, GLuint id, GLuint buffer, GLenum pname, GLintptr offset,
                             void (*real)(GLuint, GLuint, GLenum, GLintptr)) {
    if (ctx.proposed.is_object(id)) return ctx.raise(GL_INVALID_OPERATION);
    if (ctx.slot.is_hidden(id) || ctx.slot.is_doomed(id)) return real(0, buffer, pname, offset);
    const auto found = ctx.slot.records.find(id);
    const bool is_judged_only = found == ctx.slot.records.end() || !found->second.has_ended ||
                                ctx.real->glIsBuffer(buffer) == GL_FALSE || offset < 0;
    if (is_judged_only) return real(id, buffer, pname, offset);
    write_to_buffer<T>(ctx, id, found->second, pname, buffer, offset,
                       [&] { real(id, buffer, pname, offset); });
}

}  // namespace

void read_count(Context& ctx, GLuint id, GLenum pname, GLint* params) {
    read_count_as(ctx, id, pname, params);
}

void read_count(Context& ctx, GLuint id, GLenum pname, GLuint* params) {
    read_count_as(ctx, id, pname, params);
}

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
    get_query_buffer_object<GLint>(ctx, id, buffer, pname, offset, ctx.real->glGetQueryBufferObjectiv);
}

void get_query_buffer_objectuiv(Context& ctx, GLuint id, GLuint buffer, GLenum pname, GLintptr offset) {
    get_query_buffer_object<GLuint>(ctx, id, buffer, pname, offset, ctx.real->glGetQueryBufferObjectuiv);
}

void get_query_buffer_objecti64v(Context& ctx, GLuint id, GLuint buffer, GLenum pname, GLintptr offset) {
    get_query_buffer_object<GLint64>(ctx, id, buffer, pname, offset, ctx.real->glGetQueryBufferObjecti64v);
}

void get_query_buffer_objectui64v(Context& ctx, GLuint id, GLuint buffer, GLenum pname, GLintptr offset) {
    get_query_buffer_object<GLuint64>(ctx, id, buffer, pname, offset, ctx.real->glGetQueryBufferObjectui64v);
}

}  // namespace glext_emu::features
