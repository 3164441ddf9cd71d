// SPDX-License-Identifier: MIT
// Framebuffers of every kind that scenes are drawn into, and what each of their samples holds.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "harness/gl.h"

namespace conformance {

struct TargetKind {
    const char* name;
    GLenum depth_format;  // 0: the default framebuffer, 24-bit depth and 8-bit stencil
    bool has_stencil;
    int samples;  // 0: not multisampled
    int layers;   // 0: not layered
};

inline constexpr std::array<TargetKind, 9> kTargetKinds = {{
    {"default framebuffer", 0, true, 0, 0},
    {"DEPTH24_STENCIL8", GL_DEPTH24_STENCIL8, true, 0, 0},
    {"DEPTH32F_STENCIL8", GL_DEPTH32F_STENCIL8, true, 0, 0},
    {"DEPTH24_STENCIL8, 4 samples", GL_DEPTH24_STENCIL8, true, 4, 0},
    {"DEPTH24_STENCIL8, 3 layers", GL_DEPTH24_STENCIL8, true, 0, 3},
    {"DEPTH_COMPONENT16", GL_DEPTH_COMPONENT16, false, 0, 0},
    {"DEPTH_COMPONENT24", GL_DEPTH_COMPONENT24, false, 0, 0},
    {"DEPTH_COMPONENT32F", GL_DEPTH_COMPONENT32F, false, 0, 0},
    {"DEPTH_COMPONENT32F, 4 samples", GL_DEPTH_COMPONENT32F, false, 4, 0},
}};

// What every sample holds, in the order layer, row, column, sample.
struct Buffers {
    std::vector<float> depth;           // as ReadPixels gives it
    std::vector<std::uint8_t> stencil;  // empty where there is none
    std::vector<std::uint32_t> colour;
};

class Target {
  public:
    // A kind that is multisampled is single-sampled on a machine that has no such textures.
    Target(const TargetKind& kind, int width, int height);
    ~Target();
    Target(const Target&) = delete;
    Target& operator=(const Target&) = delete;

    int width() const { return width_; }
    int height() const { return height_; }
    int samples() const { return samples_ == 0 ? 1 : samples_; }  // of a pixel
    int layers() const { return kind_.layers == 0 ? 1 : kind_.layers; }
    bool is_layered() const { return kind_.layers > 0; }
    bool has_stencil() const { return kind_.has_stencil; }
    bool has_float_depth() const {
        return kind_.depth_format == GL_DEPTH_COMPONENT32F || kind_.depth_format == GL_DEPTH32F_STENCIL8;
    }
    std::size_t size() const;                        // samples in all
    std::size_t pixel_of(std::size_t sample) const;  // row * width + column, in whatever layer

    // For drawing and reading; of a layered target all layers, or one.
    void bind() const { glBindFramebuffer(GL_FRAMEBUFFER, whole_); }
    void bind_layer(int layer) const;

    // Leaves the state neutral and the whole target bound.
    Buffers read(bool with_colour) const;
    // Depth and stencil alone.
    Buffers read() const { return read(false); }

  private:
    void attach(GLenum attachment, GLuint texture);
    void read_pixels(Buffers& buffers, int layer, bool with_colour) const;
    void read_samples(Buffers& buffers, bool with_colour) const;

    TargetKind kind_;
    int width_;
    int height_;
    int samples_;
    GLuint whole_ = 0;
    std::vector<GLuint> single_layers_;
    GLuint colour_ = 0;
    GLuint depth_ = 0;
};

}  // namespace conformance
