// SPDX-License-Identifier: MIT
// Load path: the GL libraries are opened, used, closed and opened again, as a program does that changes
// renderer.
#include "find_opened.h"

int main(void) {
    for (int round = 0; round < 3; ++round) {
        open_gl_libraries();
        const int status = check_platform(find_winsys_symbol, find_gl_symbol);
        if (status != kPassed) return status;
        dlclose(gl_handle);
        dlclose(winsys_handle);
    }
    return kPassed;
}
