// SPDX-License-Identifier: MIT
// The drawable that a context draws to: the window, pixmap, pbuffer or memory behind the default framebuffer.
// GL does not tell its size, so the front end that makes the context current leaves here whom to ask.
#pragma once

#include <GL/gl.h>

#include <cstdint>

namespace glext_emu {

struct DrawSurface {
    struct Size {
        GLsizei width = 0;
        GLsizei height = 0;
    };
    // Asks the window system, which may be another process.
    using AskSize = Size (*)(const DrawSurface& surface);

    AskSize ask_size = nullptr;  // null: there is no drawable, or its size is known and never changes
    void* display = nullptr;     // as the window system's own functions take them
    std::uintptr_t name = 0;
    bool exists = false;
    Size size = {};
    bool has_size = false;                 // false until it is asked for, and after what may change it
    GLint viewport[4] = {-1, -1, -1, -1};  // the program's when it was asked for

    bool has_format = false;  // what follows is known
    GLint samples = 0;        // 0: single-sampled
    GLint depth_bits = 0;
    GLint stencil_bits = 0;
};

}  // namespace glext_emu
