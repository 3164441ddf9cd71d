// SPDX-License-Identifier: MIT
// A machine whose results are late by a number of calls (the clock calls=N): what it says before and after.
// On any other clock there is nothing to see, and the tests are skipped by the one that finds that out.
#include "emu_occlusion_unit/unit_test.h"

namespace conformance {
namespace {

class LateResults : public UnitTest {
  protected:
    void SetUp() override {
        ASSERT_NO_FATAL_FAILURE(UnitTest::SetUp());
        if (IsSkipped()) return;
        // With nothing drawn, and the GL idle, only a clock keeps a result from being there.
        glFinish();
        const Query query;
        begin_unit(GL_VISIBLE_BIT_EMU, query.name());
        end_unit();
        if (is_available(query)) GTEST_SKIP() << "results of this machine are not late";
    }

    static bool is_available(const Query& query) {
        return get_unit(query.name(), GL_QUERY_RESULT_AVAILABLE) == GL_TRUE;
    }
};

// 4.2: QUERY_RESULT_AVAILABLE: "TRUE if the records can be returned without waiting."
TEST_F(LateResults, a_sequential_query_is_unavailable_first_and_available_later) {
    const Query query;
    draw_left_occluder();
    begin_unit(kAllRegisters, query.name());
    draw_half_hidden();
    end_unit();
    ASSERT_FALSE(is_available(query));
    int polls = 1;
    while (!is_available(query) && polls < 1000) ++polls;
    EXPECT_GT(polls, 1);
    EXPECT_LT(polls, 1000);
    Record record{};
    get_records(query.name(), 0, 1, &record);
    expect_record(record, kAllRegisters, kHalfHidden);
}

TEST_F(LateResults, shapes_are_unavailable_first_and_available_later) {
    const Query query;
    const std::array<GLfloat, 12> quad = {8, 8, kNear, 24, 8, kNear, 24, 24, kNear, 8, 24, kNear};
    unit_shapes(kAllRegisters, GL_QUAD_EMU, 1, quad.data(), nullptr, query.name());
    ASSERT_FALSE(is_available(query));
    int polls = 1;
    while (!is_available(query) && polls < 1000) ++polls;
    EXPECT_GT(polls, 1);
    EXPECT_LT(polls, 1000);
    EXPECT_EQ(get_unit(query.name(), GL_VISIBLE_HITS_EMU), 256u);
}

// 4.2: all but QUERY_RESULT_AVAILABLE, QUERY_TARGET and RECORD_COUNT_EMU wait: then the records are there.
TEST_F(LateResults, what_does_not_wait_leaves_a_result_late) {
    const Query query;
    begin_unit(kAllRegisters, query.name());
    end_unit();
    EXPECT_EQ(get_unit(query.name(), GL_QUERY_TARGET), static_cast<GLuint>(GL_OCCLUSION_UNIT_EMU));
    EXPECT_EQ(get_unit(query.name(), GL_RECORD_COUNT_EMU), 1u);
    EXPECT_FALSE(is_available(query));
}

TEST_F(LateResults, each_read_waits) {
    for (const GLenum pname : {GL_QUERY_RESULT, GL_VISIBLE_EMU, GL_PROJECTED_HITS_EMU, GL_VISIBLE_HITS_EMU,
                               GL_NEAREST_DEPTH_EMU, GL_REGISTERS_EMU}) {
        const Query query;
        begin_unit(kAllRegisters, query.name());
        end_unit();
        ASSERT_FALSE(is_available(query)) << pname;
        get_unit(query.name(), pname);
        EXPECT_TRUE(is_available(query)) << pname;
    }
    const Query query;
    begin_unit(kAllRegisters, query.name());
    end_unit();
    ASSERT_FALSE(is_available(query));
    Record record{};
    get_records(query.name(), 0, 1, &record);
    EXPECT_TRUE(is_available(query));
}

}  // namespace
}  // namespace conformance
