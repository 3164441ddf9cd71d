// SPDX-License-Identifier: MIT
// The GL commands that the clients call, as pointers of the context's own library: libGL and libOSMesa have
// the same names, and one program may choose. They stand in this namespace, where they hide the global names.
#pragma once

#include <GL/gl.h>

#define APPS_GL_COMMANDS(COMMAND) \
    COMMAND(glBlendFunc)          \
    COMMAND(glClear)              \
    COMMAND(glClearColor)         \
    COMMAND(glColorMask)          \
    COMMAND(glColorPointer)       \
    COMMAND(glDepthFunc)          \
    COMMAND(glDepthMask)          \
    COMMAND(glDisable)            \
    COMMAND(glDrawArrays)         \
    COMMAND(glDrawElements)       \
    COMMAND(glDrawPixels)         \
    COMMAND(glEnable)             \
    COMMAND(glEnableClientState)  \
    COMMAND(glFinish)             \
    COMMAND(glGetBooleanv)        \
    COMMAND(glGetString)          \
    COMMAND(glLineWidth)          \
    COMMAND(glLoadIdentity)       \
    COMMAND(glLoadMatrixf)        \
    COMMAND(glMatrixMode)         \
    COMMAND(glPixelStorei)        \
    COMMAND(glPolygonOffset)      \
    COMMAND(glPopMatrix)          \
    COMMAND(glPushMatrix)         \
    COMMAND(glRasterPos2f)        \
    COMMAND(glReadPixels)         \
    COMMAND(glShadeModel)         \
    COMMAND(glVertexPointer)      \
    COMMAND(glViewport)

namespace apps {

class Platform;

#define DECLARE(name) extern decltype(&::name) name;
APPS_GL_COMMANDS(DECLARE)
#undef DECLARE

/// Points all of them to the functions of the platform's library. All contexts of a process are of one
/// library.
void load_gl(Platform& platform);

}  // namespace apps
