// SPDX-License-Identifier: MIT
// Framebuffer objects and programs of the tests.
#include "harness/objects.h"

#include <gtest/gtest.h>

#include <array>

namespace conformance {

const char* const kFixedVertexSource =
    "#version 120\n"
    "void main() { gl_Position = ftransform(); gl_FrontColor = gl_Color; }\n";

Framebuffer::Framebuffer(const Shape& shape) {
    glGenFramebuffers(1, &name_);
    bind();
    glGenRenderbuffers(1, &colour_);
    glBindRenderbuffer(GL_RENDERBUFFER, colour_);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, shape.samples, GL_RGBA8, shape.width, shape.height);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, colour_);
    if (shape.depth_stencil) {
        glGenRenderbuffers(1, &depth_stencil_);
        glBindRenderbuffer(GL_RENDERBUFFER, depth_stencil_);
        glRenderbufferStorageMultisample(GL_RENDERBUFFER, shape.samples, GL_DEPTH24_STENCIL8, shape.width,
                                         shape.height);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER,
                                  depth_stencil_);
    }
    EXPECT_EQ(glCheckFramebufferStatus(GL_FRAMEBUFFER), static_cast<GLenum>(GL_FRAMEBUFFER_COMPLETE));
}

Framebuffer::~Framebuffer() {
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glDeleteFramebuffers(1, &name_);
    glDeleteRenderbuffers(1, &colour_);
    glDeleteRenderbuffers(1, &depth_stencil_);
}

Program::Program(const Sources& sources) : name_(glCreateProgram()) {
    attach(GL_VERTEX_SHADER, sources.vertex);
    attach(GL_FRAGMENT_SHADER, sources.fragment);
    attach(GL_GEOMETRY_SHADER, sources.geometry);
    attach(GL_TESS_CONTROL_SHADER, sources.control);
    attach(GL_TESS_EVALUATION_SHADER, sources.evaluation);
    glLinkProgram(name_);
    GLint linked = GL_FALSE;
    glGetProgramiv(name_, GL_LINK_STATUS, &linked);
    std::array<char, 1024> log{};
    glGetProgramInfoLog(name_, static_cast<GLsizei>(log.size()), nullptr, log.data());
    EXPECT_EQ(linked, GL_TRUE) << log.data();
    glUseProgram(name_);
}

Program::~Program() {
    glUseProgram(0);
    glDeleteProgram(name_);
}

void Program::attach(GLenum stage, const std::string& source) const {
    if (source.empty()) return;
    const GLuint shader = glCreateShader(stage);
    const char* text = source.c_str();
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    GLint compiled = GL_FALSE;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    std::array<char, 1024> log{};
    glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), nullptr, log.data());
    EXPECT_EQ(compiled, GL_TRUE) << log.data();
    glAttachShader(name_, shader);
    glDeleteShader(shader);
}

}  // namespace conformance
