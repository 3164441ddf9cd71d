// SPDX-License-Identifier: MIT
// Whose depths are read: framebuffer objects of every format, attachment and size, and every sample of them.
#include "emu_depth_region_query/region_test.h"

namespace conformance {
namespace {

// A framebuffer object with nothing but a depth texture, bound for drawing and for reading while it lives.
class DepthTexture {
  public:
    explicit DepthTexture(GLenum format, int samples = 0, int width = kSurfaceSize,
                          int height = kSurfaceSize) {
        const bool has_stencil = format == GL_DEPTH24_STENCIL8 || format == GL_DEPTH32F_STENCIL8;
        const GLenum target = samples == 0 ? GL_TEXTURE_2D : GL_TEXTURE_2D_MULTISAMPLE;
        glGenTextures(1, &texture_);
        glBindTexture(target, texture_);
        if (samples == 0) {
            glTexStorage2D(target, 1, format, width, height);
        } else {
            glTexStorage2DMultisample(target, samples, format, width, height, GL_TRUE);
        }
        glGenFramebuffers(1, &name_);
        glBindFramebuffer(GL_FRAMEBUFFER, name_);
        glFramebufferTexture2D(GL_FRAMEBUFFER,
                               has_stencil ? GL_DEPTH_STENCIL_ATTACHMENT : GL_DEPTH_ATTACHMENT, target,
                               texture_, 0);
        glDrawBuffer(GL_NONE);
        glReadBuffer(GL_NONE);
        EXPECT_EQ(glCheckFramebufferStatus(GL_FRAMEBUFFER), static_cast<GLenum>(GL_FRAMEBUFFER_COMPLETE));
        glClearDepth(1.0);
        glClear(GL_DEPTH_BUFFER_BIT);
    }
    ~DepthTexture() {
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        glDeleteFramebuffers(1, &name_);
        glDeleteTextures(1, &texture_);
    }
    DepthTexture(const DepthTexture&) = delete;
    DepthTexture& operator=(const DepthTexture&) = delete;

    GLuint name() const { return name_; }

  private:
    GLuint name_ = 0;
    GLuint texture_ = 0;
};

void expect_steps() {
    put_depth({0, 0, 32, 64}, kTwoFifths);
    put_depth({7, 9, 1, 1}, kFifth);
    put_depth({30, 63, 1, 1}, kFourFifths);
    EXPECT_EQ(occluded({0, 0, 32, 64}), 1.0f);
    EXPECT_EQ(occluded({0, 0, 33, 64}), 0.0f);
    EXPECT_NEAR(furthest({0, 0, 32, 64}), kFourFifths, kLittle);
    EXPECT_NEAR(nearest({0, 0, 32, 64}), kFifth, kLittle);
    EXPECT_EQ(furthest(kWhole), 1.0f);
}

class RegionFormats : public RegionTest, public ::testing::WithParamInterface<GLenum> {};

// "the depth buffer of the draw framebuffer", of whatever format
TEST_P(RegionFormats, every_format_answers) {
    const DepthTexture framebuffer(GetParam());
    expect_steps();
}

// "the value that ReadPixels returns with format DEPTH_COMPONENT and type FLOAT"
TEST_P(RegionFormats, depths_are_those_of_read_pixels) {
    const DepthTexture framebuffer(GetParam());
    for (int i = 0; i < 64; ++i) put_depth({i, 0, 1, 64}, 0.0137f * static_cast<GLfloat>(i + 1));
    for (int i = 0; i < 64; ++i) {
        const Rect column = {i, i, 1, 1};
        EXPECT_EQ(furthest(column), read_depths(column).front()) << i;
        EXPECT_EQ(nearest(column), read_depths(column).front()) << i;
    }
}

INSTANTIATE_TEST_SUITE_P(Each, RegionFormats,
                         ::testing::Values(GL_DEPTH_COMPONENT16, GL_DEPTH_COMPONENT24, GL_DEPTH24_STENCIL8,
                                           GL_DEPTH_COMPONENT32F, GL_DEPTH32F_STENCIL8));

using RegionFramebuffers = RegionTest;

// "Where the format is finer than a float ... the furthest depth is rounded towards the far value and the
// nearest towards the near value"
TEST_F(RegionFramebuffers, bounds_of_32_bits_hold_every_depth_between_them) {
    const DepthTexture framebuffer(GL_DEPTH_COMPONENT32);
    expect_steps();
    for (int i = 0; i < 64; ++i) {
        put_depth(kWhole, 0.501f + 0.00713f * static_cast<GLfloat>(i));
        GLuint fixed = 0;
        glReadPixels(5, 5, 1, 1, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, &fixed);
        const double exact = fixed / 4294967295.0;
        const Rect pixel = {5, 5, 1, 1};
        far_depth(GL_ONE);
        EXPECT_GE(furthest(pixel), exact);
        EXPECT_LE(nearest(pixel), exact);
        EXPECT_NEAR(furthest(pixel), exact, 6e-8);
        EXPECT_NEAR(nearest(pixel), exact, 6e-8);
        far_depth(GL_ZERO);
        EXPECT_LE(furthest(pixel), exact);
        EXPECT_GE(nearest(pixel), exact);
    }
}

// "the draw framebuffer": not the one that is read from
TEST_F(RegionFramebuffers, the_draw_framebuffer_is_asked) {
    put_depth(kWhole, kFifth);
    const DepthTexture framebuffer(GL_DEPTH_COMPONENT24);
    put_depth(kWhole, kFourFifths);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
    EXPECT_NEAR(furthest(kWhole), kFourFifths, kLittle);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer.name());
    EXPECT_NEAR(furthest(kWhole), kFifth, kLittle);
    EXPECT_EQ(get_integer(GL_READ_FRAMEBUFFER_BINDING), static_cast<GLint>(framebuffer.name()));
}

// "clipped to the framebuffer", whose size is its own
TEST_F(RegionFramebuffers, a_framebuffer_of_another_size_is_asked_whole) {
    const DepthTexture framebuffer(GL_DEPTH_COMPONENT24, 0, 200, 100);
    put_depth({0, 0, 200, 100}, kTwoFifths);
    put_depth({199, 99, 1, 1}, kFourFifths);
    const GLuint64 before = pixels_read();
    EXPECT_NEAR(furthest({-1, -1, 1000, 1000}), kFourFifths, kLittle);
    EXPECT_EQ(pixels_read() - before, 20000u);
}

// GL 4.5, 9.2: the framebuffer is what its attachments have in common
TEST_F(RegionFramebuffers, attachments_of_different_sizes_count_with_what_they_share) {
    const DepthTexture framebuffer(GL_DEPTH_COMPONENT24, 0, 50, 20);
    GLuint colour = 0;
    glGenRenderbuffers(1, &colour);
    glBindRenderbuffer(GL_RENDERBUFFER, colour);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, 30, 64);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, colour);
    furthest({0, 0, 100, 100});
    EXPECT_EQ(pixels_read(), 600u);
    glDeleteRenderbuffers(1, &colour);
}

// "Of a layered framebuffer the first layer is asked"
TEST_F(RegionFramebuffers, of_layers_the_first_is_asked) {
    GLuint texture = 0;
    GLuint framebuffer = 0;
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D_ARRAY, texture);
    glTexStorage3D(GL_TEXTURE_2D_ARRAY, 1, GL_DEPTH_COMPONENT24, 64, 64, 2);
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glDrawBuffer(GL_NONE);
    glReadBuffer(GL_NONE);
    for (GLint layer = 0; layer < 2; ++layer) {
        glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, texture, 0, layer);
        put_depth(kWhole, layer == 0 ? kTwoFifths : kFourFifths);
    }
    glFramebufferTexture(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, texture, 0);
    EXPECT_NEAR(furthest(kWhole), kTwoFifths, kLittle);
    EXPECT_NEAR(nearest(kWhole), kTwoFifths, kLittle);
    glDeleteFramebuffers(1, &framebuffer);
    glDeleteTextures(1, &texture);
}

class RegionSamples : public RegionTest, public ::testing::WithParamInterface<GLenum> {
  protected:
    void SetUp() override {
        ASSERT_NO_FATAL_FAILURE(RegionTest::SetUp());
        if (IsSkipped()) return;
        if (get_integer(GL_MAX_DEPTH_TEXTURE_SAMPLES) < 4) GTEST_SKIP() << "needs four depth samples";
    }
};

// "all samples of its pixels"
TEST_P(RegionSamples, every_sample_counts) {
    const DepthTexture framebuffer(GetParam(), 4);
    expect_steps();
    glEnable(GL_SAMPLE_MASK);
    for (GLuint sample = 0; sample < 4; ++sample) {
        put_depth(kWhole, kTwoFifths);
        glEnable(GL_DEPTH_TEST);
        glDepthFunc(GL_ALWAYS);
        glSampleMaski(0, 1u << sample);
        draw_rect({20, 24, 1, 1}, kFourFifths);
        draw_rect({21, 24, 1, 1}, kFifth);
        EXPECT_NEAR(furthest(kWhole), kFourFifths, kLittle) << sample;
        EXPECT_NEAR(nearest(kWhole), kFifth, kLittle) << sample;
        EXPECT_NEAR(nearest({20, 24, 1, 1}), kTwoFifths, kLittle) << sample;
        EXPECT_NEAR(furthest({21, 24, 1, 1}), kTwoFifths, kLittle) << sample;
        draw_rect({40, 2, 1, 1}, 1.0f);
        EXPECT_EQ(occluded(kWhole), 0.0f) << sample;
        EXPECT_EQ(occluded({0, 3, 64, 61}), 1.0f) << sample;
        glDepthFunc(GL_LESS);
        glDisable(GL_DEPTH_TEST);
    }
    glDisable(GL_SAMPLE_MASK);
}

// "pixels, not samples"
TEST_P(RegionSamples, pixels_are_counted_once) {
    const DepthTexture framebuffer(GetParam(), 4);
    furthest({0, 0, 8, 8});
    EXPECT_EQ(pixels_read(), 64u);
}

// "the value that ReadPixels returns" for the same depth in a single-sampled buffer
TEST_P(RegionSamples, depths_are_those_of_a_single_sampled_buffer) {
    for (const GLfloat depth : {0.3f, 0.51f, 0.76f, 0.8f, 0.93f, 0.999f}) {
        GLfloat expected = 0;
        {
            const DepthTexture single(GetParam());
            put_depth(kWhole, depth);
            expected = furthest({3, 3, 1, 1});
        }
        const DepthTexture multisampled(GetParam(), 4);
        put_depth(kWhole, depth);
        EXPECT_EQ(furthest({3, 3, 9, 9}), expected) << depth;
        EXPECT_EQ(nearest({3, 3, 9, 9}), expected) << depth;
    }
}

INSTANTIATE_TEST_SUITE_P(Each, RegionSamples,
                         ::testing::Values(GL_DEPTH_COMPONENT16, GL_DEPTH_COMPONENT24, GL_DEPTH24_STENCIL8,
                                           GL_DEPTH_COMPONENT32F, GL_DEPTH32F_STENCIL8));

}  // namespace
}  // namespace conformance
