// SPDX-License-Identifier: MIT
// GetQueryObject* of what the proposed extensions keep, to client memory only.
#pragma once

#include <GL/gl.h>
#include <GL/glext.h>

namespace glext_emu {
struct Context;
}

namespace glext_emu::features {

// <id> is an object of one of the proposed targets.
void get_proposed_result(Context& ctx, GLuint id, GLenum pname, GLint* params);
void get_proposed_result(Context& ctx, GLuint id, GLenum pname, GLuint* params);
void get_proposed_result(Context& ctx, GLuint id, GLenum pname, GLint64* params);
void get_proposed_result(Context& ctx, GLuint id, GLenum pname, GLuint64* params);

}  // namespace glext_emu::features
