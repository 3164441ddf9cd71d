// SPDX-License-Identifier: MIT
// A witness of a program's occlusion queries that has nothing of the layer's: preloaded above it, it notes
// what the program draws within a query, and after the query's end draws that again with depth written. Where
// reading back shows another depth, something has passed; then the depth is put back. A line for each query
// goes to the file that QUERY_WITNESS names: name, left, bottom, right, top, nearest depth.
//
// For programs that ask about boxes in a compatibility context and in the default framebuffer: their queries
// change no state and write no depth. What passes at an equal depth leaves no trace. Calls from one thread.
#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>
#include <GL/glx.h>
#include <dlfcn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define EXPORT __attribute__((visibility("default")))
#define MOST_DRAWS 64

struct draw {
    GLenum mode;
    GLint first;
    GLsizei count;
    GLenum type;  // 0: DrawArrays
    const void* indices;
};

static struct draw draws[MOST_DRAWS];
static int draw_count;
static GLuint query;  // active; 0: none

static void fail(const char* what) {
    fprintf(stderr, "query_witness: %s\n", what);
    abort();
}

static __GLXextFuncPtr next_or_null(const char* name) {
    static __GLXextFuncPtr (*get)(const GLubyte*);
    if (get == NULL) *(void**)&get = dlsym(RTLD_NEXT, "glXGetProcAddressARB");
    return get((const GLubyte*)name);
}

static __GLXextFuncPtr next(const char* name) {
    const __GLXextFuncPtr found = next_or_null(name);
    if (found == NULL) fail(name);
    return found;
}

#define REAL(name) ((__typeof__(&name))next(#name))

static void note(struct draw draw) {
    if (query == 0) return;
    if (draw_count == MOST_DRAWS) fail("too many draws in a query");
    draws[draw_count++] = draw;
}

static void repeat_draws(void) {
    for (int i = 0; i < draw_count; ++i) {
        const struct draw* const d = &draws[i];
        if (d->type == 0) {
            REAL(glDrawArrays)(d->mode, d->first, d->count);
        } else {
            REAL(glDrawElements)(d->mode, d->count, d->type, d->indices);
        }
    }
}

static GLenum depth_format(void) {
    GLint depth_bits = 0, stencil_bits = 0;
    glGetIntegerv(GL_DEPTH_BITS, &depth_bits);
    glGetIntegerv(GL_STENCIL_BITS, &stencil_bits);
    if (stencil_bits != 0) return GL_DEPTH24_STENCIL8;
    return depth_bits == 32   ? GL_DEPTH_COMPONENT32
           : depth_bits == 24 ? GL_DEPTH_COMPONENT24
                              : GL_DEPTH_COMPONENT16;
}

// Depth goes to a framebuffer of the witness's own, or comes back from it, in the same format and so
// unchanged.
static void copy_depth(int width, int height, int is_back) {
    static GLuint framebuffer, buffer;
    if (framebuffer == 0) {
        REAL(glGenFramebuffers)(1, &framebuffer);
        REAL(glGenRenderbuffers)(1, &buffer);
    }
    if (!is_back) {
        const GLenum format = depth_format();
        REAL(glBindFramebuffer)(GL_DRAW_FRAMEBUFFER, framebuffer);
        REAL(glBindRenderbuffer)(GL_RENDERBUFFER, buffer);
        REAL(glRenderbufferStorage)(GL_RENDERBUFFER, format, width, height);
        REAL(glFramebufferRenderbuffer)(GL_DRAW_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, buffer);
        REAL(glBindRenderbuffer)(GL_RENDERBUFFER, 0);
        glDrawBuffer(GL_NONE);
    }
    REAL(glBindFramebuffer)(GL_READ_FRAMEBUFFER, is_back ? framebuffer : 0);
    REAL(glBindFramebuffer)(GL_DRAW_FRAMEBUFFER, is_back ? 0 : framebuffer);
    const GLboolean has_scissor = glIsEnabled(GL_SCISSOR_TEST);
    glDisable(GL_SCISSOR_TEST);
    REAL(glBlitFramebuffer)(0, 0, width, height, 0, 0, width, height, GL_DEPTH_BUFFER_BIT, GL_NEAREST);
    if (has_scissor) glEnable(GL_SCISSOR_TEST);
    REAL(glBindFramebuffer)(GL_FRAMEBUFFER, 0);
}

static GLuint* read_depth(int width, int height) {
    GLuint* const depth = malloc((size_t)width * (size_t)height * sizeof *depth);
    REAL(glReadPixels)(0, 0, width, height, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, depth);
    return depth;
}

// What has changed is what passed.
static void report(GLuint id, const GLuint* before, int width, int height) {
    GLuint* const after = read_depth(width, height);
    GLfloat* const depth = malloc((size_t)width * (size_t)height * sizeof *depth);
    REAL(glReadPixels)(0, 0, width, height, GL_DEPTH_COMPONENT, GL_FLOAT, depth);
    int left = width, bottom = height, right = -1, top = -1;
    float nearest = 1;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const size_t at = (size_t)y * (size_t)width + (size_t)x;
            if (after[at] == before[at]) continue;
            if (x < left) left = x;
            if (x > right) right = x;
            if (y < bottom) bottom = y;
            if (y > top) top = y;
            if (depth[at] < nearest) nearest = depth[at];
        }
    }
    if (right < 0) left = bottom = 0;
    static FILE* file;
    if (file == NULL) file = fopen(getenv("QUERY_WITNESS"), "w");
    if (file == NULL) fail("QUERY_WITNESS names no file that can be written");
    fprintf(file, "%u %d %d %d %d %.9g\n", id, left, bottom, right, top, (double)nearest);
    fflush(file);
    free(depth);
    free(after);
}

static void look(GLuint id) {
    GLint viewport[4], draw_binding = 0, read_binding = 0;
    glGetIntegerv(GL_VIEWPORT, viewport);
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &draw_binding);
    glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &read_binding);
    if (draw_binding != 0 || read_binding != 0) fail("the program draws into a framebuffer object");
    if (glGetError() != GL_NO_ERROR) fail("an error of the program");
    const int width = viewport[0] + viewport[2], height = viewport[1] + viewport[3];
    GLuint* const before = read_depth(width, height);
    copy_depth(width, height, 0);
    glPushAttrib(GL_DEPTH_BUFFER_BIT);
    glDepthMask(GL_TRUE);  // so that the nearest that passes stays
    repeat_draws();
    glPopAttrib();
    report(id, before, width, height);
    copy_depth(width, height, 1);
    GLuint* const again = read_depth(width, height);
    if (memcmp(before, again, (size_t)width * (size_t)height * sizeof *again) != 0)
        fail("the depth is another now");
    free(before);
    free(again);
    if (glGetError() != GL_NO_ERROR) fail("an error of the witness");
}

EXPORT void glBeginQuery(GLenum target, GLuint id) {
    query = id;
    draw_count = 0;
    REAL(glBeginQuery)(target, id);
}
EXPORT void glEndQuery(GLenum target) {
    REAL(glEndQuery)(target);
    const GLuint ended = query;
    query = 0;
    look(ended);
}
EXPORT void glDrawArrays(GLenum mode, GLint first, GLsizei count) {
    note((struct draw){mode, first, count, 0, NULL});
    REAL(glDrawArrays)(mode, first, count);
}
EXPORT void glDrawElements(GLenum mode, GLsizei count, GLenum type, const void* indices) {
    note((struct draw){mode, 0, count, type, indices});
    REAL(glDrawElements)(mode, count, type, indices);
}

EXPORT __GLXextFuncPtr glXGetProcAddressARB(const GLubyte* name) {
    const char* const text = (const char*)name;
    if (strcmp(text, "glBeginQuery") == 0 || strcmp(text, "glBeginQueryARB") == 0)
        return (__GLXextFuncPtr)glBeginQuery;
    if (strcmp(text, "glEndQuery") == 0 || strcmp(text, "glEndQueryARB") == 0)
        return (__GLXextFuncPtr)glEndQuery;
    if (strcmp(text, "glDrawArrays") == 0) return (__GLXextFuncPtr)glDrawArrays;
    if (strcmp(text, "glDrawElements") == 0) return (__GLXextFuncPtr)glDrawElements;
    return next_or_null(text);
}
EXPORT __GLXextFuncPtr glXGetProcAddress(const GLubyte* name) {
    return glXGetProcAddressARB(name);
}
