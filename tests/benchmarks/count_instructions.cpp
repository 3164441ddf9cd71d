// SPDX-License-Identifier: MIT
// Calls GL functions in loops between two callgrind requests each, so that callgrind counts every loop by
// itself.
//
//   valgrind --tool=callgrind --collect-atstart=no ./count_instructions CALLS
//
// Run once without the layer and once with it: the difference of the counts over CALLS is the layer's price
// for a call. Run on the null driver, whose functions always cost the same.
#define GL_GLEXT_PROTOTYPES
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/gl.h>
#include <GL/glext.h>
#include <valgrind/callgrind.h>

#include <cstdio>
#include <cstdlib>

namespace {

bool make_context_current() {
    const EGLDisplay display = eglGetDisplay(EGL_DEFAULT_DISPLAY);
    if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr) || !eglBindAPI(EGL_OPENGL_API))
        return false;
    const EGLContext context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, nullptr);
    return context != EGL_NO_CONTEXT && eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context);
}

// The dump is called <name>; callgrind writes it to a file of its own.
template <typename Call>
void count(const char* name, long calls, Call call) {
    call();  // the dynamic linker binds the symbol here, not in the loop
    CALLGRIND_TOGGLE_COLLECT;
    for (long i = 0; i < calls; ++i) call();
    CALLGRIND_TOGGLE_COLLECT;
    CALLGRIND_DUMP_STATS_AT(name);
}

}  // namespace

int main(int argc, char** argv) {
    const long calls = argc == 2 ? std::atol(argv[1]) : 0;
    if (calls <= 0) {
        std::fprintf(stderr, "usage: count_instructions CALLS\n");
        return 2;
    }
    if (!make_context_current()) {
        std::fprintf(stderr, "count_instructions: no context\n");
        return 1;
    }
    std::printf("%s\n", reinterpret_cast<const char*>(glGetString(GL_RENDERER)));

    count("glColor4f", calls, [] { glColor4f(0, 0, 0, 0); });
    count("glVertex3f", calls, [] { glVertex3f(0, 0, 0); });
    count("glTexImage2D", calls, [] { glTexImage2D(0, 0, 0, 0, 0, 0, 0, 0, nullptr); });
    count("glGetError", calls, [] { glGetError(); });
    count("glIsEnabled", calls, [] { glIsEnabled(GL_DEPTH_TEST); });
    count("glEnable", calls, [] { glEnable(GL_DEPTH_TEST); });
    count("glBegin", calls, [] { glBegin(GL_TRIANGLES); });
    count("glEnd", calls, [] { glEnd(); });
    count("glDrawArrays", calls, [] { glDrawArrays(GL_TRIANGLES, 0, 3); });
    count("glDrawElements", calls, [] { glDrawElements(GL_TRIANGLES, 3, GL_UNSIGNED_INT, nullptr); });
    count("glCallList", calls, [] { glCallList(1); });
    count("samples_query", calls, [] {
        GLuint samples = 0;
        glBeginQuery(GL_SAMPLES_PASSED, 1);
        glEndQuery(GL_SAMPLES_PASSED);
        glGetQueryObjectuiv(1, GL_QUERY_RESULT, &samples);
    });
    return 0;
}
