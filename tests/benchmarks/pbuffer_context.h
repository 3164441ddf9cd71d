// SPDX-License-Identifier: MIT
// A compatibility context with a pbuffer to draw into, on EGL's surfaceless platform: what the benchmarks
// draw with. The pbuffer gives a depth buffer to machines that have no framebuffer objects.
#pragma once

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <cstdio>
#include <cstdlib>

namespace benchmarks {

// Makes it current in this thread, or ends the program with status 1 and one sentence.
inline void make_pbuffer_context(int width, int height, int stencil_bits = 0) {
    const auto fail = [](const char* step) {
        std::fprintf(stderr, "no context: %s failed, EGL error 0x%x\n", step,
                     static_cast<unsigned>(eglGetError()));
        std::exit(1);
    };
    const EGLDisplay display =
        eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr)) fail("eglInitialize");
    eglBindAPI(EGL_OPENGL_API);
    const EGLint wanted[] = {EGL_SURFACE_TYPE,
                             EGL_PBUFFER_BIT,
                             EGL_RENDERABLE_TYPE,
                             EGL_OPENGL_BIT,
                             EGL_RED_SIZE,
                             8,
                             EGL_DEPTH_SIZE,
                             24,
                             EGL_STENCIL_SIZE,
                             stencil_bits,
                             EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (!eglChooseConfig(display, wanted, &config, 1, &count) || count == 0) fail("eglChooseConfig");
    const EGLint size[] = {EGL_WIDTH, width, EGL_HEIGHT, height, EGL_NONE};
    const EGLSurface surface = eglCreatePbufferSurface(display, config, size);
    if (surface == EGL_NO_SURFACE) fail("eglCreatePbufferSurface");
    const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, nullptr);
    if (context == EGL_NO_CONTEXT) fail("eglCreateContext");
    if (!eglMakeCurrent(display, surface, surface, context)) fail("eglMakeCurrent");
}

}  // namespace benchmarks
