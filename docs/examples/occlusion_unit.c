// SPDX-License-Identifier: MIT
// GL_EMU_occlusion_unit: how much of a box behind a half wall is seen, how near, and where; then of many at
// once.
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/glext_emu.h>
#include <stdio.h>
#include <string.h>

enum { kSize = 64, kBoxes = 3 };

static void open_context(void) {
    const EGLint wish[] = {EGL_SURFACE_TYPE,    EGL_PBUFFER_BIT, EGL_DEPTH_SIZE, 24,
                           EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,  EGL_NONE};
    const EGLint size[] = {EGL_WIDTH, kSize, EGL_HEIGHT, kSize, EGL_NONE};
    EGLDisplay display = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, NULL);
    EGLConfig config;
    EGLint count;
    eglInitialize(display, NULL, NULL), eglBindAPI(EGL_OPENGL_API);
    eglChooseConfig(display, wish, &config, 1, &count);
    EGLSurface surface = eglCreatePbufferSurface(display, config, size);
    eglMakeCurrent(display, surface, surface, eglCreateContext(display, config, EGL_NO_CONTEXT, NULL));
}

static void print_record(const char* name, const GLocclusionrecordEMU* record) {
    printf("%s: %d of %d samples visible", name, (int)record->visible_hits, (int)record->projected_hits);
    if (record->visible) {
        printf(", nearest at %.3f, within (%d, %d) to (%d, %d)", record->nearest_depth, record->box[0],
               record->box[1], record->box[2], record->box[3]);
    }
    puts("");
}

int main(void) {
    open_context();
    if (!strstr((const char*)glGetString(GL_EXTENSIONS), "GL_EMU_occlusion_unit")) {
        puts("this GL has no occlusion unit");
        return 1;
    }
    PFNGLBEGINOCCLUSIONUNITEMUPROC begin =
        (PFNGLBEGINOCCLUSIONUNITEMUPROC)eglGetProcAddress("glBeginOcclusionUnitEMU");
    PFNGLENDOCCLUSIONUNITEMUPROC end =
        (PFNGLENDOCCLUSIONUNITEMUPROC)eglGetProcAddress("glEndOcclusionUnitEMU");
    PFNGLOCCLUSIONUNITSHAPESEMUPROC ask =
        (PFNGLOCCLUSIONUNITSHAPESEMUPROC)eglGetProcAddress("glOcclusionUnitShapesEMU");
    PFNGLGETOCCLUSIONRECORDSEMUPROC get =
        (PFNGLGETOCCLUSIONRECORDSEMUPROC)eglGetProcAddress("glGetOcclusionRecordsEMU");
    PFNGLGENQUERIESPROC gen = (PFNGLGENQUERIESPROC)eglGetProcAddress("glGenQueries");

    GLuint queries[2];
    gen(2, queries);
    glEnable(GL_DEPTH_TEST), glClear(GL_DEPTH_BUFFER_BIT);
    glRectf(-1, -1, 0, 1);  // the wall, at depth 0.5 over the left half

    // What is drawn between Begin and End is counted; each register is armed by itself.
    GLocclusionrecordEMU record, records[kBoxes];
    glDepthMask(GL_FALSE);
    begin(GL_ALL_REGISTERS_EMU, queries[0]);
    glTranslatef(0, 0, 0.5f), glRectf(-0.5f, -0.5f, 0.5f, 0.5f), glLoadIdentity();
    end();
    get(queries[0], 0, 1, &record);
    print_record("a rectangle behind the wall's edge", &record);

    // Many boxes, smallest and largest x, y, z of each, in one call.
    const GLfloat boxes[kBoxes][6] = {{-0.75f, -0.25f, 0.25f, -0.25f, 0.25f, 0.75f},
                                      {-0.25f, -0.25f, 0.25f, 0.25f, 0.25f, 0.75f},
                                      {0.25f, -0.25f, -0.75f, 0.75f, 0.25f, -0.25f}};
    ask(GL_ALL_REGISTERS_EMU, GL_BOX_EMU, kBoxes, boxes[0], NULL, queries[1]);
    get(queries[1], 0, kBoxes, records);
    for (int i = 0; i < kBoxes; ++i) print_record("a box", &records[i]);
    return glGetError() != GL_NO_ERROR;
}
