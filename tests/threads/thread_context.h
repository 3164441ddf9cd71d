// SPDX-License-Identifier: MIT
// A compatibility context with a 64x64 pbuffer of EGL's surfaceless platform, for tests that pass contexts
// from thread to thread. EGL's bound API belongs to the thread, so making a context current binds it.
#pragma once

#define GL_GLEXT_PROTOTYPES
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/gl.h>
#include <GL/glext.h>

namespace threads {

constexpr int kSize = 64;  // pixels, width and height of the pbuffer

class ThreadContext {
  public:
    // <share> is a context to share objects with, or null. Nothing is made current.
    explicit ThreadContext(const ThreadContext* share = nullptr);
    ~ThreadContext();
    ThreadContext(const ThreadContext&) = delete;
    ThreadContext& operator=(const ThreadContext&) = delete;

    void make_current() const;
    // Leaves the calling thread without a context.
    static void release();
    // The same by eglReleaseThread, as a thread does that is about to end.
    static void release_thread();
    // Destroys the context now; where it is current somewhere, GL ends it when it is so no more.
    void destroy();
    EGLContext handle() const { return context_; }

  private:
    EGLSurface surface_ = EGL_NO_SURFACE;
    EGLContext context_ = EGL_NO_CONTEXT;
};

// A quad over <width> x <height> pixels from the lower left, at window depth (z + 1) / 2: as many samples.
void draw_pixels(int width, int height, float z);

}  // namespace threads
