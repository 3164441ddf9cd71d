// SPDX-License-Identifier: MIT
// GL_EMU_depth_region_query: is a tile of the screen full, and how far away is what is furthest in it?
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/gl.h>
#include <GL/glext_emu.h>
#include <stdio.h>
#include <string.h>

static PFNGLGETDEPTHREGIONFVEMUPROC get_depth_region;

static void tell(const char* tile, int x) {
    GLfloat is_occluded = 0, furthest = 0;
    get_depth_region(GL_REGION_OCCLUDED_EMU, x, 0, 32, 64, &is_occluded);
    get_depth_region(GL_FURTHEST_DEPTH_EMU, x, 0, 32, 64, &furthest);
    printf("%s tile: %s, furthest depth %.3f\n", tile, is_occluded == 1 ? "occluded" : "open", furthest);
}

int main(void) {
    EGLDisplay display = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, NULL);
    const EGLint wish[] = {
        EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_DEPTH_SIZE, 24, EGL_NONE};
    const EGLint size[] = {EGL_WIDTH, 64, EGL_HEIGHT, 64, EGL_NONE};
    EGLConfig config;
    EGLint count = 0;
    if (!eglInitialize(display, NULL, NULL) || !eglBindAPI(EGL_OPENGL_API)) return 1;
    if (!eglChooseConfig(display, wish, &config, 1, &count) || count == 0) return 1;
    EGLSurface surface = eglCreatePbufferSurface(display, config, size);
    eglMakeCurrent(display, surface, surface, eglCreateContext(display, config, EGL_NO_CONTEXT, NULL));
    if (!strstr((const char*)glGetString(GL_EXTENSIONS), "GL_EMU_depth_region_query")) {
        puts("this GL has no depth region queries");
        return 1;
    }
    get_depth_region = (PFNGLGETDEPTHREGIONFVEMUPROC)eglGetProcAddress("glGetDepthRegionfvEMU");

    glEnable(GL_DEPTH_TEST), glClear(GL_DEPTH_BUFFER_BIT);
    glRectf(-1, -1, 0, 1);  // the left half, at depth 0.5
    tell("left", 0), tell("right", 32);
    return glGetError() != GL_NO_ERROR;
}
