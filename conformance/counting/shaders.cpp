// SPDX-License-Identifier: MIT
// Fragment shaders that discard or set the depth, before and after early tests (CNT-28 to CNT-31).
#include <string>

#include "counting/counters.h"

namespace conformance {
namespace {

class ShaderCounts : public CountingTest {};
class EarlyTestsCount : public CountingTest {
  protected:
    void SetUp() override {
        ASSERT_NO_FATAL_FAILURE(CountingTest::SetUp());
        if (IsSkipped()) return;
        if (const auto why = lacks("GL_ARB_shader_image_load_store")) GTEST_SKIP() << *why;
    }
};

COUNT_WITH_EACH(ShaderCounts);
COUNT_WITH_EACH(EarlyTestsCount);

// A fragment shader with the statements <body>.
std::string fragment_shader(const std::string& body) {
    return "#version 130\nvoid main() {\n" + body + "    gl_FragColor = gl_Color;\n}\n";
}

std::string early_fragment_shader(const std::string& body) {
    return "#version 150 compatibility\n#extension GL_ARB_shader_image_load_store : "
           "require\nlayout(early_fragment_tests) in;\nvoid main() {\n" +
           body + "    gl_FragColor = gl_Color;\n}\n";
}

const char* const kDiscardLeft = "    if (gl_FragCoord.x < 32.0) discard;\n";
const char* const kLeftFarRightNear = "    gl_FragDepth = gl_FragCoord.x < 32.0 ? 0.75 : 0.25;\n";

// CNT-28. GL 4.5, 15.2: what discard removes reaches no later test.
TEST_P(ShaderCounts, a_discarded_fragment_does_not_count) {
    if (const auto why = lacks(30)) GTEST_SKIP() << *why;
    const Program program({.vertex = kFixedVertexSource, .fragment = fragment_shader(kDiscardLeft)});
    expect_count(kAll / 2, draw_whole);
    expect_count(0, [] { draw_rect(kLeft, kMiddle); });
    draw_occluder();  // on the right half
    expect_count(0, [] { draw_rect(kRight, kFar); });
    expect_count(kAll / 2, [] { draw_rect(kWhole, kNear); });
}

// CNT-30. GL 4.5, 15.2.3: gl_FragDepth replaces the fragment's depth in the depth test.
TEST_P(ShaderCounts, the_depth_of_the_shader_decides) {
    if (const auto why = lacks(30)) GTEST_SKIP() << *why;
    draw_occluder();
    glDepthMask(GL_FALSE);
    const Program program({.vertex = kFixedVertexSource, .fragment = fragment_shader(kLeftFarRightNear)});
    expect_count(kAll / 2, [] { draw_rect(kWhole, kNear); });
    expect_count(0, [] { draw_rect(kLeft, kNear); });
    expect_count(kAll / 2, [] { draw_rect(kRight, kFar); });
}

// CNT-29. GL 4.5, 14.9.4: with early_fragment_tests the stencil and depth tests and the counting of samples
// come before the fragment shader.
TEST_P(EarlyTestsCount, a_fragment_counts_before_the_shader_discards_it) {
    const Program program({.vertex = kFixedVertexSource, .fragment = early_fragment_shader(kDiscardLeft)});
    expect_count(kAll, draw_whole);
    expect_count(kAll / 2, [] { draw_rect(kLeft, kMiddle); });
}

// CNT-29. The same tests remove fragments before they count.
TEST_P(EarlyTestsCount, what_fails_the_early_tests_does_not_count) {
    draw_occluder();
    glDepthMask(GL_FALSE);
    const Program program({.vertex = kFixedVertexSource, .fragment = early_fragment_shader("")});
    expect_count(0, [] { draw_rect(kWhole, kFar); });
    expect_count(kAll, [] { draw_rect(kWhole, kNear); });
    glEnable(GL_STENCIL_TEST);
    glStencilFunc(GL_EQUAL, 1, 0xFF);
    expect_count(0, [] { draw_rect(kWhole, kNear); });
}

// CNT-31. GL 4.5, 15.2.4: with early tests a depth that the shader writes has no effect; the
// rasterized depth has been tested.
TEST_P(EarlyTestsCount, the_depth_of_the_shader_does_not_matter) {
    draw_occluder();
    glDepthMask(GL_FALSE);
    const Program program(
        {.vertex = kFixedVertexSource, .fragment = early_fragment_shader(kLeftFarRightNear)});
    expect_count(kAll, [] { draw_rect(kWhole, kNear); });
    expect_count(0, [] { draw_rect(kWhole, kFar); });
}

}  // namespace
}  // namespace conformance
