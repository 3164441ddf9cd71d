// SPDX-License-Identifier: MIT
// The context of the thread tests: see thread_context.h.
#include "thread_context.h"

#include <cstdio>
#include <cstdlib>
#include <thread>
#include <vector>

namespace threads {
namespace {

struct Screen {
    EGLDisplay display;
    EGLConfig config;
};

[[noreturn]] void give_up(const char* what) {
    std::fprintf(stderr, "EGL does not work: %s\n", what);
    std::exit(1);
}

Screen open_screen() {
    Screen screen{};
    screen.display = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (!eglInitialize(screen.display, nullptr, nullptr)) give_up("eglInitialize");
    const EGLint wanted[] = {
        EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_DEPTH_SIZE, 24, EGL_NONE};
    EGLint count = 0;
    if (!eglChooseConfig(screen.display, wanted, &screen.config, 1, &count) || count == 0)
        give_up("no config has a pbuffer, OpenGL and depth");
    return screen;
}

const Screen& screen() {
    static const Screen the_screen = open_screen();
    return the_screen;
}

}  // namespace

ThreadContext::ThreadContext(const ThreadContext* share) {
    const Screen& on = screen();
    eglBindAPI(EGL_OPENGL_API);
    const EGLint size[] = {EGL_WIDTH, kSize, EGL_HEIGHT, kSize, EGL_NONE};
    surface_ = eglCreatePbufferSurface(on.display, on.config, size);
    context_ = eglCreateContext(on.display, on.config, share ? share->context_ : EGL_NO_CONTEXT, nullptr);
    if (surface_ == EGL_NO_SURFACE || context_ == EGL_NO_CONTEXT) give_up("a context");
}

ThreadContext::~ThreadContext() {
    if (context_ != EGL_NO_CONTEXT) destroy();
}

void ThreadContext::make_current() const {
    eglBindAPI(EGL_OPENGL_API);
    if (!eglMakeCurrent(screen().display, surface_, surface_, context_)) give_up("eglMakeCurrent");
}

void ThreadContext::release() {
    eglBindAPI(EGL_OPENGL_API);
    if (!eglMakeCurrent(screen().display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT))
        give_up("eglMakeCurrent without a context");
}

void ThreadContext::release_thread() {
    if (!eglReleaseThread()) give_up("eglReleaseThread");
}

void ThreadContext::destroy() {
    eglDestroyContext(screen().display, context_);
    eglDestroySurface(screen().display, surface_);
    context_ = EGL_NO_CONTEXT;
}

void draw_pixels(int width, int height, float z) {
    glViewport(0, 0, width, height);
    glBegin(GL_QUADS);
    glVertex3f(-1, -1, z);
    glVertex3f(1, -1, z);
    glVertex3f(1, 1, z);
    glVertex3f(-1, 1, z);
    glEnd();
}

void draw_occluder() {
    glEnable(GL_DEPTH_TEST);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    draw_pixels(kSize, kSize, 0.0F);
    glDepthMask(GL_FALSE);
}

WrongAnswers ask_in_threads(const ThreadContext& first, const std::function<int(unsigned)>& ask) {
    WrongAnswers wrong;
    wrong.fill(-1);
    std::vector<std::thread> threads;
    for (unsigned index = 0; index < wrong.size(); ++index) {
        threads.emplace_back([&, index] {
            const ThreadContext context(&first);
            context.make_current();
            wrong[index] = ask(index);
            ThreadContext::release();
        });
    }
    for (std::thread& thread : threads) thread.join();
    return wrong;
}

}  // namespace threads
