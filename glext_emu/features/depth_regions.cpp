// SPDX-License-Identifier: MIT
// GL_EMU_depth_region_query: what the depth buffer holds inside a rectangle. Hey, Tobler, Purgathofer,
// "Real-Time Occlusion Culling with a Lazy Occlusion Grid", 2001, ask hardware for a state ("is all of this
// tile occluded?") and for a furthest z; docs/extensions/EMU_depth_region_query.txt is the text.
//
// A query is evaluated when it is asked; the clock says when its result may be seen.
#include <algorithm>
#include <bit>
#include <optional>
#include <span>
#include <vector>

#include "context/depth_reader.h"
#include "context/framebuffer_info.h"
#include "context/report.h"
#include "context/settings.h"
#include "features/features.h"
#include "features/query_buffers.h"
#include "features/stall.h"

namespace glext_emu::features {
namespace {

// A command's regions, clipped, are in ctx.depth_reader.rects: a question about one tile takes a microsecond,
// so no memory is asked for.
struct Question {
    GLenum pname;
    FramebufferInfo framebuffer;
};

// Nothing where the command is in error, which is raised.
std::optional<Question> question_of(Context& ctx, GLenum pname, GLsizei count, const GLint* rectangles) {
    const Question question{pname, draw_framebuffer_info(ctx)};
    const FramebufferInfo& framebuffer = question.framebuffer;
    if (framebuffer.is_between_begin_and_end) return std::nullopt;  // the driver has raised the error
    const bool is_known =
        pname == GL_REGION_OCCLUDED_EMU || pname == GL_FURTHEST_DEPTH_EMU || pname == GL_NEAREST_DEPTH_EMU;
    if (!is_known) return ctx.raise(GL_INVALID_ENUM), std::nullopt;
    if (count < 0 || count > max_depth_regions()) return ctx.raise(GL_INVALID_VALUE), std::nullopt;
    for (GLsizei i = 0; i < count; ++i) {
        const GLint* const size = rectangles + 4 * i + 2;
        if (size[0] < 0 || size[1] < 0) return ctx.raise(GL_INVALID_VALUE), std::nullopt;
    }
    if (!framebuffer.is_complete) return ctx.raise(GL_INVALID_FRAMEBUFFER_OPERATION), std::nullopt;
    if (framebuffer.depth_bits == 0) return ctx.raise(GL_INVALID_OPERATION), std::nullopt;
    std::vector<Rect>& rects = ctx.depth_reader.rects;
    rects.clear();
    for (GLsizei i = 0; i < count; ++i) {
        const GLint* const rect = rectangles + 4 * i;
        rects.push_back(clipped({rect[0], rect[1], rect[2], rect[3]}, framebuffer.width, framebuffer.height));
    }
    return question;
}

// As a device's narrower register holds it, still a bound.
float held_depth(Context& ctx, float depth, DepthEnd end) {
    const auto bits = settings().device.region_depth_bits;
    return bits ? narrowed_depth(ctx, depth, *bits, end == DepthEnd::kGreatest) : depth;
}

// Writes one value a region; false where the driver cannot tell, with the error raised.
bool answer(Context& ctx, const Question& question, std::span<GLfloat> values) {
    const bool is_far_at_one = ctx.proposed.far_end == GL_ONE;
    const bool asks_for_nearest = question.pname == GL_NEAREST_DEPTH_EMU;
    const DepthEnd end = is_far_at_one != asks_for_nearest ? DepthEnd::kGreatest : DepthEnd::kLeast;
    // Of no depth at all the furthest is the nearest that there can be, and the other way round.
    const DepthBound of_none{.depth = end == DepthEnd::kGreatest ? 0.0F : 1.0F, .is_at_end = false};

    DepthReader& reader = ctx.depth_reader;
    reader.bounds.assign(reader.rects.size(), of_none);
    if (!read_depth_bounds(ctx, question.framebuffer, end, reader.rects, reader.bounds)) {
        ctx.raise(GL_OUT_OF_MEMORY);
        return false;
    }
    std::uint64_t pixels = 0;
    for (const Rect& rect : reader.rects) pixels += static_cast<std::uint64_t>(rect.area());
    ctx.proposed.pixels_read += pixels;
    ctx.frame.pixels_read += pixels;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const DepthBound& bound = reader.bounds[i];
        const GLfloat state = bound.is_at_end ? 0.0F : 1.0F;
        values[i] = question.pname == GL_REGION_OCCLUDED_EMU ? state : held_depth(ctx, bound.depth, end);
    }
    return true;
}

// Results of 32 bits: of the state 0 or 1, of depths the floats, whose bits are ordered as the depths are.
// None where the driver cannot tell, with the error raised.
std::vector<GLuint> answer_in_words(Context& ctx, const Question& question) {
    std::vector<GLfloat> values(ctx.depth_reader.rects.size());
    if (!answer(ctx, question, values)) return {};
    std::vector<GLuint> words;
    words.reserve(values.size());
    for (const GLfloat value : values) {
        words.push_back(question.pname == GL_REGION_OCCLUDED_EMU ? static_cast<GLuint>(value)
                                                                 : std::bit_cast<GLuint>(value));
    }
    return words;
}

// True, with the error raised, where not all of <ids> can become objects of the query.
bool refuses_names(Context& ctx, std::span<const GLuint> ids) {
    for (const GLuint id : ids) {
        if (refuses_proposed_name(ctx, id, GL_DEPTH_REGION_EMU)) return true;
    }
    std::vector<GLuint> sorted(ids.begin(), ids.end());
    std::ranges::sort(sorted);
    if (std::ranges::adjacent_find(sorted) == sorted.end()) return false;
    ctx.raise(GL_INVALID_OPERATION);
    return true;
}

// The same for <count> words at <offset> of <buffer>.
bool refuses_buffer(Context& ctx, GLsizei count, GLuint buffer, GLintptr offset) {
    const bool is_buffer = ctx.kind.has_named_buffers && ctx.real->glIsBuffer(buffer) != GL_FALSE;
    if (!is_buffer || is_mapped(ctx, buffer)) return ctx.raise(GL_INVALID_OPERATION), true;
    GLint64 size = 0;
    {
        const OwnCalls own(ctx);
        ctx.real->glGetNamedBufferParameteri64v(buffer, GL_BUFFER_SIZE, &size);
    }
    const GLint64 written = static_cast<GLint64>(sizeof(GLuint)) * count;
    const bool fits =
        offset >= 0 && offset % static_cast<GLintptr>(sizeof(GLuint)) == 0 && offset <= size - written;
    if (!fits) ctx.raise(GL_INVALID_VALUE);
    return !fits;
}

// When the answers to the question whose rectangles were read are due.
occlusion_unit::Tick due_of_regions(Context& ctx) {
    need_pixels("a depth region query");
    if (ctx.time != nullptr) {
        std::uint64_t pixels = 0;
        for (const Rect& rect : ctx.depth_reader.rects) pixels += static_cast<std::uint64_t>(rect.area());
        ctx.time->ask_about_regions(ctx.depth_reader.rects.size(), pixels);
    }
    return ctx.clock.due();
}

}  // namespace

GLint max_depth_regions() {
    return settings().device.max_regions.value_or(65536);
}

void far_depth_emu(Context& ctx, GLenum end) {
    if (end != GL_ONE && end != GL_ZERO) return ctx.raise(GL_INVALID_ENUM);
    ctx.proposed.far_end = end;
}

void get_depth_regionfv_emu(Context& ctx, GLenum pname, GLint x, GLint y, GLsizei width, GLsizei height,
                            GLfloat* value) {
    const GLint rectangle[] = {x, y, width, height};
    get_depth_regionsfv_emu(ctx, pname, 1, rectangle, value);
}

void get_depth_regionsfv_emu(Context& ctx, GLenum pname, GLsizei count, const GLint* rectangles,
                             GLfloat* values) {
    const auto question = question_of(ctx, pname, count, rectangles);
    if (!question) return;
    // Reading the time takes as long as reading a hundred depths.
    std::optional<StallScope> stall;
    if (Report::instance().is_wanted()) stall.emplace(ctx);
    const occlusion_unit::Tick due = due_of_regions(ctx);
    const bool is_answered = answer(ctx, *question, {values, ctx.depth_reader.rects.size()});
    ctx.clock.wait_until(due);
    if (is_answered) ctx.frame.results += static_cast<std::uint64_t>(count);
}

void query_depth_regions_emu(Context& ctx, GLenum pname, GLsizei count, const GLint* rectangles,
                             const GLuint* ids) {
    const auto question = question_of(ctx, pname, count, rectangles);
    if (!question) return;
    const std::span names(ids, static_cast<std::size_t>(count));
    if (refuses_names(ctx, names)) return;
    const occlusion_unit::Tick due = due_of_regions(ctx);
    const std::vector<GLuint> words = answer_in_words(ctx, *question);
    for (std::size_t i = 0; i < words.size(); ++i) {
        ProposedQuery& query = renew_proposed_query(ctx, names[i], GL_DEPTH_REGION_EMU);
        query.word = words[i];
        query.due = due;
        query.has_ended = true;
    }
    ctx.frame.queries_begun += words.size();
    ctx.update_hot();
}

void query_depth_regions_buffer_emu(Context& ctx, GLenum pname, GLsizei count, const GLint* rectangles,
                                    GLuint buffer, GLintptr offset) {
    const auto question = question_of(ctx, pname, count, rectangles);
    if (!question || refuses_buffer(ctx, count, buffer, offset)) return;
    const occlusion_unit::Tick due = due_of_regions(ctx);
    const std::vector<GLuint> words = answer_in_words(ctx, *question);
    if (words.empty()) return;
    // The machine's pipeline is in order: whoever reads the buffer gets the results, so they are waited for.
    const StallScope stall(ctx);
    wait_in_pipe(ctx, due);
    put_bytes(ctx, buffer, offset, words.data(), static_cast<GLsizeiptr>(words.size() * sizeof(GLuint)));
    ctx.frame.queries_begun += words.size();
    ctx.frame.results += words.size();
}

}  // namespace glext_emu::features
