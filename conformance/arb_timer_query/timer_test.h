// SPDX-License-Identifier: MIT
// What the tests of GL_ARB_timer_query share: the fixture, and 64-bit results.
#pragma once

#include "harness/gl_test.h"
#include "harness/query.h"

namespace conformance {

class TimerTest : public GlTest {
  protected:
    void SetUp() override {
        ASSERT_NO_FATAL_FAILURE(GlTest::SetUp());
        if (const auto why = lacks(33, "GL_ARB_timer_query")) GTEST_SKIP() << *why;
    }
};

inline GLuint64 nanoseconds_of(const Query& query) {
    GLuint64 value = 0;
    glGetQueryObjectui64v(query.name(), GL_QUERY_RESULT, &value);
    return value;
}

inline GLint64 now_in_nanoseconds() {
    GLint64 value = -1;
    glGetInteger64v(GL_TIMESTAMP, &value);
    return value;
}

// So many overdraws of every pixel.
inline void work(int layers) {
    for (int i = 0; i < layers; ++i) draw_rect(kWhole, kNear);
}

}  // namespace conformance
