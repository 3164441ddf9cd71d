// SPDX-License-Identifier: MIT
// The fixture of tests in OpenGL ES: what GlTest is, with a shader where that uses fixed function.
//
// The parameter is the major version, 2 or 3; a driver may answer with a later one. Desktop GL's own commands
// (glBegin, glClearDepth) must not be used: `draw_rect` and `clear` of the fixture are those of ES.
#pragma once

#include <optional>

#include "harness/gl_test.h"
#include "harness/objects.h"

namespace conformance {

class EsTest : public GlTest, public ::testing::WithParamInterface<int> {
  protected:
    void TearDown() override;
    ContextWish wish() const override { return {.api = Api::kEs2, .major = GetParam()}; }
    void prepare() override;

    // White, in pixels and window depths as the functions of the same names in draw.h.
    static void draw_rect(const Rect& rect, float depth);
    static void clear(float depth = 1.0f);
    static void draw_occluder();

  private:
    std::optional<Program> program_;
};

}  // namespace conformance
