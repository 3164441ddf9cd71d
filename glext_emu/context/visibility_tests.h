// SPDX-License-Identifier: MIT
// What the layer remembers of GL_HP_visibility_test: the program's buffer and the test of the batch that is
// under way.
#pragma once

#include "context/count_pipe.h"

namespace glext_emu {

struct VisibilityTests {
    bool has_buffer = false;  // VisibilityBuffer was called, whatever it said
    GLboolean* buffer = nullptr;
    GLsizei size = 0;  // of it, in results
    bool waits = false;
    bool is_enabled = false;
    GLsizei test = 0;  // the one that is under way: the first is 0
    CountPipe pipe;
};

}  // namespace glext_emu
