// SPDX-License-Identifier: MIT
// Load path: every address is asked for in a static constructor, before main and before any context.
#include "platform.h"

#define NAME(name) {#name, NULL},

static struct NamedFunction rows[] = {GL_COMMANDS(NAME) WINSYS_COMMANDS(NAME)};
static const size_t kRowCount = sizeof rows / sizeof rows[0];

__attribute__((constructor)) static void look_up_before_main(void) {
    for (size_t i = 0; i < kRowCount; ++i) rows[i].function = (Function)GET_PROC_ADDRESS(rows[i].name);
}

static Function find(const char* name) {
    return find_in_rows(rows, kRowCount, name);
}

int main(void) {
    return check_platform(find, find);
}
