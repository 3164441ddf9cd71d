// SPDX-License-Identifier: MIT
// A compatibility context on a 64x64 pbuffer of EGL's surfaceless platform, made with the functions that a
// load path finds: no window system, so these paths run on any machine.
#pragma once

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include "load_check.h"

#define WINSYS_COMMANDS(F)     \
    F(eglBindAPI)              \
    F(eglChooseConfig)         \
    F(eglCreateContext)        \
    F(eglCreatePbufferSurface) \
    F(eglDestroyContext)       \
    F(eglDestroySurface)       \
    F(eglGetPlatformDisplay)   \
    F(eglInitialize)           \
    F(eglMakeCurrent)          \
    F(eglTerminate)

typedef EGLContext ContextHandle;

struct Egl {
    WINSYS_COMMANDS(MEMBER)
};

struct Session {
    struct Egl egl;
    EGLDisplay display;
    EGLConfig config;
    EGLSurface surface;
    EGLContext context;
};

static inline struct Egl find_winsys_commands(Finder find) {
    struct Egl table;
    WINSYS_COMMANDS(FILL)
    return table;
}

static inline EGLContext create_context(const struct Session* session) {
    return session->egl.eglCreateContext(session->display, session->config, EGL_NO_CONTEXT, NULL);
}

static inline EGLBoolean make_current(const struct Session* session, EGLContext context) {
    const EGLSurface surface = context ? session->surface : EGL_NO_SURFACE;
    return session->egl.eglMakeCurrent(session->display, surface, surface, context);
}

static inline void destroy_context(const struct Session* session, EGLContext context) {
    session->egl.eglDestroyContext(session->display, context);
}

// Leaves the session's context current. Exits with a sentence when EGL itself does not work.
static inline struct Session open_session(Finder find) {
    struct Session session = {.egl = find_winsys_commands(find)};
    const struct Egl* egl = &session.egl;
    session.display = egl->eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, NULL);
    if (!egl->eglInitialize(session.display, NULL, NULL)) exit(failed("eglInitialize"));
    egl->eglBindAPI(EGL_OPENGL_API);
    const EGLint wanted[] = {
        EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_DEPTH_SIZE, 16, EGL_NONE};
    EGLint count = 0;
    if (!egl->eglChooseConfig(session.display, wanted, &session.config, 1, &count) || count == 0)
        exit(failed("no EGL config has a pbuffer, OpenGL and depth"));
    const EGLint size[] = {EGL_WIDTH, 64, EGL_HEIGHT, 64, EGL_NONE};
    session.surface = egl->eglCreatePbufferSurface(session.display, session.config, size);
    session.context = create_context(&session);
    if (!make_current(&session, session.context)) exit(failed("eglMakeCurrent"));
    return session;
}

static inline void close_session(struct Session* session) {
    make_current(session, NULL);
    destroy_context(session, session->context);
    session->egl.eglDestroySurface(session->display, session->surface);
    session->egl.eglTerminate(session->display);
}

static inline int check_platform(Finder find_winsys, Finder find) {
    struct Session session = open_session(find_winsys);
    const struct Gl gl = find_gl(find);
    const int status = check_gl(&gl);
    close_session(&session);
    return status;
}
