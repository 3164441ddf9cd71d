// SPDX-License-Identifier: MIT
#include "context/saved_state.h"

#include <algorithm>
#include <array>

namespace glext_emu {

SavedState::~SavedState() {
    for (; !undo_.empty(); undo_.pop_back()) undo_.back()();
}

GLint SavedState::get(GLenum name) const {
    GLint value = 0;
    ctx_.real->glGetIntegerv(name, &value);
    return value;
}

void SavedState::set(GLenum cap, bool is_on) {
    const RealGl& real = *ctx_.real;
    const bool was_on = real.glIsEnabled(cap) != GL_FALSE;
    if (was_on == is_on) return;
    // Each viewport has its own; Enable would set them all.
    if (cap == GL_SCISSOR_TEST && ctx_.kind.version >= GlVersion{4, 1}) {
        (is_on ? real.glEnablei : real.glDisablei)(cap, 0);
        return undo([&real, cap, was_on] { (was_on ? real.glEnablei : real.glDisablei)(cap, 0); });
    }
    (is_on ? real.glEnable : real.glDisable)(cap);
    undo([&real, cap, was_on] { (was_on ? real.glEnable : real.glDisable)(cap); });
}

void SavedState::draw_unconditionally() {
    const RealGl& real = *ctx_.real;
    const GlVersion version = ctx_.kind.version;
    if (version >= GlVersion{4, 3}) set(GL_DEBUG_OUTPUT, false);
    if (ctx_.conditional.query != 0 && ctx_.conditional.is_in_driver) {
        real.glEndConditionalRender();
        undo([&real, was = ctx_.conditional] { real.glBeginConditionalRender(was.query, was.mode); });
    }
    const bool records = version >= GlVersion{4, 0} && get(GL_TRANSFORM_FEEDBACK_ACTIVE) != 0 &&
                         get(GL_TRANSFORM_FEEDBACK_PAUSED) == 0;
    if (records) {
        real.glPauseTransformFeedback();
        undo([&real] { real.glResumeTransformFeedback(); });
    }
    set(GL_RASTERIZER_DISCARD, false);
}

void SavedState::draw_plain_polygons() {
    const RealGl& real = *ctx_.real;
    const GlVersion version = ctx_.kind.version;
    const GLint distances = get(GL_MAX_CLIP_DISTANCES);
    for (GLint i = 0; i < distances; ++i) set(GL_CLIP_DISTANCE0 + static_cast<GLenum>(i), false);
    set(GL_POLYGON_SMOOTH, false);
    set(GL_SAMPLE_ALPHA_TO_COVERAGE, false);
    if (ctx_.kind.is_compatibility()) {
        set(GL_POLYGON_STIPPLE, false);
        set(GL_ALPHA_TEST, false);
    }
    if (version >= GlVersion{3, 1}) set(GL_PRIMITIVE_RESTART, false);
    if (version >= GlVersion{4, 0}) set(GL_SAMPLE_SHADING, false);
    if (version >= GlVersion{4, 3}) set(GL_PRIMITIVE_RESTART_FIXED_INDEX, false);
    std::array<GLint, 2> modes{};
    real.glGetIntegerv(GL_POLYGON_MODE, modes.data());
    if (modes[0] == GL_FILL && modes[1] == GL_FILL) return;
    real.glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    undo([&real, modes] {
        if (modes[0] == modes[1]) return real.glPolygonMode(GL_FRONT_AND_BACK, static_cast<GLenum>(modes[0]));
        real.glPolygonMode(GL_FRONT, static_cast<GLenum>(modes[0]));
        real.glPolygonMode(GL_BACK, static_cast<GLenum>(modes[1]));
    });
}

void SavedState::write_nothing() {
    const RealGl& real = *ctx_.real;
    struct ColorMask {
        std::array<GLboolean, 4> channels;
    };
    std::vector<ColorMask> masks(static_cast<std::size_t>(std::max(get(GL_MAX_DRAW_BUFFERS), 1)));
    for (std::size_t i = 0; i < masks.size(); ++i) {
        real.glGetBooleani_v(GL_COLOR_WRITEMASK, static_cast<GLuint>(i), masks[i].channels.data());
    }
    const bool writes = std::ranges::any_of(masks, [](const ColorMask& mask) {
        return std::ranges::any_of(mask.channels, [](GLboolean on) { return on != GL_FALSE; });
    });
    if (writes) {
        real.glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
        undo([&real, masks = std::move(masks)] {
            for (std::size_t i = 0; i < masks.size(); ++i) {
                const auto& on = masks[i].channels;
                real.glColorMaski(static_cast<GLuint>(i), on[0], on[1], on[2], on[3]);
            }
        });
    }
    depth_mask(false);
    if (real.glIsEnabled(GL_STENCIL_TEST) == GL_FALSE) return;
    const auto front = static_cast<GLuint>(get(GL_STENCIL_WRITEMASK));
    const auto back = static_cast<GLuint>(get(GL_STENCIL_BACK_WRITEMASK));
    if (front == 0 && back == 0) return;
    real.glStencilMaskSeparate(GL_FRONT_AND_BACK, 0);
    undo([&real, front, back] {
        real.glStencilMaskSeparate(GL_FRONT, front);
        real.glStencilMaskSeparate(GL_BACK, back);
    });
}

void SavedState::set_all_bits() {
    const RealGl& real = *ctx_.real;
    std::array<GLboolean, 4> on{};
    real.glGetBooleani_v(GL_COLOR_WRITEMASK, 0, on.data());
    real.glColorMaski(0, GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    undo([&real, on] { real.glColorMaski(0, on[0], on[1], on[2], on[3]); });
    set(GL_COLOR_LOGIC_OP, true);
    const auto was = static_cast<GLenum>(get(GL_LOGIC_OP_MODE));
    real.glLogicOp(GL_SET);
    undo([&real, was] { real.glLogicOp(was); });
}

void SavedState::ignore_depth_in_stencil() {
    const RealGl& real = *ctx_.real;
    const auto op = [&](GLenum name) { return static_cast<GLenum>(get(name)); };
    const std::array front = {op(GL_STENCIL_FAIL), op(GL_STENCIL_PASS_DEPTH_FAIL),
                              op(GL_STENCIL_PASS_DEPTH_PASS)};
    const std::array back = {op(GL_STENCIL_BACK_FAIL), op(GL_STENCIL_BACK_PASS_DEPTH_FAIL),
                             op(GL_STENCIL_BACK_PASS_DEPTH_PASS)};
    real.glStencilOpSeparate(GL_FRONT, front[0], front[2], front[2]);
    real.glStencilOpSeparate(GL_BACK, back[0], back[2], back[2]);
    undo([&real, front, back] {
        real.glStencilOpSeparate(GL_FRONT, front[0], front[1], front[2]);
        real.glStencilOpSeparate(GL_BACK, back[0], back[1], back[2]);
    });
}

void SavedState::depth_mask(bool is_on) {
    const RealGl& real = *ctx_.real;
    const bool was_on = get(GL_DEPTH_WRITEMASK) != 0;
    if (was_on == is_on) return;
    real.glDepthMask(is_on ? GL_TRUE : GL_FALSE);
    undo([&real, was_on] { real.glDepthMask(was_on ? GL_TRUE : GL_FALSE); });
}

void SavedState::depth_func(GLenum func) {
    const RealGl& real = *ctx_.real;
    const auto was = static_cast<GLenum>(get(GL_DEPTH_FUNC));
    if (was == func) return;
    real.glDepthFunc(func);
    undo([&real, was] { real.glDepthFunc(was); });
}

void SavedState::use_program(GLuint program) {
    const RealGl& real = *ctx_.real;
    const auto was = static_cast<GLuint>(get(GL_CURRENT_PROGRAM));
    real.glUseProgram(program);
    undo([&real, was] { real.glUseProgram(was); });
}

void SavedState::bind_vertex_array(GLuint array) {
    const RealGl& real = *ctx_.real;
    const auto was = static_cast<GLuint>(get(GL_VERTEX_ARRAY_BINDING));
    real.glBindVertexArray(array);
    undo([&real, was] { real.glBindVertexArray(was); });
}

void SavedState::bind_framebuffer(GLuint framebuffer) {
    const RealGl& real = *ctx_.real;
    const auto draw = static_cast<GLuint>(get(GL_DRAW_FRAMEBUFFER_BINDING));
    const auto read = static_cast<GLuint>(get(GL_READ_FRAMEBUFFER_BINDING));
    real.glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    undo([&real, draw, read] {
        real.glBindFramebuffer(GL_DRAW_FRAMEBUFFER, draw);
        real.glBindFramebuffer(GL_READ_FRAMEBUFFER, read);
    });
}

void SavedState::bind_draw_framebuffer(GLuint framebuffer) {
    const RealGl& real = *ctx_.real;
    const auto was = static_cast<GLuint>(get(GL_DRAW_FRAMEBUFFER_BINDING));
    real.glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
    undo([&real, was] { real.glBindFramebuffer(GL_DRAW_FRAMEBUFFER, was); });
}

void SavedState::bind_read_framebuffer(GLuint framebuffer) {
    const RealGl& real = *ctx_.real;
    const auto was = static_cast<GLuint>(get(GL_READ_FRAMEBUFFER_BINDING));
    real.glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer);
    undo([&real, was] { real.glBindFramebuffer(GL_READ_FRAMEBUFFER, was); });
}

// The first viewport alone: the layer's draws go to no other.
void SavedState::viewport(GLsizei width, GLsizei height) {
    const RealGl& real = *ctx_.real;
    std::array<GLfloat, 4> was{};
    real.glGetFloatv(GL_VIEWPORT, was.data());
    if (ctx_.kind.version >= GlVersion{4, 1}) {
        real.glViewportIndexedf(0, 0, 0, static_cast<GLfloat>(width), static_cast<GLfloat>(height));
        undo([&real, was] { real.glViewportIndexedf(0, was[0], was[1], was[2], was[3]); });
    } else {
        real.glViewport(0, 0, width, height);
        undo([&real, was] {
            real.glViewport(static_cast<GLint>(was[0]), static_cast<GLint>(was[1]),
                            static_cast<GLsizei>(was[2]), static_cast<GLsizei>(was[3]));
        });
    }
}

void SavedState::read_plainly() {
    const RealGl& real = *ctx_.real;
    const auto buffer = static_cast<GLuint>(get(GL_PIXEL_PACK_BUFFER_BINDING));
    if (buffer != 0) {
        real.glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
        undo([&real, buffer] { real.glBindBuffer(GL_PIXEL_PACK_BUFFER, buffer); });
    }
    struct Setting {
        GLenum name;
        GLint plain;
    };
    static constexpr Setting kPacking[] = {{GL_PACK_SWAP_BYTES, 0},  {GL_PACK_ROW_LENGTH, 0},
                                           {GL_PACK_SKIP_ROWS, 0},   {GL_PACK_SKIP_PIXELS, 0},
                                           {GL_PACK_INVERT_MESA, 0}, {GL_PACK_ALIGNMENT, 1}};
    for (const auto& [name, plain] : kPacking) {
        const GLint was = get(name);
        if (was == plain) continue;
        real.glPixelStorei(name, plain);
        undo([&real, name, was] { real.glPixelStorei(name, was); });
    }
    real.glGetError();  // of a driver without GL_MESA_pack_invert
    if (!ctx_.kind.is_compatibility()) return;
    static constexpr Setting kTransfer[] = {
        {GL_DEPTH_SCALE, 1}, {GL_DEPTH_BIAS, 0}, {GL_RED_SCALE, 1}, {GL_RED_BIAS, 0}, {GL_MAP_COLOR, 0}};
    for (const auto& [name, plain] : kTransfer) {
        GLfloat was = 0;
        real.glGetFloatv(name, &was);
        real.glPixelTransferf(name, static_cast<GLfloat>(plain));
        undo([&real, name, was] { real.glPixelTransferf(name, was); });
    }
}

}  // namespace glext_emu
