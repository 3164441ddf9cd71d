// SPDX-License-Identifier: MIT
// How a draw of the program's is made once more without the program noticing.
#pragma once

#include <GL/gl.h>
#include <GL/glext.h>

#include <optional>

#include "context/context.h"

namespace glext_emu {

// True while a query of the program's counts primitives or invocations rather than samples or time: it sees
// every draw.
bool counts_draws(Context& ctx);
// False where a repeated draw would leave traces that cannot be hidden: its shaders write memory, or a query
// of the program's counts primitives or invocations.
bool can_repeat(Context& ctx, DrawKind kind = DrawKind::kPrimitives);

// Inside this scope the program's draw may be repeated: its errors, its debug messages, its transform
// feedback and its occlusion query do not see it.
class Repetition {
  public:
    Repetition(Context& ctx, DrawKind kind);
    ~Repetition();
    Repetition(const Repetition&) = delete;
    Repetition& operator=(const Repetition&) = delete;

  private:
    Context& ctx_;
    OwnCalls own_;
    std::optional<CountPause> pause_;
    bool has_pushed_ = false;
    bool feedback_was_active_ = false;
    bool debug_output_was_on_ = false;
};

}  // namespace glext_emu
