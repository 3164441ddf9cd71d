// SPDX-License-Identifier: MIT
// Random scenes: the witness against the driver's own counter and buffers, and the unit against the witness.
#include <cstdio>
#include <vector>

#include "harness/query.h"
#include "witness/fragments.h"
#include "witness/instances.h"
#include "witness/scene_test.h"
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

class Played : public SceneTest {
  protected:
    void SetUp() override { make_scene(0); }

    // What the witness says of the scene's draws.
    Simulation witness() {
        scene().start();
        Simulation simulation(scene().target(), scene().target().read(), scene().far_end());
        for (const Draw& draw : scene().draws()) {
            simulation.draw(fragments_of(scene(), draw), draw.pipeline(), draw.settings());
        }
        return simulation;
    }
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

class UnitScenes : public Played {
  protected:
    void SetUp() override {
        if (!machine().has_unit) GTEST_SKIP() << "needs GL_EMU_occlusion_unit";
        Played::SetUp();
    }

    // The scene's draws under the unit.
    GLocclusionrecordEMU asked() {
        scene().start();
        set_far_end(scene().far_end());
        const UnitQuery query;
        query.begin();
        scene().play_all();
        query.end();
        const GLocclusionrecordEMU record = query.records().front();
        set_far_end(GL_ONE);
        EXPECT_TRUE(no_error());
        return record;
    }

    // Registers that the text allows to be undetermined here, and that are.
    GLbitfield undetermined(const GLocclusionrecordEMU& record) {
        GLbitfield allowed = 0;
        if (scene().may_leave_nearest_depth()) allowed |= GL_NEAREST_DEPTH_BIT_EMU;
        if (scene().may_leave_marks()) allowed |= GL_NEAREST_DEPTH_BIT_EMU | GL_SCREEN_BOX_BIT_EMU;
        if (scene().may_leave_projected_hits()) allowed |= GL_PROJECTED_HITS_BIT_EMU;
        const GLbitfield missing = GL_ALL_REGISTERS_EMU & ~record.registers;
        EXPECT_EQ(missing & ~allowed, 0u) << "undetermined without need";
        Determinacy& seen = machine().determinacy;
        ++seen.records;
        if (missing & GL_NEAREST_DEPTH_BIT_EMU) ++seen.without_nearest_depth;
        if (missing & GL_PROJECTED_HITS_BIT_EMU) ++seen.without_projected_hits;
        return missing;
    }
};

// Every register is what the witness read back, and the unit changed no sample of any buffer.
TEST_P(UnitScenes, registers_are_what_the_witness_read_back) {
    const GLocclusionrecordEMU record = asked();
    const Buffers after = scene().target().read(true);
    scene().start();
    const Query query;  // softpipe's depths of 16 bits are others while nothing counts
    query.count([&] { scene().play_all(); });
    const Buffers without = scene().target().read(true);
    EXPECT_TRUE(same(after.depth, without.depth, scene().target()));
    EXPECT_TRUE(same(after.stencil, without.stencil, scene().target()));
    EXPECT_TRUE(same(after.colour, without.colour, scene().target()));

    const Registers expected = witness().registers();
    const GLbitfield missing = undetermined(record);
    EXPECT_EQ(record.visible, expected.visible_hits != 0 ? 1u : 0u);
    EXPECT_EQ(record.visible_hits, expected.visible_hits);
    if (!(missing & GL_SCREEN_BOX_BIT_EMU)) {
        EXPECT_EQ(box_of(record), expected.box);
    }
    if (!(missing & GL_PROJECTED_HITS_BIT_EMU)) {
        EXPECT_EQ(record.projected_hits, expected.projected_hits);
    }
    if (!(missing & GL_NEAREST_DEPTH_BIT_EMU)) {
        EXPECT_EQ(record.nearest_depth, expected.nearest_depth);
    }
}

PLAY_ON_FOUR_MACHINES(WitnessScenes, kShortScenes, kScenesOfMachine);
PLAY_ON_FOUR_MACHINES(UnitScenes, kShortScenes, kScenesOfMachine);

}  // namespace
}  // namespace conformance
