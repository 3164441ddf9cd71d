// SPDX-License-Identifier: MIT
// Load paths by dlopen: `dlopened FLAG WINSYS_LIBRARY [GL_LIBRARY]`. FLAG is `local`, `global` (names are
// then looked up with RTLD_DEFAULT) or `deepbind`. Without GL_LIBRARY everything comes from GetProcAddress.
#define _GNU_SOURCE
#include "find_opened.h"

static Function (*get_proc_address)(const char* name);

static Function find_by_get_proc_address(const char* name) {
    return get_proc_address(name);
}

static void* open_with(const char* flag, const char* library) {
    if (strcmp(flag, "global") == 0) {
        open_or_exit(library, RTLD_NOW | RTLD_GLOBAL);
        return RTLD_DEFAULT;
    }
    return open_or_exit(library, RTLD_NOW | RTLD_LOCAL | (strcmp(flag, "deepbind") == 0 ? RTLD_DEEPBIND : 0));
}

int main(int argc, char** argv) {
    if (argc < 3) return kBadUse;
    winsys_handle = open_with(argv[1], argv[2]);
    if (argc > 3) {
        gl_handle = open_with(argv[1], argv[3]);
        return check_platform(find_winsys_symbol, find_gl_symbol);
    }
    get_proc_address =
        (Function(*)(const char*))require_function(find_winsys_symbol, WINSYS_GET_PROC_ADDRESS);
    return check_platform(find_by_get_proc_address, find_by_get_proc_address);
}
