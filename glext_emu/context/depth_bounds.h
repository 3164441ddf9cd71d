// SPDX-License-Identifier: MIT
// The least or the greatest of many depths, as glReadPixels puts them into memory in their buffer's own
// format, and what it is as a float. Nothing here knows GL.
#pragma once

#include <cstddef>
#include <cstdint>

namespace glext_emu {

enum class DepthFormat {
    kUnorm16,       // 2 bytes: UNSIGNED_SHORT
    kUnorm24,       // 4 bytes, the depth in the upper 24 bits: UNSIGNED_INT_24_8, UNSIGNED_INT
    kUnorm32,       // 4 bytes: UNSIGNED_INT
    kFloat,         // 4 bytes: FLOAT
    kFloatStencil,  // 8 bytes, the depth in the first 4: FLOAT_32_UNSIGNED_INT_24_8_REV
};

enum class DepthEnd { kLeast, kGreatest };

std::size_t bytes_per_pixel(DepthFormat format);

// Rows of pixels, <stride> bytes from one to the next; neither width nor height is 0.
struct DepthImage {
    const std::byte* first = nullptr;
    std::size_t stride = 0;
    std::size_t width = 0;
    std::size_t height = 0;
};

// The depth at the end <end> of those of <image>, as its buffer holds it: the integer, or the bits of the
// float.
std::uint32_t depth_bound(DepthFormat format, DepthEnd end, const DepthImage& image);

// The float that glReadPixels gives for <depth>. One of 32 bits has no exact float: then the next one towards
// <end>, so that no depth of the buffer lies beyond the bound.
float depth_as_float(DepthFormat format, DepthEnd end, std::uint32_t depth);

}  // namespace glext_emu
