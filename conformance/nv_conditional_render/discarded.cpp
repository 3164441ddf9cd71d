// SPDX-License-Identifier: MIT
// Every command of fixed function that 2.X names has no effect under a query of no samples (COND-18,
// COND-21).
#include <array>
#include <vector>

#include "nv_conditional_render/conditional_test.h"

namespace conformance {
namespace {

// 2.X: "In this case, Begin, End, all vertex array commands performing an implicit Begin and End, DrawPixels
// (section 3.6), Bitmap (section 3.7), Clear (section 4.2.3), Accum (section 4.2.4), CopyPixels
// (section 4.3.3), EvalMesh1 and EvalMesh2 (section 5.1), BlitFramebuffer, ClearBuffer*, and DispatchCompute*
// have no effect."
class Discarded : public ConditionalTest {};

// A unit square by its corners, a whole buffer large under the pixel coordinates.
constexpr GLfloat kSize = kSurfaceSize;
constexpr std::array<GLfloat, 12> kCorners = {0,     0,     kNear, kSize, 0,     kNear,
                                              kSize, kSize, kNear, 0,     kSize, kNear};
constexpr std::array<GLubyte, 4> kOrder = {0, 1, 2, 3};

TEST_F(Discarded, begin_and_end) {
    expect_drawing_discarded([] { draw_rect({4, 4, 10, 10}, kNear); }, 100);
    expect_drawing_discarded([] { draw_point(7, 7, kNear); }, 1);
    expect_drawing_discarded([] { glRecti(4, 4, 14, 14); }, 100);
}

TEST_F(Discarded, vertex_array_commands) {
    glEnableClientState(GL_VERTEX_ARRAY);
    glVertexPointer(3, GL_FLOAT, 0, kCorners.data());
    const GLint first = 0;
    const GLsizei count = 4;
    const void* indices = kOrder.data();
    const int all = kWhole.area();
    expect_drawing_discarded([] { glDrawArrays(GL_QUADS, 0, 4); }, all);
    expect_drawing_discarded([&] { glDrawElements(GL_QUADS, 4, GL_UNSIGNED_BYTE, indices); }, all);
    expect_drawing_discarded([&] { glDrawRangeElements(GL_QUADS, 0, 3, 4, GL_UNSIGNED_BYTE, indices); }, all);
    expect_drawing_discarded([&] { glMultiDrawArrays(GL_QUADS, &first, &count, 1); }, all);
    expect_drawing_discarded([&] { glMultiDrawElements(GL_QUADS, &count, GL_UNSIGNED_BYTE, &indices, 1); },
                             all);
    expect_drawing_discarded(
        [] {
            glBegin(GL_QUADS);
            for (const GLubyte corner : kOrder) glArrayElement(corner);
            glEnd();
        },
        all);
}

TEST_F(Discarded, vertex_array_commands_of_later_versions) {
    glEnableClientState(GL_VERTEX_ARRAY);
    glVertexPointer(3, GL_FLOAT, 0, kCorners.data());
    const GLsizei count = 4;
    const void* indices = kOrder.data();
    const GLint base = 0;
    const int all = kWhole.area();
    if (const auto why = lacks(32)) GTEST_SKIP() << *why;
    expect_drawing_discarded([] { glDrawArraysInstanced(GL_QUADS, 0, 4, 2); }, all);
    expect_drawing_discarded([&] { glDrawElementsInstanced(GL_QUADS, 4, GL_UNSIGNED_BYTE, indices, 2); },
                             all);
    expect_drawing_discarded([&] { glDrawElementsBaseVertex(GL_QUADS, 4, GL_UNSIGNED_BYTE, indices, 0); },
                             all);
    expect_drawing_discarded(
        [&] { glDrawRangeElementsBaseVertex(GL_QUADS, 0, 3, 4, GL_UNSIGNED_BYTE, indices, 0); }, all);
    expect_drawing_discarded(
        [&] { glDrawElementsInstancedBaseVertex(GL_QUADS, 4, GL_UNSIGNED_BYTE, indices, 1, 0); }, all);
    expect_drawing_discarded(
        [&] { glMultiDrawElementsBaseVertex(GL_QUADS, &count, GL_UNSIGNED_BYTE, &indices, 1, &base); }, all);
    if (const auto why = lacks(42, "GL_ARB_base_instance")) GTEST_SKIP() << *why;
    expect_drawing_discarded([] { glDrawArraysInstancedBaseInstance(GL_QUADS, 0, 4, 1, 0); }, all);
    expect_drawing_discarded(
        [&] { glDrawElementsInstancedBaseInstance(GL_QUADS, 4, GL_UNSIGNED_BYTE, indices, 1, 0); }, all);
    expect_drawing_discarded(
        [&] {
            glDrawElementsInstancedBaseVertexBaseInstance(GL_QUADS, 4, GL_UNSIGNED_BYTE, indices, 1, 0, 0);
        },
        all);
}

TEST_F(Discarded, the_pixel_paths) {
    const std::vector<GLubyte> white(4 * 8 * 8, 255);
    const std::vector<GLubyte> ones(8, 255);
    glRasterPos3f(16.0f, 16.0f, kNear);
    expect_drawing_discarded([&] { glDrawPixels(8, 8, GL_RGBA, GL_UNSIGNED_BYTE, white.data()); }, 64);
    expect_drawing_discarded([&] { glBitmap(8, 8, 0.0f, 0.0f, 0.0f, 0.0f, ones.data()); }, 64);
    expect_discarded(
        [] {
            clear();
            draw_rect({0, 0, 8, 8}, kNear);
        },
        [] { glCopyPixels(0, 0, 8, 8, GL_COLOR); }, [] { return drawn_pixels(); }, 64, 128);
}

TEST_F(Discarded, clears) {
    const auto white = [] { draw_rect(kWhole, kNear); };
    expect_discarded(
        white, [] { glClear(GL_COLOR_BUFFER_BIT); }, [] { return drawn_pixels(); }, kWhole.area(), 0);
    const auto depth = [] { return read_depths({0, 0, 1, 1})[0]; };
    expect_discarded([] { clear(); },
                     [] {
                         glClearDepth(0.0);
                         glClear(GL_DEPTH_BUFFER_BIT);
                     },
                     depth, 1.0f, 0.0f);
    const auto stencil = [] {
        GLubyte value = 0xAA;
        glReadPixels(0, 0, 1, 1, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, &value);
        return int{value};
    };
    expect_discarded([] { clear(); },
                     [] {
                         glClearStencil(3);
                         glClear(GL_STENCIL_BUFFER_BIT);
                     },
                     stencil, 0, 3);

    const std::array<GLfloat, 4> ones = {1.0f, 1.0f, 1.0f, 1.0f};
    const GLfloat nearest = 0.0f;
    const GLint three = 3;
    expect_drawing_discarded([&] { glClearBufferfv(GL_COLOR, 0, ones.data()); }, kWhole.area());
    expect_discarded([] { clear(); }, [&] { glClearBufferfv(GL_DEPTH, 0, &nearest); }, depth, 1.0f, 0.0f);
    expect_discarded([] { clear(); }, [&] { glClearBufferiv(GL_STENCIL, 0, &three); }, stencil, 0, 3);
    expect_discarded([] { clear(); }, [] { glClearBufferfi(GL_DEPTH_STENCIL, 0, 0.0f, 3); }, depth, 1.0f,
                     0.0f);
    expect_discarded([] { clear(); }, [] { glClearBufferfi(GL_DEPTH_STENCIL, 0, 0.0f, 3); }, stencil, 0, 3);
}

TEST_F(Discarded, evaluator_meshes) {
    constexpr std::array<GLfloat, 6> line = {0.0f, 0.5f, kNear, kSize, 0.5f, kNear};
    constexpr std::array<GLfloat, 12> square = {0, 0,     kNear, kSize, 0,     kNear,
                                                0, kSize, kNear, kSize, kSize, kNear};
    glEnable(GL_MAP1_VERTEX_3);
    glEnable(GL_MAP2_VERTEX_3);
    glMap1f(GL_MAP1_VERTEX_3, 0.0f, 1.0f, 3, 2, line.data());
    glMap2f(GL_MAP2_VERTEX_3, 0.0f, 1.0f, 3, 2, 0.0f, 1.0f, 6, 2, square.data());
    glMapGrid1f(1, 0.0f, 1.0f);
    glMapGrid2f(1, 0.0f, 1.0f, 1, 0.0f, 1.0f);
    expect_drawing_discarded([] { glEvalMesh1(GL_LINE, 0, 1); }, kSurfaceSize);
    expect_drawing_discarded([] { glEvalMesh2(GL_FILL, 0, 1, 0, 1); }, kWhole.area());
}

TEST_F(Discarded, the_accumulation_buffer) {
    const Surface accumulating({.accumulation_bits = 8});
    if (!accumulating) GTEST_SKIP() << "no surface with an accumulation buffer";
    come_back(accumulating);
    const auto returned = [] {
        clear();
        glAccum(GL_RETURN, 1.0f);
        return drawn_pixels();
    };
    expect_discarded(
        [] {
            glClearAccum(0.0f, 0.0f, 0.0f, 0.0f);
            glClear(GL_ACCUM_BUFFER_BIT);
            draw_rect(kWhole, kNear);
        },
        [] { glAccum(GL_LOAD, 1.0f); }, returned, 0, kWhole.area());
    come_back();
}

// COND-21. GL 4.5, 10.9: discarded commands "have no effect"; of errors the text says nothing. Decided: a
// command that is wrong is refused, discarded or not.
TEST_F(Discarded, a_wrong_command_is_refused_all_the_same) {
    const Answered hidden(Answered::kHidden);
    glBeginConditionalRender(hidden.name(), GL_QUERY_WAIT);
    glDrawArrays(0xFFFF, 0, 3);
    EXPECT_TRUE(error_is(GL_INVALID_ENUM));
    glDrawArrays(GL_TRIANGLES, 0, -1);
    EXPECT_TRUE(error_is(GL_INVALID_VALUE));
    glClear(0x80000000);
    EXPECT_TRUE(error_is(GL_INVALID_VALUE));
    glBegin(0xFFFF);
    EXPECT_TRUE(error_is(GL_INVALID_ENUM));
    glEndConditionalRender();
}

}  // namespace
}  // namespace conformance
