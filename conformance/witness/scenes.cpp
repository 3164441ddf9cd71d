// SPDX-License-Identifier: MIT
// Random scenes: the witness against the driver's own counter and buffers, and the unit against the witness.
#include <gtest/gtest.h>

#include <cstdio>
#include <optional>
#include <vector>

#include "harness/gl_test.h"
#include "harness/query.h"
#include "witness/fragments.h"
#include "witness/instances.h"
#include "witness/machine.h"
#include "witness/scene.h"
#include "witness/simulation.h"

namespace conformance {
namespace {

// Where two buffers differ first, or that they do not.
template <typename Value>
::testing::AssertionResult same(const std::vector<Value>& got, const std::vector<Value>& expected,
                                const Target& target) {
    std::size_t differences = 0;
    std::size_t first = 0;
    for (std::size_t i = expected.size(); i-- > 0;) {
        if (got[i] == expected[i]) continue;
        ++differences;
        first = i;
    }
    if (differences == 0) return ::testing::AssertionSuccess();
    const std::size_t pixel = target.pixel_of(first);
    const auto width = static_cast<std::size_t>(target.width());
    return ::testing::AssertionFailure()
           << differences << " samples differ, the first of pixel (" << pixel % width << ", " << pixel / width
           << "): " << +got[first] << " instead of " << +expected[first];
}

class Played : public ::testing::TestWithParam<int> {
  protected:
    void SetUp() override { scene_.emplace(static_cast<std::uint64_t>(GetParam())); }
    void TearDown() override {
        EXPECT_TRUE(no_error()) << "the scene left an error behind";
        if (HasFailure()) std::printf("scene %d: %s\n", GetParam(), scene_->description().c_str());
        neutral();
        scene_.reset();
    }

    // What the witness says of the scene's draws.
    Simulation witness() {
        scene_->start();
        Simulation simulation(scene_->target(), scene_->target().read(), scene_->far_end());
        for (const Draw& draw : scene_->draws()) {
            simulation.draw(fragments_of(*scene_, draw), draw.pipeline(), draw.settings());
        }
        return simulation;
    }

    Scene& scene() { return *scene_; }

  private:
    std::optional<Scene> scene_;
};

class WitnessScenes : public Played {};

// The witness takes the draws apart and puts them together again: what comes out has to be what the driver
// made of them in one piece, its count of samples and each sample's depth and stencil.
TEST_P(WitnessScenes, agree_with_the_samples_that_passed_and_the_buffers) {
    scene().start();
    const Query query;
    const GLuint passed = query.count([&] { scene().play_all(); });
    const Buffers driver = scene().target().read();
    const Simulation simulation = witness();
    EXPECT_EQ(simulation.registers().visible_hits, passed);
    EXPECT_TRUE(same(simulation.buffers().depth, driver.depth, scene().target()));
    EXPECT_TRUE(same(simulation.buffers().stencil, driver.stencil, scene().target()));
}

PLAY_ON_FOUR_MACHINES(WitnessScenes, kShortScenes, kScenesOfMachine);

}  // namespace
}  // namespace conformance
