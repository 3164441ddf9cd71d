// SPDX-License-Identifier: MIT
#include "context/private_copy.h"

#include <algorithm>
#include <vector>

#include "context/context.h"
#include "context/saved_state.h"

// GL_MESA_framebuffer_flip_y; Debian's glext.h knows the name for ES only.
#ifndef GL_FRAMEBUFFER_FLIP_Y_MESA
#define GL_FRAMEBUFFER_FLIP_Y_MESA 0x8BBB
#endif

namespace glext_emu {
namespace {

using occlusion_unit::Box;
using occlusion_unit::FarEnd;
using occlusion_unit::Record;

bool points_to_far(GLenum func, FarEnd far_end) {
    return far_end == FarEnd::kOne ? func == GL_LESS || func == GL_LEQUAL
                                   : func == GL_GREATER || func == GL_GEQUAL;
}

// 0: there is none that the driver would copy to.
GLenum depth_format(const FramebufferInfo& info) {
    const bool has_stencil = info.stencil_bits != 0;
    if (info.depth_bits == 0) return has_stencil ? GL_STENCIL_INDEX8 : 0;
    if (info.has_float_depth) return has_stencil ? GL_DEPTH32F_STENCIL8 : GL_DEPTH_COMPONENT32F;
    if (info.depth_bits == 24) return has_stencil ? GL_DEPTH24_STENCIL8 : GL_DEPTH_COMPONENT24;
    if (has_stencil) return 0;
    return info.depth_bits == 16 ? GL_DEPTH_COMPONENT16 : GL_DEPTH_COMPONENT32;
}

GLenum attachment_of(const FramebufferInfo& info) {
    if (info.depth_bits == 0) return GL_STENCIL_ATTACHMENT;
    return info.stencil_bits != 0 ? GL_DEPTH_STENCIL_ATTACHMENT : GL_DEPTH_ATTACHMENT;
}

GLbitfield buffers_of(const FramebufferInfo& info) {
    return (info.depth_bits != 0 ? GL_DEPTH_BUFFER_BIT : 0u) |
           (info.stencil_bits != 0 ? GL_STENCIL_BUFFER_BIT : 0u);
}

bool is_same_shape(const FramebufferInfo& a, const FramebufferInfo& b) {
    return a.width == b.width && a.height == b.height && a.samples == b.samples && a.layers == b.layers &&
           a.depth_bits == b.depth_bits && a.has_float_depth == b.has_float_depth &&
           a.stencil_bits == b.stencil_bits && a.is_default == b.is_default;
}

GLuint make_texture(Context& ctx, const FramebufferInfo& info, GLenum format) {
    const RealGl& real = *ctx.real;
    GLuint texture = 0;
    const bool is_layered = info.layers != 0;
    if (info.samples != 0) {
        real.glCreateTextures(is_layered ? GL_TEXTURE_2D_MULTISAMPLE_ARRAY : GL_TEXTURE_2D_MULTISAMPLE, 1,
                              &texture);
        if (is_layered) {
            real.glTextureStorage3DMultisample(texture, info.samples, format, info.width, info.height,
                                               info.layers, GL_TRUE);
        } else {
            real.glTextureStorage2DMultisample(texture, info.samples, format, info.width, info.height,
                                               GL_TRUE);
        }
    } else {
        real.glCreateTextures(is_layered ? GL_TEXTURE_2D_ARRAY : GL_TEXTURE_2D, 1, &texture);
        if (is_layered) {
            real.glTextureStorage3D(texture, 1, format, info.width, info.height, info.layers);
        } else {
            real.glTextureStorage2D(texture, 1, format, info.width, info.height);
        }
    }
    return texture;
}

// Marks of one framebuffer, samples of a pixel one after the other.
struct Marked {
    Rect rect;
    int samples;
    const std::vector<std::uint8_t>& marks;
};

Box box_of(const Marked& marked) {
    const auto row_size = static_cast<std::size_t>(marked.rect.width * marked.samples);
    Box box;
    for (GLsizei y = 0; y < marked.rect.height; ++y) {
        const auto row = marked.marks.begin() + static_cast<std::ptrdiff_t>(row_size) * y;
        const auto end = row + static_cast<std::ptrdiff_t>(row_size);
        const auto is_marked = [](std::uint8_t mark) { return mark != 0; };
        const auto first = std::find_if(row, end, is_marked);
        if (first == end) continue;
        const auto last = std::find_if(std::reverse_iterator(end), std::reverse_iterator(row), is_marked);
        const auto column = [&](auto at) { return static_cast<GLint>((at - row) / marked.samples); };
        box = united(box, {marked.rect.x + column(first), marked.rect.y + y,
                           marked.rect.x + column(last.base() - 1), marked.rect.y + y});
    }
    return box;
}

}  // namespace

MarkingPlan plan_marking(const FramebufferInfo& info, const FragmentTests& tests, GLbitfield registers,
                         FarEnd far_end) {
    MarkingPlan plan;
    plan.can_mark = true;
    const bool can_fail = tests.depth_can_fail() && info.depth_bits != 0;
    const bool wants_depth = (registers & GL_NEAREST_DEPTH_BIT_EMU) != 0;
    if (!can_fail) {
        // Without a depth buffer the register stays where it is, at the far end.
        plan.can_tell_depth = wants_depth;
        plan.starts_far = wants_depth && info.depth_bits != 0;
        plan.forces_depth_writes = plan.starts_far;
    } else if (tests.depth_func == GL_NEVER) {
        plan.marks_nothing = true;
        plan.can_tell_depth = wants_depth;
    } else if (tests.depth_func == GL_EQUAL) {
        plan.can_tell_depth = wants_depth;
    } else if (points_to_far(tests.depth_func, far_end)) {
        // With writes a fragment may fail that passed without: only stencil could make a difference of that.
        plan.can_tell_depth = wants_depth && (tests.depth_writes || !tests.stencil_feeds_back());
        plan.forces_depth_writes = plan.can_tell_depth;
    }
    return plan;
}

bool PrivateCopy::make(Context& ctx, const FramebufferInfo& info, GLenum format_of_marks) {
    const RealGl& real = *ctx.real;
    destroy(ctx);
    shape = info;
    marks_format = format_of_marks;
    is_usable = false;
    const GLenum format = depth_format(info);
    if (format == 0 && buffers_of(info) != 0) return false;
    real.glCreateFramebuffers(1, &framebuffer);
    real.glCreateFramebuffers(1, &layer_reader);
    marks = make_texture(ctx, info, marks_format);
    real.glNamedFramebufferTexture(framebuffer, GL_COLOR_ATTACHMENT0, marks, 0);
    if (format != 0) {
        depths = make_texture(ctx, info, format);
        real.glNamedFramebufferTexture(framebuffer, attachment_of(info), depths, 0);
    }
    if (real.glGetError() != GL_NO_ERROR) return false;
    // A window's rows run the other way, and with them the rule for fragments on an edge.
    if (info.is_default) {
        real.glNamedFramebufferParameteri(framebuffer, GL_FRAMEBUFFER_FLIP_Y_MESA, GL_TRUE);
        if (real.glGetError() != GL_NO_ERROR) return false;
    }
    is_usable =
        real.glCheckNamedFramebufferStatus(framebuffer, GL_DRAW_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
    return is_usable;
}

void PrivateCopy::destroy(Context& ctx) {
    const GLuint textures[] = {depths, marks};
    ctx.real->glDeleteTextures(2, textures);
    const GLuint framebuffers[] = {framebuffer, layer_reader};
    ctx.real->glDeleteFramebuffers(2, framebuffers);
    *this = {};
}

bool PrivateCopy::take(Context& ctx, const FramebufferInfo& info, GLenum format_of_marks) {
    const OwnCalls own(ctx);
    const RealGl& real = *ctx.real;
    const bool is_there = framebuffer != 0 && is_same_shape(shape, info) && marks_format == format_of_marks;
    if (!is_there) make(ctx, info, format_of_marks);
    if (!is_usable) return false;
    const GLbitfield buffers = buffers_of(info);
    if (buffers == 0) return true;
    if (info.layers != 0) return copy_layers(ctx, buffers);
    GLint program = 0;
    real.glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &program);
    SavedState saved(ctx);
    saved.set(GL_SCISSOR_TEST, false);
    real.glBlitNamedFramebuffer(static_cast<GLuint>(program), framebuffer, 0, 0, info.width, info.height, 0,
                                0, info.width, info.height, buffers, GL_NEAREST);
    return real.glGetError() == GL_NO_ERROR;
}

// A blit reads and writes the first layer only, so each layer is attached by itself.
bool PrivateCopy::copy_layers(Context& ctx, GLbitfield buffers) {
    const RealGl& real = *ctx.real;
    GLint program = 0;
    real.glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &program);
    const GLenum attachment = shape.depth_bits != 0 ? GL_DEPTH_ATTACHMENT : GL_STENCIL_ATTACHMENT;
    const auto ask = [&](GLenum name) {
        GLint value = 0;
        real.glGetNamedFramebufferAttachmentParameteriv(static_cast<GLuint>(program), attachment, name,
                                                        &value);
        return value;
    };
    if (ask(GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE) != GL_TEXTURE) return false;
    const auto texture = static_cast<GLuint>(ask(GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME));
    const GLint level = ask(GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LEVEL);
    SavedState saved(ctx);
    saved.set(GL_SCISSOR_TEST, false);
    GLuint source = 0;
    real.glCreateFramebuffers(1, &source);
    for (GLint layer = 0; layer < shape.layers; ++layer) {
        real.glNamedFramebufferTextureLayer(source, attachment_of(shape), texture, level, layer);
        real.glNamedFramebufferTextureLayer(layer_reader, attachment_of(shape), depths, 0, layer);
        real.glBlitNamedFramebuffer(source, layer_reader, 0, 0, shape.width, shape.height, 0, 0, shape.width,
                                    shape.height, buffers, GL_NEAREST);
    }
    real.glDeleteFramebuffers(1, &source);
    return real.glGetError() == GL_NO_ERROR;
}

std::optional<Record> PrivateCopy::mark(Context& ctx, const FragmentTests& tests, const MarkingPlan& plan,
                                        FarEnd far_end, const std::function<void()>& draw) {
    SavedState saved(ctx);
    prepare(ctx, saved, tests, plan, far_end);
    draw();
    return read(ctx, saved, plan, far_end);
}

void PrivateCopy::prepare(Context& ctx, SavedState& saved, const FragmentTests& tests,
                          const MarkingPlan& plan, FarEnd far_end) {
    const RealGl& real = *ctx.real;
    saved.bind_draw_framebuffer(framebuffer);
    saved.set_all_bits();
    const bool is_scissored = real.glIsEnabled(GL_SCISSOR_TEST) != GL_FALSE;
    if (is_scissored) real.glDisable(GL_SCISSOR_TEST);
    constexpr GLfloat kUnmarked[4] = {};
    real.glClearNamedFramebufferfv(framebuffer, GL_COLOR, 0, kUnmarked);
    if (plan.forces_depth_writes) saved.depth_mask(true);
    if (plan.starts_far) {
        const GLfloat far_depth = occlusion_unit::far_depth(far_end);
        real.glClearNamedFramebufferfv(framebuffer, GL_DEPTH, 0, &far_depth);
    }
    if (is_scissored) real.glEnable(GL_SCISSOR_TEST);
    if (!plan.starts_far) return;
    saved.set(GL_DEPTH_TEST, true);
    saved.depth_func(far_end == FarEnd::kOne ? GL_LEQUAL : GL_GEQUAL);
    if (tests.stencil_test) saved.ignore_depth_in_stencil();
}

// What the scissor test lets a draw reach.
Rect PrivateCopy::reachable(Context& ctx) const {
    Rect rect{0, 0, shape.width, shape.height};
    if (ctx.real->glIsEnabled(GL_SCISSOR_TEST) == GL_FALSE) return rect;
    GLint box[4] = {};
    ctx.real->glGetIntegerv(GL_SCISSOR_BOX, box);
    // llvmpipe draws samples of pixels that lie beside the rectangle.
    const GLint margin = shape.samples != 0 ? 1 : 0;
    const auto grown = [margin](GLint size) { return std::min(size, 1 << 30) + 2 * margin; };
    return clipped({std::max(box[0], -(1 << 30)) - margin, std::max(box[1], -(1 << 30)) - margin,
                    grown(box[2]), grown(box[3])},
                   shape.width, shape.height);
}

std::optional<Record> PrivateCopy::read(Context& ctx, SavedState& saved, const MarkingPlan& plan,
                                        FarEnd far_end) {
    const RealGl& real = *ctx.real;
    Record record = occlusion_unit::empty_record(occlusion_unit::kAllRegisters, far_end);
    const Rect rect = reachable(ctx);
    if (rect.is_empty()) return record;
    saved.read_plainly();
    saved.bind_read_framebuffer(shape.layers != 0 ? layer_reader : framebuffer);
    const bool reads_depth = plan.can_tell_depth && shape.depth_bits != 0;
    const int samples = std::max(shape.samples, 1);
    std::vector<std::uint8_t> flags;
    std::vector<float> found;
    for (GLint layer = 0; layer < std::max(shape.layers, 1); ++layer) {
        GLuint source = framebuffer;
        if (shape.layers != 0) {
            source = layer_reader;
            real.glNamedFramebufferTextureLayer(source, GL_COLOR_ATTACHMENT0, marks, 0, layer);
            if (depths != 0)
                real.glNamedFramebufferTextureLayer(source, attachment_of(shape), depths, 0, layer);
        }
        Rect read = rect;
        Record part = record;
        if (shape.samples != 0) {
            if (!read_samples(ctx, source, rect, found, flags)) return std::nullopt;
            part.box = box_of({rect, samples, flags});
        } else {
            flags.resize(static_cast<std::size_t>(rect.area()));
            real.glReadPixels(rect.x, rect.y, rect.width, rect.height, GL_RED, GL_UNSIGNED_BYTE,
                              flags.data());
            part.box = box_of({rect, samples, flags});
            if (reads_depth && !is_empty(part.box)) {
                read = {part.box.left, part.box.bottom, part.box.right - part.box.left + 1,
                        part.box.top - part.box.bottom + 1};
                found.resize(static_cast<std::size_t>(read.area()));
                real.glReadPixels(read.x, read.y, read.width, read.height, GL_DEPTH_COMPONENT, GL_FLOAT,
                                  found.data());
            }
        }
        if (reads_depth && !is_empty(part.box)) {
            std::size_t at = 0;
            for (GLint y = read.y; y < read.y + read.height; ++y) {
                const std::size_t row =
                    static_cast<std::size_t>(y - rect.y) * static_cast<std::size_t>(rect.width);
                for (GLint x = read.x; x < read.x + read.width; ++x) {
                    for (int sample = 0; sample < samples; ++sample, ++at) {
                        const std::size_t mark =
                            (row + static_cast<std::size_t>(x - rect.x)) * static_cast<std::size_t>(samples) +
                            static_cast<std::size_t>(sample);
                        if (flags[mark] == 0) continue;
                        if (is_nearer(found[at], part.nearest_depth, far_end)) part.nearest_depth = found[at];
                    }
                }
            }
        }
        record = merged(record, part, far_end);
    }
    return record;
}

}  // namespace glext_emu
