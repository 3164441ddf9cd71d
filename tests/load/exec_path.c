// SPDX-License-Identifier: MIT
// Exec: `exec_path inherit`: a child program has the layer as its parent has. `exec_path off`: a child that
// is started with GLEXT_EMU=0 has none. The child is this same program, called without an argument.
#include <unistd.h>

#include "find_linked.h"

int main(int argc, char** argv) {
    const int status = check_platform(find_linked, find_linked);
    if (argc == 1 || status != kPassed) return status;
    if (strcmp(argv[1], "off") == 0) {
        setenv("GLEXT_EMU", "0", 1);
        setenv("EXPECT", "nothing", 1);
    }
    execl("/proc/self/exe", argv[0], (char*)NULL);
    return failed("exec");
}
