// SPDX-License-Identifier: MIT
// Render modes, discarded and refused draws, multisampling and framebuffer objects (HP-58 to HP-63).
#include <array>

#include "harness/objects.h"
#include "hp_occlusion_test/hp_test.h"

namespace conformance {
namespace {

class Framebuffers : public HpTest {
  protected:
    static bool whole_rect_counts() {
        return result_of([] { draw_rect(kWhole, kMiddle); });
    }
};

// HP-58. GL compatibility: in render modes FEEDBACK and SELECT primitives are not rasterized.
TEST_F(Framebuffers, feedback_and_selection_make_no_fragments) {
    std::array<GLfloat, 256> feedback{};
    std::array<GLuint, 256> names{};
    glFeedbackBuffer(feedback.size(), GL_3D, feedback.data());
    glSelectBuffer(names.size(), names.data());
    for (const GLenum mode : {GL_FEEDBACK, GL_SELECT}) {
        SCOPED_TRACE(mode);
        glRenderMode(mode);
        glInitNames();
        glPushName(1);
        EXPECT_FALSE(whole_rect_counts());
        EXPECT_GT(glRenderMode(GL_RENDER), 0) << "nothing was fed back or selected";
    }
    EXPECT_TRUE(whole_rect_counts());
}

// HP-58. GL 4.5, 14.1: with RASTERIZER_DISCARD primitives are discarded before rasterization.
TEST_F(Framebuffers, rasterizer_discard_makes_no_fragments) {
    if (const auto why = lacks(30)) GTEST_SKIP() << *why;
    glEnable(GL_RASTERIZER_DISCARD);
    EXPECT_FALSE(whole_rect_counts());
    glDisable(GL_RASTERIZER_DISCARD);
    EXPECT_TRUE(whole_rect_counts());
}

// HP-60. NV 4.1.6A counts samples where SAMPLE_BUFFERS is 1: one that passes makes the result TRUE.
TEST_F(Framebuffers, one_passing_sample_of_many_is_enough) {
    if (const auto why = lacks(32)) GTEST_SKIP() << *why;
    const Framebuffer multisampled({.samples = 4});
    clear();
    EXPECT_TRUE(whole_rect_counts());
    glEnable(GL_SAMPLE_MASK);
    glSampleMaski(0, 0x1);
    EXPECT_TRUE(whole_rect_counts());
    glSampleMaski(0, 0x0);
    EXPECT_FALSE(whole_rect_counts()) << "the sample mask left no sample";
    glDisable(GL_SAMPLE_MASK);

    glEnable(GL_SAMPLE_ALPHA_TO_COVERAGE);
    glColor4f(1.0f, 1.0f, 1.0f, 0.0f);
    EXPECT_FALSE(whole_rect_counts()) << "alpha 0 left no coverage";
    glColor4f(1.0f, 1.0f, 1.0f, 1.0f);
    EXPECT_TRUE(whole_rect_counts());
}

// HP-61. Rendering to a framebuffer object is rendering.
TEST_F(Framebuffers, rendering_to_a_framebuffer_object_counts) {
    if (const auto why = lacks(30)) GTEST_SKIP() << *why;
    const Framebuffer framebuffer({});
    draw_occluder();
    EXPECT_TRUE(result_of([] { draw_rect({8, 8, 16, 16}, kNear); }));
    EXPECT_EQ(drawn_pixels(), 16 * 16);
    EXPECT_FALSE(result_of([] { draw_rect({8, 8, 16, 16}, kFar); }));
}

// HP-61. ARB_framebuffer_no_attachments: rasterization and the tests go on without an attachment.
TEST_F(Framebuffers, a_framebuffer_without_attachments_counts) {
    if (const auto why = lacks(43, "GL_ARB_framebuffer_no_attachments")) GTEST_SKIP() << *why;
    GLuint name = 0;
    glGenFramebuffers(1, &name);
    glBindFramebuffer(GL_FRAMEBUFFER, name);
    glFramebufferParameteri(GL_FRAMEBUFFER, GL_FRAMEBUFFER_DEFAULT_WIDTH, kSurfaceSize);
    glFramebufferParameteri(GL_FRAMEBUFFER, GL_FRAMEBUFFER_DEFAULT_HEIGHT, kSurfaceSize);
    ASSERT_EQ(glCheckFramebufferStatus(GL_FRAMEBUFFER), static_cast<GLenum>(GL_FRAMEBUFFER_COMPLETE));
    EXPECT_TRUE(whole_rect_counts());
    EXPECT_FALSE(result_of([] {
        draw_rect({kSurfaceSize, 0, 8, 8}, kMiddle);
    })) << "beside the default width";
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glDeleteFramebuffers(1, &name);
}

// HP-62. GL 4.5, 9.4.4: drawing to an incomplete framebuffer is INVALID_FRAMEBUFFER_OPERATION and draws
// nothing.
TEST_F(Framebuffers, a_draw_to_an_incomplete_framebuffer_does_not_count) {
    if (const auto why = lacks(30)) GTEST_SKIP() << *why;
    GLuint name = 0;
    glGenFramebuffers(1, &name);
    glBindFramebuffer(GL_FRAMEBUFFER, name);
    EXPECT_FALSE(whole_rect_counts());
    EXPECT_TRUE(error_is(GL_INVALID_FRAMEBUFFER_OPERATION));
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glDeleteFramebuffers(1, &name);
    EXPECT_TRUE(whole_rect_counts());
}

// HP-63. GL 4.5, 2.3.1: a command that generates an error has no other effect.
TEST_F(Framebuffers, a_draw_in_error_does_not_count) {
    constexpr GLenum kNoMode = 0xFFFF;
    const std::array<GLfloat, 9> corners = {0.0f, 0.0f, 0.5f, 64.0f, 0.0f, 0.5f, 0.0f, 64.0f, 0.5f};
    glEnableClientState(GL_VERTEX_ARRAY);
    glVertexPointer(3, GL_FLOAT, 0, corners.data());
    EXPECT_FALSE(result_of([] { glDrawArrays(kNoMode, 0, 3); }));
    EXPECT_TRUE(error_is(GL_INVALID_ENUM));
    EXPECT_FALSE(result_of([] { glDrawArrays(GL_TRIANGLES, 0, -1); }));
    EXPECT_TRUE(error_is(GL_INVALID_VALUE));
    EXPECT_FALSE(result_of([] { glBegin(kNoMode); }));
    EXPECT_TRUE(error_is(GL_INVALID_ENUM));
    EXPECT_TRUE(result_of([] { glDrawArrays(GL_TRIANGLES, 0, 3); }));
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
    glDisableClientState(GL_VERTEX_ARRAY);
}

}  // namespace
}  // namespace conformance
