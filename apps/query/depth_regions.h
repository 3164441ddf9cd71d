// SPDX-License-Identifier: MIT
// Questions about rectangles of the depth buffer: by GL_EMU_depth_region_query, or, on a machine without it,
// by reading them back (glReadPixels) and looking. Far is 1.
#pragma once

#include <memory>
#include <vector>

#include "apps/culling/canvas.h"
#include "apps/platform/platform.h"

namespace apps {

class DepthRegions {
  public:
    virtual ~DepthRegions() = default;

    /// "GL_EMU_depth_region_query" or "glReadPixels".
    virtual std::string_view extension() const = 0;

    virtual std::vector<std::uint8_t> are_occluded(std::span<const Rectangle> regions) = 0;
    virtual std::vector<float> furthest_depths(std::span<const Rectangle> regions) = 0;

    /// Times that the CPU waited for the GPU, in one call of the above with so many regions.
    virtual std::uint64_t waits_for(std::size_t regions) const = 0;
};

/// `wanted`: one of the names above, or empty for the first that the machine has; null if it has not the
/// wanted one. A context is current.
std::unique_ptr<DepthRegions> choose_depth_regions(Platform& platform, std::string_view wanted = {});

}  // namespace apps
