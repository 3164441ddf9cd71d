// SPDX-License-Identifier: MIT
// What the tests of HP overlapped with ARB_occlusion_query share: the fixture, which skips where either is
// absent.
#pragma once

#include "harness/query.h"
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

}  // namespace conformance
