// SPDX-License-Identifier: MIT
// Commands that need objects have no effect under a query of no samples: blits, indirect draws, compute,
// transform feedback (COND-18, COND-22).
#include <array>
#include <vector>

#include "harness/objects.h"
#include "nv_conditional_render/conditional_test.h"

namespace conformance {
namespace {

class DiscardedObjects : public ConditionalTest {};

// A buffer object that goes with its scope; bound to <target> while it lives.
class Buffer {
  public:
    Buffer(GLenum target, GLsizeiptr bytes, const void* data) {
        glGenBuffers(1, &name_);
        glBindBuffer(target, name_);
        glBufferData(target, bytes, data, GL_STATIC_DRAW);
    }
    ~Buffer() { glDeleteBuffers(1, &name_); }
    Buffer(const Buffer&) = delete;
    Buffer& operator=(const Buffer&) = delete;
    GLuint name() const { return name_; }

  private:
    GLuint name_ = 0;
};

constexpr GLfloat kSize = kSurfaceSize;
constexpr std::array<GLfloat, 12> kCorners = {0,     0,     kNear, kSize, 0,     kNear,
                                              kSize, kSize, kNear, 0,     kSize, kNear};

// COND-18. 2.X: "BlitFramebuffer" has no effect.
TEST_F(DiscardedObjects, blits) {
    const Framebuffer source({});
    clear();
    draw_rect({0, 0, 10, 10}, kNear);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    const auto blit = [&] {
        glBindFramebuffer(GL_READ_FRAMEBUFFER, source.name());
        glBlitFramebuffer(0, 0, 16, 16, 0, 0, 16, 16, GL_COLOR_BUFFER_BIT, GL_NEAREST);
        glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
    };
    glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
    expect_drawing_discarded(blit, 100);
}

// COND-18. GL 4.5, 10.9: all commands of 2.4, among them the indirect draws.
TEST_F(DiscardedObjects, indirect_draws) {
    if (const auto why = lacks(40, "GL_ARB_draw_indirect")) GTEST_SKIP() << *why;
    constexpr std::array<GLuint, 4> arrays = {4, 1, 0, 0};  // count, instances, first, base instance
    constexpr std::array<GLuint, 5> elements = {4, 1, 0, 0,
                                                0};  // count, instances, first, base vertex, base instance
    constexpr std::array<GLubyte, 4> order = {0, 1, 2, 3};
    const Buffer vertices(GL_ARRAY_BUFFER, sizeof kCorners, kCorners.data());
    const Buffer indices(GL_ELEMENT_ARRAY_BUFFER, sizeof order, order.data());
    glEnableClientState(GL_VERTEX_ARRAY);
    glVertexPointer(3, GL_FLOAT, 0, nullptr);
    const bool many = !lacks(43, "GL_ARB_multi_draw_indirect");
    {
        const Buffer commands(GL_DRAW_INDIRECT_BUFFER, sizeof arrays, arrays.data());
        expect_drawing_discarded([] { glDrawArraysIndirect(GL_QUADS, nullptr); }, kWhole.area());
        if (many) {
            expect_drawing_discarded([] { glMultiDrawArraysIndirect(GL_QUADS, nullptr, 1, 0); },
                                     kWhole.area());
        }
    }
    const Buffer commands(GL_DRAW_INDIRECT_BUFFER, sizeof elements, elements.data());
    expect_drawing_discarded([] { glDrawElementsIndirect(GL_QUADS, GL_UNSIGNED_BYTE, nullptr); },
                             kWhole.area());
    if (many) {
        expect_drawing_discarded(
            [] { glMultiDrawElementsIndirect(GL_QUADS, GL_UNSIGNED_BYTE, nullptr, 1, 0); }, kWhole.area());
    }
}

// COND-18. 2.X: "DispatchCompute*" have no effect.
TEST_F(DiscardedObjects, compute_dispatches) {
    if (const auto why = lacks(43)) GTEST_SKIP() << *why;
    const char* const source =
        "#version 430\n"
        "layout(local_size_x = 1) in;\n"
        "layout(std430, binding = 0) buffer Runs { uint runs; };\n"
        "void main() { atomicAdd(runs, 1u); }\n";
    const GLuint program = glCreateShaderProgramv(GL_COMPUTE_SHADER, 1, &source);
    const auto dispatch = [&](auto command) {
        glUseProgram(program);
        command();
        glUseProgram(0);
    };
    constexpr GLuint zero = 0;
    constexpr std::array<GLuint, 3> groups = {5, 1, 1};
    const Buffer runs(GL_SHADER_STORAGE_BUFFER, sizeof zero, &zero);
    const Buffer commands(GL_DISPATCH_INDIRECT_BUFFER, sizeof groups, groups.data());
    const auto reset = [&] { glBufferSubData(GL_SHADER_STORAGE_BUFFER, 0, sizeof zero, &zero); };
    const auto look = [] {
        glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
        glFinish();
        GLuint value = kUntouched;
        glGetBufferSubData(GL_SHADER_STORAGE_BUFFER, 0, sizeof value, &value);
        return value;
    };
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, runs.name());
    expect_discarded(
        reset, [&] { dispatch([] { glDispatchCompute(5, 1, 1); }); }, look, 0u, 5u);
    expect_discarded(
        reset, [&] { dispatch([] { glDispatchComputeIndirect(0); }); }, look, 0u, 5u);
    glDeleteProgram(program);
}

// COND-22. GL 4.5, 10.9: a discarded draw has no effect: nothing is captured, no primitive is counted.
TEST_F(DiscardedObjects, transform_feedback_captures_and_counts_nothing) {
    constexpr GLfloat untouched = -7.0f;
    const std::array<GLfloat, 12> before = {untouched, untouched, untouched, untouched, untouched, untouched,
                                            untouched, untouched, untouched, untouched, untouched, untouched};
    const Program program({.vertex = kFixedVertexSource});
    const char* const varying = "gl_Position";
    glTransformFeedbackVaryings(program.name(), 1, &varying, GL_INTERLEAVED_ATTRIBS);
    glLinkProgram(program.name());
    glUseProgram(program.name());
    const Buffer captured(GL_TRANSFORM_FEEDBACK_BUFFER, sizeof before, before.data());
    glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, captured.name());
    const Query written(GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN);
    const Query generated(GL_PRIMITIVES_GENERATED);
    for (const auto outcome : {Answered::kHidden, Answered::kVisible}) {
        glUseProgram(0);
        const Answered query(outcome);
        glUseProgram(program.name());
        const GLuint expected = outcome == Answered::kVisible ? 1u : 0u;
        EXPECT_EQ(generated.count([&] {
            EXPECT_EQ(written.count([&] {
                glBeginTransformFeedback(GL_TRIANGLES);
                under(query, GL_QUERY_WAIT, [] { draw_triangle(kNear); });
                glEndTransformFeedback();
            }),
                      expected);
        }),
                  expected);
        std::array<GLfloat, 12> after{};
        glGetBufferSubData(GL_TRANSFORM_FEEDBACK_BUFFER, 0, sizeof after, after.data());
        EXPECT_EQ(after == before, outcome == Answered::kHidden);
    }
}

// COND-18. GL 4.5, 13.2.3: DrawTransformFeedback is a draw like any other.
TEST_F(DiscardedObjects, drawing_what_was_captured) {
    if (const auto why = lacks(40, "GL_ARB_transform_feedback2")) GTEST_SKIP() << *why;
    GLuint feedback = 0;
    glGenTransformFeedbacks(1, &feedback);
    glBindTransformFeedback(GL_TRANSFORM_FEEDBACK, feedback);
    const Buffer captured(GL_TRANSFORM_FEEDBACK_BUFFER, 256, nullptr);
    glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, captured.name());
    {
        const Program program({.vertex = kFixedVertexSource});
        const char* const varying = "gl_Position";
        glTransformFeedbackVaryings(program.name(), 1, &varying, GL_INTERLEAVED_ATTRIBS);
        glLinkProgram(program.name());
        glUseProgram(program.name());
        glBeginTransformFeedback(GL_POINTS);
        for (const int x : {3, 5, 9}) draw_point(x, x, kNear);
        glEndTransformFeedback();
    }
    const Buffer vertices(GL_ARRAY_BUFFER, sizeof kCorners, kCorners.data());
    const std::array<GLfloat, 9> points = {3.5f, 3.5f, kNear, 5.5f, 5.5f, kNear, 9.5f, 9.5f, kNear};
    glBufferSubData(GL_ARRAY_BUFFER, 0, sizeof points, points.data());
    glEnableClientState(GL_VERTEX_ARRAY);
    glVertexPointer(3, GL_FLOAT, 0, nullptr);
    expect_drawing_discarded([&] { glDrawTransformFeedback(GL_POINTS, feedback); }, 3);
    glBindTransformFeedback(GL_TRANSFORM_FEEDBACK, 0);
    glDeleteTransformFeedbacks(1, &feedback);
}

}  // namespace
}  // namespace conformance
