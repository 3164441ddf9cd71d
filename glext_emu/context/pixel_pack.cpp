// SPDX-License-Identifier: MIT
#include "context/pixel_pack.h"

#include "context/context.h"
#include "context/list_pause.h"

namespace glext_emu {
namespace {

constexpr GLenum kPackInvertMesa = 0x8758;  // GL_MESA_pack_invert

// Unlike the rest, pixel transfer is compiled into an open display list.
void set_depth_transfer(Context& ctx, GLfloat scale, GLfloat bias) {
    const ListPause pause(ctx);
    ctx.real->glPixelTransferf(GL_DEPTH_SCALE, scale);
    ctx.real->glPixelTransferf(GL_DEPTH_BIAS, bias);
}

}  // namespace

PixelPack::PixelPack(Context& ctx, GLuint framebuffer, bool obeys_order)
    : ctx_(ctx),
      framebuffer_(framebuffer),
      stores_{{{GL_PACK_ROW_LENGTH},
               {GL_PACK_SKIP_ROWS},
               {GL_PACK_SKIP_PIXELS},
               {GL_PACK_SWAP_BYTES},
               {kPackInvertMesa}}} {
    const RealGl& real = *ctx.real;
    GLint read_framebuffer = 0;
    real.glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &read_framebuffer);
    read_framebuffer_ = static_cast<GLuint>(read_framebuffer);
    if (read_framebuffer_ != framebuffer_) real.glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_);
    real.glGetIntegerv(GL_PIXEL_PACK_BUFFER_BINDING, &pack_buffer_);
    if (pack_buffer_ != 0) real.glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    GLint alignment = 1;
    real.glGetIntegerv(GL_PACK_ALIGNMENT, &alignment);
    alignment_ = static_cast<std::size_t>(alignment);
    for (Store& store : stores_) {
        if (store.name == kPackInvertMesa && !obeys_order) continue;
        real.glGetIntegerv(store.name, &store.value);
        if (store.value != 0) real.glPixelStorei(store.name, 0);
    }
    if (!ctx.kind.is_compatibility()) return;
    real.glGetFloatv(GL_DEPTH_SCALE, &depth_scale_);
    real.glGetFloatv(GL_DEPTH_BIAS, &depth_bias_);
    if (depth_scale_ != 1 || depth_bias_ != 0) set_depth_transfer(ctx, 1, 0);
}

PixelPack::~PixelPack() {
    const RealGl& real = *ctx_.real;
    for (const Store& store : stores_) {
        if (store.value != 0) real.glPixelStorei(store.name, store.value);
    }
    if (pack_buffer_ != 0) real.glBindBuffer(GL_PIXEL_PACK_BUFFER, static_cast<GLuint>(pack_buffer_));
    if (read_framebuffer_ != framebuffer_) real.glBindFramebuffer(GL_READ_FRAMEBUFFER, read_framebuffer_);
    if (depth_scale_ != 1 || depth_bias_ != 0) set_depth_transfer(ctx_, depth_scale_, depth_bias_);
}

}  // namespace glext_emu
