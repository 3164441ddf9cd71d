// SPDX-License-Identifier: MIT
// GL as every conformance program sees it: Khronos' headers, linked through GLVND, nothing of the emulator.
#pragma once

#define GL_GLEXT_PROTOTYPES 1
#include <GL/gl.h>
#include <GL/glext.h>
