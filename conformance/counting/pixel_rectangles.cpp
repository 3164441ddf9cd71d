// SPDX-License-Identifier: MIT
// Pixel rectangles are made into fragments, and count as such (CNT-20 to CNT-22).
#include <array>
#include <vector>

#include "counting/counters.h"

namespace conformance {
namespace {

class PixelsCount : public CountingTest {
  protected:
    // An occluder over all; the raster position stands before or behind it. Nothing more is written to depth.
    static void stand_at(int x, int y, float depth) {
        draw_occluder();
        glDepthMask(GL_FALSE);
        glRasterPos3f(static_cast<GLfloat>(x), static_cast<GLfloat>(y), depth);
    }

    // <draw>, at the lower left of the window, makes so many fragments at the raster position's depth.
    static void expect_at_raster_depth(std::uint64_t samples, const Draw& draw) {
        stand_at(0, 0, kFar);
        expect_count(0, draw);
        stand_at(0, 0, kNear);
        expect_count(samples, draw);
    }
};

COUNT_WITH_EACH(PixelsCount);

void draw_white_pixels(int width, int height) {
    const std::vector<GLubyte> white(static_cast<std::size_t>(4 * width * height), 0xFF);
    glDrawPixels(width, height, GL_RGBA, GL_UNSIGNED_BYTE, white.data());
}

// CNT-20. GL 4.5 compatibility, 18.1: DrawPixels makes fragments, with the raster position's depth.
TEST_P(PixelsCount, draw_pixels_counts_its_pixels) {
    expect_at_raster_depth(16 * 12, [] { draw_white_pixels(16, 12); });
    EXPECT_EQ(drawn_pixels(), 16 * 12);
}

// CNT-20. GL 4.5 compatibility, 18.1.1: zoomed, a group is a rectangle of fragments.
TEST_P(PixelsCount, zoomed_pixels_count_every_fragment) {
    glPixelZoom(2.0f, 2.0f);
    expect_at_raster_depth(4 * 16 * 12, [] { draw_white_pixels(16, 12); });
    EXPECT_EQ(drawn_pixels(), 4 * 16 * 12);
}

// CNT-20. GL 4.5, 17.3.1: what lies outside the window has no pixel to pass for.
TEST_P(PixelsCount, pixels_beyond_the_window_do_not_count) {
    stand_at(kSize - 6, kSize - 8, kNear);
    expect_count(6 * 8, [] { draw_white_pixels(16, 12); });
    EXPECT_EQ(drawn_pixels(), 6 * 8);
}

// CNT-20. GL 4.5 compatibility, 18.1.1: a group of depths makes fragments that carry them; they take the
// depth test like all others.
TEST_P(PixelsCount, drawn_depths_take_the_depth_test) {
    std::vector<GLfloat> depths(16 * 12, kFar);
    const auto draw = [&] { glDrawPixels(16, 12, GL_DEPTH_COMPONENT, GL_FLOAT, depths.data()); };
    stand_at(0, 0, kNear);
    glDepthMask(GL_TRUE);
    expect_count(0, draw);
    depths.assign(16 * 12, kNear);
    expect_count(16 * 12, draw);
}

// CNT-21. GL 4.5 compatibility, 18.1.2: a bitmap's bits that are 1 become fragments.
TEST_P(PixelsCount, bitmap_counts_its_one_bits) {
    const std::array<GLubyte, 4> five_bits = {0x80, 0x00, 0x18, 0x03};
    expect_at_raster_depth(5, [&] { glBitmap(8, 4, 0.0f, 0.0f, 0.0f, 0.0f, five_bits.data()); });
    const std::array<GLubyte, 4> no_bits{};
    expect_count(0, [&] { glBitmap(8, 4, 0.0f, 0.0f, 0.0f, 0.0f, no_bits.data()); });
    EXPECT_EQ(drawn_pixels(), 5);
}

// CNT-22. GL 4.5 compatibility, 18.3.2: CopyPixels is as ReadPixels followed by DrawPixels.
TEST_P(PixelsCount, copied_colours_count) {
    expect_at_raster_depth(16 * 12, [] { glCopyPixels(32, 32, 16, 12, GL_COLOR); });
}

// CNT-22. The same of depths: 0.25 is copied to where 0.5 stands, and then 0.5 to where 0.25 does.
TEST_P(PixelsCount, copied_depths_take_the_depth_test) {
    draw_occluder();
    draw_rect({32, 32, 16, 12}, kNear);
    glRasterPos3f(0.0f, 0.0f, kFar);  // the depth is copied: the raster position's does not matter
    expect_count(16 * 12, [] { glCopyPixels(32, 32, 16, 12, GL_DEPTH); });
    EXPECT_NEAR(read_depths({0, 0, 1, 1}).front(), kNear, 1e-6);
    expect_count(0, [] { glCopyPixels(48, 0, 16, 12, GL_DEPTH); });
}

// CNT-22. GL 2.1, 4.3.1: stencil indices "are produced in lieu of fragments", and but for pixel ownership and
// scissor "all other per-fragment operations are bypassed".
TEST_P(PixelsCount, drawn_and_copied_stencil_does_not_count) {
    if (GetParam().is_conservative) GTEST_SKIP() << "a conservative TRUE says nothing";
    draw_occluder();
    glRasterPos3f(0.0f, 0.0f, kNear);
    const std::vector<GLubyte> ones(16 * 12, 1);
    expect_count(0, [&] { glDrawPixels(16, 12, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, ones.data()); });
    glRasterPos3f(32.0f, 32.0f, kNear);
    expect_count(0, [] { glCopyPixels(0, 0, 16, 12, GL_STENCIL); });
    GLubyte stencil = 0;
    glReadPixels(32, 32, 1, 1, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, &stencil);
    EXPECT_EQ(stencil, 1);
}

}  // namespace
}  // namespace conformance
