// SPDX-License-Identifier: MIT
// Drawing in OpenGL ES: a program that does as use_pixel_coordinates does, and rectangles as strips.
#include "harness/es_test.h"

#include <array>

namespace conformance {

namespace {

constexpr GLuint kPosition = 0;  // the one attribute

// Both are GLSL ES 1.00, which ES 3 takes too. A pixel corner goes to [-1, 1], a window depth likewise.
constexpr const char* kVertexSource =
    "attribute vec3 position;\n"
    "uniform float size;\n"
    "void main() { gl_Position = vec4(2.0 * position.xy / size - 1.0, 2.0 * position.z - 1.0, 1.0); }\n";
constexpr const char* kFragmentSource = "void main() { gl_FragColor = vec4(1.0); }\n";

}  // namespace

void EsTest::prepare() {
    program_.emplace(Program::Sources{.vertex = kVertexSource, .fragment = kFragmentSource});
    glUniform1f(glGetUniformLocation(program_->name(), "size"), static_cast<GLfloat>(kSurfaceSize));
    glViewport(0, 0, kSurfaceSize, kSurfaceSize);
    glEnableVertexAttribArray(kPosition);
    clear();
}

void EsTest::TearDown() {
    // The program goes while its context is current.
    program_.reset();
    GlTest::TearDown();
}

void EsTest::clear(float depth) {
    glClearColor(0.0f, 0.0f, 0.0f, 0.0f);
    glClearDepthf(depth);
    glClearStencil(0);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
}

void EsTest::draw_rect(const Rect& rect, float depth) {
    const auto left = static_cast<GLfloat>(rect.x);
    const auto bottom = static_cast<GLfloat>(rect.y);
    const auto right = static_cast<GLfloat>(rect.x + rect.width);
    const auto top = static_cast<GLfloat>(rect.y + rect.height);
    const std::array<GLfloat, 12> corners = {left, bottom, depth, right, bottom, depth,
                                             left, top,    depth, right, top,    depth};
    glVertexAttribPointer(kPosition, 3, GL_FLOAT, GL_FALSE, 0, corners.data());
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

void EsTest::draw_occluder() {
    clear();
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    draw_rect(kWhole, kMiddle);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

}  // namespace conformance
