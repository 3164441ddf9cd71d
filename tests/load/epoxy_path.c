// SPDX-License-Identifier: MIT
// Load path: libepoxy, which opens the GL libraries itself at the first call of each function.
#ifdef LOAD_GLX
#include <epoxy/gl.h>
#include <epoxy/glx.h>
#else
#include <epoxy/egl.h>
#include <epoxy/gl.h>
#endif

#include "platform.h"

static Function find_winsys(const char* name) {
#ifndef LOAD_GLX
    // libepoxy 1.5.10 offers the EGL 1.5 name only once a display is current; the extension's does the same.
    if (strcmp(name, "eglGetPlatformDisplay") == 0) return (Function)eglGetPlatformDisplayEXT;
#endif
    const struct NamedFunction rows[] = {WINSYS_COMMANDS(ROW)};
    return find_in_rows(rows, sizeof rows / sizeof rows[0], name);
}

static Function find_gl_by_epoxy(const char* name) {
    const struct NamedFunction rows[] = {GL_COMMANDS(ROW)};
    return find_in_rows(rows, sizeof rows / sizeof rows[0], name);
}

int main(void) {
    return check_platform(find_winsys, find_gl_by_epoxy);
}
