// SPDX-License-Identifier: MIT
// How a draw of the program's is made once more without the program noticing.
#pragma once

#include <GL/gl.h>
#include <GL/glext.h>

#include <optional>
#include <vector>

#include "context/context.h"

namespace glext_emu {

// False where a repeated draw would leave traces that cannot be hidden: its shaders write memory, or a query
// of the program's counts primitives or invocations.
bool can_repeat(Context& ctx);

// Inside this scope the program's draw may be repeated: its errors, its debug messages, its transform
// feedback and its occlusion query do not see it.
class Repetition {
  public:
    explicit Repetition(Context& ctx);
    ~Repetition();
    Repetition(const Repetition&) = delete;
    Repetition& operator=(const Repetition&) = delete;

  private:
    Context& ctx_;
    OwnCalls own_;
    std::optional<CountPause> pause_;
    bool feedback_was_active_ = false;
    bool debug_output_was_on_ = false;
};

// Inside this scope a draw writes no colour and no stencil; depth is its user's affair.
class WritesOff {
  public:
    explicit WritesOff(Context& ctx);
    ~WritesOff();
    WritesOff(const WritesOff&) = delete;
    WritesOff& operator=(const WritesOff&) = delete;

  private:
    struct ColorMask {
        GLboolean channels[4];
    };
    Context& ctx_;
    std::vector<ColorMask> color_masks_;  // of each draw buffer; empty where all were off
    bool stencil_was_on_ = false;
    GLint front_mask_ = 0;
    GLint back_mask_ = 0;
};

}  // namespace glext_emu
