// SPDX-License-Identifier: MIT
#include "context/framebuffer_info.h"

#include <algorithm>
#include <limits>

#include "context/context.h"

namespace glext_emu {
namespace {

GLint get(const Context& ctx, GLenum name) {
    GLint value = 0;
    ctx.real->glGetIntegerv(name, &value);
    return value;
}

GLint attachment_value(const Context& ctx, GLenum attachment, GLenum name) {
    GLint value = 0;
    ctx.real->glGetFramebufferAttachmentParameteriv(GL_DRAW_FRAMEBUFFER, attachment, name, &value);
    return value;
}

// What has no image is not asked further: the error would show in a debug context's log.
bool has_image(const Context& ctx, GLenum attachment) {
    return attachment_value(ctx, attachment, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE) != GL_NONE;
}

void read_depth_and_stencil(const Context& ctx, GLenum depth, GLenum stencil, FramebufferInfo& info) {
    if (has_image(ctx, depth)) {
        info.depth_bits = attachment_value(ctx, depth, GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE);
        info.has_float_depth =
            attachment_value(ctx, depth, GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE) == GL_FLOAT;
    }
    if (has_image(ctx, stencil)) {
        info.stencil_bits = attachment_value(ctx, stencil, GL_FRAMEBUFFER_ATTACHMENT_STENCIL_SIZE);
    }
}

GLint sample_count(const Context& ctx) {
    return get(ctx, GL_SAMPLE_BUFFERS) != 0 ? get(ctx, GL_SAMPLES) : 0;
}

GLuint samples_per_pixel(const Context& ctx) {
    const GLint samples = get(ctx, GL_SAMPLES);
    return samples > 1 ? static_cast<GLuint>(samples) : 1;
}

// A window may be resized at any time, but drivers follow at these times only, and an X server is 20 us away.
DrawSurface::Size surface_size(Context& ctx) {
    DrawSurface& surface = ctx.draw_surface;
    if (surface.ask_size == nullptr) return surface.size;
    GLint viewport[4];
    ctx.real->glGetIntegerv(GL_VIEWPORT, viewport);
    if (!surface.has_size || !std::ranges::equal(viewport, surface.viewport)) {
        surface.size = surface.ask_size(surface);
        surface.has_size = true;
        std::ranges::copy(viewport, surface.viewport);
    }
    return surface.size;
}

FramebufferInfo default_framebuffer(Context& ctx) {
    FramebufferInfo info{.is_default = true};
    if (!ctx.draw_surface.exists) return info;
    info.is_complete = true;
    const DrawSurface::Size size = surface_size(ctx);
    info.width = size.width;
    info.height = size.height;
    // Its format is that of the configuration, which stays while it is current.
    if (!ctx.draw_surface.has_format) {
        ctx.draw_surface.samples = sample_count(ctx);
        read_depth_and_stencil(ctx, GL_DEPTH, GL_STENCIL, info);
        ctx.draw_surface.depth_bits = info.depth_bits;
        ctx.draw_surface.stencil_bits = info.stencil_bits;
        ctx.draw_surface.has_format = true;
    }
    info.samples = ctx.draw_surface.samples;
    info.depth_bits = ctx.draw_surface.depth_bits;
    info.stencil_bits = ctx.draw_surface.stencil_bits;
    return info;
}

struct ImageSize {
    GLint width = 0;
    GLint height = 0;
    GLint layers = 0;  // 0: not layered
};

ImageSize renderbuffer_size(const Context& ctx, GLuint name) {
    ImageSize size;
    ctx.real->glGetNamedRenderbufferParameteriv(name, GL_RENDERBUFFER_WIDTH, &size.width);
    ctx.real->glGetNamedRenderbufferParameteriv(name, GL_RENDERBUFFER_HEIGHT, &size.height);
    return size;
}

ImageSize texture_size(const Context& ctx, GLenum attachment, GLuint name) {
    const GLint level = attachment_value(ctx, attachment, GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LEVEL);
    const bool is_layered = attachment_value(ctx, attachment, GL_FRAMEBUFFER_ATTACHMENT_LAYERED) != 0;
    ImageSize size;
    GLint target = 0;
    GLint depth = 0;
    ctx.real->glGetTextureParameteriv(name, GL_TEXTURE_TARGET, &target);
    ctx.real->glGetTextureLevelParameteriv(name, level, GL_TEXTURE_WIDTH, &size.width);
    ctx.real->glGetTextureLevelParameteriv(name, level, GL_TEXTURE_HEIGHT, &size.height);
    ctx.real->glGetTextureLevelParameteriv(name, level, GL_TEXTURE_DEPTH, &depth);
    const bool is_1d_array = target == GL_TEXTURE_1D_ARRAY;
    if (is_layered) size.layers = is_1d_array ? size.height : target == GL_TEXTURE_CUBE_MAP ? 6 : depth;
    if (is_1d_array) size.height = 1;
    return size;
}

FramebufferInfo framebuffer_object(Context& ctx, GLuint framebuffer) {
    FramebufferInfo info{.name = framebuffer};
    if (ctx.real->glCheckFramebufferStatus(GL_DRAW_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) return info;
    info.is_complete = true;
    info.samples = sample_count(ctx);
    read_depth_and_stencil(ctx, GL_DEPTH_ATTACHMENT, GL_STENCIL_ATTACHMENT, info);

    ImageSize least{std::numeric_limits<GLint>::max(), std::numeric_limits<GLint>::max(),
                    std::numeric_limits<GLint>::max()};
    bool has_any = false;
    const auto take = [&](GLenum attachment) {
        const GLint type = attachment_value(ctx, attachment, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE);
        if (type == GL_NONE) return;
        const auto name =
            static_cast<GLuint>(attachment_value(ctx, attachment, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME));
        const ImageSize size =
            type == GL_RENDERBUFFER ? renderbuffer_size(ctx, name) : texture_size(ctx, attachment, name);
        least.width = std::min(least.width, size.width);
        least.height = std::min(least.height, size.height);
        least.layers = std::min(least.layers, size.layers);
        has_any = true;
    };
    take(GL_DEPTH_ATTACHMENT);
    take(GL_STENCIL_ATTACHMENT);
    const GLint colors = get(ctx, GL_MAX_COLOR_ATTACHMENTS);
    for (GLint i = 0; i < colors; ++i) take(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(i));
    if (!has_any) {  // ARB_framebuffer_no_attachments
        const auto ask = [&](GLenum name) {
            GLint value = 0;
            ctx.real->glGetNamedFramebufferParameteriv(framebuffer, name, &value);
            return value;
        };
        least = {ask(GL_FRAMEBUFFER_DEFAULT_WIDTH), ask(GL_FRAMEBUFFER_DEFAULT_HEIGHT),
                 ask(GL_FRAMEBUFFER_DEFAULT_LAYERS)};
    }
    info.width = least.width;
    info.height = least.height;
    info.layers = least.layers;
    return info;
}

}  // namespace

std::uint64_t window_pixels(Context& ctx) {
    if (!ctx.draw_surface.exists) return 0;
    const DrawSurface::Size size = surface_size(ctx);
    return static_cast<std::uint64_t>(size.width) * static_cast<std::uint64_t>(size.height);
}

FramebufferInfo draw_framebuffer_info(Context& ctx) {
    constexpr GLint kNoName = -1;
    GLint bound = kNoName;
    ctx.real->glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
    if (bound == kNoName) return {.is_between_begin_and_end = true};
    const auto framebuffer = static_cast<GLuint>(bound);
    // Nothing is asked then that could be in error, and looking for one takes time.
    if (framebuffer == 0 && ctx.draw_surface.has_format) return default_framebuffer(ctx);
    const OwnCalls own(ctx);
    return framebuffer == 0 ? default_framebuffer(ctx) : framebuffer_object(ctx, framebuffer);
}

GLuint samples_per_count(Context& ctx) {
    return ctx.real->glIsEnabled(GL_MULTISAMPLE) != GL_FALSE ? 1 : samples_per_pixel(ctx);
}

GLuint samples_per_fragment(Context& ctx) {
    return ctx.real->glIsEnabled(GL_MULTISAMPLE) != GL_FALSE ? samples_per_pixel(ctx) : 1;
}

}  // namespace glext_emu
