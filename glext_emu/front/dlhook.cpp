// SPDX-License-Identifier: MIT
#include "front/dlhook.h"

#include <dlfcn.h>

using DlSym = void* (*)(void*, const char*);
using DlOpen = void* (*)(const char*, int);

__attribute__((visibility("hidden"))) DlSym next_dlsym = nullptr;
__attribute__((visibility("hidden"))) DlOpen next_dlopen = nullptr;

namespace glext_emu {

DlSym libc_dlsym = nullptr;

bool equals(const char* a, const char* b) {
    while (*a != '\0' && *a == *b) {
        ++a;
        ++b;
    }
    return *a == *b;
}

// libc's own dlsym is found by version; through it the next interposer's, so that the chain stays whole.
void find_next() {
    if (next_dlsym != nullptr) return;
    libc_dlsym = reinterpret_cast<DlSym>(dlvsym(RTLD_NEXT, "dlsym", "GLIBC_2.34"));
    if (libc_dlsym == nullptr)
        libc_dlsym = reinterpret_cast<DlSym>(dlvsym(RTLD_NEXT, "dlsym", "GLIBC_2.2.5"));
    next_dlopen = reinterpret_cast<DlOpen>(libc_dlsym(RTLD_NEXT, "dlopen"));
    const auto next = reinterpret_cast<DlSym>(libc_dlsym(RTLD_NEXT, "dlsym"));
    next_dlsym = next != nullptr ? next : libc_dlsym;
}

}  // namespace glext_emu
