// SPDX-License-Identifier: MIT
// Commands that change nothing to a program under a device and take time on it: clears, reads of pixels, and
// how much video memory its buffers fill. And GL_EMU_device_time, by which a program tells of its own work.
#include "context/device_time.h"
#include "context/framebuffer_info.h"
#include "context/list_pause.h"
#include "features/features.h"

#include <algorithm>
#include <limits>

namespace glext_emu::features {
namespace {

bool is_executed(const Context& ctx) {
    return ctx.time != nullptr && !ctx.recording.only_compiles();
}

// Pixels that a clear touches: the draw framebuffer's, inside the scissor rectangle.
void note_clear(Context& ctx) {
    if (!is_executed(ctx) || ctx.real->glIsEnabled(GL_RASTERIZER_DISCARD) != GL_FALSE) return;
    const FramebufferInfo info = draw_framebuffer_info(ctx);
    std::uint64_t pixels = static_cast<std::uint64_t>(info.width) * static_cast<std::uint64_t>(info.height);
    if (ctx.real->glIsEnabled(GL_SCISSOR_TEST) != GL_FALSE) {
        GLint box[4] = {};
        ctx.real->glGetIntegerv(GL_SCISSOR_BOX, box);
        const auto length = [](std::int64_t low, std::int64_t size, std::int64_t most) {
            return static_cast<std::uint64_t>(
                std::max<std::int64_t>(0, std::min(low + size, most) - std::max<std::int64_t>(low, 0)));
        };
        pixels = length(box[0], box[2], info.width) * length(box[1], box[3], info.height);
    }
    ctx.time->clear(pixels, static_cast<std::uint32_t>(std::max(info.samples, 1)));
}

// A clear of one buffer of several is half of a clear of colour and depth.
template <class Call>
void clear_by(Context& ctx, Call call) {
    if (ctx.time == nullptr) return call();
    ctx.time->pause();
    if (driver_accepts(ctx, call)) note_clear(ctx);
}

// Before the pixels are there: the device has to draw them first.
void note_read(Context& ctx, GLsizei width, GLsizei height) {
    const auto pixels = static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height);
    GLint buffer = 0;
    ctx.real->glGetIntegerv(GL_PIXEL_PACK_BUFFER_BINDING, &buffer);
    if (buffer != 0) return ctx.time->copy_to_buffer(pixels);
    ctx.time->read_back(pixels);
}

template <class Call>
void read_by(Context& ctx, GLsizei width, GLsizei height, Call call) {
    if (ctx.time == nullptr) return call();
    need_pixels("glReadPixels");
    ctx.time->pause();
    if (driver_accepts(ctx, call) && width > 0 && height > 0) note_read(ctx, width, height);
}

// The buffer of vertices or indices that is bound to <target>; 0: none, or one of another kind.
GLuint bound_mesh(Context& ctx, GLenum target) {
    GLint name = 0;
    if (target == GL_ARRAY_BUFFER) ctx.real->glGetIntegerv(GL_ARRAY_BUFFER_BINDING, &name);
    if (target == GL_ELEMENT_ARRAY_BUFFER) ctx.real->glGetIntegerv(GL_ELEMENT_ARRAY_BUFFER_BINDING, &name);
    return static_cast<GLuint>(name);
}

void note_storage(Context& ctx, GLuint buffer, GLsizeiptr size) {
    if (ctx.time == nullptr || buffer == 0) return;
    ShareGroup& group = *ctx.share_group;
    const std::lock_guard lock(group.mutex);
    GLsizeiptr& bytes = group.buffer_sizes[buffer];
    group.buffer_bytes += size - bytes;
    bytes = size;
}

}  // namespace

void clear(Context& ctx, GLbitfield mask) {
    clear_by(ctx, [&] { ctx.real->glClear(mask); });
}

void clear_bufferfi(Context& ctx, GLenum buffer, GLint index, GLfloat depth, GLint stencil) {
    clear_by(ctx, [&] { ctx.real->glClearBufferfi(buffer, index, depth, stencil); });
}

void clear_bufferfv(Context& ctx, GLenum buffer, GLint index, const GLfloat* value) {
    clear_by(ctx, [&] { ctx.real->glClearBufferfv(buffer, index, value); });
}

void clear_bufferiv(Context& ctx, GLenum buffer, GLint index, const GLint* value) {
    clear_by(ctx, [&] { ctx.real->glClearBufferiv(buffer, index, value); });
}

void clear_bufferuiv(Context& ctx, GLenum buffer, GLint index, const GLuint* value) {
    clear_by(ctx, [&] { ctx.real->glClearBufferuiv(buffer, index, value); });
}

void clear_named_framebufferfi(Context& ctx, GLuint framebuffer, GLenum buffer, GLint index, GLfloat depth,
                               GLint stencil) {
    clear_by(ctx, [&] { ctx.real->glClearNamedFramebufferfi(framebuffer, buffer, index, depth, stencil); });
}

void clear_named_framebufferfv(Context& ctx, GLuint framebuffer, GLenum buffer, GLint index,
                               const GLfloat* value) {
    clear_by(ctx, [&] { ctx.real->glClearNamedFramebufferfv(framebuffer, buffer, index, value); });
}

void clear_named_framebufferiv(Context& ctx, GLuint framebuffer, GLenum buffer, GLint index,
                               const GLint* value) {
    clear_by(ctx, [&] { ctx.real->glClearNamedFramebufferiv(framebuffer, buffer, index, value); });
}

void clear_named_framebufferuiv(Context& ctx, GLuint framebuffer, GLenum buffer, GLint index,
                                const GLuint* value) {
    clear_by(ctx, [&] { ctx.real->glClearNamedFramebufferuiv(framebuffer, buffer, index, value); });
}

void read_pixels(Context& ctx, GLint x, GLint y, GLsizei width, GLsizei height, GLenum format, GLenum type,
                 void* pixels) {
    read_by(ctx, width, height, [&] { ctx.real->glReadPixels(x, y, width, height, format, type, pixels); });
}

void readn_pixels(Context& ctx, GLint x, GLint y, GLsizei width, GLsizei height, GLenum format, GLenum type,
                  GLsizei size, void* data) {
    read_by(ctx, width, height,
            [&] { ctx.real->glReadnPixels(x, y, width, height, format, type, size, data); });
}

void buffer_data(Context& ctx, GLenum target, GLsizeiptr size, const void* data, GLenum usage) {
    if (driver_accepts(ctx, [&] { ctx.real->glBufferData(target, size, data, usage); }))
        note_storage(ctx, bound_mesh(ctx, target), size);
}

void buffer_storage(Context& ctx, GLenum target, GLsizeiptr size, const void* data, GLbitfield flags) {
    if (driver_accepts(ctx, [&] { ctx.real->glBufferStorage(target, size, data, flags); }))
        note_storage(ctx, bound_mesh(ctx, target), size);
}

void named_buffer_data(Context& ctx, GLuint buffer, GLsizeiptr size, const void* data, GLenum usage) {
    if (driver_accepts(ctx, [&] { ctx.real->glNamedBufferData(buffer, size, data, usage); }))
        note_storage(ctx, buffer, size);
}

void named_buffer_storage(Context& ctx, GLuint buffer, GLsizeiptr size, const void* data, GLbitfield flags) {
    if (driver_accepts(ctx, [&] { ctx.real->glNamedBufferStorage(buffer, size, data, flags); }))
        note_storage(ctx, buffer, size);
}

void delete_buffers(Context& ctx, GLsizei n, const GLuint* buffers) {
    ctx.real->glDeleteBuffers(n, buffers);
    if (ctx.time == nullptr || buffers == nullptr) return;
    ShareGroup& group = *ctx.share_group;
    const std::lock_guard lock(group.mutex);
    for (GLsizei i = 0; i < n; ++i) {
        const auto found = group.buffer_sizes.find(buffers[i]);
        if (found == group.buffer_sizes.end()) continue;
        group.buffer_bytes -= found->second;
        group.buffer_sizes.erase(found);
    }
}

void device_work_emu(Context& ctx, GLuint64 nanoseconds) {
    if (ctx.time != nullptr) ctx.time->work(nanoseconds);
}

}  // namespace glext_emu::features
