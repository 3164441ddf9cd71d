// SPDX-License-Identifier: MIT
// What the tests of HP overlapped with ARB_occlusion_query share: the fixture, which skips where either is
// absent, and query objects that go with their scope.
#pragma once

#include "hp_occlusion_test/hp_test.h"

namespace conformance {

class MixTest : public HpTest {
  protected:
    void SetUp() override {
        ASSERT_NO_FATAL_FAILURE(HpTest::SetUp());
        if (IsSkipped()) return;
        if (const auto why = lacks(15, "GL_ARB_occlusion_query")) GTEST_SKIP() << *why;
    }
};

class Query {
  public:
    explicit Query(GLenum target = GL_SAMPLES_PASSED) : target_(target) { glGenQueries(1, &name_); }
    ~Query() { glDeleteQueries(1, &name_); }
    Query(const Query&) = delete;
    Query& operator=(const Query&) = delete;

    GLuint name() const { return name_; }
    void begin() const { glBeginQuery(target_, name_); }
    void end() const { glEndQuery(target_); }

    // Waits for the result.
    GLuint result() const {
        GLuint value = 0xDEADBEEF;
        glGetQueryObjectuiv(name_, GL_QUERY_RESULT, &value);
        return value;
    }

    template <typename Draw>
    GLuint count(Draw draw) const {
        begin();
        draw();
        end();
        return result();
    }

  private:
    GLenum target_;
    GLuint name_ = 0;
};

}  // namespace conformance
