// SPDX-License-Identifier: MIT
#include "features/proposed_results.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <limits>
#include <optional>

#include "context/list_pause.h"
#include "context/refusals.h"
#include "features/features.h"
#include "features/stall.h"

namespace glext_emu::features {
namespace {

static_assert(sizeof(GLocclusionrecordEMU) == sizeof(occlusion_unit::Record));

// What a name stands for: nothing, where it is no name of a unit's result.
GLbitfield register_of(GLenum pname, GLbitfield armed) {
    switch (pname) {
        case GL_VISIBLE_EMU:
            return GL_VISIBLE_BIT_EMU;
        case GL_PROJECTED_HITS_EMU:
            return GL_PROJECTED_HITS_BIT_EMU;
        case GL_VISIBLE_HITS_EMU:
            return GL_VISIBLE_HITS_BIT_EMU;
        case GL_NEAREST_DEPTH_EMU:
            return GL_NEAREST_DEPTH_BIT_EMU;
        case GL_SCREEN_BOX_EMU:
            return GL_SCREEN_BOX_BIT_EMU;
        case GL_QUERY_RESULT:
        case GL_QUERY_RESULT_NO_WAIT:
            return (armed & GL_VISIBLE_HITS_BIT_EMU) != 0 ? GL_VISIBLE_HITS_BIT_EMU : GL_VISIBLE_BIT_EMU;
        default:
            return 0;
    }
}

// GL 4.6, 4.2.3: what does not fit is returned as the nearest value that does.
template <class T>
T nearest(std::uint64_t value) {
    return static_cast<T>(std::min<std::uint64_t>(value, std::numeric_limits<T>::max()));
}

bool is_available(Context& ctx, ProposedQuery& query) {
    ctx.frame.polls++;
    const ListPause pause(ctx);
    if (ctx.clock.delays() && !ctx.clock.poll(query.due)) return false;
    // A deterministic clock does not depend on when the driver happens to be ready.
    if (ctx.clock.is_deterministic()) drain_records(ctx, query);
    query.was_seen_available = query.pending == nullptr || query.pending->is_ready(ctx);
    return query.was_seen_available;
}

void wait_for(Context& ctx, ProposedQuery& query) {
    const ListPause pause(ctx);  // what reads the marks may draw
    std::optional<StallScope> stall;
    if (!query.was_seen_available) stall.emplace(ctx);
    drain_records(ctx, query);
    ctx.clock.wait_until(query.due);
    query.was_seen_available = true;
    ctx.frame.results++;
}

template <class T>
void write_register(const occlusion_unit::Record& record, GLbitfield wanted, T* params) {
    switch (wanted) {
        case GL_VISIBLE_BIT_EMU:
            *params = static_cast<T>(record.visible);
            return;
        case GL_PROJECTED_HITS_BIT_EMU:
            *params = nearest<T>(record.projected_hits);
            return;
        case GL_VISIBLE_HITS_BIT_EMU:
            *params = nearest<T>(record.visible_hits);
            return;
        case GL_NEAREST_DEPTH_BIT_EMU:
            *params = static_cast<T>(std::bit_cast<std::uint32_t>(record.nearest_depth));
            return;
        default:
            params[0] = static_cast<T>(record.box.left);
            params[1] = static_cast<T>(record.box.bottom);
            params[2] = static_cast<T>(record.box.right);
            params[3] = static_cast<T>(record.box.top);
    }
}

template <class T>
void get_region(Context& ctx, ProposedQuery& query, T* params) {
    wait_for(ctx, query);
    *params = static_cast<T>(query.word);
}

template <class T>
void get_unit(Context& ctx, ProposedQuery& query, GLbitfield wanted, T* params) {
    if ((wanted & query.armed) == 0) return ctx.raise(GL_INVALID_OPERATION);
    wait_for(ctx, query);
    if (query.records.empty()) return ctx.raise(GL_INVALID_OPERATION);
    const occlusion_unit::Record& first = query.records.front();
    if ((wanted & first.registers) == 0) return ctx.raise(GL_INVALID_OPERATION);
    write_register(first, wanted, params);
}

template <class T>
void get_result(Context& ctx, GLuint id, GLenum pname, T* params) {
    GLint bound = 0;
    if (ctx.kind.has_query_buffer) ctx.real->glGetIntegerv(GL_QUERY_BUFFER_BINDING, &bound);
    ProposedQuery& query = ctx.proposed.objects.at(id);
    const bool is_unit = query.target == GL_OCCLUSION_UNIT_EMU;
    const GLbitfield wanted = register_of(pname, query.armed);
    if (pname == GL_QUERY_RESULT_NO_WAIT && (refuses_query_buffers(ctx) || !ctx.kind.has_query_buffer)) {
        return ctx.raise(GL_INVALID_ENUM);
    }
    const bool is_name_of_units = wanted != 0 || pname == GL_RECORD_COUNT_EMU || pname == GL_REGISTERS_EMU;
    const bool is_name = pname == GL_QUERY_RESULT_AVAILABLE || pname == GL_QUERY_TARGET ||
                         pname == GL_QUERY_RESULT || pname == GL_QUERY_RESULT_NO_WAIT ||
                         (is_unit && is_name_of_units);
    if (!is_name) return ctx.raise(GL_INVALID_ENUM);
    if (bound != 0 || !query.has_ended) return ctx.raise(GL_INVALID_OPERATION);
    if (params == nullptr) return;

    switch (pname) {
        case GL_QUERY_RESULT_AVAILABLE:
            *params = is_available(ctx, query) ? T{GL_TRUE} : T{GL_FALSE};
            return;
        case GL_QUERY_TARGET:
            *params = static_cast<T>(query.target);
            return;
        case GL_RECORD_COUNT_EMU:
            *params = static_cast<T>(query.record_count);
            return;
        case GL_REGISTERS_EMU:
            wait_for(ctx, query);
            *params = query.records.empty() ? T{} : static_cast<T>(query.records.front().registers);
            return;
        case GL_QUERY_RESULT_NO_WAIT:
            if (!is_available(ctx, query)) return;
            break;
        default:
            break;
    }
    if (!is_unit) return get_region(ctx, query, params);
    get_unit(ctx, query, wanted, params);
}

}  // namespace

void get_proposed_result(Context& ctx, GLuint id, GLenum pname, GLint* params) {
    get_result(ctx, id, pname, params);
}

void get_proposed_result(Context& ctx, GLuint id, GLenum pname, GLuint* params) {
    get_result(ctx, id, pname, params);
}

void get_proposed_result(Context& ctx, GLuint id, GLenum pname, GLint64* params) {
    get_result(ctx, id, pname, params);
}

void get_proposed_result(Context& ctx, GLuint id, GLenum pname, GLuint64* params) {
    get_result(ctx, id, pname, params);
}

// Every record of the call is there, or none is written.
void get_occlusion_records_emu(Context& ctx, GLuint id, GLsizei first, GLsizei count,
                               GLocclusionrecordEMU* records) {
    const auto found = ctx.proposed.objects.find(id);
    const bool is_units =
        found != ctx.proposed.objects.end() && found->second.target == GL_OCCLUSION_UNIT_EMU;
    if (!is_units || !found->second.has_ended) return ctx.raise(GL_INVALID_OPERATION);
    ProposedQuery& query = found->second;
    if (first < 0 || count < 0 || first > query.record_count || count > query.record_count - first) {
        return ctx.raise(GL_INVALID_VALUE);
    }
    if (count == 0 || records == nullptr) return;
    wait_for(ctx, query);
    std::memcpy(records, query.records.data() + first,
                static_cast<std::size_t>(count) * sizeof(GLocclusionrecordEMU));
}

}  // namespace glext_emu::features
