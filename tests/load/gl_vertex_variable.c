// SPDX-License-Identifier: MIT
// A global variable called glVertex3f, as programs have that keep function pointers under GL's names; part of
// the program, or of a library of it. A layer that exports glVertex3f gets it bound to its own code: writing
// it crashes. A layer that calls an exported glVertex3f of its own lands in the variable.
#include <stdio.h>
#include <unistd.h>

int glVertex3f;

__attribute__((constructor)) static void write_it(void) {
    glVertex3f = 42;
}

__attribute__((destructor)) static void it_keeps_its_value(void) {
    if (glVertex3f == 42) return;
    fprintf(stderr, "failed: the program's own glVertex3f was written\n");
    _exit(1);
}
