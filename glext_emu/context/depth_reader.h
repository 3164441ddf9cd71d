// SPDX-License-Identifier: MIT
// The driver's depth buffers, read back: bounds of rectangles, and every sample of a multisampled one.
// Nothing that the program can ask for changes; nothing is counted by its queries.
#pragma once

#include <GL/gl.h>
#include <GL/glext.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "context/depth_bounds.h"
#include "context/framebuffer_info.h"

namespace glext_emu {

struct Context;

// In pixels of a framebuffer.
struct Rect {
    GLint x = 0;
    GLint y = 0;
    GLsizei width = 0;
    GLsizei height = 0;

    bool is_empty() const { return width == 0 || height == 0; }
    std::int64_t area() const { return std::int64_t{width} * height; }
};

// What lies inside a framebuffer of this size of a rectangle of whatever coordinates; width, height >= 0.
Rect clipped(const Rect& rect, GLsizei width, GLsizei height);

struct DepthBound {
    float depth = 0;         // as glReadPixels gives it; see depth_as_float
    bool is_at_end = false;  // it is 0 or 1, whichever end was asked for, in the buffer itself
};

// What the layer keeps between two readings of a context.
struct DepthReader {
    std::vector<std::byte> scratch;
    std::vector<Rect> rects;  // of the features' use, like the next
    std::vector<DepthBound> bounds;
    GLuint sample_program = 0;    // of read_samples; 0: not made yet, or there is none
    bool fetch_is_known = false;  // how a shader's fetch converts 24 bits; see sample_reader.cpp
    bool fetch_multiplies = false;
};

// The depth at <end> of all samples of each rectangle of the draw framebuffer, which is complete and has a
// depth buffer; <info> describes it. The rectangles are clipped; the bounds of empty ones stay. False where
// the driver cannot tell.
bool read_depth_bounds(Context& ctx, const FramebufferInfo& info, DepthEnd end, std::span<const Rect> rects,
                       std::span<DepthBound> bounds);

// All samples of a rectangle of the framebuffer object <fbo>, those of a pixel one after the other, pixels
// row by row from the lower left: its depths, and its colour attachment 0, of format R8. False where the
// driver cannot tell.
bool read_samples(Context& ctx, GLuint fbo, const Rect& rect, std::vector<float>& depths,
                  std::vector<std::uint8_t>& marks);

}  // namespace glext_emu
