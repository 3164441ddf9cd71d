// SPDX-License-Identifier: MIT
// What happens around a draw: the HP test's segment is opened when the first draw needs it, so that enabling
// the test costs nothing; the report counts; and what the Occlusion Unit watches is drawn in a way that can
// be repeated.
#include "context/discard_scope.h"
#include "context/framebuffer_info.h"
#include "context/settings.h"
#include "context/unit_run.h"
#include "features/features.h"
#include "features/list_recorder.h"

#include <utility>

namespace glext_emu::features {
namespace {

void count_draw(Context& ctx, Triangles triangles) {
    ctx.frame.draws++;
    ctx.frame.triangles += triangles.count;
    ctx.frame.triangles_are_known = ctx.frame.triangles_are_known && triangles.is_known;
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

VertexSource source_of(DrawKind kind) {
    return kind == DrawKind::kCollected ? VertexSource::kList
           : kind == DrawKind::kPixels  ? VertexSource::kPixels
                                        : VertexSource::kArrays;
}

// A draw is about to be executed.
void before_draw(Context& ctx, Triangles triangles) {
    count_draw(ctx, triangles);
    if (ctx.follows_text && ctx.slot.counts_samples()) {
        set_samples_per_count(ctx, samples_per_count(ctx));
    }
    if ((ctx.slot.counters & kDepthPassCounter) != 0)
        set_samples_per_fragment(ctx, samples_per_fragment(ctx));
    // While a list is compiled and executed, the segment stands open already: opening it now would compile
    // it.
    if (ctx.slot.wants_segment() && !ctx.recording.is_open()) open_segment(ctx);
}

// Where draws may have to be repeated, each of them in a list is a step of its own.
bool stands_alone(const Context& ctx) {
    return ctx.repeats_draws && ctx.recording.is_open() && !ctx.inside_begin_end &&
           ctx.recording.begin_end == BeginEnd::kUnchanged;
}

// A draw that is compiled and executed while the unit watches is executed first, by itself.
void draw_in_list(Context& ctx, Triangles triangles, DrawCall call) {
    ListRecording& recording = ctx.recording;
    const bool is_watched = !recording.only_compiles() && ctx.proposed.run != nullptr;
    close_step(ctx);
    if (is_watched) {
        recording.is_suspended = true;
        draw(ctx, triangles, call);
        recording.is_suspended = false;
    } else if (!recording.only_compiles()) {
        before_draw(ctx, triangles);
        if (ctx.time != nullptr)
            ctx.time->draw(triangles.count, triangles.is_known, source_of(triangles.kind));
    }
    open_draw_step(ctx, is_watched ? GL_COMPILE : recording.mode);
    call();
    close_draw_step(ctx, triangles.kind == DrawKind::kPixels ? DrawKind::kPixels : DrawKind::kCollected);
    open_step(ctx);
}

void draw_rectangle(Context& ctx, GLenum pixels, DrawKind kind, DrawCall call) {
    if (!counts_too_much(ctx, pixels)) return draw(ctx, no_triangles(kind), call);
    const CountPause pause(ctx);
    if (ctx.proposed.run != nullptr) ctx.proposed.run->close_segment(ctx);
    count_draw(ctx, no_triangles(kind));
    call();
}

}  // namespace

void draw_watched(Context& ctx, Triangles triangles, DrawCall call) {
    if (ctx.time == nullptr) return draw_under_unit(ctx, triangles.kind, call);
    ctx.time->draw_apart(triangles.count, triangles.is_known, source_of(triangles.kind));
    bool is_first = true;
    draw_under_unit(ctx, triangles.kind, [&] {
        if (!std::exchange(is_first, false)) return call();
        ctx.time->count();
        call();
        ctx.time->stop_counting();
    });
}

void draw(Context& ctx, Triangles triangles, DrawCall call) {
    if (stands_alone(ctx)) return draw_in_list(ctx, triangles, call);
    // A command that is only compiled draws nothing now.
    if (ctx.recording.only_compiles() || ctx.inside_begin_end) return call();
    before_draw(ctx, triangles);
    if (ctx.proposed.run != nullptr && !ctx.recording.is_open()) [[unlikely]]
        return draw_watched(ctx, triangles, call);
    if (ctx.time == nullptr) [[likely]]
        return call();
    ctx.time->draw(triangles.count, triangles.is_known, source_of(triangles.kind));
    if (!settings().is_dry) return call();
    // Only the driver knows how many triangles there are.
    if (triangles.is_known) return;
    const DiscardScope discards(ctx);
    call();
}

void draw_pixels(Context& ctx, GLsizei width, GLsizei height, GLenum format, GLenum type,
                 const void* pixels) {
    draw_rectangle(ctx, format, DrawKind::kPixels,
                   [&] { ctx.real->glDrawPixels(width, height, format, type, pixels); });
}

void copy_pixels(Context& ctx, GLint x, GLint y, GLsizei width, GLsizei height, GLenum type) {
    draw_rectangle(ctx, type, DrawKind::kPixels, [&] { ctx.real->glCopyPixels(x, y, width, height, type); });
}

void draw_collected(Context& ctx, GLenum mode, GLuint list) {
    draw(ctx, {0, false, DrawKind::kCollected}, [&] {
        ctx.real->glBegin(mode);
        ctx.real->glCallList(list);
        ctx.real->glEnd();
    });
}

// What stands between the Begin and End of a primitive that will be repeated is collected in a list of the
// driver's, which is called between another Begin and End: a list with the primitive itself is not the same
// to Mesa, which cuts its quadrilaterals along the other diagonal.
void begin(Context& ctx, GLenum mode) {
    if (!is_primitive(mode) || ctx.inside_begin_end) return ctx.real->glBegin(mode);

    ListRecording& recording = ctx.recording;
    const bool is_watched = ctx.proposed.run != nullptr && !recording.only_compiles() && makes_fragments(ctx);
    if (stands_alone(ctx)) {
        recording.is_in_draw_step = true;
        close_step(ctx);
        open_draw_step(ctx, is_watched ? GL_COMPILE : recording.mode);
        if (is_watched) ctx.collected_primitive = recording.segment;
    } else if (is_watched && !recording.is_open()) {
        ctx.collected_primitive = make_hidden_list(ctx);
        ctx.real->glNewList(ctx.collected_primitive, GL_COMPILE);
    }
    if (recording.is_open()) recording.follow(BeginEnd::kOpens);
    if (!recording.only_compiles()) {
        if (ctx.collected_primitive == 0) {
            before_draw(ctx, unknown());
            if (ctx.time != nullptr) ctx.time->draw(0, false, VertexSource::kImmediate);
            if (settings().is_dry) ctx.dry_primitive.emplace(ctx);
        }
        remember_list_base(ctx);
        ctx.set_inside_begin_end(true);
    }
    if (ctx.collected_primitive != 0) {
        ctx.collected_mode = mode;
    } else {
        ctx.real->glBegin(mode);
    }
}

void end(Context& ctx) {
    ListRecording& recording = ctx.recording;
    const GLuint collected = std::exchange(ctx.collected_primitive, 0);
    if (recording.is_open()) recording.follow(BeginEnd::kCloses);
    if (!recording.only_compiles()) ctx.set_inside_begin_end(false);
    if (collected == 0) ctx.real->glEnd();
    ctx.dry_primitive.reset();

    if (recording.is_in_draw_step && recording.begin_end == BeginEnd::kUnchanged) {
        recording.is_in_draw_step = false;
        close_draw_step(ctx, DrawKind::kCollected);
        if (collected != 0) {
            recording.steps.back().primitive = ctx.collected_mode;
            recording.is_suspended = true;
            draw_collected(ctx, ctx.collected_mode, collected);
            recording.is_suspended = false;
        }
        open_step(ctx);
    } else if (collected != 0) {
        ctx.real->glEndList();
        draw_collected(ctx, ctx.collected_mode, collected);
        delete_hidden_list(ctx, collected);
    }
}

}  // namespace glext_emu::features
