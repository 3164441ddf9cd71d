// SPDX-License-Identifier: MIT
// The Finder of a program that is linked with its GL libraries: the dynamic linker has bound every function.
#pragma once

#include "platform.h"

static inline Function find_linked(const char* name) {
    static const struct NamedFunction kRows[] = {GL_COMMANDS(ROW) WINSYS_COMMANDS(ROW)};
    return find_in_rows(kRows, sizeof kRows / sizeof kRows[0], name);
}
