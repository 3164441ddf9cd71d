// SPDX-License-Identifier: MIT
// The conditional rendering in progress, where the layer has to know of it.
#pragma once

#include <GL/gl.h>

namespace glext_emu {

struct ConditionalRender {
    GLuint query = 0;  // 0: none in progress, as far as the layer follows it
    // False where everything is drawn because a result is not due yet: then the driver knows of none.
    bool is_in_driver = false;
    GLenum mode = 0;  // the driver's, while it is there
};

}  // namespace glext_emu
