// SPDX-License-Identifier: MIT
#include "features/features.h"

#include "context/settings.h"

namespace glext_emu::features {

GLint max_depth_regions() {
    return settings().device.max_regions.value_or(65536);
}

void far_depth_emu(Context& ctx, GLenum end) {
    if (end != GL_ONE && end != GL_ZERO) return ctx.raise(GL_INVALID_ENUM);
    ctx.proposed.far_end = end;
}

void get_depth_regionfv_emu(Context&, GLenum, GLint, GLint, GLsizei, GLsizei, GLfloat*) {
}
void get_depth_regionsfv_emu(Context&, GLenum, GLsizei, const GLint*, GLfloat*) {
}
void query_depth_regions_emu(Context&, GLenum, GLsizei, const GLint*, const GLuint*) {
}
void query_depth_regions_buffer_emu(Context&, GLenum, GLsizei, const GLint*, GLuint, GLintptr) {
}

}  // namespace glext_emu::features
