// SPDX-License-Identifier: MIT
// A libGL.so.1 of a program's own, such as programs bring along that were built before GLVND: it has GL's and
// GLX's functions itself and no driver is loaded through it, so that there is no seam. Debian has none any
// more; this one stands in for it. Behind it is Mesa's GLX library, linked and not looked up, whose functions
// it calls.
//
// Only what the load paths call is here.
#include <GL/glx.h>
#include <glvnd/libglxabi.h>
#include <stdlib.h>
#include <string.h>

#include "load_check.h"

#define EXPORT __attribute__((visibility("default")))

#define GLX_COMMANDS(F)  \
    F(glXChooseVisual)   \
    F(glXCreateContext)  \
    F(glXDestroyContext) \
    F(glXIsDirect)       \
    F(glXMakeCurrent)    \
    F(glXSwapBuffers)

// What Mesa has in its library for GLVND, whose part we play.
Bool __glx_Main(uint32_t version, const __GLXapiExports* exports, __GLXvendorInfo* vendor,
                __GLXapiImports* imports);

static __GLXapiImports mesa;

static Function find_in_mesa(const char* name) {
    if (!mesa.getProcAddress) {
        static const __GLXapiExports no_exports;
        const uint32_t version = GLX_VENDOR_ABI_VERSION;
        if (!__glx_Main(version, &no_exports, NULL, &mesa)) exit(failed("Mesa's GLX library does not start"));
    }
    return as_function(mesa.getProcAddress((const GLubyte*)name));
}

// The function of the same name and type that Mesa has.
#define MESA(name) ((__typeof__(&name))find_in_mesa(#name))

EXPORT void glBegin(GLenum mode) {
    MESA(glBegin)(mode);
}
EXPORT void glClear(GLbitfield mask) {
    MESA(glClear)(mask);
}
EXPORT void glDisable(GLenum cap) {
    MESA(glDisable)(cap);
}
EXPORT void glEnable(GLenum cap) {
    MESA(glEnable)(cap);
}
EXPORT void glEnd(void) {
    MESA(glEnd)();
}
EXPORT void glGetBooleanv(GLenum name, GLboolean* values) {
    MESA(glGetBooleanv)(name, values);
}
EXPORT GLenum glGetError(void) {
    return MESA(glGetError)();
}
EXPORT const GLubyte* glGetString(GLenum name) {
    return MESA(glGetString)(name);
}
EXPORT void glVertex3f(GLfloat x, GLfloat y, GLfloat z) {
    MESA(glVertex3f)(x, y, z);
}

EXPORT XVisualInfo* glXChooseVisual(Display* display, int screen, int* wanted) {
    return MESA(glXChooseVisual)(display, screen, wanted);
}
EXPORT GLXContext glXCreateContext(Display* display, XVisualInfo* visual, GLXContext share, Bool direct) {
    return MESA(glXCreateContext)(display, visual, share, direct);
}
EXPORT void glXDestroyContext(Display* display, GLXContext context) {
    MESA(glXDestroyContext)(display, context);
}
EXPORT Bool glXIsDirect(Display* display, GLXContext context) {
    return MESA(glXIsDirect)(display, context);
}
EXPORT Bool glXMakeCurrent(Display* display, GLXDrawable drawable, GLXContext context) {
    return MESA(glXMakeCurrent)(display, drawable, context);
}
EXPORT void glXSwapBuffers(Display* display, GLXDrawable drawable) {
    MESA(glXSwapBuffers)(display, drawable);
}

EXPORT Function glXGetProcAddressARB(const GLubyte* name) {
    static const struct NamedFunction kRows[] = {GL_COMMANDS(ROW) GLX_COMMANDS(ROW)};
    const Function own = find_in_rows(kRows, sizeof kRows / sizeof kRows[0], (const char*)name);
    return own ? own : find_in_mesa((const char*)name);
}
EXPORT Function glXGetProcAddress(const GLubyte* name) {
    return glXGetProcAddressARB(name);
}
