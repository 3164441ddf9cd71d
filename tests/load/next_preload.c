// SPDX-License-Identifier: MIT
// Another preload, beside the layer: it takes a function of libc and finds the real one with RTLD_NEXT, which
// the dynamic linker resolves by who calls. A dlsym hook that hides the caller makes it find itself.
#define _GNU_SOURCE
#include <dlfcn.h>
#include <string.h>
#include <time.h>

__attribute__((visibility("default"))) int neighbour_calls(void);
__attribute__((visibility("default"))) time_t time(time_t* seconds);

static int calls;

int neighbour_calls(void) {
    return calls;
}

time_t time(time_t* seconds) {
    time_t (*next)(time_t*);
    void* symbol = dlsym(RTLD_NEXT, "time");
    memcpy(&next, &symbol, sizeof next);
    ++calls;
    if (calls > 1000 || !next) return (time_t)-1;  // it found itself, or nothing
    return next(seconds);
}
