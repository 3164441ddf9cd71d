// SPDX-License-Identifier: MIT
#include "features/features.h"

namespace glext_emu::features {

void occlusion_unit_shapes_emu(Context&, GLbitfield, GLenum, GLsizei, const GLfloat*, const GLfloat*,
                               GLuint) {
}

}  // namespace glext_emu::features
