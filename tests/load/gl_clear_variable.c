// SPDX-License-Identifier: MIT
// A global variable called glClear, as programs have that keep function pointers under GL's names; part of
// the program, or of a library of it. A layer that exports glClear gets it bound to its own code: writing it
// crashes. A layer that calls an exported glClear of its own lands in the variable.
#include <stdio.h>
#include <unistd.h>

int glClear;

__attribute__((constructor)) static void write_it(void) {
    glClear = 42;
}

__attribute__((destructor)) static void it_keeps_its_value(void) {
    if (glClear == 42) return;
    fprintf(stderr, "failed: the program's own glClear was written\n");
    _exit(1);
}
