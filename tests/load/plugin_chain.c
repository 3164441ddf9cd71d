// SPDX-License-Identifier: MIT
// Load path: a program without GL opens a plugin, which opens a part, which opens GL. NEXT_STEP is the file
// that this step opens by its bare name: the dynamic linker finds it only through the RUNPATH ($ORIGIN/next)
// of the caller, so a dlopen hook that hides who calls breaks the chain. OPEN_FLAGS: more flags to open it
// with.
#define _GNU_SOURCE
#include "find_opened.h"

#ifndef OPEN_FLAGS
#define OPEN_FLAGS 0
#endif

int run_step(void);

#ifdef NEXT_STEP
int run_step(void) {
    void* handle = dlopen(NEXT_STEP, RTLD_NOW | RTLD_LOCAL | OPEN_FLAGS);
    if (!handle) return failed(dlerror());
    int (*run_next)(void) = (int (*)(void))as_function(dlsym(handle, "run_step"));
    return run_next ? run_next() : failed("the next step has no run_step");
}

int main(void) {
    return run_step();
}
#else
int run_step(void) {
    open_gl_libraries();
    return check_platform(find_winsys_symbol, find_gl_symbol);
}
#endif
