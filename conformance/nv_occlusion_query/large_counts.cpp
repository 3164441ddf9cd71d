// SPDX-License-Identifier: MIT
// Counts that the counter, or the type of a Get, cannot hold (NV-44), cheaply: a framebuffer without
// attachments needs no memory.
#include <limits>

#include "nv_occlusion_query/nv_test.h"

namespace conformance {
namespace {

class NvLargeCounts : public NvTest {
  protected:
    static constexpr int kEdge = 2048;  // pixels, of 4 samples each: 2^24 samples

    void SetUp() override {
        ASSERT_NO_FATAL_FAILURE(NvTest::SetUp());
        if (IsSkipped()) return;
        if (const auto why = lacks(43, "GL_ARB_framebuffer_no_attachments")) GTEST_SKIP() << *why;
        glGenFramebuffers(1, &framebuffer_);
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
        glFramebufferParameteri(GL_FRAMEBUFFER, GL_FRAMEBUFFER_DEFAULT_WIDTH, kEdge);
        glFramebufferParameteri(GL_FRAMEBUFFER, GL_FRAMEBUFFER_DEFAULT_HEIGHT, kEdge);
        glFramebufferParameteri(GL_FRAMEBUFFER, GL_FRAMEBUFFER_DEFAULT_SAMPLES, 4);
        ASSERT_EQ(glCheckFramebufferStatus(GL_FRAMEBUFFER), static_cast<GLenum>(GL_FRAMEBUFFER_COMPLETE));
        use_pixel_coordinates(kEdge, kEdge);
    }
    void TearDown() override {
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        glDeleteFramebuffers(1, &framebuffer_);
        NvTest::TearDown();
    }

    static void cover(int times) {
        for (int i = 0; i < times; ++i) draw_rect({0, 0, kEdge, kEdge}, kMiddle);
    }

  private:
    GLuint framebuffer_ = 0;
};

// NV-44. NV 4.1.6A: "It is recommended, but not required, that implementations handle this overflow case by
// saturating at 2^PIXEL_COUNTER_BITS_NV-1". Decided: saturates. Of the 24 bits that the text asks for at
// least.
TEST_F(NvLargeCounts, a_counter_of_24_bits_saturates) {
    if (get_integer(GL_PIXEL_COUNTER_BITS_NV) != 24) GTEST_SKIP() << "the counter has another width";
    constexpr GLuint kLargest = (1u << 24) - 1;
    const NvQuery query;
    EXPECT_EQ(query.count([] { draw_rect({0, 0, kEdge, kEdge - 1}, kMiddle); }), kLargest + 1 - 4 * kEdge);
    EXPECT_EQ(query.count([] { cover(1); }), kLargest) << "wrapped to zero";
    EXPECT_EQ(query.count([] { cover(2); }), kLargest);
}

// NV-44. GetOcclusionQueryivNV returns an int; decided, as GL 4.5, 4.2.1, has it: the nearest value to 2^31.
TEST_F(NvLargeCounts, a_count_that_an_int_cannot_hold_is_given_as_its_largest) {
    if (get_integer(GL_PIXEL_COUNTER_BITS_NV) < 32) GTEST_SKIP() << "the counter is too narrow";
    const NvQuery query;
    EXPECT_EQ(query.count([] { cover(128); }), 1u << 31);
    GLint integer = 0;
    glGetOcclusionQueryivNV(query.name(), GL_PIXEL_COUNT_NV, &integer);
    EXPECT_EQ(integer, std::numeric_limits<GLint>::max());
}

}  // namespace
}  // namespace conformance
