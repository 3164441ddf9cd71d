// SPDX-License-Identifier: MIT
// A compatibility context with a 64x64 pbuffer of EGL's surfaceless platform, for tests that pass contexts
// from thread to thread; and what such tests draw. EGL's bound API belongs to the thread, so making a context
// current binds it.
#pragma once

#define GL_GLEXT_PROTOTYPES
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/gl.h>
#include <GL/glext.h>

#include <array>
#include <functional>
#include <random>

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

// Covers the pbuffer at z = 0; leaves the depth test on with LESS, and writes to depth off.
void draw_occluder();

// Something of a random size before the occluder or behind it.
struct Block {
    int width, height;
    bool in_front;

    explicit Block(std::mt19937& random)
        : width(1 + static_cast<int>(random() % 16)),
          height(1 + static_cast<int>(random() % 16)),
          in_front((random() & 1U) != 0) {}
    float z() const { return in_front ? -0.5F : 0.5F; }
    void draw() const { draw_pixels(width, height, z()); }
    GLuint all_samples() const { return static_cast<GLuint>(width * height); }
    GLuint samples() const { return in_front ? all_samples() : 0; }
};

// Eight threads at once, in each a context that shares with <first> and is current: how many wrong answers
// <ask>, which gets the thread's number, has counted there; -1 where it did not return.
using WrongAnswers = std::array<int, 8>;
WrongAnswers ask_in_threads(const ThreadContext& first, const std::function<int(unsigned)>& ask);

}  // namespace threads
