// SPDX-License-Identifier: MIT
// Preloaded into a program: what each of its frames took, from swap to swap. A line for each goes to the file
// that FRAME_TIMES names: nanoseconds by the clock on the wall, and of the processor's time of all threads.
// The latter counts no other program's work, so it can be measured on a machine that is busy.
#define _GNU_SOURCE
#include <EGL/egl.h>
#include <GL/glx.h>
#include <dlfcn.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#define EXPORT __attribute__((visibility("default")))

static long long nanoseconds_of(clockid_t clock) {
    struct timespec now;
    clock_gettime(clock, &now);
    return now.tv_sec * 1000000000LL + now.tv_nsec;
}

// The first swap begins the first frame.
static void note_swap(void) {
    static FILE* file;
    static long long wall, processor;
    if (file == NULL) {
        const char* const path = getenv("FRAME_TIMES");
        file = path == NULL ? NULL : fopen(path, "w");
        if (file == NULL) {
            fputs("frame_times: FRAME_TIMES names no file that can be written\n", stderr);
            abort();
        }
    } else {
        fprintf(file, "%lld %lld\n", nanoseconds_of(CLOCK_MONOTONIC) - wall,
                nanoseconds_of(CLOCK_PROCESS_CPUTIME_ID) - processor);
    }
    wall = nanoseconds_of(CLOCK_MONOTONIC);
    processor = nanoseconds_of(CLOCK_PROCESS_CPUTIME_ID);
}

EXPORT EGLBoolean eglSwapBuffers(EGLDisplay display, EGLSurface surface) {
    static EGLBoolean (*next)(EGLDisplay, EGLSurface);
    if (next == NULL) *(void**)&next = dlsym(RTLD_NEXT, "eglSwapBuffers");
    const EGLBoolean done = next(display, surface);
    note_swap();
    return done;
}

EXPORT void glXSwapBuffers(Display* display, GLXDrawable drawable) {
    static void (*next)(Display*, GLXDrawable);
    if (next == NULL) *(void**)&next = dlsym(RTLD_NEXT, "glXSwapBuffers");
    next(display, drawable);
    note_swap();
}
