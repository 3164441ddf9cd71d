// SPDX-License-Identifier: MIT
// What the tests of GL_HP_occlusion_test share: the fixture, which skips where the extension is absent, and
// the one way to read the result that has no other effect than the specified one.
#pragma once

#include "harness/gl_test.h"

namespace conformance {

class HpTest : public GlTest {
  protected:
    void SetUp() override {
        ASSERT_NO_FATAL_FAILURE(GlTest::SetUp());
        if (const auto why = lacks("GL_HP_occlusion_test")) GTEST_SKIP() << *why;
    }
};

inline bool test_enabled() {
    return glIsEnabled(GL_OCCLUSION_TEST_HP) == GL_TRUE;
}

// Reads the result, which clears it.
inline bool read_result() {
    GLboolean result = 0xAA;  // neither TRUE nor FALSE: a Get that writes nothing is seen
    glGetBooleanv(GL_OCCLUSION_TEST_RESULT_HP, &result);
    EXPECT_TRUE(result == GL_TRUE || result == GL_FALSE) << "the Get wrote " << int{result};
    return result == GL_TRUE;
}

// The extension's own recipe: enable, draw, disable, read.
template <typename Draw>
bool result_of(Draw draw) {
    glEnable(GL_OCCLUSION_TEST_HP);
    draw();
    glDisable(GL_OCCLUSION_TEST_HP);
    return read_result();
}

// Makes the pending result TRUE and leaves the test disabled.
inline void pass_one_fragment() {
    glEnable(GL_OCCLUSION_TEST_HP);
    draw_point(0, 0, 0.0f);
    glDisable(GL_OCCLUSION_TEST_HP);
}

}  // namespace conformance
