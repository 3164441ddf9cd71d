// SPDX-License-Identifier: MIT
#include "context/repetition.h"

#include <algorithm>
#include <vector>

#include "context/unit_run.h"

namespace glext_emu {
namespace {

GLint get(Context& ctx, GLenum name) {
    GLint value = 0;
    ctx.real->glGetIntegerv(name, &value);
    return value;
}

GLint resources(Context& ctx, GLuint program, GLenum interface) {
    GLint count = 0;
    ctx.real->glGetProgramInterfaceiv(program, interface, GL_ACTIVE_RESOURCES, &count);
    return count;
}

bool has_bound_image(Context& ctx) {
    const GLint units = get(ctx, GL_MAX_IMAGE_UNITS);
    for (GLint i = 0; i < units; ++i) {
        GLint name = 0;
        ctx.real->glGetIntegeri_v(GL_IMAGE_BINDING_NAME, static_cast<GLuint>(i), &name);
        if (name != 0) return true;
    }
    return false;
}

// GL 4.6, table 7.3: the types of image uniforms are numbered in one piece.
bool is_image(GLint type) {
    return type >= GL_IMAGE_1D && type <= GL_UNSIGNED_INT_IMAGE_2D_MULTISAMPLE_ARRAY;
}

bool has_image_uniform(Context& ctx, GLuint program) {
    const GLint uniforms = resources(ctx, program, GL_UNIFORM);
    for (GLint i = 0; i < uniforms; ++i) {
        constexpr GLenum kType = GL_TYPE;
        GLint type = 0;
        ctx.real->glGetProgramResourceiv(program, GL_UNIFORM, static_cast<GLuint>(i), 1, &kType, 1, nullptr,
                                         &type);
        if (is_image(type)) return true;
    }
    return false;
}

bool writes_memory(Context& ctx, GLuint program) {
    if (program == 0) return false;
    return resources(ctx, program, GL_SHADER_STORAGE_BLOCK) != 0 ||
           resources(ctx, program, GL_ATOMIC_COUNTER_BUFFER) != 0 ||
           (has_bound_image(ctx) && has_image_uniform(ctx, program));
}

// The programs that a draw runs.
std::vector<GLuint> programs(Context& ctx) {
    if (const GLint program = get(ctx, GL_CURRENT_PROGRAM); program != 0)
        return {static_cast<GLuint>(program)};
    const GLint pipeline = ctx.kind.version >= GlVersion{4, 1} ? get(ctx, GL_PROGRAM_PIPELINE_BINDING) : 0;
    if (pipeline == 0) return {};
    std::vector<GLuint> found;
    for (const GLenum stage : {GL_VERTEX_SHADER, GL_TESS_CONTROL_SHADER, GL_TESS_EVALUATION_SHADER,
                               GL_GEOMETRY_SHADER, GL_FRAGMENT_SHADER}) {
        GLint program = 0;
        ctx.real->glGetProgramPipelineiv(static_cast<GLuint>(pipeline), stage, &program);
        if (program != 0) found.push_back(static_cast<GLuint>(program));
    }
    return found;
}

// Current attributes, materials, the raster position.
bool leaves_state_behind(const Context& ctx, DrawKind kind) {
    return ctx.kind.is_compatibility() && (kind == DrawKind::kCollected || kind == DrawKind::kPixels);
}

}  // namespace

bool counts_draws(Context& ctx) {
    static constexpr GLenum kTargets[] = {GL_PRIMITIVES_GENERATED,
                                          GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN,
                                          GL_TRANSFORM_FEEDBACK_OVERFLOW,
                                          GL_TRANSFORM_FEEDBACK_STREAM_OVERFLOW,
                                          GL_VERTICES_SUBMITTED,
                                          GL_PRIMITIVES_SUBMITTED,
                                          GL_VERTEX_SHADER_INVOCATIONS,
                                          GL_TESS_CONTROL_SHADER_PATCHES,
                                          GL_TESS_EVALUATION_SHADER_INVOCATIONS,
                                          GL_GEOMETRY_SHADER_INVOCATIONS,
                                          GL_GEOMETRY_SHADER_PRIMITIVES_EMITTED,
                                          GL_FRAGMENT_SHADER_INVOCATIONS,
                                          GL_CLIPPING_INPUT_PRIMITIVES,
                                          GL_CLIPPING_OUTPUT_PRIMITIVES};
    const OwnCalls own(ctx);
    return ctx.proposed.counts_draws && std::ranges::any_of(kTargets, [&](GLenum target) {
               if (ctx.time != nullptr && ctx.time->counters().holds(target)) return false;
               GLint query = 0;
               ctx.real->glGetQueryiv(target, GL_CURRENT_QUERY, &query);
               return query != 0;
           });
}

bool can_repeat(Context& ctx, DrawKind kind) {
    const OwnCalls own(ctx);
    if (leaves_state_behind(ctx, kind) && get(ctx, GL_ATTRIB_STACK_DEPTH) >= ctx.kind.attrib_stack_depth) {
        return false;
    }
    if (ctx.kind.version < GlVersion{4, 3}) return !counts_draws(ctx);
    const std::vector<GLuint> run = programs(ctx);
    return !counts_draws(ctx) &&
           std::ranges::none_of(run, [&](GLuint program) { return writes_memory(ctx, program); });
}

Repetition::Repetition(Context& ctx, DrawKind kind) : ctx_(ctx), own_(ctx) {
    if (ctx.proposed.run != nullptr) ctx.proposed.run->close_segment(ctx);
    if (ctx.slot.app_query != 0) pause_.emplace(ctx);
    has_pushed_ = leaves_state_behind(ctx, kind);
    if (has_pushed_) ctx.real->glPushAttrib(GL_CURRENT_BIT | GL_LIGHTING_BIT);
    if (ctx.kind.version >= GlVersion{4, 0}) {
        const auto is = [&](GLenum name) { return get(ctx_, name) != 0; };
        feedback_was_active_ = is(GL_TRANSFORM_FEEDBACK_ACTIVE) && !is(GL_TRANSFORM_FEEDBACK_PAUSED);
        if (feedback_was_active_) ctx.real->glPauseTransformFeedback();
    }
    if (ctx.kind.version >= GlVersion{4, 3}) {
        debug_output_was_on_ = ctx.real->glIsEnabled(GL_DEBUG_OUTPUT) != GL_FALSE;
        if (debug_output_was_on_) ctx.real->glDisable(GL_DEBUG_OUTPUT);
    }
}

Repetition::~Repetition() {
    if (has_pushed_) ctx_.real->glPopAttrib();
    if (debug_output_was_on_) ctx_.real->glEnable(GL_DEBUG_OUTPUT);
    if (feedback_was_active_) ctx_.real->glResumeTransformFeedback();
}

}  // namespace glext_emu
