// SPDX-License-Identifier: MIT
// The seam front end: libGLX and libEGL load their driver through dlsym(h, "__glx_Main") and "__egl_Main" and take every
// GL and window-system function from it. Answering these two names puts the layer below all GL libraries.
//
// seam_symbol and seam_open_flags run inside every dlsym and dlopen of the process, some of them before libc or a
// sanitizer is ready: no libc calls here but dlvsym, no instrumentation, no static that needs a guard.
#include <dlfcn.h>

#include "front/driver.h"

#define FREESTANDING __attribute__((visibility("hidden"), no_sanitize("address", "thread", "undefined")))

extern "C" {

using DlSym = void* (*)(void*, const char*);
using DlOpen = void* (*)(const char*, int);

__attribute__((visibility("hidden"))) DlSym seam_next_dlsym = nullptr;
__attribute__((visibility("hidden"))) DlOpen seam_next_dlopen = nullptr;

FREESTANDING void* seam_symbol(void* library, const char* name);
FREESTANDING int seam_open_flags(const char* file, int flags);
}

namespace {

FREESTANDING bool equals(const char* a, const char* b) {
    while (*a != '\0' && *a == *b) {
        ++a;
        ++b;
    }
    return *a == *b;
}

FREESTANDING bool starts_with(const char* text, const char* prefix) {
    while (*prefix != '\0' && *text == *prefix) {
        ++text;
        ++prefix;
    }
    return *prefix == '\0';
}

// libc's own dlsym is found by version; through it the next interposer's, so that the chain stays whole.
FREESTANDING void find_next() {
    if (seam_next_dlsym != nullptr) return;
    auto libc_dlsym = reinterpret_cast<DlSym>(dlvsym(RTLD_NEXT, "dlsym", "GLIBC_2.34"));
    if (libc_dlsym == nullptr) libc_dlsym = reinterpret_cast<DlSym>(dlvsym(RTLD_NEXT, "dlsym", "GLIBC_2.2.5"));
    seam_next_dlopen = reinterpret_cast<DlOpen>(libc_dlsym(RTLD_NEXT, "dlopen"));
    const auto next = reinterpret_cast<DlSym>(libc_dlsym(RTLD_NEXT, "dlsym"));
    seam_next_dlsym = next != nullptr ? next : libc_dlsym;
}

// libGL.so.1, libGLX.so.0, libOpenGL.so.0, libEGL.so.1, libGLESv2.so.2 and their like.
FREESTANDING bool is_gl_library(const char* file) {
    const char* base = file;
    for (const char* c = file; *c != '\0'; ++c) {
        if (*c == '/') base = c + 1;
    }
    return starts_with(base, "libGL") || starts_with(base, "libEGL") || starts_with(base, "libOpenGL");
}

}  // namespace

void* seam_symbol(void* library, const char* name) {
    find_next();
    if (name == nullptr || name[0] != '_' || name[1] != '_') return nullptr;
    const bool is_glx = equals(name, "__glx_Main");
    if (!is_glx && !equals(name, "__egl_Main")) return nullptr;
    void* const real = seam_next_dlsym(library, name);
    if (real == nullptr) return nullptr;
    return is_glx ? glext_emu::wrap_glx_main(real) : glext_emu::wrap_egl_main(real);
}

// With RTLD_DEEPBIND a GL library finds libc's dlsym before ours, and its driver would escape the layer.
int seam_open_flags(const char* file, int flags) {
    find_next();
    if ((flags & RTLD_DEEPBIND) == 0 || file == nullptr || !is_gl_library(file)) return flags;
    glext_emu::deepbind_was_cleared = true;
    return flags & ~RTLD_DEEPBIND;
}
