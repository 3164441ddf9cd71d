// SPDX-License-Identifier: MIT
// What the tests of GL_EMU_depth_region_query share: its commands, which no library exports; the fixture,
// which skips where the extension is absent; and depths put where a test wants them.
#pragma once

#include <array>
#include <vector>

#include "harness/gl_test.h"
#include "harness/objects.h"
#include "harness/query.h"

// After glext.h with its prototypes, which it includes without.
#include <GL/glext_emu.h>

namespace conformance {

void far_depth(GLenum end);
void get_region(GLenum pname, const Rect& rect, GLfloat* value);
void get_regions(GLenum pname, GLsizei count, const Rect* rects, GLfloat* values);
void query_regions(GLenum pname, GLsizei count, const Rect* rects, const GLuint* ids);
void query_regions_into(GLenum pname, GLsizei count, const Rect* rects, GLuint buffer, GLintptr offset);

inline constexpr std::array kEachQuestion = {GL_REGION_OCCLUDED_EMU, GL_FURTHEST_DEPTH_EMU,
                                             GL_NEAREST_DEPTH_EMU};
inline constexpr GLfloat kUnwritten = -7.0f;  // what an output holds that no call may write

// The answer of one region by the blocking command; kUnwritten where it writes nothing.
GLfloat ask(GLenum pname, const Rect& rect);
inline GLfloat occluded(const Rect& rect) {
    return ask(GL_REGION_OCCLUDED_EMU, rect);
}
inline GLfloat furthest(const Rect& rect) {
    return ask(GL_FURTHEST_DEPTH_EMU, rect);
}
inline GLfloat nearest(const Rect& rect) {
    return ask(GL_NEAREST_DEPTH_EMU, rect);
}

// Every pixel of <rect> gets this depth, by a scissored clear. The fifths lie in every fixed-point format:
// 2^16 - 1, 2^24 - 1 and 2^32 - 1 are divisible by 5.
void put_depth(const Rect& rect, GLfloat depth);
inline constexpr GLfloat kFifth = 0.2f;
inline constexpr GLfloat kTwoFifths = 0.4f;
inline constexpr GLfloat kThreeFifths = 0.6f;
inline constexpr GLfloat kFourFifths = 0.8f;
// A step of 16 bits, the coarsest format: GL leaves it to the driver whether a clear rounds or truncates.
inline constexpr GLfloat kLittle = 1.0f / 65535.0f;

GLuint64 pixels_read();

// The fixture: the whole depth buffer is at the far value 1.
class RegionTest : public GlTest {
  protected:
    void SetUp() override;
};

}  // namespace conformance
