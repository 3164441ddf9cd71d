// SPDX-License-Identifier: MIT
// Depth decides, colour does not (CNT-01 to CNT-07, CNT-32), and the same again (CNT-56).
#include <array>
#include <random>

#include "counting/counters.h"

namespace conformance {
namespace {

class DepthCounts : public CountingTest {};
class ColourCounts : public CountingTest {};

COUNT_WITH_EACH(DepthCounts);
COUNT_WITH_EACH(ColourCounts);

// CNT-01, CNT-02, CNT-03. ARB 4.1.6A: "the samples-passed count increases by 1 for each fragment"; GL 4.5,
// 17.3.6: with the depth test disabled, comparison and update are bypassed.
TEST_P(DepthCounts, without_a_depth_test_every_fragment_counts) {
    expect_count(kAll, draw_whole);
    expect_count(1, [] { draw_point(7, 9, kMiddle); });
    expect_count(0, [] {});
    expect_count(2 * kAll, [] {
        draw_rect(kWhole, kNear);
        draw_rect(kWhole, kFar);
    });
}

// CNT-04. ARB 4.1.6A: counted is "each fragment that passes the depth test".
TEST_P(DepthCounts, what_is_behind_the_occluder_does_not_count) {
    draw_occluder();
    expect_count(0, [] { draw_rect(kWhole, kFar); });
    expect_count(kAll, [] { draw_rect(kWhole, kNear); });
    clear();
    draw_rect(kLeft, kMiddle);
    expect_count(kAll / 2, [] { draw_rect(kWhole, kFar); });
}

// CNT-05. GL 4.5, 17.3.6: NEVER and ALWAYS whatever is stored.
TEST_P(DepthCounts, never_and_always_are_exact) {
    draw_occluder();
    glDepthFunc(GL_NEVER);
    expect_count(0, [] { draw_rect(kWhole, kNear); });
    glDepthFunc(GL_ALWAYS);
    expect_count(kAll, [] { draw_rect(kWhole, kFar); });
}

// CNT-06. The depth that a counted fragment leaves behind is what the next one is tested against.
TEST_P(DepthCounts, the_second_of_two_equal_depths_counts_without_depth_writes_only) {
    const auto twice = [] {
        draw_whole();
        draw_whole();
    };
    glEnable(GL_DEPTH_TEST);
    expect_count(kAll, twice);
    expect_count(0, draw_whole);
    clear();
    glDepthMask(GL_FALSE);
    expect_count(2 * kAll, twice);
    expect_count(kAll, draw_whole);
}

// CNT-32. GL 4.5, 17.3.5 and 17.3.6: "If there is no depth buffer, it is as if the depth buffer test always
// passes"; of the stencil buffer likewise.
TEST_P(DepthCounts, without_a_depth_and_stencil_buffer_both_tests_pass) {
    if (const auto why = lacks(30)) GTEST_SKIP() << *why;
    const Framebuffer colour_only({.depth_stencil = false});
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_NEVER);
    expect_count(kAll, draw_whole);
    glEnable(GL_STENCIL_TEST);
    glStencilFunc(GL_NEVER, 0, 0xFF);
    expect_count(kAll, draw_whole);
}

// CNT-56. GL 4.5, appendix A.1: "For any given GL and framebuffer state vector, and for any GL command, the
// resulting GL and framebuffer state must be identical whenever the command is executed".
TEST_P(DepthCounts, the_same_scene_gives_the_same_count) {
    constexpr int kTriangles = 60;
    glEnable(GL_DEPTH_TEST);
    const auto scene = [] {
        std::mt19937 random(1997);
        const auto coordinate = [&] { return static_cast<GLfloat>(random() % 6400) / 100.0f; };
        for (int i = 0; i < 3 * kTriangles; ++i) {
            if (i % 3 == 0) glBegin(GL_TRIANGLES);
            const GLfloat x = coordinate();
            const GLfloat y = coordinate();
            glVertex3f(x, y, coordinate() / 64.0f);
            if (i % 3 == 2) glEnd();
        }
    };
    const auto first = count(scene);
    EXPECT_GT(first, 0u);
    const int drawn = drawn_pixels();
    for (int again = 0; again < 3; ++again) {
        clear();
        EXPECT_EQ(count(scene), first);
        EXPECT_EQ(drawn_pixels(), drawn);
    }
}

// CNT-07. ARB, issues: samples count "immediately after _both_ the depth and stencil tests"; all that follows
// (blending, logic operation, masks) comes too late to matter.
TEST_P(ColourCounts, what_becomes_of_the_colour_does_not_matter) {
    draw_occluder();
    glDepthMask(GL_FALSE);
    const auto expect_as_ever = [] {
        expect_count(kAll, [] { draw_rect(kWhole, kNear); });
        expect_count(0, [] { draw_rect(kWhole, kFar); });
    };
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    expect_as_ever();
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDrawBuffer(GL_NONE);
    expect_as_ever();
    glDrawBuffer(GL_BACK);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ZERO, GL_ONE);
    expect_as_ever();
    glDisable(GL_BLEND);
    glEnable(GL_COLOR_LOGIC_OP);
    glLogicOp(GL_NOOP);
    expect_as_ever();
    EXPECT_EQ(drawn_pixels(), 0);
}

// CNT-41. NV 4.1.6A: "Whenever a fragment reaches this stage": a fragment, not each colour that it writes.
TEST_P(ColourCounts, a_fragment_for_several_colour_attachments_counts_once) {
    if (const auto why = lacks(30)) GTEST_SKIP() << *why;
    const Framebuffer framebuffer({});
    std::array<GLuint, 2> more{};
    glGenRenderbuffers(more.size(), more.data());
    for (std::size_t i = 0; i < more.size(); ++i) {
        glBindRenderbuffer(GL_RENDERBUFFER, more[i]);
        glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, kSize, kSize);
        const auto attachment = static_cast<GLenum>(GL_COLOR_ATTACHMENT1 + i);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, more[i]);
    }
    constexpr std::array<GLenum, 3> kAttachments = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1,
                                                    GL_COLOR_ATTACHMENT2};
    glDrawBuffers(kAttachments.size(), kAttachments.data());
    ASSERT_EQ(glCheckFramebufferStatus(GL_FRAMEBUFFER), static_cast<GLenum>(GL_FRAMEBUFFER_COMPLETE));
    draw_occluder();
    expect_count(0, [] { draw_rect(kWhole, kFar); });
    expect_count(kAll, [] { draw_rect(kWhole, kNear); });
    for (const GLenum attachment : kAttachments) {
        glReadBuffer(attachment);
        EXPECT_EQ(drawn_pixels(), kSize * kSize);
    }
    glDeleteRenderbuffers(more.size(), more.data());
}

}  // namespace
}  // namespace conformance
