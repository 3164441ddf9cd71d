// SPDX-License-Identifier: MIT
// The one context that all scenes of a run share: what the driver compiled for one scene serves the next.
//
// Nothing of a scene may therefore outlive it: `neutral` brings back every state that scenes set.
#pragma once

#include <gtest/gtest.h>

#include <optional>

#include "harness/gl_test.h"

namespace conformance {

// Records that were asked for and what of them the unit could not tell.
struct Determinacy {
    int records = 0;
    int without_projected_hits = 0;
    int without_nearest_depth = 0;
};

class Machine : public ::testing::Environment {
  public:
    void SetUp() override;
    void TearDown() override;

    int most_samples = 0;  // of a multisampled depth texture; 0 where every pixel has one sample
    bool has_indirect_draws = false;
    // Softpipe makes other fragments of one line or point from time to time, by the state of depth and
    // stencil: where drawing the same twice does not do the same, nothing can be compared.
    bool repeats_lines = true;
    // Softpipe writes the colour of a fragment into another layer than its depth, where primitives of several
    // layers meet in one draw.
    bool layers_agree = true;
    bool has_unit = false;
    bool has_regions = false;
    Determinacy determinacy;

  private:
    std::optional<Surface> surface_;
    std::optional<Context> context_;
};

Machine& machine();

// The state of a new context, as far as scenes change it, and of the default framebuffer.
void neutral();

// A command that GL libraries do not export.
template <typename Function>
Function command(const char* name) {
    return reinterpret_cast<Function>(platform().get_proc_address(name));
}

}  // namespace conformance
