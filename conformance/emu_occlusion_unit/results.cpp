// SPDX-License-Identifier: MIT
// How results are read: by GetQueryObject, value by value, and as records; when they are there.
#include <bit>
#include <limits>

#include "emu_occlusion_unit/unit_test.h"

namespace conformance {
namespace {

class UnitResults : public UnitTest {
  protected:
    // Over <query>, what draw_half_hidden shows of itself.
    static void ask_half_hidden(GLbitfield registers, const Query& query) {
        draw_left_occluder();
        begin_unit(registers, query.name());
        draw_half_hidden();
        end_unit();
    }
};

// 4.2: the values of <pname>, of the first record.
TEST_F(UnitResults, each_register_is_read_by_its_name) {
    const Query query;
    ask_half_hidden(kAllRegisters, query);
    EXPECT_EQ(get_unit(query.name(), GL_REGISTERS_EMU), static_cast<GLuint>(kAllRegisters));
    EXPECT_EQ(get_unit(query.name(), GL_RECORD_COUNT_EMU), 1u);
    EXPECT_EQ(get_unit(query.name(), GL_VISIBLE_EMU), 1u);
    EXPECT_EQ(get_unit(query.name(), GL_PROJECTED_HITS_EMU), kHalfHidden.projected);
    EXPECT_EQ(get_unit(query.name(), GL_VISIBLE_HITS_EMU), kHalfHidden.visible);
    EXPECT_EQ(get_unit(query.name(), GL_QUERY_RESULT), kHalfHidden.visible);
    EXPECT_TRUE(get_unit(query.name(), GL_QUERY_RESULT_AVAILABLE));
    EXPECT_NEAR(std::bit_cast<float>(get_unit(query.name(), GL_NEAREST_DEPTH_EMU)), kFar, kDepthStep24);
    std::array<GLuint, 5> box = {kUntouched, kUntouched, kUntouched, kUntouched, kUntouched};
    glGetQueryObjectuiv(query.name(), GL_SCREEN_BOX_EMU, box.data());
    EXPECT_EQ(box, (std::array<GLuint, 5>{32, 8, 55, 23, kUntouched}));
}

// The four types say the same.
TEST_F(UnitResults, the_four_gets_agree) {
    const Query query;
    ask_half_hidden(kAllRegisters, query);
    for (const GLenum pname : {GL_QUERY_RESULT, GL_QUERY_RESULT_AVAILABLE, GL_QUERY_TARGET, GL_VISIBLE_EMU,
                               GL_PROJECTED_HITS_EMU, GL_VISIBLE_HITS_EMU, GL_NEAREST_DEPTH_EMU,
                               GL_SCREEN_BOX_EMU, GL_RECORD_COUNT_EMU, GL_REGISTERS_EMU}) {
        SCOPED_TRACE(pname);
        std::array<GLuint, 4> value = {kUntouched};
        std::array<GLint, 4> signed_value = {-7};
        std::array<GLint64, 4> wide = {-7};
        std::array<GLuint64, 4> wide_unsigned = {kUntouched};
        glGetQueryObjectuiv(query.name(), pname, value.data());
        glGetQueryObjectiv(query.name(), pname, signed_value.data());
        glGetQueryObjecti64v(query.name(), pname, wide.data());
        glGetQueryObjectui64v(query.name(), pname, wide_unsigned.data());
        EXPECT_NE(value[0], kUntouched);
        for (std::size_t i = 0; i < (pname == GL_SCREEN_BOX_EMU ? 4 : 1); ++i) {
            EXPECT_EQ(signed_value[i], static_cast<GLint>(value[i]));
            EXPECT_EQ(wide[i], value[i]);
            EXPECT_EQ(wide_unsigned[i], value[i]);
        }
    }
}

// 4.2: the empty rectangle is signed.
TEST_F(UnitResults, the_empty_box_ends_at_minus_one) {
    const Query query;
    begin_unit(GL_SCREEN_BOX_BIT_EMU, query.name());
    end_unit();
    std::array<GLint, 4> box = {-7, -7, -7, -7};
    glGetQueryObjectiv(query.name(), GL_SCREEN_BOX_EMU, box.data());
    EXPECT_EQ(box, (std::array<GLint, 4>{0, 0, -1, -1}));
    std::array<GLint64, 4> wide = {-7, -7, -7, -7};
    glGetQueryObjecti64v(query.name(), GL_SCREEN_BOX_EMU, wide.data());
    EXPECT_EQ(wide, (std::array<GLint64, 4>{0, 0, -1, -1}));
}

// 4.2: "INVALID_OPERATION ... where a register is asked for that is not among REGISTERS_EMU".
TEST_F(UnitResults, a_register_that_was_not_armed_cannot_be_asked_for) {
    const std::array names = {GL_VISIBLE_EMU, GL_PROJECTED_HITS_EMU, GL_VISIBLE_HITS_EMU,
                              GL_NEAREST_DEPTH_EMU, GL_SCREEN_BOX_EMU};
    for (std::size_t armed = 0; armed < names.size(); ++armed) {
        const Query query;
        ask_half_hidden(kEachRegister[armed], query);
        EXPECT_EQ(get_unit(query.name(), GL_REGISTERS_EMU), static_cast<GLuint>(kEachRegister[armed]));
        for (std::size_t asked = 0; asked < names.size(); ++asked) {
            if (asked == armed) continue;
            EXPECT_EQ(get_unit(query.name(), names[asked]), kUntouched);
            EXPECT_TRUE(error_is(GL_INVALID_OPERATION)) << armed << ", " << asked;
        }
    }
}

// 4.2: QUERY_RESULT is "VISIBLE_HITS_EMU if that register was armed, else VISIBLE_EMU", else
// INVALID_OPERATION.
TEST_F(UnitResults, the_query_result_is_the_count_or_the_flag) {
    const auto result_of = [](GLbitfield registers) {
        const Query query;
        ask_half_hidden(registers, query);
        return get_unit(query.name(), GL_QUERY_RESULT);
    };
    EXPECT_EQ(result_of(GL_VISIBLE_HITS_BIT_EMU), kHalfHidden.visible);
    EXPECT_EQ(result_of(GL_VISIBLE_HITS_BIT_EMU | GL_VISIBLE_BIT_EMU), kHalfHidden.visible);
    EXPECT_EQ(result_of(GL_VISIBLE_BIT_EMU), 1u);
    EXPECT_TRUE(no_error());
    EXPECT_EQ(result_of(GL_PROJECTED_HITS_BIT_EMU | GL_NEAREST_DEPTH_BIT_EMU | GL_SCREEN_BOX_BIT_EMU),
              kUntouched);
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
}

// 4.2: "whatever <pname> is, where the query is active."
TEST_F(UnitResults, an_active_query_cannot_be_asked) {
    const Query query;
    begin_unit(kAllRegisters, query.name());
    for (const GLenum pname :
         {GL_QUERY_RESULT, GL_QUERY_RESULT_AVAILABLE, GL_VISIBLE_EMU, GL_PROJECTED_HITS_EMU,
          GL_SCREEN_BOX_EMU, GL_RECORD_COUNT_EMU, GL_REGISTERS_EMU}) {
        EXPECT_EQ(get_unit(query.name(), pname), kUntouched);
        EXPECT_TRUE(error_is(GL_INVALID_OPERATION)) << pname;
    }
    end_unit();
}

// 4.2: "For objects of other targets the names of registers, RECORD_COUNT_EMU and REGISTERS_EMU generate
// INVALID_ENUM."
TEST_F(UnitResults, objects_of_other_targets_have_no_registers) {
    const Query samples;
    samples.count([] {});
    for (const GLenum pname :
         {GL_VISIBLE_EMU, GL_PROJECTED_HITS_EMU, GL_VISIBLE_HITS_EMU, GL_NEAREST_DEPTH_EMU, GL_SCREEN_BOX_EMU,
          GL_RECORD_COUNT_EMU, GL_REGISTERS_EMU}) {
        EXPECT_EQ(get_unit(samples.name(), pname), kUntouched);
        EXPECT_TRUE(error_is(GL_INVALID_ENUM)) << pname;
    }
    const Query unit;
    begin_unit(kAllRegisters, unit.name());
    end_unit();
    EXPECT_EQ(get_unit(unit.name(), GL_LINES), kUntouched);
    EXPECT_TRUE(error_is(GL_INVALID_ENUM)) << "no name of a parameter";
}

// 4.2: QUERY_RESULT_AVAILABLE becomes TRUE, and does not become FALSE again; then a read does not change
// that.
TEST_F(UnitResults, polling_comes_to_an_end) {
    const Query query;
    ask_half_hidden(kAllRegisters, query);
    int polls = 1;
    while (get_unit(query.name(), GL_QUERY_RESULT_AVAILABLE) != GL_TRUE && polls < 100000) ++polls;
    EXPECT_LT(polls, 100000);
    Record record{};
    get_records(query.name(), 0, 1, &record);
    expect_record(record, kAllRegisters, kHalfHidden);
    EXPECT_TRUE(get_unit(query.name(), GL_QUERY_RESULT_AVAILABLE));
}

// 4.2: GetOcclusionRecordsEMU and GetQueryObject wait; also twice, also out of order.
TEST_F(UnitResults, reads_wait_in_any_order) {
    const std::array<Query, 4> queries;
    for (const Query& query : queries) ask_half_hidden(kAllRegisters, query);
    for (std::size_t i = queries.size(); i-- > 0;) {
        for (int again = 0; again < 2; ++again) {
            Record record{};
            get_records(queries[i].name(), 0, 1, &record);
            expect_record(record, kAllRegisters, kHalfHidden);
            EXPECT_EQ(get_unit(queries[i].name(), GL_PROJECTED_HITS_EMU), kHalfHidden.projected);
        }
    }
}

// 4.2: "In whatever way a program learns that results are there, for example by Finish or a fence".
TEST_F(UnitResults, after_finish_the_records_are_there) {
    const Query query;
    ask_half_hidden(kAllRegisters, query);
    glFinish();
    EXPECT_TRUE(get_unit(query.name(), GL_QUERY_RESULT_AVAILABLE));
    ask_half_hidden(GL_VISIBLE_HITS_BIT_EMU, query);
    const GLsync fence = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
    constexpr GLuint64 kOneSecondNs = 1'000'000'000;
    const GLenum waited = glClientWaitSync(fence, GL_SYNC_FLUSH_COMMANDS_BIT, 10 * kOneSecondNs);
    EXPECT_TRUE(waited == GL_CONDITION_SATISFIED || waited == GL_ALREADY_SIGNALED);
    EXPECT_TRUE(get_unit(query.name(), GL_QUERY_RESULT_AVAILABLE));
    glDeleteSync(fence);
}

// 17.3.5.1, Begin: what an object held before is gone, read or not.
TEST_F(UnitResults, a_result_that_nobody_read_is_replaced) {
    const Query query;
    ask_half_hidden(kAllRegisters, query);
    begin_unit(GL_VISIBLE_HITS_BIT_EMU, query.name());
    draw_rect({40, 40, 2, 3}, kNear);
    end_unit();
    EXPECT_EQ(get_unit(query.name(), GL_QUERY_RESULT), 6u);
    EXPECT_EQ(get_unit(query.name(), GL_REGISTERS_EMU), static_cast<GLuint>(GL_VISIBLE_HITS_BIT_EMU));
}

}  // namespace
}  // namespace conformance
