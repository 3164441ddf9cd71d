// SPDX-License-Identifier: MIT
// GL_NV_occlusion_query: the counting query of 2001. Its objects are query objects on SAMPLES_PASSED, of one
// name space with ARB_occlusion_query's (docs/decisions/0005-nv-occlusion-query.md); what the two texts have
// different is here.
#include "context/settings.h"
#include "features/features.h"
#include "features/list_recorder.h"

namespace glext_emu::features {
namespace {

// Errors: INVALID_OPERATION "if GenOcclusionQueriesNV or DeleteOcclusionQueriesNV is called when an occlusion
// query is active".
bool refuses_names(Context& ctx, GLsizei n) {
    if (n < 0) {
        ctx.raise(GL_INVALID_VALUE);
    } else if (ctx.slot.app_query != 0) {
        ctx.raise(GL_INVALID_OPERATION);
    } else {
        return false;
    }
    return true;
}

// Errors: INVALID_OPERATION "if GetOcclusionQueryivNV or GetOcclusionQueryuivNV is called where id is not the
// name of an occlusion query", or of the active one.
bool has_count(Context& ctx, GLuint id) {
    const auto found = ctx.slot.records.find(id);
    return found != ctx.slot.records.end() && found->second.has_ended && is_object(ctx, id);
}

template <class T>
void get_occlusion_query(Context& ctx, GLuint id, GLenum pname, T* params) {
    if (pname != GL_PIXEL_COUNT_NV && pname != GL_PIXEL_COUNT_AVAILABLE_NV) return ctx.raise(GL_INVALID_ENUM);
    if (!has_count(ctx, id)) return ctx.raise(GL_INVALID_OPERATION);
    if (params != nullptr) read_count(ctx, id, pname, params);
}

}  // namespace

void gen_occlusion_queries_nv(Context& ctx, GLsizei n, GLuint* ids) {
    if (refuses_names(ctx, n)) return;
    ctx.real->glGenQueries(n, ids);
}

void delete_occlusion_queries_nv(Context& ctx, GLsizei n, const GLuint* ids) {
    if (refuses_names(ctx, n)) return;
    delete_queries(ctx, n, ids);
}

GLboolean is_occlusion_query_nv(Context& ctx, GLuint id) {
    return is_query(ctx, id);
}

void begin_occlusion_query_nv(Context& ctx, GLuint id) {
    if (ctx.recording.is_open()) {
        return record(
            ctx, {[](Context& c, const ListOperation& op) { begin_occlusion_query_nv(c, op.first); }, id});
    }
    // Errors: INVALID_OPERATION "if BeginOcclusionQueryNV is called when an occlusion query is already
    // active".
    if (ctx.slot.app_query != 0) return ctx.raise(GL_INVALID_OPERATION);
    start_query(ctx, GL_SAMPLES_PASSED, id);
}

void end_occlusion_query_nv(Context& ctx) {
    if (ctx.recording.is_open()) {
        return record(ctx, {[](Context& c, const ListOperation&) { end_occlusion_query_nv(c); }});
    }
    if (!ctx.slot.counts_samples()) return ctx.raise(GL_INVALID_OPERATION);
    finish_query(ctx, GL_SAMPLES_PASSED);
}

void get_occlusion_queryiv_nv(Context& ctx, GLuint id, GLenum pname, GLint* params) {
    get_occlusion_query(ctx, id, pname, params);
}

void get_occlusion_queryuiv_nv(Context& ctx, GLuint id, GLenum pname, GLuint* params) {
    get_occlusion_query(ctx, id, pname, params);
}

GLint counter_bits(Context& ctx) {
    if (const std::optional<int> bits = settings().device.counter_bits) return *bits;
    GLint bits = 0;
    ctx.real->glGetQueryiv(GL_SAMPLES_PASSED, GL_QUERY_COUNTER_BITS, &bits);
    return bits;
}

}  // namespace glext_emu::features
