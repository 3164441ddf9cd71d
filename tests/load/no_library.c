// SPDX-License-Identifier: MIT
// A program that looks for GL in its own scope and has no library of it, under the exports, whose names are
// there even so: nothing may crash, nothing may seem to work.
#define _GNU_SOURCE
#include <dlfcn.h>

#include "load_check.h"

static Function find_in_scope(const char* name) {
    return as_function(dlsym(RTLD_DEFAULT, name));
}

int main(void) {
    void (*enable)(GLenum) = (void (*)(GLenum))require_function(find_in_scope, "glEnable");
    const GLubyte* (*get_string)(GLenum) =
        (const GLubyte* (*)(GLenum))require_function(find_in_scope, "glGetString");
    void (*begin_nv)(GLuint) = (void (*)(GLuint))require_function(find_in_scope, "glBeginOcclusionQueryNV");
    void* (*create)(GLenum, void*) =
        (void* (*)(GLenum, void*))require_function(find_in_scope, "OSMesaCreateContext");
    int (*make_current)(void*, unsigned long, void*) =
        (int (*)(void*, unsigned long, void*))require_function(find_in_scope, "glXMakeCurrent");
    Function (*get_proc_address)(const char*) =
        (Function(*)(const char*))require_function(find_in_scope, "eglGetProcAddress");

    enable(OCCLUSION_TEST_HP);
    begin_nv(1);
    if (get_string(GL_EXTENSIONS)) return failed("there are extensions without a GL");
    if (create(GL_RGBA, NULL)) return failed("there is a context without OSMesa");
    if (make_current(NULL, 0, NULL)) return failed("GLX works without a library");
    if (get_proc_address("glEnable")) return failed("EGL has a function without a library");
    return kPassed;
}
