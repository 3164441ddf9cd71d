// SPDX-License-Identifier: MIT
// What the tests over random scenes share: a scene whose seed follows from the test's number, and the state
// afterwards.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <optional>

#include "harness/gl_test.h"
#include "witness/machine.h"
#include "witness/scene.h"
#include "witness/unit.h"

namespace conformance {

class SceneTest : public ::testing::TestWithParam<int> {
  protected:
    // Seeds of different tests start at different numbers.
    void make_scene(std::uint64_t first_seed) {
        scene_.emplace(first_seed + static_cast<std::uint64_t>(GetParam()));
    }
    void TearDown() override {
        if (!scene_) return;
        if (machine().has_unit || machine().has_regions) set_far_end(GL_ONE);
        neutral();
        EXPECT_TRUE(no_error()) << "an error is left behind";
        if (HasFailure()) tell_recipe(*scene_);
        scene_.reset();
    }

    Scene& scene() { return *scene_; }

  private:
    std::optional<Scene> scene_;
};

}  // namespace conformance
