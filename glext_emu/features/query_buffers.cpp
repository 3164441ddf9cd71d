// SPDX-License-Identifier: MIT
#include "features/query_buffers.h"

#include <utility>

namespace glext_emu::features {
namespace {

// A buffer on a binding point that nothing draws from, and what was there before afterwards.
class BindScope {
  public:
    BindScope(Context& ctx, GLenum target, GLenum binding, GLuint buffer) : ctx_(ctx), target_(target) {
        ctx_.real->glGetIntegerv(binding, &before_);
        ctx_.real->glBindBuffer(target_, buffer);
    }
    ~BindScope() { ctx_.real->glBindBuffer(target_, static_cast<GLuint>(before_)); }
    BindScope(const BindScope&) = delete;
    BindScope& operator=(const BindScope&) = delete;

  private:
    Context& ctx_;
    GLenum target_;
    GLint before_ = 0;
};

}  // namespace

void put_bytes(Context& ctx, GLuint buffer, GLintptr offset, const void* bytes, GLsizeiptr size) {
    const OwnCalls own(ctx);
    const BindScope to(ctx, GL_COPY_WRITE_BUFFER, GL_COPY_WRITE_BUFFER_BINDING, buffer);
    // A copy writes to immutable storage too, which BufferSubData may not.
    GLuint scratch = 0;
    ctx.real->glGenBuffers(1, &scratch);
    {
        const BindScope from(ctx, GL_COPY_READ_BUFFER, GL_COPY_READ_BUFFER_BINDING, scratch);
        ctx.real->glBufferData(GL_COPY_READ_BUFFER, size, bytes, GL_STREAM_COPY);
        ctx.real->glCopyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, 0, offset, size);
    }
    ctx.real->glDeleteBuffers(1, &scratch);
}

bool take_bytes(Context& ctx, GLuint buffer, GLintptr offset, void* bytes, GLsizeiptr size) {
    const OwnCalls own(ctx);
    const BindScope from(ctx, GL_COPY_READ_BUFFER, GL_COPY_READ_BUFFER_BINDING, buffer);
    ctx.real->glGetBufferSubData(GL_COPY_READ_BUFFER, offset, size, bytes);
    return ctx.real->glGetError() == GL_NO_ERROR;
}

}  // namespace glext_emu::features
