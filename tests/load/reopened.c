// SPDX-License-Identifier: MIT
// Load path: the GL libraries are opened, used, closed and opened again, as a program does that changes
// renderer. Each time somewhere else in memory, and more often than any table of drivers is long.
#define _GNU_SOURCE
#include <sys/mman.h>

#include "find_opened.h"

// Takes the places that the libraries left, so that they cannot come back to them: small pieces, as many as
// the largest of them would fill.
static void fill_the_gaps(void) {
    const size_t kPiece = 64U << 10;
    const size_t kAll = 128U << 20;
    for (size_t taken = 0; taken < kAll; taken += kPiece)
        if (mmap(NULL, kPiece, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0) == MAP_FAILED)
            exit(failed("mmap"));
}

int main(void) {
    enum { kRounds = 20 };
    for (int round = 0; round < kRounds; ++round) {
        open_gl_libraries();
        const int status = check_platform(find_winsys_symbol, find_gl_symbol);
        if (status != kPassed) {
            fprintf(stderr, "in round %d\n", round);
            return status;
        }
        dlclose(gl_handle);
        dlclose(winsys_handle);
        fill_the_gaps();
    }
    return kPassed;
}
