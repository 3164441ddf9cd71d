// SPDX-License-Identifier: MIT
#include "context/sample_reader.h"

#include "context/context.h"

namespace glext_emu {

bool read_multisampled(Context&, const FramebufferInfo&, DepthEnd, std::span<const Rect>,
                       std::span<DepthBound>) {
    return false;
}

}  // namespace glext_emu
