// SPDX-License-Identifier: MIT
// Objects of the unit: names, lifetime, and what of GL's other commands takes them.
#include <optional>

#include "emu_occlusion_unit/unit_test.h"

namespace conformance {
namespace {

class UnitObjects : public UnitTest {};

// 4.2: "IsQuery returns TRUE for an object of the unit from its first use on."
TEST_F(UnitObjects, a_name_becomes_an_object_when_it_is_begun) {
    const Query begun;
    const Query asked;
    EXPECT_FALSE(glIsQuery(begun.name()));
    begin_unit(kAllRegisters, begun.name());
    EXPECT_TRUE(glIsQuery(begun.name()));
    end_unit();
    EXPECT_TRUE(glIsQuery(begun.name()));
    EXPECT_FALSE(glIsQuery(asked.name()));
    unit_shapes(GL_VISIBLE_BIT_EMU, GL_BOX_EMU, 0, nullptr, nullptr, asked.name());
    EXPECT_TRUE(glIsQuery(asked.name()));
}

// 4.2: QUERY_TARGET is OCCLUSION_UNIT_EMU.
TEST_F(UnitObjects, the_object_tells_its_target) {
    const Query query;
    ASSERT_TRUE(no_error());
    begin_unit(GL_VISIBLE_BIT_EMU, query.name());
    end_unit();
    EXPECT_EQ(get_unit(query.name(), GL_QUERY_TARGET), static_cast<GLuint>(GL_OCCLUSION_UNIT_EMU));
}

// 4.2: "BeginQuery, BeginQueryIndexed, GetQueryiv and CreateQueries do not accept the target".
TEST_F(UnitObjects, no_older_command_accepts_the_target) {
    const Query query;
    glBeginQuery(GL_OCCLUSION_UNIT_EMU, query.name());
    EXPECT_TRUE(error_is(GL_INVALID_ENUM));
    glBeginQueryIndexed(GL_OCCLUSION_UNIT_EMU, 0, query.name());
    EXPECT_TRUE(error_is(GL_INVALID_ENUM));
    glEndQuery(GL_OCCLUSION_UNIT_EMU);
    EXPECT_TRUE(error_is(GL_INVALID_ENUM));
    GLint value = -7;
    glGetQueryiv(GL_OCCLUSION_UNIT_EMU, GL_CURRENT_QUERY, &value);
    EXPECT_TRUE(error_is(GL_INVALID_ENUM));
    EXPECT_EQ(value, -7);
    if (const auto why = lacks(45, "GL_ARB_direct_state_access")) GTEST_SKIP() << *why;
    GLuint created = kUntouched;
    glCreateQueries(GL_OCCLUSION_UNIT_EMU, 1, &created);
    EXPECT_TRUE(error_is(GL_INVALID_ENUM));
    EXPECT_EQ(created, kUntouched);
}

// 4.2: "BeginQuery and QueryCounter with the name of such an object generate INVALID_OPERATION".
TEST_F(UnitObjects, an_object_of_the_unit_is_none_of_another_target) {
    const Query query;
    begin_unit(kAllRegisters, query.name());
    end_unit();
    for (const GLenum target :
         {GL_SAMPLES_PASSED, GL_ANY_SAMPLES_PASSED, GL_PRIMITIVES_GENERATED, GL_TIME_ELAPSED}) {
        glBeginQuery(target, query.name());
        EXPECT_TRUE(error_is(GL_INVALID_OPERATION)) << target;
        EXPECT_EQ(current_query(target), 0);
        glBeginQueryIndexed(target, 0, query.name());
        EXPECT_TRUE(error_is(GL_INVALID_OPERATION)) << target;
    }
    glQueryCounter(query.name(), GL_TIMESTAMP);
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
    EXPECT_EQ(get_unit(query.name(), GL_QUERY_TARGET), static_cast<GLuint>(GL_OCCLUSION_UNIT_EMU));
}

TEST_F(UnitObjects, nv_queries_do_not_begin_an_object_of_the_unit) {
    if (const auto why = lacks("GL_NV_occlusion_query")) GTEST_SKIP() << *why;
    const Query query;
    begin_unit(kAllRegisters, query.name());
    end_unit();
    glBeginOcclusionQueryNV(query.name());
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
}

// 4.2: "An active query of the unit is not the CURRENT_QUERY of any target."
TEST_F(UnitObjects, the_active_query_is_current_on_no_target) {
    const Query query;
    begin_unit(kAllRegisters, query.name());
    draw_rect({0, 0, 4, 4}, kNear);
    for (const GLenum target :
         {GL_SAMPLES_PASSED, GL_ANY_SAMPLES_PASSED, GL_ANY_SAMPLES_PASSED_CONSERVATIVE,
          GL_PRIMITIVES_GENERATED, GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN, GL_TIME_ELAPSED}) {
        EXPECT_EQ(current_query(target), 0) << target;
    }
    end_unit();
}

// 4.2: "DeleteQueries of the active object of the unit marks its name as unused at once and ends the query".
TEST_F(UnitObjects, deleting_the_active_object_ends_its_query) {
    GLuint name = 0;
    glGenQueries(1, &name);
    begin_unit(kAllRegisters, name);
    draw_rect({0, 0, 4, 4}, kNear);
    glDeleteQueries(1, &name);
    EXPECT_FALSE(glIsQuery(name));
    end_unit();
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
    begin_unit(kAllRegisters, name);
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION)) << "the name is unused";
    const Query samples;
    EXPECT_EQ(samples.count([] { draw_rect({0, 0, 4, 4}, kNear); }), 16u);
    expect_seen(seen(16, {0, 0, 4, 4}, kNear), [] {
        glEnable(GL_DEPTH_TEST);
        clear();
        draw_rect({0, 0, 4, 4}, kNear);
    });
}

// 4.2, of all query objects: a deleted name is unused, and may be an object of another target later.
TEST_F(UnitObjects, a_deleted_object_is_gone_and_its_name_free) {
    GLuint name = 0;
    glGenQueries(1, &name);
    begin_unit(kAllRegisters, name);
    end_unit();
    glDeleteQueries(1, &name);
    EXPECT_FALSE(glIsQuery(name));
    Record record = kUnwritten;
    get_records(name, 0, 1, &record);
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
    EXPECT_EQ(get_unit(name, GL_VISIBLE_EMU), kUntouched);
    EXPECT_NE(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
    std::array<GLuint, 8> names{};
    glGenQueries(8, names.data());
    for (const GLuint fresh : names) {
        glBeginQuery(GL_SAMPLES_PASSED, fresh);
        glEndQuery(GL_SAMPLES_PASSED);
        EXPECT_TRUE(no_error());
    }
    glDeleteQueries(8, names.data());
}

// 4.2: "query objects ... of the unit belong to one context."
TEST_F(UnitObjects, another_context_has_other_objects) {
    const Query query;
    draw_left_occluder();
    begin_unit(kAllRegisters, query.name());
    draw_half_hidden();
    const Context other({}, &context());
    ASSERT_TRUE(other && other.make_current(surface()));
    EXPECT_FALSE(glIsQuery(query.name()));
    end_unit();
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION)) << "nothing is active in this context";
    Record record{};
    get_records(query.name(), 0, 1, &record);
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
    use_pixel_coordinates();
    draw_rect(kWhole, kNear);
    come_back();
    end_unit();
    get_records(query.name(), 0, 1, &record);
    expect_record(record, kAllRegisters, kHalfHidden);
}

// 4.2: "BeginConditionalRender with an object of the unit generates INVALID_OPERATION."
TEST_F(UnitObjects, an_object_of_the_unit_is_no_condition) {
    const Query query;
    begin_unit(kAllRegisters, query.name());
    end_unit();
    glBeginConditionalRender(query.name(), GL_QUERY_WAIT);
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
    draw_rect({0, 0, 4, 4}, kNear);
    EXPECT_EQ(drawn_pixels(), 16);
    glEndConditionalRender();
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION)) << "nothing was begun";
}

// 4.2: "If records are asked for while a buffer is bound to QUERY_BUFFER, or by a command that writes to a
// buffer object, INVALID_OPERATION is generated."
TEST_F(UnitObjects, records_do_not_go_into_buffers) {
    if (const auto why = lacks(44, "GL_ARB_query_buffer_object")) GTEST_SKIP() << *why;
    const Query query;
    begin_unit(kAllRegisters, query.name());
    draw_rect({0, 0, 4, 4}, kNear);
    end_unit();
    const std::array<GLuint, 4> before = {kUntouched, kUntouched, kUntouched, kUntouched};
    GLuint buffer = 0;
    glGenBuffers(1, &buffer);
    glBindBuffer(GL_QUERY_BUFFER, buffer);
    glBufferData(GL_QUERY_BUFFER, sizeof(before), before.data(), GL_STREAM_READ);
    for (const GLenum pname :
         {GL_QUERY_RESULT, GL_QUERY_RESULT_AVAILABLE, GL_VISIBLE_HITS_EMU, GL_SCREEN_BOX_EMU}) {
        glGetQueryObjectuiv(query.name(), pname, nullptr);
        EXPECT_TRUE(error_is(GL_INVALID_OPERATION)) << pname;
    }
    glBindBuffer(GL_QUERY_BUFFER, 0);
    if (!lacks(45, "GL_ARB_direct_state_access")) {
        glGetQueryBufferObjectuiv(query.name(), buffer, GL_QUERY_RESULT, 0);
        EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
    }
    std::array<GLuint, 4> after{};
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glGetBufferSubData(GL_ARRAY_BUFFER, 0, sizeof(after), after.data());
    EXPECT_EQ(after, before);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    glDeleteBuffers(1, &buffer);
}

// New State: FAR_DEPTH_EMU by each Get, initially ONE, in no attribute group.
TEST_F(UnitObjects, the_far_end_is_state_of_no_attribute_group) {
    EXPECT_EQ(get_integer(GL_FAR_DEPTH_EMU), GL_ONE);
    glPushAttrib(GL_ALL_ATTRIB_BITS);
    far_depth(GL_ZERO);
    glPopAttrib();
    GLint64 wide = -7;
    GLfloat single = -7.0f;
    GLdouble twice = -7.0;
    GLboolean truth = GL_TRUE;
    glGetInteger64v(GL_FAR_DEPTH_EMU, &wide);
    glGetFloatv(GL_FAR_DEPTH_EMU, &single);
    glGetDoublev(GL_FAR_DEPTH_EMU, &twice);
    glGetBooleanv(GL_FAR_DEPTH_EMU, &truth);
    EXPECT_EQ(get_integer(GL_FAR_DEPTH_EMU), GL_ZERO);
    EXPECT_EQ(wide, GL_ZERO);
    EXPECT_EQ(single, 0.0f);
    EXPECT_EQ(twice, 0.0);
    EXPECT_EQ(truth, GL_FALSE);
    far_depth(GL_ONE);
    EXPECT_EQ(get_integer(GL_FAR_DEPTH_EMU), GL_ONE);
}

// New Implementation Dependent State.
TEST_F(UnitObjects, the_limits_can_be_asked_for) {
    for (const GLenum limit : {GL_OCCLUSION_COUNTER_BITS_EMU, GL_MAX_OCCLUSION_SHAPES_EMU}) {
        const GLint value = get_integer(limit);
        EXPECT_GE(value, 1);
        GLint64 wide = -7;
        GLfloat single = -7.0f;
        GLdouble twice = -7.0;
        GLboolean truth = GL_FALSE;
        glGetInteger64v(limit, &wide);
        glGetFloatv(limit, &single);
        glGetDoublev(limit, &twice);
        glGetBooleanv(limit, &truth);
        EXPECT_EQ(wide, value);
        EXPECT_EQ(single, static_cast<GLfloat>(value));
        EXPECT_EQ(twice, value);
        EXPECT_TRUE(truth);
    }
    EXPECT_LE(get_integer(GL_OCCLUSION_COUNTER_BITS_EMU), 64);
}

}  // namespace
}  // namespace conformance
