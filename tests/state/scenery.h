// SPDX-License-Identifier: MIT
// A context in an unusual state, so that a layer which sets state of its own and puts the default back is
// seen.
#pragma once

namespace tests {

// Sets as much state as the context's version has to something that is not its default. Drawing still reaches
// pixels.
void disarrange();

// What a rectangle over the whole window draws then: the viewport is 1 to 61 by 2 to 61, the scissor box 1 to
// 51 by 1 to 50.
inline constexpr unsigned kPixelsOfWhole = 50 * 48;

}  // namespace tests
