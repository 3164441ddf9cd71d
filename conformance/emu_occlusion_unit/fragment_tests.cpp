// SPDX-License-Identifier: MIT
// What comes before the depth test takes samples from both counters; what comes after takes none.
#include "emu_occlusion_unit/unit_test.h"

namespace conformance {
namespace {

class UnitFragmentTests : public UnitTest {
  protected:
    // Stencil 1 in the upper half of the window; the depths are those of draw_left_occluder.
    static void draw_upper_stencil() {
        glDisable(GL_STENCIL_TEST);
        draw_left_occluder();
        glEnable(GL_STENCIL_TEST);
        glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
        glStencilFunc(GL_ALWAYS, 1, 0xFF);
        glDepthMask(GL_FALSE);
        glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
        glDisable(GL_DEPTH_TEST);
        draw_rect({0, kHalf, kSize, kHalf}, kNear);
        glEnable(GL_DEPTH_TEST);
        glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
        glDepthMask(GL_TRUE);
        glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
    }

    static GLubyte stencil_at(int x, int y) {
        GLubyte value = 0xEE;
        glReadPixels(x, y, 1, 1, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, &value);
        return value;
    }
};

// Of 48 x 16 pixels the right 24 are before the occluder, and the upper eight rows of stencil 1.
constexpr Rect kAcross = {8, 24, 48, 16};

// 17.3.5.1: what reaches the depth test is what is left "after ... the stencil test".
TEST_F(UnitFragmentTests, what_fails_the_stencil_test_is_not_even_projected) {
    draw_upper_stencil();
    glStencilFunc(GL_EQUAL, 1, 0xFF);
    expect_seen(seen(48 * 8, {kHalf, 32, 24, 8}, kFar), [] { draw_rect(kAcross, kFar); });
    draw_upper_stencil();
    glStencilFunc(GL_EQUAL, 0, 0xFF);
    expect_seen(seen(48 * 8, {kHalf, 24, 24, 8}, kFar), [] { draw_rect(kAcross, kFar); });
    draw_upper_stencil();
    glStencilFunc(GL_NEVER, 0, 0xFF);
    expect_seen({}, [] { draw_rect(kAcross, kFar); });
}

// A stencil test that always passes may write whatever it likes: all registers are determined.
TEST_F(UnitFragmentTests, stencil_writes_go_on_while_the_unit_counts) {
    draw_left_occluder();
    glEnable(GL_STENCIL_TEST);
    glStencilFunc(GL_ALWAYS, 5, 0xFF);
    glStencilOp(GL_ZERO, GL_INCR, GL_REPLACE);
    expect_seen(kHalfHidden, draw_half_hidden);
    EXPECT_EQ(stencil_at(10, 10), 1) << "incremented once where the depth test fails";
    EXPECT_EQ(stencil_at(40, 10), 5) << "replaced where it passes";
    EXPECT_EQ(stencil_at(40, 40), 0);
}

// 17.3.5.2: a stencil test that depends on what it wrote itself; PROJECTED_HITS need not be determined.
TEST_F(UnitFragmentTests, a_stencil_test_that_reads_what_it_writes_is_exact_or_undetermined) {
    draw_left_occluder();
    glEnable(GL_STENCIL_TEST);
    glStencilFunc(GL_EQUAL, 0, 0xFF);
    glStencilOp(GL_KEEP, GL_INCR, GL_INCR);
    // The second rectangle finds 1 wherever the first one was.
    expect_seen_or_undetermined(GL_PROJECTED_HITS_BIT_EMU, kHalfHidden, [] {
        draw_half_hidden();
        draw_half_hidden();
    });
    EXPECT_EQ(stencil_at(10, 10), 1);
    EXPECT_EQ(stencil_at(40, 10), 1);
    // With the depth test off, nothing can fail in between.
    clear();
    glDisable(GL_DEPTH_TEST);
    expect_seen(seen(768, kHalfHiddenRect, kFar), [] {
        draw_half_hidden();
        draw_half_hidden();
    });
}

// The same without depth writes; NEAREST_DEPTH need not be determined either.
TEST_F(UnitFragmentTests, stencil_writes_without_depth_writes_are_exact_or_undetermined) {
    draw_left_occluder();
    glDepthMask(GL_FALSE);
    glEnable(GL_STENCIL_TEST);
    glStencilFunc(GL_EQUAL, 0, 0xFF);
    glStencilOp(GL_KEEP, GL_KEEP, GL_INCR);
    const Seen expected = {.projected = 768 + 384, .visible = 384, .nearest = kFar, .box = kHalfHidden.box};
    expect_seen_or_undetermined(GL_PROJECTED_HITS_BIT_EMU | GL_NEAREST_DEPTH_BIT_EMU, expected, [] {
        draw_half_hidden();
        draw_half_hidden();  // the hidden half is projected again
    });
    glDepthMask(GL_TRUE);
}

// The two faces have a stencil test each.
TEST_F(UnitFragmentTests, each_face_has_its_own_stencil_test) {
    draw_left_occluder();
    glEnable(GL_STENCIL_TEST);
    glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
    glStencilFuncSeparate(GL_FRONT, GL_NEVER, 0, 0xFF);
    glStencilFuncSeparate(GL_BACK, GL_ALWAYS, 0, 0xFF);
    expect_seen({}, draw_half_hidden);
    glFrontFace(GL_CW);
    expect_seen(kHalfHidden, draw_half_hidden);
    glFrontFace(GL_CCW);
}

// 17.3.5.1: left after the "alpha test".
TEST_F(UnitFragmentTests, what_fails_the_alpha_test_is_not_even_projected) {
    draw_left_occluder();
    glEnable(GL_ALPHA_TEST);
    glAlphaFunc(GL_GREATER, 0.5f);
    const auto draw_two = [] {
        glColor4f(1.0f, 1.0f, 1.0f, 0.25f);
        draw_rect(kWhole, kNear);
        glColor4f(1.0f, 1.0f, 1.0f, 0.75f);
        draw_half_hidden();
    };
    expect_seen(kHalfHidden, draw_two);
    glAlphaFunc(GL_NEVER, 0.0f);
    expect_seen({}, draw_two);
}

// Alpha that changes within a primitive: 1 at the left edge, 0 at the right; above 0.5 in the left half.
TEST_F(UnitFragmentTests, the_alpha_test_cuts_through_a_primitive) {
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_ALPHA_TEST);
    glAlphaFunc(GL_GREATER, 0.5f);
    expect_seen(seen(kHalf * 16, {0, 8, kHalf, 16}, kMiddle), [] {
        glBegin(GL_QUADS);
        for (const auto& [x, y] : {std::pair{0, 8}, {kSize, 8}, {kSize, 24}, {0, 24}}) {
            glColor4f(1.0f, 1.0f, 1.0f, x == 0 ? 1.0f : 0.0f);
            glVertex3f(static_cast<GLfloat>(x), static_cast<GLfloat>(y), kMiddle);
        }
        glEnd();
    });
    glColor4f(1.0f, 1.0f, 1.0f, 1.0f);
}

// 17.3.5.1: left after "the scissor test", and the pixel ownership test.
TEST_F(UnitFragmentTests, what_the_scissor_rectangle_cuts_off_is_not_even_projected) {
    draw_left_occluder();
    glEnable(GL_SCISSOR_TEST);
    glScissor(24, 12, 16, 40);
    expect_seen(seen(16 * 12, {kHalf, 12, 8, 12}, kFar), draw_half_hidden);
    glScissor(0, 0, 0, 0);
    expect_seen({}, draw_half_hidden);
    glDisable(GL_SCISSOR_TEST);
    clear();
    expect_seen(seen(8 * 8, {kSize - 8, kSize - 8, 8, 8}, kFar), [] {
        draw_rect({kSize - 8, kSize - 8, 40, 40}, kFar);
    });
}

// 17.3.5.1: "A fragment's colour, what becomes of it, and the masks do not matter."
TEST_F(UnitFragmentTests, what_becomes_of_the_colour_does_not_matter) {
    const std::array<Draw, 4> states = {[] { glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE); },
                                        [] {
                                            glEnable(GL_BLEND);
                                            glBlendFunc(GL_ZERO, GL_ONE);
                                        },
                                        [] {
                                            glEnable(GL_COLOR_LOGIC_OP);
                                            glLogicOp(GL_NOOP);
                                        },
                                        [] { glDrawBuffer(GL_NONE); }};
    for (const Draw& set : states) {
        draw_left_occluder();
        set();
        expect_seen(kHalfHidden, draw_half_hidden);
        glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
        glDisable(GL_BLEND);
        glDisable(GL_COLOR_LOGIC_OP);
    }
    glDrawBuffer(GL_BACK);
    while (glGetError() != GL_NO_ERROR) {
    }
}

// 17.3.5.1: it is fragments that step the unit: what is culled or clipped makes none.
TEST_F(UnitFragmentTests, what_is_culled_or_clipped_away_makes_no_sample) {
    draw_left_occluder();
    glEnable(GL_CULL_FACE);
    glCullFace(GL_FRONT);
    expect_seen({}, draw_half_hidden);
    glCullFace(GL_BACK);
    expect_seen(kHalfHidden, draw_half_hidden);
    glDisable(GL_CULL_FACE);
    draw_left_occluder();
    const std::array<GLdouble, 4> right_of_48 = {1.0, 0.0, 0.0, -48.0};
    glClipPlane(GL_CLIP_PLANE0, right_of_48.data());
    glEnable(GL_CLIP_PLANE0);
    expect_seen(seen(8 * 16, {48, 8, 8, 16}, kFar), draw_half_hidden);
    glDisable(GL_CLIP_PLANE0);
    glEnable(GL_RASTERIZER_DISCARD);
    expect_seen({}, draw_half_hidden);
    glDisable(GL_RASTERIZER_DISCARD);
}

// A polygon stipple lets every second column through.
TEST_F(UnitFragmentTests, a_stipple_takes_its_share) {
    draw_left_occluder();
    const std::vector<GLubyte> odd_columns(32 * 32 / 8, 0x55);
    glPolygonStipple(odd_columns.data());
    glEnable(GL_POLYGON_STIPPLE);
    expect_seen({.projected = 24 * 16, .visible = 12 * 16, .nearest = kFar, .box = {33, 8, 55, 23}},
                draw_half_hidden);
    glDisable(GL_POLYGON_STIPPLE);
}

}  // namespace
}  // namespace conformance
