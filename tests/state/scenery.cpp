// SPDX-License-Identifier: MIT
// Unusual state, chapter by chapter of GL.
#include "scenery.h"

#include <array>

#include "harness/gl.h"
#include "harness/gl_test.h"

namespace tests {

namespace {

void disarrange_fixed_function() {
    glViewport(1, 2, 60, 59);
    glDepthRange(0.0625, 0.9375);
    glMatrixMode(GL_TEXTURE);
    glLoadIdentity();
    glScalef(2.0f, 0.5f, 1.0f);
    glMatrixMode(GL_MODELVIEW);
    glPushMatrix();
    glPushAttrib(GL_FOG_BIT);
    glEnable(GL_SCISSOR_TEST);
    glScissor(1, 1, 50, 49);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
    glEnable(GL_STENCIL_TEST);
    glStencilFunc(GL_ALWAYS, 3, 0x7F);
    glStencilOp(GL_KEEP, GL_INCR, GL_DECR);
    glStencilMask(0x3F);
    glColorMask(GL_TRUE, GL_FALSE, GL_TRUE, GL_FALSE);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE);
    glEnable(GL_ALPHA_TEST);
    glAlphaFunc(GL_GEQUAL, 0.25f);
    glEnable(GL_LIGHT2);
    const std::array<GLfloat, 4> position = {1.0f, 2.0f, 3.0f, 0.0f};
    glLightfv(GL_LIGHT2, GL_POSITION, position.data());
    glColor4f(0.75f, 0.5f, 0.25f, 1.0f);
    glRasterPos3f(5.0f, 6.0f, 0.125f);
    glPointSize(2.0f);
    glLineWidth(3.0f);
    glPixelStorei(GL_PACK_ALIGNMENT, 2);
    glPixelStorei(GL_UNPACK_SKIP_ROWS, 1);
    glClearDepth(0.875);
    glClearStencil(5);
    glListBase(7);
    glHint(GL_FOG_HINT, GL_NICEST);
    GLuint texture = 0;
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
}

// Buffers bound to each target that a layer might use itself.
void disarrange_buffers(int version) {
    std::array<GLuint, 3> buffers{};
    glGenBuffers(buffers.size(), buffers.data());
    glBindBuffer(GL_PIXEL_PACK_BUFFER, buffers[0]);
    glBufferData(GL_PIXEL_PACK_BUFFER, 256, nullptr, GL_STATIC_DRAW);
    if (version >= 30) {
        GLuint array = 0;
        glGenVertexArrays(1, &array);
        glBindVertexArray(array);
    }
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[1]);
    if (version >= 31) glBindBuffer(GL_COPY_WRITE_BUFFER, buffers[2]);
    if (version >= 44) glBindBuffer(GL_QUERY_BUFFER, buffers[2]);
}

void disarrange_textures_and_multisampling(int version) {
    glActiveTexture(GL_TEXTURE3);
    GLuint texture = 0;
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glActiveTexture(GL_TEXTURE1);
    glSampleCoverage(0.5f, GL_TRUE);
    if (version >= 32) glEnable(GL_SAMPLE_MASK);
    if (version >= 33) {
        GLuint sampler = 0;
        glGenSamplers(1, &sampler);
        glBindSampler(2, sampler);
    }
    if (version >= 31) {
        glEnable(GL_PRIMITIVE_RESTART);
        glPrimitiveRestartIndex(77);
    }
}

}  // namespace

void disarrange() {
    const int version = conformance::gl_version();
    disarrange_fixed_function();
    if (version >= 13) disarrange_textures_and_multisampling(version);
    if (version >= 21) disarrange_buffers(version);
}

}  // namespace tests
