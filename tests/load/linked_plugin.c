// SPDX-License-Identifier: MIT
// A plugin that is linked with GL: opening it opens GL, under whatever flags its host chose for it.
#include "find_linked.h"

int run_step(void);

int run_step(void) {
    return check_platform(find_linked, find_linked);
}
