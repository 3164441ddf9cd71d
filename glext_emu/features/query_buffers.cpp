// SPDX-License-Identifier: MIT
#include "features/query_buffers.h"

namespace glext_emu::features {

bool is_mapped(Context& ctx, GLuint buffer) {
    if (!ctx.kind.has_named_buffers) return false;
    const OwnCalls own(ctx);
    GLint is_mapped = GL_FALSE;
    GLint access = 0;
    ctx.real->glGetNamedBufferParameteriv(buffer, GL_BUFFER_MAPPED, &is_mapped);
    ctx.real->glGetNamedBufferParameteriv(buffer, GL_BUFFER_ACCESS_FLAGS, &access);
    return is_mapped != GL_FALSE && (access & GL_MAP_PERSISTENT_BIT) == 0;
}

bool can_correct(Context& ctx, GLuint buffer) {
    return ctx.kind.has_named_buffers && ctx.real->glIsBuffer(buffer) != GL_FALSE && !is_mapped(ctx, buffer);
}

void put_bytes(Context& ctx, GLuint buffer, GLintptr offset, const void* bytes, GLsizeiptr size) {
    const OwnCalls own(ctx);
    // A copy writes to immutable storage too, which BufferSubData may not.
    GLuint scratch = 0;
    ctx.real->glCreateBuffers(1, &scratch);
    ctx.real->glNamedBufferData(scratch, size, bytes, GL_STREAM_COPY);
    ctx.real->glCopyNamedBufferSubData(scratch, buffer, 0, offset, size);
    ctx.real->glDeleteBuffers(1, &scratch);
}

bool take_bytes(Context& ctx, GLuint buffer, GLintptr offset, void* bytes, GLsizeiptr size) {
    const OwnCalls own(ctx);
    GLint64 length = 0;
    ctx.real->glGetNamedBufferParameteri64v(buffer, GL_BUFFER_SIZE, &length);
    if (offset < 0 || offset > length - size) return false;
    ctx.real->glGetNamedBufferSubData(buffer, offset, size, bytes);
    return true;
}

}  // namespace glext_emu::features
