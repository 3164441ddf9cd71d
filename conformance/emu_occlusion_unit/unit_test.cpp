// SPDX-License-Identifier: MIT
// Commands of the extension by GetProcAddress, and comparison of records.
#include "emu_occlusion_unit/unit_test.h"

namespace conformance {

namespace {

// Asked for at every call: a pointer may belong to the context.
template <typename Function>
Function command(const char* name) {
    return reinterpret_cast<Function>(platform().get_proc_address(name));
}

}  // namespace

const Seen kHalfHidden = seen(48 * 16, {kHalf, 8, 24, 16}, kFar);

void far_depth(GLenum end) {
    command<PFNGLFARDEPTHEMUPROC>("glFarDepthEMU")(end);
}

void begin_unit(GLbitfield registers, GLuint id) {
    command<PFNGLBEGINOCCLUSIONUNITEMUPROC>("glBeginOcclusionUnitEMU")(registers, id);
}

void end_unit() {
    command<PFNGLENDOCCLUSIONUNITEMUPROC>("glEndOcclusionUnitEMU")();
}

void unit_shapes(GLbitfield registers, GLenum shape, GLsizei count, const GLfloat* vertices,
                 const GLfloat* matrix, GLuint id) {
    command<PFNGLOCCLUSIONUNITSHAPESEMUPROC>("glOcclusionUnitShapesEMU")(registers, shape, count, vertices,
                                                                         matrix, id);
}

void get_records(GLuint id, GLsizei first, GLsizei count, Record* records) {
    command<PFNGLGETOCCLUSIONRECORDSEMUPROC>("glGetOcclusionRecordsEMU")(id, first, count, records);
}

Seen seen(GLuint64 projected, const Rect& pixels, float nearest) {
    return {.projected = projected,
            .visible = static_cast<GLuint64>(pixels.area()),
            .nearest = nearest,
            .box = {pixels.x, pixels.y, pixels.x + pixels.width - 1, pixels.y + pixels.height - 1}};
}

Record ask(GLbitfield registers, const Draw& draw) {
    const Query query;
    begin_unit(registers, query.name());
    draw();
    end_unit();
    Record record = kUnwritten;
    get_records(query.name(), 0, 1, &record);
    EXPECT_TRUE(no_error());
    return record;
}

void expect_record(const Record& record, GLbitfield armed, const Seen& expected) {
    EXPECT_EQ(record.registers, armed);
    const auto holds = [&](GLbitfield bit) { return (record.registers & bit) != 0; };
    EXPECT_EQ(record.visible, holds(GL_VISIBLE_BIT_EMU) && expected.visible != 0 ? 1u : 0u);
    EXPECT_EQ(record.projected_hits, holds(GL_PROJECTED_HITS_BIT_EMU) ? expected.projected : 0u);
    EXPECT_EQ(record.visible_hits, holds(GL_VISIBLE_HITS_BIT_EMU) ? expected.visible : 0u);
    if (holds(GL_NEAREST_DEPTH_BIT_EMU)) {
        EXPECT_NEAR(record.nearest_depth, expected.nearest, expected.depth_step);
    } else {
        EXPECT_EQ(record.nearest_depth, 0.0f);
    }
    const std::array box = {record.box[0], record.box[1], record.box[2], record.box[3]};
    EXPECT_EQ(box, holds(GL_SCREEN_BOX_BIT_EMU) ? expected.box : Seen{}.box);
    EXPECT_EQ(record.reserved, 0u);
}

void expect_seen(const Seen& expected, const Draw& draw) {
    expect_record(ask(kAllRegisters, draw), kAllRegisters, expected);
}

void expect_seen_or_undetermined(GLbitfield may, const Seen& expected, const Draw& draw) {
    const Record record = ask(kAllRegisters, draw);
    EXPECT_EQ(record.registers | may, kAllRegisters) << "a register is undetermined without a reason";
    expect_record(record, record.registers, expected);
}

void expect_refused(GLenum error, GLbitfield registers, GLuint id) {
    begin_unit(registers, id);
    EXPECT_TRUE(error_is(error)) << "Begin";
    unit_shapes(registers, GL_BOX_EMU, 1, kNearBox.data(), nullptr, id);
    EXPECT_TRUE(error_is(error)) << "Shapes";
    end_unit();
    EXPECT_TRUE(error_is(GL_INVALID_OPERATION)) << "nothing was begun";
}

GLuint get_unit(GLuint id, GLenum pname) {
    GLuint value = kUntouched;
    glGetQueryObjectuiv(id, pname, &value);
    return value;
}

void UnitTest::SetUp() {
    ASSERT_NO_FATAL_FAILURE(GlTest::SetUp());
    if (const auto why = lacks("GL_EMU_occlusion_unit")) GTEST_SKIP() << *why;
}

void draw_left_occluder() {
    clear();
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glDepthMask(GL_TRUE);
    draw_rect(kLeft, kMiddle);
}

void draw_half_hidden() {
    draw_rect(kHalfHiddenRect, kFar);
}

void draw_half_hidden_strip() {
    glBegin(GL_TRIANGLE_STRIP);
    glVertex3f(8.0f, 8.0f, kFar);
    glVertex3f(56.0f, 8.0f, kFar);
    glVertex3f(8.0f, 24.0f, kFar);
    glVertex3f(56.0f, 24.0f, kFar);
    glEnd();
}

GLuint use_recording_program(const char* vertex_source, const char* varying) {
    const GLuint program = glCreateProgram();
    const GLuint shader = glCreateShader(GL_VERTEX_SHADER);
    glShaderSource(shader, 1, &vertex_source, nullptr);
    glCompileShader(shader);
    glAttachShader(program, shader);
    glDeleteShader(shader);  // goes with the program
    glTransformFeedbackVaryings(program, 1, &varying, GL_INTERLEAVED_ATTRIBS);
    glLinkProgram(program);
    glUseProgram(program);
    return program;
}

}  // namespace conformance
