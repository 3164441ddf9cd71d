// SPDX-License-Identifier: MIT
// GL objects that tests need beside the default framebuffer: framebuffers of any kind and programs.
#pragma once

#include <string>

#include "harness/draw.h"
#include "harness/gl.h"

namespace conformance {

// A framebuffer object of RGBA8 and, where asked, 24-bit depth with 8-bit stencil; bound while it lives.
class Framebuffer {
  public:
    struct Shape {
        int width = kSurfaceSize;
        int height = kSurfaceSize;
        int samples = 0;  // 0: not multisampled
        bool depth_stencil = true;
    };

    explicit Framebuffer(const Shape& shape);
    ~Framebuffer();
    Framebuffer(const Framebuffer&) = delete;
    Framebuffer& operator=(const Framebuffer&) = delete;

    void bind() const { glBindFramebuffer(GL_FRAMEBUFFER, name_); }
    GLuint name() const { return name_; }

  private:
    GLuint name_ = 0;
    GLuint colour_ = 0;
    GLuint depth_stencil_ = 0;
};

// A linked program, in use while it lives; an empty source leaves its stage out. A compile error fails the
// test.
class Program {
  public:
    struct Sources {
        std::string vertex = {};
        std::string fragment = {};
        std::string geometry = {};
        std::string control = {};
        std::string evaluation = {};
    };

    explicit Program(const Sources& sources);
    ~Program();
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;

    GLuint name() const { return name_; }

  private:
    void attach(GLenum stage, const std::string& source) const;

    GLuint name_ = 0;
};

// A vertex stage that does as fixed function does, for programs that only want another fragment stage.
extern const char* const kFixedVertexSource;

}  // namespace conformance
