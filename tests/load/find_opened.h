// SPDX-License-Identifier: MIT
// The Finders of a program that opens its GL libraries, locally, and looks every function up.
// The including file defines _GNU_SOURCE first where it needs RTLD_NEXT and its like.
#pragma once

#include <dlfcn.h>

#include "platform.h"

static void* winsys_handle;
static void* gl_handle;

// As the manual of dlsym wants it: null may be a symbol's value, so it is dlerror that tells.
static inline Function find_symbol(void* handle, const char* name) {
    dlerror();
    void* symbol = dlsym(handle, name);
    const char* error = dlerror();
    if (symbol && error) exit(failed(error));
    return as_function(symbol);
}

static inline Function find_winsys_symbol(const char* name) {
    return find_symbol(winsys_handle, name);
}

static inline Function find_gl_symbol(const char* name) {
    return find_symbol(gl_handle, name);
}

static inline void* open_or_exit(const char* library, int mode) {
    void* handle = dlopen(library, mode);
    if (!handle) exit(failed(dlerror()));
    return handle;
}

static inline void open_gl_libraries(void) {
    winsys_handle = open_or_exit(WINSYS_LIBRARY, RTLD_NOW | RTLD_LOCAL);
    gl_handle = open_or_exit(GL_LIBRARY, RTLD_NOW | RTLD_LOCAL);
}
