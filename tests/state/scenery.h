// SPDX-License-Identifier: MIT
// A context in an unusual state, so that a layer which sets state of its own and puts the default back is
// seen.
#pragma once

namespace tests {

// Sets as much state as the context's version has to something that is not its default. Drawing still reaches
// pixels.
void disarrange();

}  // namespace tests
