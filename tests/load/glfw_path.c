// SPDX-License-Identifier: MIT
// Load path: GLFW, on X11: `glfw_path glx`, `glfw_path egl` or `glfw_path osmesa`.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "load_check.h"

static Function find_by_glfw(const char* name) {
    return glfwGetProcAddress(name);
}

static int failed_in_glfw(void) {
    const char* sentence = NULL;
    glfwGetError(&sentence);
    return failed(sentence ? sentence : "GLFW gives no reason");
}

int main(int argc, char** argv) {
    if (argc != 2) return kBadUse;
    if (!getenv("DISPLAY")) return kSkipped;
    if (!glfwInit()) return failed_in_glfw();
    const int api = strcmp(argv[1], "egl") == 0      ? GLFW_EGL_CONTEXT_API
                    : strcmp(argv[1], "osmesa") == 0 ? GLFW_OSMESA_CONTEXT_API
                                                     : GLFW_NATIVE_CONTEXT_API;
    glfwWindowHint(GLFW_CONTEXT_CREATION_API, api);
    glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
    glfwWindowHint(GLFW_DEPTH_BITS, 16);
    GLFWwindow* window = glfwCreateWindow(64, 64, "load path", NULL, NULL);
    if (!window) return failed_in_glfw();
    glfwMakeContextCurrent(window);
    const struct Gl gl = find_gl(find_by_glfw);
    const int status = check_gl(&gl);
    glfwTerminate();
    return status;
}
