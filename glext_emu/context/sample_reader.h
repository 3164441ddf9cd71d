// SPDX-License-Identifier: MIT
// Multisampled depth buffers, sample by sample. glReadPixels does not read them, so a compute shader does,
// from a copy.
#pragma once

#include <span>

#include "context/depth_reader.h"

namespace glext_emu {

// read_depth_bounds of a multisampled framebuffer.
bool read_multisampled(Context& ctx, const FramebufferInfo& info, DepthEnd end, const Rect& all,
                       std::span<const Rect> rects, std::span<DepthBound> bounds);

}  // namespace glext_emu
