// SPDX-License-Identifier: MIT
// The exports' part of dlsym: what a program looks up in the handle of a library. What it looks up in a scope
// (RTLD_DEFAULT, RTLD_NEXT) the dynamic linker finds among the exported names.
#include <dlfcn.h>

#include "front/dlhook.h"
#include "front/exports.h"

namespace {

// glEnable, glXMakeCurrent, eglMakeCurrent, OSMesaMakeCurrent; not libc's glob.
FREESTANDING bool looks_like_gl(const char* name) {
    const auto is_upper = [](char c) { return c >= 'A' && c <= 'Z'; };
    if (name[0] == 'g' && name[1] == 'l') return is_upper(name[2]);
    if (name[0] == 'e' && name[1] == 'g' && name[2] == 'l') return is_upper(name[3]);
    return name[0] == 'O' && name[1] == 'S' && name[2] == 'M' && name[3] == 'e';
}

}  // namespace

void* dlhook_symbol(void* library, const char* name, const void* caller) {
    glext_emu::find_next();
    if (name == nullptr || library == RTLD_DEFAULT || library == RTLD_NEXT) return nullptr;
    return looks_like_gl(name) ? glext_emu::exported_symbol(library, name, caller) : nullptr;
}

void dlhook_before_dlopen(const char*, int) {
    glext_emu::find_next();
}
