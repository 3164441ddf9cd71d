// SPDX-License-Identifier: MIT
// The program for next_preload.c: the other preload must reach libc's time, and GL must still have the layer.
#include <time.h>

#include "find_opened.h"

__attribute__((weak)) int neighbour_calls(void);

int main(void) {
    if (!neighbour_calls) return failed("the other preload is not loaded");
    struct timespec now;
    clock_gettime(CLOCK_REALTIME, &now);
    const time_t seconds = time(NULL);
    if (seconds < now.tv_sec - 1 || seconds > now.tv_sec + 60) return failed("time is not libc's time");
    if (neighbour_calls() != 1) return failed("the other preload was not called exactly once");

    open_gl_libraries();
    return check_platform(find_winsys_symbol, find_gl_symbol);
}
