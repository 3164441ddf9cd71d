// SPDX-License-Identifier: MIT
// Inside this scope the driver rasterises nothing; what it counts of primitives it counts on.
#pragma once

#include <GL/gl.h>
#include <GL/glext.h>

namespace glext_emu {

struct Context;

class DiscardScope {
  public:
    explicit DiscardScope(Context& ctx);
    ~DiscardScope();
    DiscardScope(const DiscardScope&) = delete;
    DiscardScope& operator=(const DiscardScope&) = delete;

  private:
    Context& ctx_;
    bool was_on_;
};

}  // namespace glext_emu
