// SPDX-License-Identifier: MIT
// Pixel rectangles make fragments and count; clears, blits and copies make none and do not (HP-56).
#include <array>
#include <functional>

#include "harness/objects.h"
#include "hp_occlusion_test/hp_test.h"

namespace conformance {
namespace {

class PixelPaths : public HpTest {
  protected:
    // Draws at the current raster position, once before an occluder and once behind it.
    static void expect_counted(int pixels, const std::function<void()>& draw) {
        draw_occluder();
        glDepthMask(GL_FALSE);
        for (const bool visible : {true, false}) {
            glClear(GL_COLOR_BUFFER_BIT);
            glRasterPos3f(8.0f, 8.0f, visible ? kNear : kFar);
            EXPECT_EQ(result_of(draw), visible);
            EXPECT_EQ(drawn_pixels(), visible ? pixels : 0);
            EXPECT_TRUE(no_error());
        }
    }

    // The test is enabled all along: no part of the command may count.
    static void expect_not_counted(const std::function<void()>& command) {
        EXPECT_FALSE(result_of(command));
        EXPECT_TRUE(no_error());
    }
};

// HP-56. GL, DrawPixels: a group of pixels becomes fragments with the raster position's depth.
TEST_F(PixelPaths, draw_pixels_counts) {
    const std::vector<GLubyte> white(16 * 16 * 4, 0xFF);
    expect_counted(16 * 16, [&] { glDrawPixels(16, 16, GL_RGBA, GL_UNSIGNED_BYTE, white.data()); });
}

// HP-56. GL, Bitmap: the bits that are 1 become fragments.
TEST_F(PixelPaths, bitmap_counts_its_one_bits) {
    const std::array<GLubyte, 8> striped = {0xAA, 0xAA, 0xAA, 0xAA, 0xAA, 0xAA, 0xAA, 0xAA};
    expect_counted(8 * 4, [&] { glBitmap(8, 8, 0.0f, 0.0f, 0.0f, 0.0f, striped.data()); });
    const std::array<GLubyte, 8> empty{};
    expect_not_counted([&] { glBitmap(8, 8, 0.0f, 0.0f, 0.0f, 0.0f, empty.data()); });
}

// HP-56. GL, CopyPixels: as ReadPixels followed by DrawPixels.
TEST_F(PixelPaths, copy_pixels_counts) {
    const auto source = [] {
        glDisable(GL_DEPTH_TEST);
        draw_rect({48, 48, 8, 8}, kNear);
        glEnable(GL_DEPTH_TEST);
    };
    draw_occluder();
    glDepthMask(GL_FALSE);
    for (const bool visible : {true, false}) {
        glClear(GL_COLOR_BUFFER_BIT);
        source();
        glRasterPos3f(8.0f, 8.0f, visible ? kNear : kFar);
        EXPECT_EQ(result_of([] { glCopyPixels(48, 48, 8, 8, GL_COLOR); }), visible);
        EXPECT_EQ(drawn_pixels({8, 8, 8, 8}), visible ? 8 * 8 : 0);
    }
}

// HP-56. GL 4.5, 17.4.3: a clear is no rendering; it passes ownership, scissor and dithering only.
TEST_F(PixelPaths, clear_does_not_count) {
    expect_not_counted([] { glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT); });
    // A driver that clears masked or scissored by drawing a quad must not count it.
    expect_not_counted([] {
        glEnable(GL_SCISSOR_TEST);
        glScissor(8, 8, 16, 16);
        glColorMask(GL_TRUE, GL_FALSE, GL_TRUE, GL_FALSE);
        glStencilMask(0x0F);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    });
}

// HP-56, of ClearBuffer*.
TEST_F(PixelPaths, clear_buffer_does_not_count) {
    if (const auto why = lacks(30)) GTEST_SKIP() << *why;
    const std::array<GLfloat, 4> colour{1.0f, 1.0f, 1.0f, 1.0f};
    const GLfloat depth = 0.5f;
    expect_not_counted([&] {
        glClearBufferfv(GL_COLOR, 0, colour.data());
        glClearBufferfv(GL_DEPTH, 0, &depth);
        glClearBufferfi(GL_DEPTH_STENCIL, 0, depth, 1);
    });
}

// HP-56. GL 4.5 compatibility, 17.4.5: to the pixels of RETURN "only" ownership, scissor, sRGB and dithering
// apply.
TEST_F(PixelPaths, accumulation_does_not_count) {
    const Surface accumulating({.accumulation_bits = 16});
    if (!accumulating) GTEST_SKIP() << "no surface with an accumulation buffer";
    come_back(accumulating);
    clear();
    draw_rect({8, 8, 8, 8}, kMiddle);
    expect_not_counted([] {
        glAccum(GL_LOAD, 1.0f);
        glAccum(GL_RETURN, 1.0f);
    });
    EXPECT_EQ(drawn_pixels(), 8 * 8);
    come_back();
}

// HP-56. Reading and copying out of the framebuffer makes no fragments.
TEST_F(PixelPaths, reading_and_copying_to_textures_does_not_count) {
    GLuint texture = 0;
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    const std::vector<GLubyte> white(64 * 64 * 4, 0xFF);
    expect_not_counted([&] {
        read_colours();
        read_depths();
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 64, 64, 0, GL_RGBA, GL_UNSIGNED_BYTE, white.data());
        glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 0, 0, 64, 64, 0);
        glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 8, 8, 8, 8, 16, 16);
        std::vector<GLubyte> back(64 * 64 * 4);
        glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, back.data());
    });
    glDeleteTextures(1, &texture);
}

// HP-56. GL 4.5, 18.3.1: BlitFramebuffer's pixels bypass the per-fragment tests but ownership and scissor;
// mipmaps are no rendering to the framebuffer at all.
TEST_F(PixelPaths, blits_and_mipmap_generation_do_not_count) {
    if (const auto why = lacks(30)) GTEST_SKIP() << *why;
    const Framebuffer target({});
    GLuint texture = 0;
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 64, 64, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    expect_not_counted([&] {
        glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, target.name());
        glBlitFramebuffer(0, 0, 64, 64, 0, 0, 32, 32, GL_COLOR_BUFFER_BIT, GL_LINEAR);
        glBlitFramebuffer(0, 0, 64, 64, 0, 0, 64, 64, GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT,
                          GL_NEAREST);
        glGenerateMipmap(GL_TEXTURE_2D);
    });
    glDeleteTextures(1, &texture);
}

}  // namespace
}  // namespace conformance
