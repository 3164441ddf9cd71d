// SPDX-License-Identifier: MIT
// Framebuffers: formats of depth, none, samples, layers, and a change of framebuffer within a query.
#include <algorithm>

#include "emu_occlusion_unit/unit_test.h"

namespace conformance {
namespace {

class UnitFramebuffers : public UnitTest {};

// A framebuffer object with depth of one format, or none; bound while it lives.
class DepthFramebuffer {
  public:
    explicit DepthFramebuffer(GLenum format, int samples = 0) {
        glGenFramebuffers(1, &name_);
        bind();
        glGenRenderbuffers(2, buffers_.data());
        attach(0, GL_RGBA8, GL_COLOR_ATTACHMENT0, samples);
        if (format != GL_NONE) attach(1, format, GL_DEPTH_ATTACHMENT, samples);
        EXPECT_EQ(glCheckFramebufferStatus(GL_FRAMEBUFFER), static_cast<GLenum>(GL_FRAMEBUFFER_COMPLETE));
    }
    ~DepthFramebuffer() {
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        glDeleteFramebuffers(1, &name_);
        glDeleteRenderbuffers(2, buffers_.data());
    }
    DepthFramebuffer(const DepthFramebuffer&) = delete;
    DepthFramebuffer& operator=(const DepthFramebuffer&) = delete;

    void bind() const { glBindFramebuffer(GL_FRAMEBUFFER, name_); }

  private:
    void attach(std::size_t index, GLenum format, GLenum point, int samples) {
        glBindRenderbuffer(GL_RENDERBUFFER, buffers_[index]);
        glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, kSize, kSize);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, point, GL_RENDERBUFFER, buffers_[index]);
    }

    GLuint name_ = 0;
    std::array<GLuint, 2> buffers_{};
};

void draw_slope() {
    glBegin(GL_QUADS);
    for (const auto& [x, y] : {std::pair{8, 8}, {56, 8}, {56, 24}, {8, 24}}) {
        glVertex3f(static_cast<GLfloat>(x), static_cast<GLfloat>(y),
                   0.51f + 0.0037f * static_cast<GLfloat>(x + y));
    }
    glEnd();
}

// 17.3.5.1: "in the buffer's format": the smallest depth that is in the buffer after the drawing, bit by bit.
TEST_F(UnitFramebuffers, the_nearest_depth_is_of_the_format_of_the_buffer) {
    for (const GLenum format : {GL_DEPTH_COMPONENT16, GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT32F}) {
        SCOPED_TRACE(format);
        const DepthFramebuffer framebuffer(format);
        draw_left_occluder();
        const Record record = ask(kAllRegisters, draw_slope);
        const auto depths = read_depths({kHalf, 8, 24, 16});
        EXPECT_EQ(record.nearest_depth, *std::ranges::min_element(depths));
        Seen expected = kHalfHidden;
        expected.nearest = record.nearest_depth;
        expect_record(record, kAllRegisters, expected);
    }
}

// 32F: a depth that a float holds is that float.
TEST_F(UnitFramebuffers, a_float_buffer_holds_the_depth_itself) {
    const DepthFramebuffer framebuffer(GL_DEPTH_COMPONENT32F);
    draw_left_occluder();
    Seen expected = kHalfHidden;
    expected.depth_step = 0.0f;
    expect_seen(expected, draw_half_hidden);
}

// 17.3.5.1: "rounded towards the near value": a 32-bit integer depth is finer than a float.
TEST_F(UnitFramebuffers, a_finer_format_is_rounded_towards_near) {
    const DepthFramebuffer framebuffer(GL_DEPTH_COMPONENT32);
    draw_left_occluder();
    const Record record = ask(kAllRegisters, draw_slope);
    std::vector<GLuint> depths(24 * 16);
    glReadPixels(kHalf, 8, 24, 16, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, depths.data());
    const double nearest = *std::ranges::min_element(depths) / 4294967295.0;
    EXPECT_LE(record.nearest_depth, nearest);
    EXPECT_GT(record.nearest_depth, nearest - 1.0 / 16777216.0);
}

// 17.3.5.1: "or the draw framebuffer has no depth buffer ... no sample changes NEAREST_DEPTH".
TEST_F(UnitFramebuffers, without_a_depth_buffer_all_is_visible_and_no_depth_told) {
    const DepthFramebuffer framebuffer(GL_NONE);
    glEnable(GL_DEPTH_TEST);
    glClear(GL_COLOR_BUFFER_BIT);
    Seen expected = seen(768, kHalfHiddenRect, 1.0f);
    expected.depth_step = 0.0f;
    expect_seen(expected, draw_half_hidden);
    // The same of what writes nothing, as bounding volumes do; whatever the function, no depth fails.
    glDepthMask(GL_FALSE);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    for (const GLenum function : {GL_LESS, GL_GREATER, GL_EQUAL, GL_NEVER}) {
        glDepthFunc(function);
        expect_seen(expected, draw_half_hidden);
    }
}

// 17.3.5.1: "If the draw framebuffer changes within a query, the registers go on over all of its
// framebuffers."
TEST_F(UnitFramebuffers, a_query_goes_on_over_several_framebuffers) {
    draw_left_occluder();
    const DepthFramebuffer first(GL_DEPTH_COMPONENT24);
    draw_left_occluder();
    const DepthFramebuffer second(GL_DEPTH_COMPONENT16);
    draw_left_occluder();
    expect_seen({.projected = 768 + 768 + 16,
                 .visible = 384 + 384 + 16,
                 .nearest = 0.625f,
                 .box = {kHalf, 8, 63, 63}},
                [&] {
                    first.bind();
                    draw_half_hidden();
                    glBindFramebuffer(GL_FRAMEBUFFER, 0);
                    draw_rect(kHalfHiddenRect, 0.625f);
                    second.bind();
                    draw_rect({60, 60, 4, 4}, 0.875f);
                });
}

constexpr int kSamples = 4;

// 17.3.5.1: the unit is stepped by samples; the box is of pixels.
TEST_F(UnitFramebuffers, of_a_multisampled_framebuffer_samples_count) {
    const Framebuffer framebuffer({.samples = kSamples});
    ASSERT_EQ(get_integer(GL_SAMPLES), kSamples);
    draw_left_occluder();
    Seen expected = kHalfHidden;
    expected.projected *= kSamples;
    expected.visible *= kSamples;
    expect_seen(expected, draw_half_hidden);
    draw_occluder();
    expect_seen(hidden(kSamples * kAll), [] { draw_rect(kWhole, kFar); });
}

// "multisample fragment operations" come before: a mask leaves one sample of each pixel.
TEST_F(UnitFramebuffers, a_sample_mask_takes_its_samples) {
    if (const auto why = lacks(32)) GTEST_SKIP() << *why;
    const Framebuffer framebuffer({.samples = kSamples});
    draw_left_occluder();
    glEnable(GL_SAMPLE_MASK);
    glSampleMaski(0, 0x4);
    expect_seen(kHalfHidden, draw_half_hidden);
    glDisable(GL_SAMPLE_MASK);
}

// One sample of one pixel: it is in the box.
TEST_F(UnitFramebuffers, a_pixel_with_one_visible_sample_is_in_the_box) {
    if (const auto why = lacks(32)) GTEST_SKIP() << *why;
    const Framebuffer framebuffer({.samples = kSamples});
    draw_left_occluder();
    std::array<GLfloat, 2> position{};
    glGetMultisamplefv(GL_SAMPLE_POSITION, 0, position.data());
    const GLfloat x = 40.0f + position[0];
    const GLfloat y = 30.0f + position[1];
    constexpr GLfloat kReach = 0.05f;
    expect_seen({.projected = 1, .visible = 1, .nearest = kFar, .box = {40, 30, 40, 30}}, [=] {
        glBegin(GL_TRIANGLES);
        glVertex3f(x - kReach, y - kReach, kFar);
        glVertex3f(x + kReach, y - kReach, kFar);
        glVertex3f(x, y + kReach, kFar);
        glEnd();
    });
}

// NEAREST_DEPTH is of samples: on a slope, of the sample that lies nearest, not of the pixel's centre.
TEST_F(UnitFramebuffers, each_sample_has_its_own_depth) {
    if (const auto why = lacks(32)) GTEST_SKIP() << *why;
    const Framebuffer framebuffer({.samples = kSamples});
    clear();
    glEnable(GL_DEPTH_TEST);
    GLfloat leftmost = 1.0f;
    for (GLuint sample = 0; sample < kSamples; ++sample) {
        std::array<GLfloat, 2> position{};
        glGetMultisamplefv(GL_SAMPLE_POSITION, sample, position.data());
        leftmost = std::min(leftmost, position[0]);
    }
    ASSERT_LT(leftmost, 0.5f);
    // Depth x / 64 at window coordinate x.
    const Record record = ask(kAllRegisters, [] {
        glBegin(GL_QUADS);
        glVertex3f(0.0f, 8.0f, 0.0f);
        glVertex3f(64.0f, 8.0f, 1.0f);
        glVertex3f(64.0f, 24.0f, 1.0f);
        glVertex3f(0.0f, 24.0f, 0.0f);
        glEnd();
    });
    EXPECT_EQ(record.visible_hits, static_cast<GLuint64>(kSamples) * kSize * 16);
    EXPECT_NEAR(record.nearest_depth, leftmost / 64.0f, 2 * kDepthStep24);
}

// 17.3.5.1: "Samples of one pixel, and pixels of all layers, have the same coordinates."
TEST_F(UnitFramebuffers, all_layers_step_the_unit) {
    if (const auto why = lacks(32)) GTEST_SKIP() << *why;
    constexpr int kLayers = 3;
    GLuint texture = 0;
    GLuint framebuffer = 0;
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D_ARRAY, texture);
    glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_DEPTH_COMPONENT24, kSize, kSize, kLayers, 0, GL_DEPTH_COMPONENT,
                 GL_FLOAT, nullptr);
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glDrawBuffer(GL_NONE);
    glReadBuffer(GL_NONE);
    for (int layer = 0; layer < kLayers; ++layer) {  // nothing, the left half, everything is occluded
        glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, texture, 0, layer);
        draw_left_occluder();
        if (layer == 0) clear();
        if (layer == 2) draw_rect(kRight, kMiddle);
    }
    glFramebufferTexture(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, texture, 0);
    ASSERT_EQ(glCheckFramebufferStatus(GL_FRAMEBUFFER), static_cast<GLenum>(GL_FRAMEBUFFER_COMPLETE));
    const Program program({.vertex = kFixedVertexSource,
                           .geometry = "#version 150 compatibility\n"
                                       "layout(triangles) in;\n"
                                       "layout(triangle_strip, max_vertices = 9) out;\n"
                                       "void main() {\n"
                                       "    for (int layer = 0; layer < 3; ++layer) {\n"
                                       "        for (int v = 0; v < 3; ++v) {\n"
                                       "            gl_Layer = layer;\n"
                                       "            gl_Position = gl_in[v].gl_Position;\n"
                                       "            gl_FrontColor = gl_in[v].gl_FrontColor;\n"
                                       "            EmitVertex();\n"
                                       "        }\n"
                                       "        EndPrimitive();\n"
                                       "    }\n"
                                       "}\n"});
    expect_seen({.projected = 3 * 768, .visible = 768 + 384, .nearest = kFar, .box = {8, 8, 55, 23}},
                draw_half_hidden_strip);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glDeleteFramebuffers(1, &framebuffer);
    glDeleteTextures(1, &texture);
}

}  // namespace
}  // namespace conformance
