// SPDX-License-Identifier: MIT
// The seam front end: libGLX and libEGL load their driver through dlsym(h, "__glx_Main") and "__egl_Main" and
// take every GL and window-system function from it. Answering these two names puts the layer below all GL
// libraries.
//
// seam_symbol and seam_before_dlopen run inside every dlsym and dlopen of the process, some of them before
// libc or a sanitizer is ready: no libc calls here but dlvsym, no instrumentation, no static that needs a
// guard.
#include <dlfcn.h>
#include <unistd.h>

#include <atomic>

#include "front/driver.h"

#define FREESTANDING __attribute__((visibility("hidden"), no_sanitize("address", "thread", "undefined")))

extern "C" {

using DlSym = void* (*)(void*, const char*);
using DlOpen = void* (*)(const char*, int);

__attribute__((visibility("hidden"))) DlSym seam_next_dlsym = nullptr;
__attribute__((visibility("hidden"))) DlOpen seam_next_dlopen = nullptr;

FREESTANDING void* seam_symbol(void* library, const char* name);
FREESTANDING void seam_before_dlopen(const char* file, int flags);
}

namespace glext_emu {

const char* const front_name = "seam";

}  // namespace glext_emu

namespace {

FREESTANDING bool equals(const char* a, const char* b) {
    while (*a != '\0' && *a == *b) {
        ++a;
        ++b;
    }
    return *a == *b;
}

// libc's own dlsym is found by version; through it the next interposer's, so that the chain stays whole.
FREESTANDING void find_next() {
    if (seam_next_dlsym != nullptr) return;
    auto libc_dlsym = reinterpret_cast<DlSym>(dlvsym(RTLD_NEXT, "dlsym", "GLIBC_2.34"));
    if (libc_dlsym == nullptr)
        libc_dlsym = reinterpret_cast<DlSym>(dlvsym(RTLD_NEXT, "dlsym", "GLIBC_2.2.5"));
    seam_next_dlopen = reinterpret_cast<DlOpen>(libc_dlsym(RTLD_NEXT, "dlopen"));
    const auto next = reinterpret_cast<DlSym>(libc_dlsym(RTLD_NEXT, "dlsym"));
    seam_next_dlsym = next != nullptr ? next : libc_dlsym;
}

// True where the environment asks the layer for something: a GLEXT_EMU that is neither empty nor 0.
FREESTANDING bool is_wanted() {
    for (char** entry = environ; entry != nullptr && *entry != nullptr; ++entry) {
        const char* name = "GLEXT_EMU=";
        const char* c = *entry;
        while (*name != '\0' && *name == *c) {
            ++name;
            ++c;
        }
        if (*name == '\0') return *c != '\0' && !equals(c, "0");
    }
    return false;
}

// With RTLD_DEEPBIND a library, and whatever it pulls in, finds libc's dlsym before ours: libGLX or libEGL
// loaded that way would escape the layer. Loaded before, and without the flag, they bind to ours; the
// program's flag stays as it is.
void load_gl_ahead() {
    static std::atomic<bool> is_done{false};
    if (is_done.exchange(true)) return;
    for (const char* library : {"libGLX.so.0", "libEGL.so.1"}) {
        if (seam_next_dlopen(library, RTLD_LAZY | RTLD_LOCAL) == nullptr) dlerror();
    }
    glext_emu::gl_was_loaded_ahead = true;
}

}  // namespace

void* seam_symbol(void* library, const char* name) {
    find_next();
    if (name == nullptr || name[0] != '_' || name[1] != '_') return nullptr;
    const bool is_glx = equals(name, "__glx_Main");
    if (!is_glx && !equals(name, "__egl_Main")) return nullptr;
    void* const real = seam_next_dlsym(library, name);
    if (real == nullptr) return nullptr;
    // Our own vendor library does what we would do.
    if (seam_next_dlsym(library, "glext_emu_vendor") != nullptr) return real;
    dlerror();  // the program did not ask for that name
    return is_glx ? glext_emu::wrap_glx_main(real) : glext_emu::wrap_egl_main(real);
}

void seam_before_dlopen(const char* file, int flags) {
    find_next();
    const bool is_deep = (flags & (RTLD_DEEPBIND | RTLD_NOLOAD)) == RTLD_DEEPBIND;
    if (is_deep && file != nullptr && is_wanted()) load_gl_ahead();
}
