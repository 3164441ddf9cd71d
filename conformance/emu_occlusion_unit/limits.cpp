// SPDX-License-Identifier: MIT
// Limits that a machine with small ones reaches (../devices/small-unit.toml).
// 17.3.5.1: "A counter that has reached the largest such number stays there."
#include <algorithm>

#include "emu_occlusion_unit/unit_test.h"

namespace conformance {
namespace {

class UnitLimits : public UnitTest {
  protected:
    void SetUp() override {
        ASSERT_NO_FATAL_FAILURE(UnitTest::SetUp());
        if (IsSkipped()) return;
        constexpr int kMostBits = 16;
        if (get_integer(GL_OCCLUSION_COUNTER_BITS_EMU) > kMostBits)
            GTEST_SKIP() << "no test fills such a counter";
        largest_ = (GLuint64{1} << get_integer(GL_OCCLUSION_COUNTER_BITS_EMU)) - 1;
    }

    GLuint64 largest() const { return largest_; }

  private:
    GLuint64 largest_ = 0;
};

TEST_F(UnitLimits, full_counters_stay_full) {
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
    const int rounds = static_cast<int>(largest() / kAll) + 1;
    for (const int more : {0, 1, rounds}) {  // also where wrapping would end in 0
        clear();
        expect_seen({.projected = largest(), .visible = largest(), .nearest = kMiddle, .box = {0, 0, 63, 63}},
                    [=] {
                        for (int i = 0; i < rounds + more; ++i) draw_rect(kWhole, kMiddle);
                    });
    }
}

TEST_F(UnitLimits, a_counter_that_is_not_full_is_exact) {
    const GLuint64 rest = largest() % kAll;
    ASSERT_EQ(rest, static_cast<GLuint64>(kAll - 1));
    const auto draw = [&] {
        for (GLuint64 i = 0; i < largest() / kAll; ++i) draw_rect(kWhole, kMiddle);
        draw_rect({0, 0, kSize, kSize - 1}, kMiddle);
    };
    expect_seen({.projected = largest() - kSize + 1,
                 .visible = largest() - kSize + 1,
                 .nearest = kMiddle,
                 .box = {0, 0, 63, 63}},
                [&] { draw(); });
}

// Each of the two counters for itself.
TEST_F(UnitLimits, one_counter_is_full_and_the_other_is_not) {
    draw_left_occluder();
    glDepthMask(GL_FALSE);
    const GLuint64 rounds = largest() / kAll + 1;
    Seen expected = {.projected = largest(), .visible = rounds * 16, .nearest = kFar, .box = {60, 0, 63, 3}};
    expect_seen(expected, [&] {
        for (GLuint64 i = 0; i < 2 * rounds; ++i) draw_rect(kLeft, kFar);
        for (GLuint64 i = 0; i < rounds; ++i) draw_rect({60, 0, 4, 4}, kFar);
    });
    glDepthMask(GL_TRUE);
}

TEST_F(UnitLimits, counters_of_shapes_stay_full_too) {
    const std::array<GLfloat, 6> box = {0, 0, 0.25f, kSize, kSize, 0.75f};  // two faces: twice the window
    const Query query;
    unit_shapes(kAllRegisters, GL_BOX_EMU, 1, box.data(), nullptr, query.name());
    Record record{};
    get_records(query.name(), 0, 1, &record);
    const GLuint64 samples = std::min<GLuint64>(2 * kAll, largest());
    EXPECT_EQ(record.projected_hits, samples);
    EXPECT_EQ(record.visible_hits, samples);
}

// 17.3.5.3: "INVALID_VALUE ... if <count> is negative or larger than MAX_OCCLUSION_SHAPES_EMU".
TEST_F(UnitLimits, as_many_shapes_as_the_limit_are_taken) {
    const GLsizei most = get_integer(GL_MAX_OCCLUSION_SHAPES_EMU);
    ASSERT_LT(most, 100);
    std::vector<GLfloat> boxes;
    for (GLsizei i = 0; i <= most; ++i) {
        for (const GLfloat number : {0.0f, 0.0f, 0.25f, 1.0f + static_cast<GLfloat>(i), 1.0f, 0.75f})
            boxes.push_back(number);
    }
    const Query query;
    unit_shapes(GL_VISIBLE_HITS_BIT_EMU, GL_BOX_EMU, most, boxes.data(), nullptr, query.name());
    EXPECT_TRUE(no_error());
    std::vector<Record> records(static_cast<std::size_t>(most));
    get_records(query.name(), 0, most, records.data());
    for (std::size_t i = 0; i < records.size(); ++i) EXPECT_EQ(records[i].visible_hits, 2 * (i + 1));
    unit_shapes(GL_VISIBLE_HITS_BIT_EMU, GL_BOX_EMU, most + 1, boxes.data(), nullptr, query.name());
    EXPECT_TRUE(error_is(GL_INVALID_VALUE));
    EXPECT_EQ(get_unit(query.name(), GL_RECORD_COUNT_EMU), static_cast<GLuint>(most))
        << "the object is as it was";
}

}  // namespace
}  // namespace conformance
