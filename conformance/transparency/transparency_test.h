// SPDX-License-Identifier: MIT
// The fixture: the HP test, enabled and with something drawn under it, so that whatever a GL keeps for it is
// in use.
#pragma once

#include "harness/gl_test.h"
#include "harness/query.h"

namespace conformance {

class TransparencyTest : public GlTest {
  protected:
    void SetUp() override {
        GlTest::SetUp();
        if (HasFatalFailure()) return;
        if (const auto why = lacks("GL_HP_occlusion_test")) GTEST_SKIP() << *why;
        if (const auto why = lacks(15)) GTEST_SKIP() << *why;
        glEnable(GL_OCCLUSION_TEST_HP);
        draw_point(0, 0, kMiddle);
    }

    static bool visible() {
        GLboolean result = GL_FALSE;
        glGetBooleanv(GL_OCCLUSION_TEST_RESULT_HP, &result);
        return result == GL_TRUE;
    }
};

}  // namespace conformance
