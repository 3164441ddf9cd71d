// SPDX-License-Identifier: MIT
// What the tests of GL_ARB_occlusion_query share: the fixture, which skips where the extension is absent, and
// pixels.
//
// The core names of GL 1.5 are used throughout; discovery.cpp shows that the suffixed ones are the same
// commands.
#pragma once

#include "harness/gl_test.h"
#include "harness/query.h"

namespace conformance {

class ArbTest : public GlTest {
  protected:
    void SetUp() override {
        ASSERT_NO_FATAL_FAILURE(GlTest::SetUp());
        if (const auto why = lacks(15, "GL_ARB_occlusion_query")) GTEST_SKIP() << *why;
    }
};

// So many samples pass, at most kSurfaceSize a row.
inline void draw_samples(int count) {
    draw_rect({0, 0, kSurfaceSize, count / kSurfaceSize}, 0.0f);
    if (const int rest = count % kSurfaceSize) draw_rect({0, count / kSurfaceSize, rest, 1}, 0.0f);
}

// Whatever a Get of an object writes for a parameter; kUntouched when it writes nothing.
inline GLuint get_object(GLuint name, GLenum parameter) {
    GLuint value = kUntouched;
    glGetQueryObjectuiv(name, parameter, &value);
    return value;
}

// A name that no Gen of this context has returned: larger than any it will.
inline constexpr GLuint kUnknownName = 0x7000;

}  // namespace conformance
