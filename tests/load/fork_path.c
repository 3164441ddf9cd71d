// SPDX-License-Identifier: MIT
// Fork: `fork_path idle`: the parent has a context in the middle of a test, the child ends without GL.
//       `fork_path child_draws`: the parent has GL loaded and no context, the child makes its own.
#include <sys/wait.h>
#include <unistd.h>

#include "find_linked.h"

static int wait_for(pid_t child) {
    int status = 0;
    if (waitpid(child, &status, 0) != child) return failed("waitpid");
    if (!WIFEXITED(status)) return failed("the child was killed by a signal");
    return WEXITSTATUS(status);
}

static int fork_idle(void) {
    struct Session session = open_session(find_linked);
    const struct Gl gl = find_gl(find_linked);
    gl.glEnable(OCCLUSION_TEST_HP);
    draw_quad(&gl, 0);
    const pid_t child = fork();
    if (child == 0) exit(0);
    const int child_status = wait_for(child);
    if (child_status != 0) return failed("the child without GL did not end well");
    if (expects_layer() && read_result(&gl) != GL_TRUE) return failed("the fork lost the parent's result");
    gl.glDisable(OCCLUSION_TEST_HP);
    while (gl.glGetError() != GL_NO_ERROR) continue;  // without the layer the cap is unknown
    const int status = check_gl(&gl);
    close_session(&session);
    return status;
}

static int fork_child_draws(void) {
    const Function loaded = (Function)GET_PROC_ADDRESS("glClear");
    if (!loaded) return failed("GL is not loaded before the fork");
    const pid_t child = fork();
    if (child == 0) exit(check_platform(find_linked, find_linked));
    const int child_status = wait_for(child);
    if (child_status != 0) return child_status;
    return check_platform(find_linked, find_linked);
}

int main(int argc, char** argv) {
    if (argc != 2) return kBadUse;
    return strcmp(argv[1], "idle") == 0 ? fork_idle() : fork_child_draws();
}
