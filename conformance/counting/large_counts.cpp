// SPDX-License-Identifier: MIT
// Counts beyond 31 and 32 bits (CNT-54, CNT-55), cheaply: a framebuffer without attachments needs no memory,
// and one instanced draw covers it many times.
#include <array>
#include <limits>
#include <optional>

#include "counting/counters.h"

namespace conformance {
namespace {

// A framebuffer without attachments of 2^24 samples, bound while it lives.
class LargeTarget {
  public:
    static constexpr int kEdge = 2048;  // pixels
    static constexpr int kSamples = 4;
    static constexpr std::uint64_t kCovered = std::uint64_t{kEdge} * kEdge * kSamples;

    LargeTarget() {
        glGenFramebuffers(1, &name_);
        glBindFramebuffer(GL_FRAMEBUFFER, name_);
        glFramebufferParameteri(GL_FRAMEBUFFER, GL_FRAMEBUFFER_DEFAULT_WIDTH, kEdge);
        glFramebufferParameteri(GL_FRAMEBUFFER, GL_FRAMEBUFFER_DEFAULT_HEIGHT, kEdge);
        glFramebufferParameteri(GL_FRAMEBUFFER, GL_FRAMEBUFFER_DEFAULT_SAMPLES, kSamples);
        EXPECT_EQ(glCheckFramebufferStatus(GL_FRAMEBUFFER), static_cast<GLenum>(GL_FRAMEBUFFER_COMPLETE));
        use_pixel_coordinates(kEdge, kEdge);
        glEnableClientState(GL_VERTEX_ARRAY);
        glVertexPointer(2, GL_SHORT, 0, kCorners.data());
    }
    ~LargeTarget() {
        glDisableClientState(GL_VERTEX_ARRAY);
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        glDeleteFramebuffers(1, &name_);
    }
    LargeTarget(const LargeTarget&) = delete;
    LargeTarget& operator=(const LargeTarget&) = delete;

    // All samples of the framebuffer, so many times.
    static void cover(int times) { glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, times); }
    // The samples of one pixel.
    static void draw_pixel() { draw_rect({0, 0, 1, 1}, kMiddle); }

  private:
    static constexpr std::array<GLshort, 8> kCorners = {0, 0, kEdge, 0, 0, kEdge, kEdge, kEdge};

    GLuint name_ = 0;
};

constexpr int kTwoToThe32 = 256;  // so many coverings are 2^32 samples
static_assert(kTwoToThe32 * LargeTarget::kCovered == std::uint64_t{1} << 32);

class LargeCounts : public CountingTest {
  protected:
    void SetUp() override {
        ASSERT_NO_FATAL_FAILURE(CountingTest::SetUp());
        if (IsSkipped()) return;
        if (const auto why = lacks(43, "GL_ARB_framebuffer_no_attachments")) GTEST_SKIP() << *why;
        target_.emplace();
    }
    void TearDown() override {
        target_.reset();
        CountingTest::TearDown();
    }

  private:
    std::optional<LargeTarget> target_;
};

COUNT_WITH_EACH(LargeCounts);

// CNT-54. ARB, issues: "The largest minimum that can be required of a GL implementation is 32" bits: more
// samples than 1,000 full rectangles of 1024 x 1024 make are counted one by one.
TEST_P(LargeCounts, a_thousand_million_samples_are_counted_exactly) {
    if (GetParam().is_boolean) GTEST_SKIP() << "a boolean holds no number";
    constexpr int kTimes = 63;
    static_assert(kTimes * LargeTarget::kCovered > 1'048'576'000);
    expect_count(kTimes * LargeTarget::kCovered + LargeTarget::kSamples, [] {
        LargeTarget::cover(kTimes);
        LargeTarget::draw_pixel();
    });
}

// CNT-55. ARB, issues, of saturation: it "ensures that apps which want a boolean test can do this without
// worrying about the rare case where the result ends up exactly at zero after wrapping". 2^32 is such a case
// for whoever counts in 32 bits.
TEST_P(LargeCounts, two_to_the_32_samples_are_not_none) {
    // Each takes a second: one boolean of a machine, and the NV count; the other number is read by the next
    // test.
    const std::string name = GetParam().name;
    if (name == "samples") GTEST_SKIP() << "shown by its Gets";
    if (name == "any_conservative") GTEST_SKIP() << "shown by the exact boolean";
    if (name == "any" && !lacks("GL_HP_occlusion_test")) GTEST_SKIP() << "shown by the HP flag";
    expect_count(std::uint64_t{1} << 32, [] { LargeTarget::cover(kTwoToThe32); });
}

// CNT-55. GL 4.5, 4.2.1 and 2.2.2: of 64 bits exactly, of 32 the nearest value that they can represent.
TEST_P(LargeCounts, each_get_gives_the_nearest_value_that_it_can) {
    if (GetParam().name != std::string("samples")) GTEST_SKIP() << "of query objects only";
    if (const auto why = lacks(33, "GL_ARB_timer_query")) GTEST_SKIP() << *why;
    constexpr std::uint64_t kCount = (std::uint64_t{1} << 32) + LargeTarget::kSamples;
    const Query query;
    query.begin();
    LargeTarget::cover(kTwoToThe32);
    LargeTarget::draw_pixel();
    query.end();
    GLuint64 wide = 0;
    GLint64 wide_signed = 0;
    GLint narrow_signed = 0;
    glGetQueryObjectui64v(query.name(), GL_QUERY_RESULT, &wide);
    glGetQueryObjecti64v(query.name(), GL_QUERY_RESULT, &wide_signed);
    glGetQueryObjectiv(query.name(), GL_QUERY_RESULT, &narrow_signed);
    EXPECT_EQ(wide, GetParam().largest() < kCount ? GetParam().largest() : kCount);
    EXPECT_EQ(wide_signed, static_cast<GLint64>(wide));
    EXPECT_EQ(query.result(), std::numeric_limits<GLuint>::max());
    EXPECT_EQ(narrow_signed, std::numeric_limits<GLint>::max());
}

}  // namespace
}  // namespace conformance
