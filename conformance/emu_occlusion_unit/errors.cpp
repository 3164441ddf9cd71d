// SPDX-License-Identifier: MIT
// Misuse: the error that the text names, and nothing else.
#include "emu_occlusion_unit/unit_test.h"

namespace conformance {
namespace {

class UnitErrors : public UnitTest {};

constexpr GLuint kUnknownName = 0x7000;  // larger than any that Gen has returned here

// 17.3.5.1: "INVALID_VALUE ... if <registers> is 0 or has a bit other than those of ALL_REGISTERS_EMU."
TEST_F(UnitErrors, registers_have_to_be_known_ones_and_at_least_one) {
    const Query query;
    expect_refused(GL_INVALID_VALUE, 0, query.name());
    expect_refused(GL_INVALID_VALUE, 0x20, query.name());
    expect_refused(GL_INVALID_VALUE, 0xFFFFFFFF, query.name());
    EXPECT_FALSE(glIsQuery(query.name()));
}

// 17.3.5.1: "INVALID_OPERATION ... if <id> is 0, not a name returned by GenQueries, or an object of another
// target".
TEST_F(UnitErrors, the_name_has_to_be_a_generated_one_of_no_other_target) {
    expect_refused(GL_INVALID_OPERATION, kAllRegisters, 0);
    expect_refused(GL_INVALID_OPERATION, kAllRegisters, kUnknownName);
    EXPECT_FALSE(glIsQuery(kUnknownName));
    const Query samples;
    samples.count([] {});
    expect_refused(GL_INVALID_OPERATION, kAllRegisters, samples.name());
    GLuint deleted = 0;
    glGenQueries(1, &deleted);
    glDeleteQueries(1, &deleted);
    expect_refused(GL_INVALID_OPERATION, kAllRegisters, deleted);
}

// The same of an object that the other proposed extension made.
TEST_F(UnitErrors, an_object_of_a_region_query_is_refused) {
    if (const auto why = lacks("GL_EMU_depth_region_query")) GTEST_SKIP() << *why;
    const auto regions = reinterpret_cast<PFNGLQUERYDEPTHREGIONSEMUPROC>(
        platform().get_proc_address("glQueryDepthRegionsEMU"));
    const Query region;
    const GLuint id = region.name();
    const std::array<GLint, 4> rectangle = {0, 0, 4, 4};
    regions(GL_FURTHEST_DEPTH_EMU, 1, rectangle.data(), &id);
    expect_refused(GL_INVALID_OPERATION, kAllRegisters, id);
    Record record{};
    get_records(id, 0, 1, &record);
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
}

// 17.3.5.1: "if a query of the unit ... is active".
TEST_F(UnitErrors, one_query_of_the_unit_is_active_at_a_time) {
    const Query first;
    const Query second;
    glEnable(GL_DEPTH_TEST);
    begin_unit(kAllRegisters, first.name());
    for (const GLuint id : {first.name(), second.name()}) {
        begin_unit(kAllRegisters, id);
        EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
        unit_shapes(kAllRegisters, GL_BOX_EMU, 1, kNearBox.data(), nullptr, id);
        EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
    }
    draw_rect({8, 8, 4, 4}, kNear);
    end_unit();
    EXPECT_FALSE(glIsQuery(second.name()));
    Record record{};
    get_records(first.name(), 0, 1, &record);
    expect_record(record, kAllRegisters, seen(16, {8, 8, 4, 4}, kNear));
}

// 17.3.5.1: "EndOcclusionUnitEMU generates INVALID_OPERATION if no query of the unit is active."
TEST_F(UnitErrors, an_end_without_begin_is_refused) {
    end_unit();
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
    const Query samples;
    samples.begin();
    end_unit();
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
    EXPECT_EQ(current_query(GL_SAMPLES_PASSED), static_cast<GLint>(samples.name()));
    draw_rect({0, 0, 4, 4}, kNear);
    samples.end();
    EXPECT_EQ(samples.result(), 16u);
}

// 17.3.5.1: "INVALID_ENUM is generated if <end> is another value."
TEST_F(UnitErrors, the_far_end_is_one_or_zero) {
    for (const GLenum end : {GL_TRUE + 1u, static_cast<GLuint>(GL_LESS), 0xFFFFFFFFu}) {
        far_depth(end);
        EXPECT_TRUE(error_is(GL_INVALID_ENUM));
        EXPECT_EQ(get_integer(GL_FAR_DEPTH_EMU), GL_ONE);
    }
}

// 17.3.5.3: the errors of Shapes alone; the object stays what it was.
TEST_F(UnitErrors, shapes_are_refused_for_their_kind_and_number) {
    const Query query;
    const auto refused = [&](GLenum error, GLenum shape, GLsizei count) {
        unit_shapes(kAllRegisters, shape, count, kNearBox.data(), nullptr, query.name());
        EXPECT_TRUE(error_is(error));
        EXPECT_FALSE(glIsQuery(query.name()));
    };
    refused(GL_INVALID_ENUM, GL_QUADS, 1);
    refused(GL_INVALID_ENUM, 0, 1);
    refused(GL_INVALID_VALUE, GL_BOX_EMU, -1);
    refused(GL_INVALID_VALUE, GL_BOX_EMU, get_integer(GL_MAX_OCCLUSION_SHAPES_EMU) + 1);
}

// 17.3.5.3: "INVALID_FRAMEBUFFER_OPERATION is generated if the draw framebuffer is not complete."
TEST_F(UnitErrors, shapes_need_a_complete_framebuffer) {
    const Query query;
    GLuint incomplete = 0;
    glGenFramebuffers(1, &incomplete);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, incomplete);
    GLuint nothing = 0;
    glGenTextures(1, &nothing);
    glBindTexture(GL_TEXTURE_2D, nothing);
    glFramebufferTexture2D(GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, nothing, 0);
    ASSERT_NE(glCheckFramebufferStatus(GL_DRAW_FRAMEBUFFER), static_cast<GLenum>(GL_FRAMEBUFFER_COMPLETE));
    unit_shapes(kAllRegisters, GL_BOX_EMU, 1, kNearBox.data(), nullptr, query.name());
    EXPECT_TRUE(error_is(GL_INVALID_FRAMEBUFFER_OPERATION));
    EXPECT_FALSE(glIsQuery(query.name()));
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    glDeleteFramebuffers(1, &incomplete);
    glDeleteTextures(1, &nothing);
}

// 4.2: "INVALID_OPERATION is generated if <id> is not an object of the unit, or is active. INVALID_VALUE
// ...".
TEST_F(UnitErrors, records_are_read_of_an_ended_object_and_within_their_number) {
    Record record = kUnwritten;
    const auto refused = [&](GLenum error, GLuint id, GLsizei first, GLsizei count) {
        get_records(id, first, count, &record);
        EXPECT_TRUE(error_is(error)) << first << ", " << count;
        EXPECT_EQ(record.visible, kUntouched);
    };
    const Query query;
    const Query samples;
    samples.count([] {});
    refused(GL_INVALID_OPERATION, 0, 0, 1);
    refused(GL_INVALID_OPERATION, query.name(), 0, 1);
    refused(GL_INVALID_OPERATION, samples.name(), 0, 1);
    begin_unit(kAllRegisters, query.name());
    refused(GL_INVALID_OPERATION, query.name(), 0, 1);
    end_unit();
    refused(GL_INVALID_VALUE, query.name(), -1, 1);
    refused(GL_INVALID_VALUE, query.name(), 0, -1);
    refused(GL_INVALID_VALUE, query.name(), 0, 2);
    refused(GL_INVALID_VALUE, query.name(), 1, 1);
    refused(GL_INVALID_VALUE, query.name(), 0x7FFFFFFF, 0x7FFFFFFF);
    get_records(query.name(), 1, 0, &record);
    EXPECT_TRUE(no_error());
    EXPECT_EQ(record.visible, kUntouched);
}

// 17.3.5.1: "Every command of this extension generates INVALID_OPERATION between Begin and End."
TEST_F(UnitErrors, between_begin_and_end_every_command_is_refused) {
    const Query ended;
    const Query query;
    begin_unit(kAllRegisters, ended.name());
    end_unit();
    glBegin(GL_POINTS);
    begin_unit(kAllRegisters, query.name());
    end_unit();
    unit_shapes(kAllRegisters, GL_BOX_EMU, 1, kNearBox.data(), nullptr, query.name());
    Record record = kUnwritten;
    get_records(ended.name(), 0, 1, &record);
    far_depth(GL_ZERO);
    glEnd();
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
    while (glGetError() != GL_NO_ERROR) {
    }
    EXPECT_FALSE(glIsQuery(query.name()));
    EXPECT_EQ(record.visible, kUntouched);
    EXPECT_EQ(get_integer(GL_FAR_DEPTH_EMU), GL_ONE);
    end_unit();
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION)) << "nothing was begun";
}

// Each of them alone, so that no refusal hides behind another's.
TEST_F(UnitErrors, between_begin_and_end_each_command_alone_is_refused) {
    const Query query;
    Record record{};
    const std::array<Draw, 5> commands = {
        [&] { begin_unit(kAllRegisters, query.name()); }, [] { end_unit(); },
        [&] { unit_shapes(kAllRegisters, GL_BOX_EMU, 1, kNearBox.data(), nullptr, query.name()); },
        [&] { get_records(query.name(), 0, 0, &record); }, [] { far_depth(GL_ONE); }};
    begin_unit(kAllRegisters, query.name());
    end_unit();
    for (std::size_t i = 0; i < commands.size(); ++i) {
        glBegin(GL_POINTS);
        commands[i]();
        glEnd();
        EXPECT_TRUE(error_is(GL_INVALID_OPERATION)) << i;
        EXPECT_TRUE(no_error());
    }
}

}  // namespace
}  // namespace conformance
