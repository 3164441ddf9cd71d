// SPDX-License-Identifier: MIT
// What a depth buffer holds of a depth. A fragment stage sees a float; the buffer's format holds another
// value, and how a driver converts is its own affair: some truncate, some round. So the driver is asked: once
// for each format, with values on both sides of what the format can hold, drawn into such a buffer and read
// back. Where one of the known formulas gives all the answers, it is used from then on; else every value is
// drawn.
#pragma once

#include <GL/gl.h>
#include <GL/glext.h>

#include <compare>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "occlusion_unit/record_arithmetic.h"

namespace glext_emu {

struct Context;

struct DepthPrecision {
    GLint bits = 0;  // 0: no depth buffer
    bool is_float = false;
    auto operator<=>(const DepthPrecision&) const = default;
};

class DepthQuantiser {
  public:
    // Replaces each of <depths>, in [0, 1], by the float that ReadPixels returns once it is written; of a
    // format that is finer than a float, by the next one towards the near end. Waits for the driver the first
    // time, and where no formula is known. False where the driver cannot be asked now, since a query of the
    // program's counts primitives or invocations; then <depths> stay.
    [[nodiscard]] bool quantise(Context& ctx, const DepthPrecision& format, occlusion_unit::FarEnd far_end,
                                std::span<float> depths);
    // Asks the driver at once about a format that is not known, if it can be asked now.
    void prepare(Context& ctx, const DepthPrecision& format);

  private:
    // The integer that a buffer of <bits> holds.
    using Formula = std::uint32_t (*)(float depth, int bits);

    void learn(Context& ctx, const DepthPrecision& format);
    std::vector<std::uint32_t> draw(Context& ctx, const DepthPrecision& format,
                                    std::span<const float> depths);

    std::map<DepthPrecision, Formula> formulas_;  // null: none fits
    GLuint program_ = 0;                          // writes depths that lie in a buffer
    GLuint array_ = 0;
};

}  // namespace glext_emu
