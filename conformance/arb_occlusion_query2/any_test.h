// SPDX-License-Identifier: MIT
// What the tests of the boolean queries share: the three occlusion targets, and fixtures that skip where the
// GL has not the one that they are about.
#pragma once

#include <array>
#include <optional>
#include <ostream>
#include <span>
#include <string>

#include "harness/gl_test.h"
#include "harness/query.h"

namespace conformance {

struct Target {
    const char* name;
    GLenum value;
};

inline constexpr std::array<Target, 3> kOcclusionTargets = {{
    {"samples", GL_SAMPLES_PASSED},
    {"any", GL_ANY_SAMPLES_PASSED},
    {"any_conservative", GL_ANY_SAMPLES_PASSED_CONSERVATIVE},
}};

inline std::ostream& operator<<(std::ostream& out, const Target& target) {
    return out << target.name;
}

// The two that answer yes or no.
inline constexpr std::array<Target, 2> kBooleanTargets = {kOcclusionTargets[1], kOcclusionTargets[2]};

inline std::string target_name(const ::testing::TestParamInfo<Target>& info) {
    return info.param.name;
}

class AnyTest : public GlTest {
  protected:
    void SetUp() override {
        ASSERT_NO_FATAL_FAILURE(GlTest::SetUp());
        if (const auto why = lacks(33, "GL_ARB_occlusion_query2")) GTEST_SKIP() << *why;
    }

    static std::optional<std::string> lacks_conservative() { return lacks(43, "GL_ARB_ES3_compatibility"); }

    // Those of the three that this GL has.
    static std::span<const Target> occlusion_targets() {
        return std::span(kOcclusionTargets).first(lacks_conservative() ? 2 : 3);
    }
};

// Every test once with each of the two boolean targets.
class EachAnyTest : public AnyTest, public ::testing::WithParamInterface<Target> {
  protected:
    void SetUp() override {
        ASSERT_NO_FATAL_FAILURE(AnyTest::SetUp());
        if (IsSkipped() || !is_conservative()) return;
        if (const auto why = lacks_conservative()) GTEST_SKIP() << *why;
    }

    static GLenum target() { return GetParam().value; }
    static bool is_conservative() { return target() == GL_ANY_SAMPLES_PASSED_CONSERVATIVE; }
};

}  // namespace conformance
