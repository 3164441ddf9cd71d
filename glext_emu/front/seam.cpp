// SPDX-License-Identifier: MIT
// The seam front end: libGLX and libEGL load their driver through dlsym(h, "__glx_Main") and "__egl_Main" and
// take every GL and window-system function from it. Answering these two names puts the layer below all GL
// libraries.
#include <dlfcn.h>
#include <unistd.h>

#include <atomic>

#include "front/dlhook.h"
#include "front/driver.h"

namespace glext_emu {

const char* const front_name = "seam";

namespace {

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
        if (next_dlopen(library, RTLD_LAZY | RTLD_LOCAL) == nullptr) dlerror();
    }
    gl_was_loaded_ahead = true;
}

// Another front end of ours, which does what we would do: the vendor library as <library>, or the exports,
// which stand above GLVND.
bool is_ours_already(void* library) {
    if (next_dlsym(library, "glext_emu_vendor") != nullptr) return true;
    dlerror();  // the program did not ask for that name
    void* const exports = next_dlopen(kExportsLibrary, RTLD_LAZY | RTLD_NOLOAD);
    if (exports == nullptr) return false;
    dlclose(exports);
    return true;
}

}  // namespace
}  // namespace glext_emu

void* dlhook_symbol(void* library, const char* name, const void*) {
    using namespace glext_emu;
    find_next();
    if (name == nullptr || name[0] != '_' || name[1] != '_') return nullptr;
    const bool is_glx = equals(name, "__glx_Main");
    if (!is_glx && !equals(name, "__egl_Main")) return nullptr;
    void* const real = next_dlsym(library, name);
    if (real == nullptr || is_ours_already(library)) return real;
    return is_glx ? wrap_glx_main(real) : wrap_egl_main(real);
}

void dlhook_before_dlopen(const char* file, int flags) {
    using namespace glext_emu;
    find_next();
    const bool is_deep = (flags & (RTLD_DEEPBIND | RTLD_NOLOAD)) == RTLD_DEEPBIND;
    if (is_deep && file != nullptr && is_wanted()) load_gl_ahead();
}
