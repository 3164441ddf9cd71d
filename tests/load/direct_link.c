// SPDX-License-Identifier: MIT
// Load path: the program names GL's functions and the dynamic linker binds them (its libraries:
// CMakeLists.txt).
#include "find_linked.h"

int main(void) {
    return check_platform(find_linked, find_linked);
}
