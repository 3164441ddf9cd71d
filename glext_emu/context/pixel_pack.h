// SPDX-License-Identifier: MIT
// The state that glReadPixels obeys, as a reading of the layer's own needs it, and then the program's again.
// Each question is 10 ns and a reading of 32x32 depths 1,000, so only what differs is set.
#pragma once

#include <GL/gl.h>

#include <array>
#include <cstddef>

namespace glext_emu {

struct Context;

class PixelPack {
  public:
    // Reads from <framebuffer> into client memory, rows one after the other from the lowest, without depth
    // scale and bias. <obeys_order>: it matters in which order the rows come.
    PixelPack(Context& ctx, GLuint framebuffer, bool obeys_order);
    ~PixelPack();
    PixelPack(const PixelPack&) = delete;
    PixelPack& operator=(const PixelPack&) = delete;

    // Bytes from one row to the next, of rows of <row_size> bytes.
    std::size_t stride(std::size_t row_size) const {
        return (row_size + alignment_ - 1) / alignment_ * alignment_;
    }

  private:
    struct Store {
        GLenum name;
        GLint value = 0;
    };

    Context& ctx_;
    GLuint framebuffer_;
    GLuint read_framebuffer_ = 0;  // the program's
    GLint pack_buffer_ = 0;
    std::size_t alignment_ = 1;
    std::array<Store, 5> stores_;
    GLfloat depth_scale_ = 1;
    GLfloat depth_bias_ = 0;
};

}  // namespace glext_emu
