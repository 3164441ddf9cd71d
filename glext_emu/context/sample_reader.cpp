// SPDX-License-Identifier: MIT
#include "context/sample_reader.h"

#include "context/context.h"

namespace glext_emu {

bool read_multisampled(Context&, const FramebufferInfo&, DepthEnd, const Rect&, std::span<const Rect>,
                       std::span<DepthBound>) {
    return false;
}

bool read_samples(Context&, GLuint, const Rect&, std::vector<float>&, std::vector<std::uint8_t>&) {
    return false;
}

}  // namespace glext_emu
