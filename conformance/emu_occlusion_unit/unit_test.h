// SPDX-License-Identifier: MIT
// What the tests of GL_EMU_occlusion_unit share: its commands, which no library exports; the fixture, which
// skips where the extension is absent; and records, asked for and compared.
//
// Drawing is in whole pixels at stated depths (harness/draw.h), so that a test says what every register has
// to hold.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "harness/gl_test.h"
#include "harness/objects.h"
#include "harness/query.h"

// After glext.h with its prototypes, which it includes without.
#include <GL/glext_emu.h>

namespace conformance {

using Draw = std::function<void()>;
using Record = GLocclusionrecordEMU;

void far_depth(GLenum end);
void begin_unit(GLbitfield registers, GLuint id);
void end_unit();
void unit_shapes(GLbitfield registers, GLenum shape, GLsizei count, const GLfloat* vertices,
                 const GLfloat* matrix, GLuint id);
void get_records(GLuint id, GLsizei first, GLsizei count, Record* records);

inline constexpr int kSize = kSurfaceSize;
inline constexpr int kHalf = kSize / 2;
inline constexpr int kAll = kSize * kSize;  // the samples of kWhole where there is one a pixel
inline constexpr Rect kLeft = {0, 0, kHalf, kSize};
inline constexpr Rect kRight = {kHalf, 0, kHalf, kSize};
inline constexpr GLbitfield kAllRegisters = GL_ALL_REGISTERS_EMU;
inline constexpr std::array kEachRegister = {GL_VISIBLE_BIT_EMU, GL_PROJECTED_HITS_BIT_EMU,
                                             GL_VISIBLE_HITS_BIT_EMU, GL_NEAREST_DEPTH_BIT_EMU,
                                             GL_SCREEN_BOX_BIT_EMU};
// One step of a 24-bit depth buffer: a depth that the format does not have exactly is one of the two beside
// it.
inline constexpr float kDepthStep24 = 1.0f / 16777215.0f;

// What the unit has to tell of a drawing.
struct Seen {
    GLuint64 projected = 0;
    GLuint64 visible = 0;
    float nearest = 1.0f;
    std::array<GLint, 4> box = {0, 0, -1, -1};
    float depth_step = kDepthStep24;
};

// All visible samples, one a pixel, are those of <pixels>; their nearest is at <depth>.
Seen seen(GLuint64 projected, const Rect& pixels, float nearest);
inline Seen hidden(GLuint64 projected) {
    return {.projected = projected};
}

// What a record holds that no call may write.
inline constexpr Record kUnwritten = {.projected_hits = kUntouched,
                                      .visible_hits = kUntouched,
                                      .visible = kUntouched,
                                      .nearest_depth = -7.0f,
                                      .box = {-7, -7, -7, -7},
                                      .registers = kUntouched,
                                      .reserved = kUntouched};

// The record that one query of the unit over <draw> holds; waits for it.
Record ask(GLbitfield registers, const Draw& draw);

// The registers of <armed>, and no others, are determined, and hold what <expected> says.
void expect_record(const Record& record, GLbitfield armed, const Seen& expected);
// All registers, armed together.
void expect_seen(const Seen& expected, const Draw& draw);
// For what a text leaves to the implementation: a register either holds what it has to, or is not determined.
// <may> are those that need not be.
void expect_seen_or_undetermined(GLbitfield may, const Seen& expected, const Draw& draw);

// 17.3.5.2: what need not be determined where shaders write to memory, primitives or statistics are queried,
// or rendering is conditional.
inline constexpr GLbitfield kMayBeUndetermined =
    GL_PROJECTED_HITS_BIT_EMU | GL_NEAREST_DEPTH_BIT_EMU | GL_SCREEN_BOX_BIT_EMU;

// Begin and Shapes, of a box at kNear, are both refused.
void expect_refused(GLenum error, GLbitfield registers, GLuint id);
inline constexpr std::array<GLfloat, 6> kNearBox = {8.0f, 8.0f, kNear, 24.0f, 24.0f, kNear};

// A register of the first record by GetQueryObjectuiv; kUntouched where the command writes nothing.
GLuint get_unit(GLuint id, GLenum pname);

class UnitTest : public GlTest {
  protected:
    void SetUp() override;
};

// An occluder at kMiddle over the left half of the cleared depth buffer; the depth test on with LESS. What
// draw_half_hidden draws then, twice as wide as the half that it shows, has to be kHalfHidden.
void draw_left_occluder();
void draw_half_hidden();
void draw_half_hidden_strip();  // the same as two triangles, whatever the program in use makes of them
inline constexpr Rect kHalfHiddenRect = {8, 8, 48, 16};
extern const Seen kHalfHidden;

// A program whose transform feedback records <varying>, in use.
GLuint use_recording_program(const char* vertex_source, const char* varying);

}  // namespace conformance
