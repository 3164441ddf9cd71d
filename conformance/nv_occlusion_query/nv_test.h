// SPDX-License-Identifier: MIT
// What the tests of GL_NV_occlusion_query share: the fixture, which skips where the extension is absent, an
// occlusion query that goes with its scope, and the Gets.
#pragma once

#include "harness/gl_test.h"
#include "harness/query.h"

namespace conformance {

class NvTest : public GlTest {
  protected:
    void SetUp() override {
        ASSERT_NO_FATAL_FAILURE(GlTest::SetUp());
        if (const auto why = lacks("GL_NV_occlusion_query")) GTEST_SKIP() << *why;
    }
};

// Whatever a Get of an occlusion query writes for a parameter; kUntouched when it writes nothing.
inline GLuint get_nv(GLuint name, GLenum parameter) {
    GLuint value = kUntouched;
    glGetOcclusionQueryuivNV(name, parameter, &value);
    return value;
}

// The name of the active occlusion query, 0 for none.
inline GLuint active_nv() {
    return static_cast<GLuint>(get_integer(GL_CURRENT_OCCLUSION_QUERY_ID_NV));
}

// Has to end its life while no query is active: NV refuses to delete names then.
class NvQuery {
  public:
    NvQuery() { glGenOcclusionQueriesNV(1, &name_); }
    ~NvQuery() { glDeleteOcclusionQueriesNV(1, &name_); }
    NvQuery(const NvQuery&) = delete;
    NvQuery& operator=(const NvQuery&) = delete;

    GLuint name() const { return name_; }
    void begin() const { glBeginOcclusionQueryNV(name_); }
    GLuint result() const { return get_nv(name_, GL_PIXEL_COUNT_NV); }  // waits

    template <typename Draw>
    GLuint count(Draw draw) const {
        begin();
        draw();
        glEndOcclusionQueryNV();
        return result();
    }

  private:
    GLuint name_ = 0;
};

// So many samples pass, at most kSurfaceSize a row.
inline void draw_samples(int count) {
    draw_rect({0, 0, kSurfaceSize, count / kSurfaceSize}, 0.0f);
    if (const int rest = count % kSurfaceSize) draw_rect({0, count / kSurfaceSize, rest, 1}, 0.0f);
}

// A name that no Gen of this context has returned: larger than any it will.
inline constexpr GLuint kUnknownName = 0x7000;

}  // namespace conformance
