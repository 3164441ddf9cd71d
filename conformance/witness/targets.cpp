// SPDX-License-Identifier: MIT
// Textures as attachments, and two ways to read them: ReadPixels, or a shader that fetches every sample of a
// pixel.
#include "witness/targets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "witness/machine.h"
#include "witness/stages.h"

namespace conformance {

namespace {

// Draws every sample of the multisampled <texture> into a texture of floats, four a sample, and reads those.
std::vector<float> fetch(GLuint texture, GLenum mode, int width, int height, int samples) {
    const int columns = width * samples;
    GLuint floats = 0;
    glGenTextures(1, &floats);
    glBindTexture(GL_TEXTURE_2D, floats);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, columns, height, 0, GL_RGBA, GL_FLOAT, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    GLuint framebuffer = 0;
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, floats, 0);
    EXPECT_EQ(glCheckFramebufferStatus(GL_FRAMEBUFFER), static_cast<GLenum>(GL_FRAMEBUFFER_COMPLETE));
    glBindTexture(GL_TEXTURE_2D_MULTISAMPLE, texture);
    if (mode != GL_NONE)
        glTexParameteri(GL_TEXTURE_2D_MULTISAMPLE, GL_DEPTH_STENCIL_TEXTURE_MODE, static_cast<GLint>(mode));
    glViewport(0, 0, columns, height);
    use(mode == GL_STENCIL_INDEX ? Stages::kFetchStencil : Stages::kFetch);
    glRectf(-1.0f, -1.0f, 1.0f, 1.0f);
    use(Stages::kFixed);
    std::vector<float> values(static_cast<std::size_t>(columns) * static_cast<std::size_t>(height) * 4);
    glReadPixels(0, 0, columns, height, GL_RGBA, GL_FLOAT, values.data());
    glBindTexture(GL_TEXTURE_2D_MULTISAMPLE, 0);
    glBindTexture(GL_TEXTURE_2D, 0);
    glDeleteFramebuffers(1, &framebuffer);
    glDeleteTextures(1, &floats);
    return values;
}

constexpr double kMost24 = 0xFFFFFF;

// What ReadPixels gives for the integer of 24 bits that texelFetch gave as <fetched>: llvmpipe fetches by a
// product with a rounded reciprocal, off by up to a step, where ReadPixels divides. The last two steps come
// out as one.
float as_read(float fetched) {
    const double about = std::round(static_cast<double>(fetched) * kMost24);
    double integer = std::min(about + 2, kMost24);
    while (integer > about - 2 && static_cast<float>(integer) * static_cast<float>(1.0 / kMost24) != fetched)
        --integer;
    return static_cast<float>(integer / kMost24);
}

bool is_packed(GLenum format) {
    return format == GL_DEPTH24_STENCIL8 || format == GL_DEPTH32F_STENCIL8;
}

}  // namespace

Target::Target(const TargetKind& kind, int width, int height)
    : kind_(kind),
      width_(width),
      height_(height),
      samples_(machine().most_samples >= kind.samples ? kind.samples : 0) {
    if (kind.depth_format == 0) return;
    glGenFramebuffers(1, &whole_);
    bind();
    glGenTextures(1, &colour_);
    glGenTextures(1, &depth_);
    attach(GL_COLOR_ATTACHMENT0, colour_);
    attach(is_packed(kind.depth_format) ? GL_DEPTH_STENCIL_ATTACHMENT : GL_DEPTH_ATTACHMENT, depth_);
    EXPECT_EQ(glCheckFramebufferStatus(GL_FRAMEBUFFER), static_cast<GLenum>(GL_FRAMEBUFFER_COMPLETE))
        << kind.name;
    single_layers_.resize(static_cast<std::size_t>(kind.layers));
    for (int layer = 0; layer < kind.layers; ++layer) {
        glGenFramebuffers(1, &single_layers_[static_cast<std::size_t>(layer)]);
        bind_layer(layer);
        glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, colour_, 0, layer);
        glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, depth_, 0, layer);
    }
    bind();
}

Target::~Target() {
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glDeleteFramebuffers(1, &whole_);
    glDeleteFramebuffers(static_cast<GLsizei>(single_layers_.size()), single_layers_.data());
    glDeleteTextures(1, &colour_);
    glDeleteTextures(1, &depth_);
}

void Target::attach(GLenum attachment, GLuint texture) {
    const bool is_colour = attachment == GL_COLOR_ATTACHMENT0;
    const GLenum format = is_colour ? GL_RGBA8 : kind_.depth_format;
    if (samples_ > 0) {
        glBindTexture(GL_TEXTURE_2D_MULTISAMPLE, texture);
        glTexImage2DMultisample(GL_TEXTURE_2D_MULTISAMPLE, samples_, format, width_, height_, GL_TRUE);
        glFramebufferTexture2D(GL_FRAMEBUFFER, attachment, GL_TEXTURE_2D_MULTISAMPLE, texture, 0);
        glBindTexture(GL_TEXTURE_2D_MULTISAMPLE, 0);
        return;
    }
    // Format and type of no pixels at all.
    GLenum pixels = is_colour ? GL_RGBA : GL_DEPTH_COMPONENT;
    GLenum type = is_colour ? GL_UNSIGNED_BYTE : GL_FLOAT;
    if (format == GL_DEPTH24_STENCIL8) type = GL_UNSIGNED_INT_24_8;
    if (format == GL_DEPTH32F_STENCIL8) type = GL_FLOAT_32_UNSIGNED_INT_24_8_REV;
    if (!is_colour && is_packed(format)) pixels = GL_DEPTH_STENCIL;
    if (is_layered()) {
        glBindTexture(GL_TEXTURE_2D_ARRAY, texture);
        glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, static_cast<GLint>(format), width_, height_, layers(), 0, pixels,
                     type, nullptr);
        glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glFramebufferTexture(GL_FRAMEBUFFER, attachment, texture, 0);
        glBindTexture(GL_TEXTURE_2D_ARRAY, 0);
        return;
    }
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(format), width_, height_, 0, pixels, type, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glFramebufferTexture2D(GL_FRAMEBUFFER, attachment, GL_TEXTURE_2D, texture, 0);
    glBindTexture(GL_TEXTURE_2D, 0);
}

std::size_t Target::size() const {
    return static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_) *
           static_cast<std::size_t>(samples()) * static_cast<std::size_t>(layers());
}

std::size_t Target::pixel_of(std::size_t sample) const {
    const std::size_t pixels = static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
    return sample / static_cast<std::size_t>(samples()) % pixels;
}

void Target::bind_layer(int layer) const {
    glBindFramebuffer(GL_FRAMEBUFFER,
                      is_layered() ? single_layers_[static_cast<std::size_t>(layer)] : whole_);
}

Buffers Target::read(bool with_colour) const {
    neutral();
    Buffers buffers;
    if (samples_ > 0) {
        read_samples(buffers, with_colour);
    } else {
        for (int layer = 0; layer < layers(); ++layer) read_pixels(buffers, layer, with_colour);
    }
    bind();
    return buffers;
}

void Target::read_pixels(Buffers& buffers, int layer, bool with_colour) const {
    const std::size_t pixels = size() / static_cast<std::size_t>(layers());
    const std::size_t first = pixels * static_cast<std::size_t>(layer);
    bind_layer(layer);
    buffers.depth.resize(first + pixels);
    glReadPixels(0, 0, width_, height_, GL_DEPTH_COMPONENT, GL_FLOAT, &buffers.depth[first]);
    if (has_stencil()) {
        buffers.stencil.resize(first + pixels);
        glReadPixels(0, 0, width_, height_, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, &buffers.stencil[first]);
    }
    if (with_colour) {
        buffers.colour.resize(first + pixels);
        glReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, &buffers.colour[first]);
    }
}

void Target::read_samples(Buffers& buffers, bool with_colour) const {
    const std::size_t samples = size();
    const auto all_of = [&](GLuint texture, GLenum mode) {
        return fetch(texture, mode, width_, height_, samples_);
    };
    const std::vector<float> depths =
        all_of(depth_, is_packed(kind_.depth_format) ? GL_DEPTH_COMPONENT : GL_NONE);
    for (std::size_t i = 0; i < samples; ++i) {
        const float fetched = depths[4 * i];
        buffers.depth.push_back(has_float_depth() ? fetched : as_read(fetched));
    }
    if (has_stencil()) {
        const std::vector<float> stencils = all_of(depth_, GL_STENCIL_INDEX);
        for (std::size_t i = 0; i < samples; ++i)
            buffers.stencil.push_back(static_cast<std::uint8_t>(stencils[4 * i]));
    }
    if (with_colour) {
        const std::vector<float> colours = all_of(colour_, GL_NONE);
        for (std::size_t i = 0; i < samples; ++i) {
            std::uint32_t colour = 0;
            for (std::size_t part = 0; part < 4; ++part) {
                colour = colour << 8 | static_cast<std::uint32_t>(colours[4 * i + part] * 255.0f + 0.5f);
            }
            buffers.colour.push_back(colour);
        }
    }
}

}  // namespace conformance
