// SPDX-License-Identifier: MIT
// An overlay in the manner of MangoHud: a preload that takes dlsym, lets the real one look the name up, and
// answers the swap functions with its own. Where the real dlsym is, it asks libc's dlvsym, by the version in
// OVERLAY_DLSYM_VERSION (GLIBC_2.34 unless set), which passes over any interposer that has no such version.
#define _GNU_SOURCE
#include <dlfcn.h>
#include <stdlib.h>
#include <string.h>

#define EXPORT __attribute__((visibility("default")))

EXPORT int overlay_lookups(void);
EXPORT int overlay_swaps(void);
EXPORT void* dlsym(void* handle, const char* name);

typedef void* (*Dlsym)(void* handle, const char* name);

static int lookups;
static int swaps;
static void (*real_glx_swap)(void* display, unsigned long drawable);
static unsigned (*real_egl_swap)(void* display, void* surface);

int overlay_lookups(void) {
    return lookups;
}

int overlay_swaps(void) {
    return swaps;
}

static void swap_glx(void* display, unsigned long drawable) {
    ++swaps;
    real_glx_swap(display, drawable);
}

static unsigned swap_egl(void* display, void* surface) {
    ++swaps;
    return real_egl_swap(display, surface);
}

static Dlsym find_real_dlsym(void) {
    const char* version = getenv("OVERLAY_DLSYM_VERSION");
    void* symbol = dlvsym(RTLD_NEXT, "dlsym", version ? version : "GLIBC_2.34");
    Dlsym real;
    memcpy(&real, &symbol, sizeof real);
    return real;
}

// Keeps the function that was found, answers with the overlay's.
static void* replace(void* found, void* kept_in, void (*with)(void)) {
    void* answer;
    memcpy(kept_in, &found, sizeof found);
    memcpy(&answer, &with, sizeof answer);
    return answer;
}

void* dlsym(void* handle, const char* name) {
    static Dlsym real;
    if (!real) real = find_real_dlsym();
    void* found = real(handle, name);
    if (strcmp(name, "glVertex3f") == 0) ++lookups;
    if (found && strcmp(name, "glXSwapBuffers") == 0)
        return replace(found, &real_glx_swap, (void (*)(void))swap_glx);
    if (found && strcmp(name, "eglSwapBuffers") == 0)
        return replace(found, &real_egl_swap, (void (*)(void))swap_egl);
    return found;
}
