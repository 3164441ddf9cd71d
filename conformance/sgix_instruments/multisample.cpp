// SPDX-License-Identifier: MIT
// The two instruments on a multisampled framebuffer (SGI-13, SGI-15): a fragment counts once, however many of
// its samples pass.
#include "harness/objects.h"
#include "sgix_instruments/instruments_test.h"

namespace conformance {
namespace {

class MultisampledCounts : public InstrumentTest {
  protected:
    void SetUp() override {
        ASSERT_NO_FATAL_FAILURE(InstrumentTest::SetUp());
        if (IsSkipped()) return;
        if (const auto why = lacks(30)) GTEST_SKIP() << *why;
        target.emplace(Framebuffer::Shape{.samples = 4});
        clear();
    }
    void TearDown() override {
        target.reset();
        InstrumentTest::TearDown();
    }
    static void draw_box() { draw_rect({16, 10, 20, 5}, 0.5f); }

    std::optional<Framebuffer> target;
};

// SGI-13. "If MULTISAMPLE_SGIS is enabled, the counter is incremented by one for each fragment containing at
// least one sample for which the depth test passed."
TEST_F(MultisampledCounts, a_fragment_with_all_its_samples_counts_once) {
    glDisable(GL_MULTISAMPLE);
    EXPECT_EQ(value_of(kDepthPass, draw_box), 100u);
    glEnable(GL_MULTISAMPLE);
    EXPECT_EQ(value_of(kDepthPass, draw_box), 100u);
    EXPECT_EQ(value_of(kDepthPass,
                       [] {
                           draw_box();
                           glDisable(GL_MULTISAMPLE);
                           draw_box();
                           glEnable(GL_MULTISAMPLE);
                       }),
              200u);
}

// SGI-13, the same clause. Half of the box's edge columns are covered: some of their samples, not all.
TEST_F(MultisampledCounts, a_fragment_with_some_of_its_samples_counts_once) {
    const auto half_a_pixel_to_the_right = [] {
        glBegin(GL_QUADS);
        glVertex3f(10.5f, 10.0f, 0.5f);
        glVertex3f(14.5f, 10.0f, 0.5f);
        glVertex3f(14.5f, 18.0f, 0.5f);
        glVertex3f(10.5f, 18.0f, 0.5f);
        glEnd();
    };
    EXPECT_EQ(value_of(kDepthPass, half_a_pixel_to_the_right), 40u);
}

// SGI-15: "whenever a fragment ... passes", be it by one sample.
TEST_F(MultisampledCounts, one_sample_makes_the_flag_false) {
    const auto sliver = [] {
        glBegin(GL_QUADS);
        glVertex3f(10.0f, 10.0f, 0.5f);
        glVertex3f(10.5f, 10.0f, 0.5f);
        glVertex3f(10.5f, 10.5f, 0.5f);
        glVertex3f(10.0f, 10.5f, 0.5f);
        glEnd();
    };
    EXPECT_EQ(value_of(kOcclusion, sliver), GLuint{GL_FALSE});
    EXPECT_EQ(value_of(kDepthPass, sliver), 1u);
}

}  // namespace
}  // namespace conformance
