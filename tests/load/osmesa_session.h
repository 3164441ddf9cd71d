// SPDX-License-Identifier: MIT
// An OSMesa context that draws into memory of the program's, made with the functions that a load path finds.
// The declarations are OSMesa's own (GL/osmesa.h), so that only its library is needed.
#pragma once

#include "load_check.h"

#define WINSYS_COMMANDS(F)    \
    F(OSMesaCreateContextExt) \
    F(OSMesaDestroyContext)   \
    F(OSMesaMakeCurrent)

typedef void* ContextHandle;

extern ContextHandle OSMesaCreateContextExt(GLenum format, GLint depth_bits, GLint stencil_bits,
                                            GLint accum_bits, ContextHandle share);
extern void OSMesaDestroyContext(ContextHandle context);
extern GLboolean OSMesaMakeCurrent(ContextHandle context, void* buffer, GLenum type, GLsizei width,
                                   GLsizei height);
extern Function OSMesaGetProcAddress(const char* name);

struct OsMesa {
    WINSYS_COMMANDS(MEMBER)
};

struct Session {
    struct OsMesa osmesa;
    ContextHandle context;
};

static inline struct OsMesa find_winsys_commands(Finder find) {
    struct OsMesa table;
    WINSYS_COMMANDS(FILL)
    return table;
}

static inline ContextHandle create_context(const struct Session* session) {
    return session->osmesa.OSMesaCreateContextExt(GL_RGBA, 16, 0, 0, NULL);
}

static inline GLboolean make_current(const struct Session* session, ContextHandle context) {
    enum { kWidth = 64, kHeight = 64 };
    static unsigned char pixels[kWidth * kHeight * 4];
    if (!context) return session->osmesa.OSMesaMakeCurrent(NULL, NULL, GL_UNSIGNED_BYTE, 0, 0);
    return session->osmesa.OSMesaMakeCurrent(context, pixels, GL_UNSIGNED_BYTE, kWidth, kHeight);
}

static inline void destroy_context(const struct Session* session, ContextHandle context) {
    session->osmesa.OSMesaDestroyContext(context);
}

// Leaves the session's context current. Exits with a sentence when OSMesa itself does not work.
static inline struct Session open_session(Finder find) {
    struct Session session = {.osmesa = find_winsys_commands(find)};
    session.context = create_context(&session);
    if (!session.context) exit(failed("OSMesaCreateContextExt"));
    if (!make_current(&session, session.context)) exit(failed("OSMesaMakeCurrent"));
    return session;
}

static inline void close_session(struct Session* session) {
    make_current(session, NULL);
    destroy_context(session, session->context);
}

static inline int check_platform(Finder find_winsys, Finder find) {
    struct Session session = open_session(find_winsys);
    const struct Gl gl = find_gl(find);
    const int status = check_gl(&gl);
    close_session(&session);
    return status;
}
