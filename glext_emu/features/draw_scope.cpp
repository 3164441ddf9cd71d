// SPDX-License-Identifier: MIT
// What happens before a draw: the HP test's segment is opened when the first draw needs it, so that enabling
// the test costs nothing, and the report counts.
#include "features/features.h"
#include "features/list_recorder.h"

namespace glext_emu::features {
namespace {

void count_draw(Context& ctx, Triangles triangles) {
    ctx.frame.draws++;
    ctx.frame.triangles += triangles.count;
    ctx.frame.triangles_are_known = ctx.frame.triangles_are_known && triangles.is_known;
}

// NV_occlusion_query, issues: samples are counted "even if GL_MULTISAMPLE is disabled but GL_SAMPLE_BUFFERS
// is 1"; Mesa counts pixels then.
GLuint samples_per_count(Context& ctx) {
    if (ctx.real->glIsEnabled(GL_MULTISAMPLE) != GL_FALSE) return 1;
    GLint samples = 0;
    ctx.real->glGetIntegerv(GL_SAMPLES, &samples);
    return samples > 1 ? static_cast<GLuint>(samples) : 1;
}

// The modes that Begin accepts; with another it fails and no Begin/End pair is open.
bool is_primitive(GLenum mode) {
    return mode <= GL_PATCHES;
}

// GL 4.5 compatibility, chapter 18: stencil indices are written as they are, no fragment is made of them;
// Mesa draws and counts them.
bool counts_too_much(const Context& ctx, GLenum pixels) {
    const bool is_stencil = pixels == GL_STENCIL_INDEX || pixels == GL_STENCIL;
    return is_stencil && ctx.follows_text && !ctx.recording.is_open();
}

}  // namespace

void before_draw(Context& ctx, Triangles triangles) {
    // A command that is only compiled draws nothing now.
    if (ctx.recording.only_compiles() || ctx.inside_begin_end) return;
    count_draw(ctx, triangles);
    if (ctx.follows_text && ctx.slot.counts_samples()) {
        set_samples_per_count(ctx, samples_per_count(ctx));
    }
    // While a list is compiled and executed, the segment stands open already: opening it now would compile
    // it.
    if (ctx.slot.wants_segment() && !ctx.recording.is_open()) open_segment(ctx);
}

void draw_pixels(Context& ctx, GLsizei width, GLsizei height, GLenum format, GLenum type,
                 const void* pixels) {
    before_draw(ctx, no_triangles());
    std::optional<CountPause> pause;
    if (counts_too_much(ctx, format)) pause.emplace(ctx);
    ctx.real->glDrawPixels(width, height, format, type, pixels);
}

void copy_pixels(Context& ctx, GLint x, GLint y, GLsizei width, GLsizei height, GLenum type) {
    before_draw(ctx, no_triangles());
    std::optional<CountPause> pause;
    if (counts_too_much(ctx, type)) pause.emplace(ctx);
    ctx.real->glCopyPixels(x, y, width, height, type);
}

void begin(Context& ctx, GLenum mode) {
    before_draw(ctx, unknown());
    if (is_primitive(mode)) {
        if (ctx.recording.is_open()) ctx.recording.follow(BeginEnd::kOpens);
        if (!ctx.recording.only_compiles()) {
            remember_list_base(ctx);
            ctx.set_inside_begin_end(true);
        }
    }
    ctx.real->glBegin(mode);
}

void end(Context& ctx) {
    if (ctx.recording.is_open()) ctx.recording.follow(BeginEnd::kCloses);
    if (!ctx.recording.only_compiles()) ctx.set_inside_begin_end(false);
    ctx.real->glEnd();
}

}  // namespace glext_emu::features
