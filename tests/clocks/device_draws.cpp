// SPDX-License-Identifier: MIT
// What drawing takes on each clock: batches, triangles however they are told, fragments, copies of vertices,
// clears and swaps.
#include <functional>
#include <vector>

#include "device_test.h"
#include "harness/objects.h"

namespace clock_tests {
namespace {

using conformance::Framebuffer;
using conformance::kNear;
using conformance::Query;

class DeviceDraws : public DeviceTest {};

void draw_quads(int quads) {
    glBegin(GL_QUADS);
    for (int i = 0; i < quads; ++i) {
        glVertex3f(1, 1, kNear);
        glVertex3f(2, 1, kNear);
        glVertex3f(2, 2, kNear);
        glVertex3f(1, 2, kNear);
    }
    glEnd();
}

TEST_F(DeviceDraws, a_batch_takes_its_time_on_both_clocks) {
    rest();
    EXPECT_EQ(on_cpu([] { draw(3); }), kBatch);
    EXPECT_EQ(on_cpu([] { draw_batches(10, 3); }), 10 * kBatch);
    // The GPU sees the first when its command is made, and each other when the one before is done.
    rest();
    EXPECT_EQ(on_gpu([] { draw_batches(10, 3); }), kBatch + 10 * (kGpuBatch + 3 * kTriangle));
    keep_gpu_busy();
    EXPECT_EQ(on_gpu([] { draw_batches(10, 3); }), 10 * (kGpuBatch + 3 * kTriangle));
}

TEST_F(DeviceDraws, every_command_costs_the_triangles_that_it_draws) {
    static const std::vector<GLuint> indices(30, 0);
    struct Way {
        const char* name;
        std::function<void()> draw;
        int triangles;
    };
    const std::vector<Way> ways = {
        {"points", [] { glDrawArrays(GL_POINTS, 0, 9); }, 0},
        {"lines", [] { glDrawArrays(GL_LINE_STRIP, 0, 9); }, 0},
        {"triangles", [] { glDrawArrays(GL_TRIANGLES, 0, 10); }, 3},
        {"strip", [] { glDrawArrays(GL_TRIANGLE_STRIP, 0, 9); }, 7},
        {"fan", [] { glDrawArrays(GL_TRIANGLE_FAN, 0, 9); }, 7},
        {"quads", [] { glDrawArrays(GL_QUADS, 0, 9); }, 4},
        {"strip of quads", [] { glDrawArrays(GL_QUAD_STRIP, 0, 9); }, 6},
        {"polygon", [] { glDrawArrays(GL_POLYGON, 0, 9); }, 7},
        {"elements", [] { glDrawElements(GL_TRIANGLES, 9, GL_UNSIGNED_INT, indices.data()); }, 3},
        {"range", [] { glDrawRangeElements(GL_TRIANGLES, 0, 5, 9, GL_UNSIGNED_INT, indices.data()); }, 3},
        {"base", [] { glDrawElementsBaseVertex(GL_TRIANGLES, 9, GL_UNSIGNED_INT, indices.data(), 1); }, 3},
        {"instances", [] { glDrawArraysInstanced(GL_TRIANGLES, 0, 9, 5); }, 15},
        {"none", [] { glDrawArrays(GL_TRIANGLES, 0, 0); }, 0},
    };
    glEnable(GL_RASTERIZER_DISCARD);  // points and lines have fragments
    for (const Way& way : ways) {
        keep_gpu_busy();
        const GLint64 elapsed = on_gpu(way.draw);
        EXPECT_EQ(elapsed, kGpuBatch + way.triangles * kTriangle) << way.name;
        rest();
    }
    glDisable(GL_RASTERIZER_DISCARD);
}

TEST_F(DeviceDraws, a_clear_that_the_driver_refuses_costs_nothing) {
    rest();
    EXPECT_EQ(on_gpu([] {
                  glClear(0x1);
                  EXPECT_TRUE(conformance::error_is(GL_INVALID_VALUE));
              }),
              0);
}

TEST_F(DeviceDraws, what_stands_between_begin_and_end_is_counted_and_copied) {
    rest();
    EXPECT_EQ(on_cpu([] { draw_quads(3); }), kBatch + 6 * kCopiedTriangle);
    keep_gpu_busy();
    EXPECT_EQ(on_gpu([] { draw_quads(3); }), kGpuBatch + 6 * kTriangle);
    rest();
    EXPECT_EQ(on_cpu([] { draw_quads(0); }), 0);
    EXPECT_EQ(on_gpu([] { draw_quads(0); }), 0);
}

TEST_F(DeviceDraws, a_list_costs_what_it_draws_and_no_copies) {
    const GLuint list = glGenLists(2);
    rest();
    EXPECT_EQ(on_cpu([list] {
                  glNewList(list, GL_COMPILE);
                  draw_quads(3);
                  glEndList();
                  glNewList(list + 1, GL_COMPILE);
                  glEndList();
              }),
              0);
    EXPECT_EQ(on_cpu([list] { glCallList(list); }), kBatch);
    EXPECT_EQ(on_cpu([list] { glCallList(list + 1); }), 0);
    keep_gpu_busy();
    EXPECT_EQ(on_gpu([list] { glCallList(list); }), kGpuBatch + 6 * kTriangle);
    glDeleteLists(list, 2);
}

TEST_F(DeviceDraws, vertices_of_the_programs_own_memory_are_copied) {
    const std::vector<GLfloat> vertices(27, 0.0f);
    GLint buffer = 0;
    glGetIntegerv(GL_ARRAY_BUFFER_BINDING, &buffer);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    glVertexPointer(3, GL_FLOAT, 0, vertices.data());
    EXPECT_EQ(on_cpu([] { draw(3); }), kBatch + 3 * kCopiedTriangle);
    glBindBuffer(GL_ARRAY_BUFFER, static_cast<GLuint>(buffer));
    glVertexPointer(3, GL_FLOAT, 0, nullptr);
    EXPECT_EQ(on_cpu([] { draw(3); }), kBatch);
}

TEST_F(DeviceDraws, vertices_are_copied_when_buffers_do_not_fit_the_video_memory) {
    GLint kept = 0;
    glGetIntegerv(GL_ARRAY_BUFFER_BINDING, &kept);
    GLuint other = 0;
    glGenBuffers(1, &other);
    glBindBuffer(GL_ARRAY_BUFFER, other);
    glBufferData(GL_ARRAY_BUFFER, kVideoMemory, nullptr, GL_STATIC_DRAW);
    EXPECT_EQ(on_cpu([] { draw(3); }), kBatch + 3 * kCopiedTriangle);
    glBufferData(GL_ARRAY_BUFFER, 16, nullptr, GL_STATIC_DRAW);
    EXPECT_EQ(on_cpu([] { draw(3); }), kBatch);
    glBufferData(GL_ARRAY_BUFFER, kVideoMemory, nullptr, GL_STATIC_DRAW);
    EXPECT_EQ(on_cpu([] { draw(3); }), kBatch + 3 * kCopiedTriangle);
    glDeleteBuffers(1, &other);
    EXPECT_EQ(on_cpu([] { draw(3); }), kBatch);
    glBindBuffer(GL_ARRAY_BUFFER, static_cast<GLuint>(kept));
}

TEST_F(DeviceDraws, fragments_take_their_time_with_colour_and_half_of_it_without) {
    keep_gpu_busy();
    EXPECT_EQ(on_gpu([] { fill(); }), kGpuBatch + kFilled * kFragment);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    keep_gpu_busy();
    EXPECT_EQ(on_gpu([] { fill(); }), kGpuBatch + kFilled * kDepthFragment);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glEnable(GL_RASTERIZER_DISCARD);
    keep_gpu_busy();
    EXPECT_EQ(on_gpu([] { fill(); }), kGpuBatch + 2 * kTriangle);
    glDisable(GL_RASTERIZER_DISCARD);
}

TEST_F(DeviceDraws, fragments_that_the_depth_test_discards_cost_the_same) {
    glEnable(GL_DEPTH_TEST);
    conformance::clear(0.0f);
    keep_gpu_busy();
    EXPECT_EQ(on_gpu([] { fill(); }), kGpuBatch + kFilled * kFragment);
}

TEST_F(DeviceDraws, every_sample_of_a_fragment_takes_its_time) {
    const Framebuffer multisampled({.samples = 4});
    keep_gpu_busy();
    EXPECT_EQ(on_gpu([] { fill(); }), kGpuBatch + 4 * kFilled * kFragment);
    keep_gpu_busy();
    EXPECT_EQ(on_gpu([] { glClear(GL_COLOR_BUFFER_BIT); }), 4 * kWholePixels * kClearedPixel);
}

TEST_F(DeviceDraws, a_clear_costs_the_pixels_inside_the_scissor_rectangle) {
    const auto clear = [] { glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT); };
    rest();
    EXPECT_EQ(on_cpu(clear), 0);
    keep_gpu_busy();
    EXPECT_EQ(on_gpu(clear), kWholePixels * kClearedPixel);
    glEnable(GL_SCISSOR_TEST);
    glScissor(-5, 60, 15, 20);
    keep_gpu_busy();
    EXPECT_EQ(on_gpu(clear), 10 * 4 * kClearedPixel);
    glScissor(0, 0, 0, 0);
    keep_gpu_busy();
    EXPECT_EQ(on_gpu(clear), 0);
    glDisable(GL_SCISSOR_TEST);
}

TEST_F(DeviceDraws, a_swap_waits_for_all_work_and_copies_the_window) {
    GLint64 before = rest();
    surface().swap();
    EXPECT_EQ(cpu() - before, kSwap + kWholePixels * kSwappedPixel);
    before = rest();
    draw(1000);
    surface().swap();
    const GLint64 drawn = before + kBatch + kGpuBatch + 1000 * kTriangle;
    EXPECT_EQ(cpu(), drawn + kWholePixels * kSwappedPixel);
}

TEST_F(DeviceDraws, the_programs_own_work_moves_the_cpu_alone) {
    rest();
    EXPECT_EQ(on_cpu([] { work(0); }), 0);
    EXPECT_EQ(on_cpu([] { work(12'345); }), 12'345);
    // The GPU works meanwhile.
    const GLint64 before = rest();
    draw(1000);
    work(500'000);
    EXPECT_EQ(gpu(), before + kBatch + kGpuBatch + 1000 * kTriangle);
    EXPECT_EQ(on_cpu([] { work(~GLuint64{0}); }), GLint64{1} << 50);
    glBegin(GL_POINTS);
    work(1);
    glEnd();
    EXPECT_TRUE(conformance::error_is(GL_INVALID_OPERATION));
}

}  // namespace
}  // namespace clock_tests
