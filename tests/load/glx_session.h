// SPDX-License-Identifier: MIT
// A direct GLX context on a 64x64 window, made with the functions that a load path finds.
// X11 itself is linked: it is no GL. Without DISPLAY the program is skipped.
#pragma once

#include <GL/glx.h>
#include <X11/Xlib.h>

#include "load_check.h"

#define WINSYS_COMMANDS(F) \
    F(glXChooseVisual)     \
    F(glXCreateContext)    \
    F(glXDestroyContext)   \
    F(glXIsDirect)         \
    F(glXMakeCurrent)

typedef GLXContext ContextHandle;

struct Glx {
    WINSYS_COMMANDS(MEMBER)
};

struct Session {
    struct Glx glx;
    Display* display;
    XVisualInfo* visual;
    Window window;
    GLXContext context;
};

static inline struct Glx find_winsys_commands(Finder find) {
    struct Glx table;
    WINSYS_COMMANDS(FILL)
    return table;
}

static inline GLXContext create_context(const struct Session* session) {
    return session->glx.glXCreateContext(session->display, session->visual, NULL, True);
}

static inline Bool make_current(const struct Session* session, GLXContext context) {
    return session->glx.glXMakeCurrent(session->display, context ? session->window : None, context);
}

static inline void destroy_context(const struct Session* session, GLXContext context) {
    session->glx.glXDestroyContext(session->display, context);
}

// Leaves the session's context current. Exits with a sentence when X or GLX itself does not work.
static inline struct Session open_session(Finder find) {
    if (!getenv("DISPLAY")) exit(kSkipped);
    struct Session session = {.glx = find_winsys_commands(find), .display = XOpenDisplay(NULL)};
    Display* display = session.display;
    if (!display) exit(failed("DISPLAY is set and cannot be opened"));
    int wanted[] = {GLX_RGBA, GLX_DOUBLEBUFFER, GLX_DEPTH_SIZE, 16, None};
    session.visual = session.glx.glXChooseVisual(display, DefaultScreen(display), wanted);
    if (!session.visual) exit(failed("no GLX visual has double buffering and depth"));
    const Window root = RootWindow(display, session.visual->screen);
    XSetWindowAttributes attributes = {.colormap =
                                           XCreateColormap(display, root, session.visual->visual, AllocNone)};
    session.window = XCreateWindow(display, root, 0, 0, 64, 64, 0, session.visual->depth, InputOutput,
                                   session.visual->visual, CWColormap, &attributes);
    session.context = create_context(&session);
    if (!session.context) exit(failed("glXCreateContext"));
    // An indirect context is the X server's own GL, which no layer in this process can reach.
    if (!session.glx.glXIsDirect(display, session.context)) exit(failed("the GLX context is indirect"));
    if (!make_current(&session, session.context)) exit(failed("glXMakeCurrent"));
    return session;
}

static inline void close_session(struct Session* session) {
    make_current(session, NULL);
    destroy_context(session, session->context);
    XDestroyWindow(session->display, session->window);
    XFree(session->visual);
    XCloseDisplay(session->display);
}

static inline int check_platform(Finder find_winsys, Finder find) {
    struct Session session = open_session(find_winsys);
    const struct Gl gl = find_gl(find);
    const int status = check_gl(&gl);
    close_session(&session);
    return status;
}
