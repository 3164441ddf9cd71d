// SPDX-License-Identifier: MIT
// What is drawn to: windows, framebuffers without attachments, several in turn (CNT-43 to CNT-45, CNT-47,
// CNT-48).
#include "counting/counters.h"

namespace conformance {
namespace {

class TargetCounts : public CountingTest {
  protected:
    // A framebuffer without attachments, bound while it lives.
    class Bare {
      public:
        Bare(int width, int height, int samples) {
            glGenFramebuffers(1, &name_);
            glBindFramebuffer(GL_FRAMEBUFFER, name_);
            glFramebufferParameteri(GL_FRAMEBUFFER, GL_FRAMEBUFFER_DEFAULT_WIDTH, width);
            glFramebufferParameteri(GL_FRAMEBUFFER, GL_FRAMEBUFFER_DEFAULT_HEIGHT, height);
            glFramebufferParameteri(GL_FRAMEBUFFER, GL_FRAMEBUFFER_DEFAULT_SAMPLES, samples);
            EXPECT_EQ(glCheckFramebufferStatus(GL_FRAMEBUFFER), static_cast<GLenum>(GL_FRAMEBUFFER_COMPLETE));
        }
        ~Bare() {
            glBindFramebuffer(GL_FRAMEBUFFER, 0);
            glDeleteFramebuffers(1, &name_);
        }
        Bare(const Bare&) = delete;
        Bare& operator=(const Bare&) = delete;

      private:
        GLuint name_ = 0;
    };
};

COUNT_WITH_EACH(TargetCounts);

// CNT-43. GL 4.5, 17.3.1: the pixel ownership test; the window has no pixels outside itself.
TEST_P(TargetCounts, only_the_pixels_of_the_window_count) {
    glViewport(-kSize, -kSize, 3 * kSize, 3 * kSize);
    expect_count(kAll, draw_whole);
    expect_count(0, [] { draw_rect({0, 0, kSize / 4, kSize}, kMiddle); });
}

// CNT-44. NV 4.1.6A: "Whenever a fragment reaches this stage", before it is written, once or twice.
TEST_P(TargetCounts, a_fragment_for_front_and_back_counts_once) {
    GLboolean is_double_buffered = GL_FALSE;
    glGetBooleanv(GL_DOUBLEBUFFER, &is_double_buffered);
    if (is_double_buffered == GL_FALSE) GTEST_SKIP() << "needs a double-buffered surface";
    glDrawBuffer(GL_FRONT_AND_BACK);
    expect_count(kAll, draw_whole);
    draw_occluder();
    expect_count(0, [] { draw_rect(kWhole, kFar); });
}

// CNT-47. ARB_framebuffer_no_attachments: rasterization goes on in the default width and height; without
// buffers the depth test passes.
TEST_P(TargetCounts, a_framebuffer_without_attachments_counts_its_default_size) {
    if (const auto why = lacks(43, "GL_ARB_framebuffer_no_attachments")) GTEST_SKIP() << *why;
    const Bare bare(48, 20, 0);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_NEVER);
    expect_count(48 * 20, draw_whole);
    expect_count(0, [] { draw_rect({48, 0, 16, kSize}, kMiddle); });
}

// CNT-47. The same, of DEFAULT_SAMPLES samples a pixel.
TEST_P(TargetCounts, a_framebuffer_without_attachments_counts_its_default_samples) {
    if (const auto why = lacks(43, "GL_ARB_framebuffer_no_attachments")) GTEST_SKIP() << *why;
    const Bare bare(48, 20, 4);
    expect_count(4 * 48 * 20, draw_whole);
    glEnable(GL_SAMPLE_MASK);
    glSampleMaski(0, 0x0);
    expect_count(0, draw_whole);
}

// CNT-48. ARB_occlusion_query binds a query to no framebuffer.
TEST_P(TargetCounts, a_query_counts_in_every_framebuffer_that_it_sees) {
    if (const auto why = lacks(30)) GTEST_SKIP() << *why;
    const Framebuffer object({.width = 32, .height = 16});
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    expect_count(kAll + 32 * 16 + kAll / 4, [&] {
        draw_whole();
        object.bind();
        draw_whole();
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        draw_rect(kQuarter, kMiddle);
    });
    expect_count(32 * 16, [&] {
        object.bind();
        draw_whole();
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
    });
}

// CNT-48. Binding another one inside the query counts nothing by itself, nor does its clear.
TEST_P(TargetCounts, binding_and_clearing_framebuffers_does_not_count) {
    if (const auto why = lacks(32)) GTEST_SKIP() << *why;
    const Framebuffer object({});
    const Framebuffer multisampled({.samples = 4});
    expect_count(0, [&] {
        object.bind();
        clear();
        multisampled.bind();
        clear();
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        clear();
    });
}

}  // namespace
}  // namespace conformance
