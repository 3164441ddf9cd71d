// SPDX-License-Identifier: MIT
// The program for set_uid.sh: the layer stands in its own list of libraries, no preload needed.
#include <unistd.h>

#include "find_linked.h"

int main(int argc, char** argv) {
    if (argc == 2 && strcmp(argv[1], "--effective-user") == 0) return printf("%d\n", (int)geteuid()) < 0;
    return check_platform(find_linked, find_linked);
}
