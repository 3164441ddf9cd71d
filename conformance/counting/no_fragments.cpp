// SPDX-License-Identifier: MIT
// Commands that write pixels and make no fragments, and modes in which none arise (CNT-23 to CNT-27). A
// driver may well draw quads of its own for the former; a counter must not see them.
#include <array>
#include <vector>

#include "counting/counters.h"

namespace conformance {
namespace {

class NoFragments : public CountingTest {
  protected:
    // A texture of the window's size, bound.
    class Texture {
      public:
        explicit Texture(GLubyte value = 0) : pixels_(4 * kAll, value) {
            glGenTextures(1, &name_);
            glBindTexture(GL_TEXTURE_2D, name_);
            glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, kSize, kSize, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                         pixels_.data());
            glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);  // complete without mipmaps
        }
        ~Texture() { glDeleteTextures(1, &name_); }
        Texture(const Texture&) = delete;
        Texture& operator=(const Texture&) = delete;
        GLuint name() const { return name_; }

      private:
        std::vector<GLubyte> pixels_;
        GLuint name_ = 0;
    };
};

COUNT_WITH_EACH(NoFragments);

// CNT-23. GL 4.5, 17.4.3: Clear sets every pixel; of the tests only pixel ownership, scissor and dithering.
TEST_P(NoFragments, a_clear_does_not_count) {
    expect_count(0, [] { clear(); });
    glEnable(GL_SCISSOR_TEST);
    glScissor(8, 8, 16, 16);
    glColorMask(GL_TRUE, GL_FALSE, GL_TRUE, GL_FALSE);
    glStencilMask(0x0F);
    expect_count(0, [] { clear(); });
    glStencilMask(0xFF);
}

// CNT-23, of ClearBuffer*.
TEST_P(NoFragments, a_clear_of_one_buffer_does_not_count) {
    if (const auto why = lacks(30)) GTEST_SKIP() << *why;
    const std::array<GLfloat, 4> white = {1.0f, 1.0f, 1.0f, 1.0f};
    const GLfloat depth = kNear;
    const GLint stencil = 3;
    expect_count(0, [&] {
        glClearBufferfv(GL_COLOR, 0, white.data());
        glClearBufferfv(GL_DEPTH, 0, &depth);
        glClearBufferiv(GL_STENCIL, 0, &stencil);
        glClearBufferfi(GL_DEPTH_STENCIL, 0, depth, 1);
    });
    EXPECT_EQ(drawn_pixels(), kSize * kSize);
}

// CNT-23. ARB_clear_texture: no rendering at all.
TEST_P(NoFragments, a_clear_of_a_texture_does_not_count) {
    if (const auto why = lacks(44, "GL_ARB_clear_texture")) GTEST_SKIP() << *why;
    const Texture texture;
    const std::array<GLubyte, 4> white = {0xFF, 0xFF, 0xFF, 0xFF};
    expect_count(0, [&] {
        glClearTexImage(texture.name(), 0, GL_RGBA, GL_UNSIGNED_BYTE, white.data());
        glClearTexSubImage(texture.name(), 0, 4, 4, 0, 8, 8, 1, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    });
}

// CNT-24. GL 4.5, 18.3.1: of the tests BlitFramebuffer's pixels pass only pixel ownership and scissor.
TEST_P(NoFragments, a_blit_does_not_count) {
    if (const auto why = lacks(30)) GTEST_SKIP() << *why;
    draw_whole();
    const Framebuffer target({});
    clear();
    expect_count(0, [&] {
        glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
        glBlitFramebuffer(0, 0, kSize, kSize, 0, 0, kHalf, kHalf, GL_COLOR_BUFFER_BIT, GL_LINEAR);
        glBlitFramebuffer(0, 0, kSize, kSize, 0, 0, kSize, kSize, GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT,
                          GL_NEAREST);
    });
    target.bind();
    EXPECT_EQ(drawn_pixels(), kHalf * kHalf);
}

// CNT-24. The same where samples are resolved.
TEST_P(NoFragments, a_resolve_does_not_count) {
    if (const auto why = lacks(30)) GTEST_SKIP() << *why;
    const Framebuffer source({.samples = 4});
    draw_whole();
    expect_count(0, [] {
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
        glBlitFramebuffer(0, 0, kSize, kSize, 0, 0, kSize, kSize, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    });
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    EXPECT_EQ(drawn_pixels(), kSize * kSize);
}

// CNT-24. Reading and copying out of a framebuffer, and making mipmaps, draw nothing.
TEST_P(NoFragments, reading_copying_and_mipmaps_do_not_count) {
    const Texture texture;
    std::vector<GLubyte> pixels(4 * kAll, 0xFF);
    draw_whole();
    expect_count(0, [&] {
        EXPECT_EQ(drawn_pixels(), kSize * kSize);
        read_depths();
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, kSize, kSize, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
        glTexSubImage2D(GL_TEXTURE_2D, 0, 4, 4, 8, 8, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
        glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 0, 0, kSize, kSize, 0);
        glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 8, 8, 8, 8, 16, 16);
        glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
        if (!lacks(30)) glGenerateMipmap(GL_TEXTURE_2D);
    });
}

// CNT-24. ARB_copy_image: between textures, without rendering.
TEST_P(NoFragments, copying_an_image_does_not_count) {
    if (const auto why = lacks(43, "GL_ARB_copy_image")) GTEST_SKIP() << *why;
    const Texture from(0xFF);
    const Texture to;
    expect_count(0, [&] {
        glCopyImageSubData(from.name(), GL_TEXTURE_2D, 0, 0, 0, 0, to.name(), GL_TEXTURE_2D, 0, 8, 8, 0, 16,
                           16, 1);
    });
}

// CNT-25. Whatever a driver, or a layer on it, does behind these commands by drawing: between two drawings of
// the program's own nothing is added.
TEST_P(NoFragments, internal_operations_add_nothing_to_a_count) {
    if (const auto why = lacks(30)) GTEST_SKIP() << *why;
    const Texture texture(0xFF);
    GLuint buffer = 0;
    glGenBuffers(1, &buffer);
    expect_count(2 * kAll / 4, [&] {
        draw_rect(kQuarter, kMiddle);
        glBindBuffer(GL_PIXEL_PACK_BUFFER, buffer);
        glBufferData(GL_PIXEL_PACK_BUFFER, 4 * kAll, nullptr, GL_STREAM_COPY);
        glReadPixels(0, 0, kSize, kSize, GL_BGRA, GL_UNSIGNED_BYTE, nullptr);
        glGetTexImage(GL_TEXTURE_2D, 0, GL_BGRA, GL_UNSIGNED_BYTE, nullptr);
        glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
        glBindBuffer(GL_PIXEL_UNPACK_BUFFER, buffer);
        glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, kSize, kSize, GL_BGRA, GL_UNSIGNED_BYTE, nullptr);
        glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
        get_integer(GL_MAX_TEXTURE_SIZE);
        glIsEnabled(GL_DEPTH_TEST);
        glPushAttrib(GL_COLOR_BUFFER_BIT);
        clear();
        glPopAttrib();
        draw_rect(kQuarter, kMiddle);
    });
    glDeleteBuffers(1, &buffer);
}

// CNT-26. GL 4.5 compatibility, 14.1 and 20: in render modes FEEDBACK and SELECT nothing is rasterized.
TEST_P(NoFragments, feedback_and_selection_do_not_count) {
    std::array<GLfloat, 256> feedback{};
    std::array<GLuint, 256> names{};
    glFeedbackBuffer(feedback.size(), GL_3D, feedback.data());
    glSelectBuffer(names.size(), names.data());
    for (const GLenum mode : {GL_FEEDBACK, GL_SELECT}) {
        glRenderMode(mode);
        glInitNames();
        glPushName(1);
        expect_count(0, draw_whole);
        EXPECT_GT(glRenderMode(GL_RENDER), 0) << "nothing was fed back or selected";
    }
    expect_count(kAll, draw_whole);
}

// CNT-27. GL 4.5, 14.1: with RASTERIZER_DISCARD no primitive gets as far as rasterization.
TEST_P(NoFragments, discarded_primitives_do_not_count) {
    if (const auto why = lacks(30)) GTEST_SKIP() << *why;
    glEnable(GL_RASTERIZER_DISCARD);
    expect_count(0, draw_whole);
    glDisable(GL_RASTERIZER_DISCARD);
    expect_count(kAll, draw_whole);
}

}  // namespace
}  // namespace conformance
