// SPDX-License-Identifier: MIT
// Commands of the extension by GetProcAddress, and depths by scissored clears.
#include "emu_depth_region_query/region_test.h"

namespace conformance {

namespace {

// Asked for at every call: a pointer may belong to the context.
template <typename Function>
Function command(const char* name) {
    return reinterpret_cast<Function>(platform().get_proc_address(name));
}

std::vector<GLint> flat(GLsizei count, const Rect* rects) {
    std::vector<GLint> words;
    for (GLsizei i = 0; i < count; ++i) {
        words.insert(words.end(), {rects[i].x, rects[i].y, rects[i].width, rects[i].height});
    }
    return words;
}

}  // namespace

void far_depth(GLenum end) {
    command<PFNGLFARDEPTHEMUPROC>("glFarDepthEMU")(end);
}

void get_region(GLenum pname, const Rect& rect, GLfloat* value) {
    command<PFNGLGETDEPTHREGIONFVEMUPROC>("glGetDepthRegionfvEMU")(pname, rect.x, rect.y, rect.width,
                                                                   rect.height, value);
}

void get_regions(GLenum pname, GLsizei count, const Rect* rects, GLfloat* values) {
    command<PFNGLGETDEPTHREGIONSFVEMUPROC>("glGetDepthRegionsfvEMU")(pname, count, flat(count, rects).data(),
                                                                     values);
}

void query_regions(GLenum pname, GLsizei count, const Rect* rects, const GLuint* ids) {
    command<PFNGLQUERYDEPTHREGIONSEMUPROC>("glQueryDepthRegionsEMU")(pname, count, flat(count, rects).data(),
                                                                     ids);
}

void query_regions_into(GLenum pname, GLsizei count, const Rect* rects, GLuint buffer, GLintptr offset) {
    command<PFNGLQUERYDEPTHREGIONSBUFFEREMUPROC>("glQueryDepthRegionsBufferEMU")(
        pname, count, flat(count, rects).data(), buffer, offset);
}

GLfloat ask(GLenum pname, const Rect& rect) {
    GLfloat value = kUnwritten;
    get_region(pname, rect, &value);
    return value;
}

void put_depth(const Rect& rect, GLfloat depth) {
    glEnable(GL_SCISSOR_TEST);
    glScissor(rect.x, rect.y, rect.width, rect.height);
    glClearDepth(depth);
    glClear(GL_DEPTH_BUFFER_BIT);
    glDisable(GL_SCISSOR_TEST);
}

GLuint64 pixels_read() {
    GLint64 pixels = -1;
    glGetInteger64v(GL_DEPTH_REGION_PIXELS_READ_EMU, &pixels);
    return static_cast<GLuint64>(pixels);
}

void RegionTest::SetUp() {
    ASSERT_NO_FATAL_FAILURE(GlTest::SetUp());
    if (const auto why = lacks("GL_EMU_depth_region_query")) GTEST_SKIP() << *why;
}

}  // namespace conformance
