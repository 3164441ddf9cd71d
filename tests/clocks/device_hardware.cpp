// SPDX-License-Identifier: MIT
// Device time of the queries that the driver does not have: HP's test, NV's counter, the Occlusion Unit and
// depth regions. And that a context is a machine of its own.
#include <array>

#include "device_test.h"
#include "old_commands.h"

namespace clock_tests {
namespace {

using conformance::lacks;
using conformance::Query;

class DeviceHardware : public DeviceTest {};

constexpr GLint64 kAsked = kQuery + kGpuQuery + kLatency;

TEST_F(DeviceHardware, reading_the_flag_of_hp_waits_for_its_result) {
    if (const auto why = lacks("GL_HP_occlusion_test")) GTEST_SKIP() << *why;
    GLboolean flag = 0xAA;
    EXPECT_EQ(on_cpu([] {
                  glEnable(kOcclusionTest);
                  glDisable(kOcclusionTest);
              }),
              0);
    GLint64 before = rest();
    glEnable(kOcclusionTest);
    draw(1);
    EXPECT_LE(cpu(), before + kQuery);
    glGetBooleanv(kOcclusionTestResult, &flag);
    EXPECT_EQ(cpu(), before + kAsked);
    EXPECT_EQ(flag, GL_FALSE);
    before = rest();
    fill();
    glGetBooleanv(kOcclusionTestResult, &flag);
    EXPECT_EQ(cpu(), before + kAsked + kFilled * kFragment);
    EXPECT_EQ(flag, GL_TRUE);
    before = rest();
    draw(100);
    glGetBooleanv(kOcclusionTestResult, &flag);
    EXPECT_EQ(cpu(), before + kBatch + kGpuBatch + 100 * kTriangle + kGpuQuery + kLatency);
    EXPECT_EQ(flag, GL_FALSE);
    glDisable(kOcclusionTest);
}

TEST_F(DeviceHardware, a_query_of_nv_takes_what_one_of_arb_does) {
    if (const auto why = lacks("GL_NV_occlusion_query")) GTEST_SKIP() << *why;
    const NvCommands nv;
    GLuint name = 0;
    GLuint value = conformance::kUntouched;
    nv.generate(1, &name);
    const GLint64 before = rest();
    nv.begin(name);
    draw(1);
    nv.end();
    EXPECT_EQ(cpu(), before + kQuery);
    GLint64 polls = 0;
    do {
        nv.get_unsigned(name, GL_PIXEL_COUNT_AVAILABLE_NV, &value);
        ++polls;
    } while (value != GL_TRUE && polls < 1'000'000);
    EXPECT_EQ(polls, (kGpuQuery + kLatency) / kPoll);
    EXPECT_EQ(cpu(), before + kAsked);
    nv.get_unsigned(name, GL_PIXEL_COUNT_NV, &value);
    EXPECT_EQ(value, 0u);
    EXPECT_EQ(cpu(), before + kAsked);
    nv.remove(1, &name);
}

class DeviceUnit : public DeviceTest {
  protected:
    void SetUp() override {
        ASSERT_NO_FATAL_FAILURE(DeviceTest::SetUp());
        if (IsSkipped()) return;
        if (const auto why = lacks("GL_EMU_occlusion_unit")) GTEST_SKIP() << *why;
        begin_ = command<PFNGLBEGINOCCLUSIONUNITEMUPROC>("glBeginOcclusionUnitEMU");
        end_ = command<PFNGLENDOCCLUSIONUNITEMUPROC>("glEndOcclusionUnitEMU");
        shapes_ = command<PFNGLOCCLUSIONUNITSHAPESEMUPROC>("glOcclusionUnitShapesEMU");
    }
    PFNGLBEGINOCCLUSIONUNITEMUPROC begin_ = nullptr;
    PFNGLENDOCCLUSIONUNITEMUPROC end_ = nullptr;
    PFNGLOCCLUSIONUNITSHAPESEMUPROC shapes_ = nullptr;
};

// However often the layer draws to fill the registers.
TEST_F(DeviceUnit, a_draw_that_the_unit_watches_costs_what_it_costs_without) {
    glEnable(GL_DEPTH_TEST);
    for (const GLbitfield registers : {GL_VISIBLE_BIT_EMU, GL_ALL_REGISTERS_EMU}) {
        conformance::clear();
        const Query query;
        keep_gpu_busy();
        EXPECT_EQ(on_gpu([&] {
                      begin_(registers, query.name());
                      draw(100);
                      fill();
                      end_();
                  }),
                  2 * kGpuBatch + 100 * kTriangle + kFilled * kFragment + kGpuQuery)
            << registers;
        const GLint64 before = rest();
        begin_(registers, query.name());
        draw(100);
        end_();
        EXPECT_EQ(cpu(), before + kBatch + kQuery) << registers;
        const GLint64 there = before + kBatch + kGpuBatch + 100 * kTriangle + kGpuQuery + kLatency;
        GLuint visible = conformance::kUntouched;
        glGetQueryObjectuiv(query.name(), GL_QUERY_RESULT, &visible);
        EXPECT_EQ(cpu(), there) << registers;
    }
}

TEST_F(DeviceUnit, many_shapes_are_one_command_and_many_queries) {
    constexpr GLsizei kShapes = 5;
    constexpr std::array<GLfloat, 6 * kShapes> kNowhere{};  // boxes without volume, and in one corner
    const Query query;
    const auto ask_all = [&] {
        shapes_(GL_VISIBLE_BIT_EMU, GL_BOX_EMU, kShapes, kNowhere.data(), nullptr, query.name());
    };
    rest();
    EXPECT_EQ(on_cpu(ask_all), kQuery);
    keep_gpu_busy();
    EXPECT_EQ(on_gpu(ask_all), kShapes * kGpuQuery);
}

TEST_F(DeviceHardware, depth_regions_take_their_pixels_time) {
    if (const auto why = lacks("GL_EMU_depth_region_query")) GTEST_SKIP() << *why;
    const auto query_regions = command<PFNGLQUERYDEPTHREGIONSEMUPROC>("glQueryDepthRegionsEMU");
    const auto get_region = command<PFNGLGETDEPTHREGIONFVEMUPROC>("glGetDepthRegionfvEMU");
    constexpr std::array<GLint, 8> kRectangles = {0, 0, 10, 10, 60, 60, 10, 10};
    constexpr GLint64 kPixels = 100 + 16;  // of the second, what lies inside the window
    const std::array<Query, 2> queries;
    const std::array<GLuint, 2> names = {queries[0].name(), queries[1].name()};
    const auto ask_both = [&] { query_regions(GL_REGION_OCCLUDED_EMU, 2, kRectangles.data(), names.data()); };
    rest();
    EXPECT_EQ(on_cpu(ask_both), kQuery);
    keep_gpu_busy();
    EXPECT_EQ(on_gpu(ask_both), 2 * kGpuQuery + kPixels * kRegionPixel);
    const GLint64 before = rest();
    GLfloat depth = -1.0f;
    get_region(GL_FURTHEST_DEPTH_EMU, 0, 0, 10, 10, &depth);
    EXPECT_EQ(depth, 1.0f);
    EXPECT_EQ(cpu(), before + kAsked + 100 * kRegionPixel);
}

TEST_F(DeviceHardware, a_context_is_a_machine_of_its_own) {
    draw(100);
    const GLint64 before = rest();
    {
        const conformance::Surface surface;
        const conformance::Context other({}, &context());
        ASSERT_TRUE(other.make_current(surface));
        EXPECT_EQ(cpu(), 0);
        work(7);
        EXPECT_EQ(cpu(), 7);
        come_back();
        EXPECT_EQ(cpu(), before);
        draw(1);
        ASSERT_TRUE(other.make_current(surface));
        EXPECT_EQ(cpu(), 7);
        come_back();
    }
    EXPECT_EQ(cpu(), before + kBatch);
}

}  // namespace
}  // namespace clock_tests
