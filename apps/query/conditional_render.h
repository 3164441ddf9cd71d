// SPDX-License-Identifier: MIT
// Draws that the GPU leaves out where a query counted nothing, without the CPU's ever knowing:
// GL_NV_conditional_render, GL 3.0 which made it core, or its forerunner GL_NVX_conditional_render, which
// always waits.
#pragma once

#include <memory>

#include "apps/culling/canvas.h"
#include "apps/platform/platform.h"

namespace apps {

class ConditionalRender {
  public:
    virtual ~ConditionalRender() = default;

    virtual std::string_view extension() const = 0;
    virtual void begin(std::uint32_t query, Condition condition) = 0;
    virtual void end() = 0;
};

/// Null where the machine has none of them. A context is current.
std::unique_ptr<ConditionalRender> choose_conditional_render(Platform& platform);

}  // namespace apps
