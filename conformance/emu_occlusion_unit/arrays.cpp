// SPDX-License-Identifier: MIT
// Every command that draws from arrays shows the unit the same rectangle (17.3.5.1: the unit is stepped by
// each sample, by whatever command it is drawn).
#include "emu_occlusion_unit/unit_test.h"

namespace conformance {
namespace {

struct Arrays {
    std::array<GLfloat, 18> corners = {0,  0,  kFar,  // two that no draw uses: the base is 2
                                       60, 60, kFar, 8, 8, kFar, 56, 8, kFar, 8, 24, kFar, 56, 24, kFar};
    std::array<GLushort, 4> indices = {2, 3, 4, 5};
    std::array<GLushort, 4> based = {0, 1, 2, 3};
};

// All in buffer objects, so that indirect commands find them; client arrays have a test of their own.
class UnitArrays : public UnitTest {
  protected:
    void SetUp() override {
        ASSERT_NO_FATAL_FAILURE(UnitTest::SetUp());
        if (IsSkipped()) return;
        draw_left_occluder();
        glDepthMask(GL_FALSE);
        const Arrays arrays;
        glGenBuffers(4, buffers_.data());
        glBindBuffer(GL_ARRAY_BUFFER, buffers_[0]);
        glBufferData(GL_ARRAY_BUFFER, sizeof(arrays.corners), arrays.corners.data(), GL_STATIC_DRAW);
        glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers_[1]);
        glBufferData(GL_ELEMENT_ARRAY_BUFFER, 16, arrays.indices.data(), GL_STATIC_DRAW);
        glBufferSubData(GL_ELEMENT_ARRAY_BUFFER, 8, 8, arrays.based.data());
        glEnableClientState(GL_VERTEX_ARRAY);
        glVertexPointer(3, GL_FLOAT, 0, nullptr);
    }
    void TearDown() override {
        if (buffers_[0] != 0) {
            glDisableClientState(GL_VERTEX_ARRAY);
            glDeleteBuffers(4, buffers_.data());
        }
        UnitTest::TearDown();
    }

    template <std::size_t size>
    void bind_indirect(const std::array<GLuint, size>& commands) {
        glBindBuffer(GL_DRAW_INDIRECT_BUFFER, buffers_[2]);
        glBufferData(GL_DRAW_INDIRECT_BUFFER, sizeof(commands), commands.data(), GL_STATIC_DRAW);
    }
    GLuint spare_buffer() const { return buffers_[3]; }

    static void expect_all_half_hidden(const std::vector<Draw>& draws) {
        for (std::size_t i = 0; i < draws.size(); ++i) {
            SCOPED_TRACE(i);
            expect_seen(kHalfHidden, draws[i]);
        }
    }

  private:
    std::array<GLuint, 4> buffers_{};
};

const void* const kBased = reinterpret_cast<const void*>(8);
constexpr GLenum kStrip = GL_TRIANGLE_STRIP;
constexpr GLenum kShort = GL_UNSIGNED_SHORT;

TEST_F(UnitArrays, plain_arrays_and_elements_are_seen) {
    const GLint first = 2;
    const GLsizei count = 4;
    const void* const offset = nullptr;
    expect_all_half_hidden({
        [] { glDrawArrays(kStrip, 2, 4); },
        [] { glDrawElements(kStrip, 4, kShort, nullptr); },
        [] { glDrawRangeElements(kStrip, 2, 5, 4, kShort, nullptr); },
        [&] { glMultiDrawArrays(kStrip, &first, &count, 1); },
        [&] { glMultiDrawElements(kStrip, &count, kShort, &offset, 1); },
        [] {
            glBegin(kStrip);
            for (GLint i = 2; i < 6; ++i) glArrayElement(i);
            glEnd();
        },
    });
}

// A draw of several parts is one drawing: halves side by side.
TEST_F(UnitArrays, every_part_of_a_multi_draw_is_seen) {
    const std::array<GLint, 2> firsts = {2, 3};
    const std::array<GLsizei, 2> counts = {3, 3};
    const std::array<const void*, 2> offsets = {nullptr, reinterpret_cast<const void*>(2)};
    expect_all_half_hidden({
        [&] { glMultiDrawArrays(GL_TRIANGLES, firsts.data(), counts.data(), 2); },
        [&] { glMultiDrawElements(GL_TRIANGLES, counts.data(), kShort, offsets.data(), 2); },
    });
}

TEST_F(UnitArrays, elements_with_a_base_vertex_are_seen) {
    if (const auto why = lacks(32)) GTEST_SKIP() << *why;
    const GLsizei count = 4;
    const GLint base = 2;
    expect_all_half_hidden({
        [] { glDrawElementsBaseVertex(kStrip, 4, kShort, kBased, 2); },
        [] { glDrawRangeElementsBaseVertex(kStrip, 0, 3, 4, kShort, kBased, 2); },
        [&] { glMultiDrawElementsBaseVertex(kStrip, &count, kShort, &kBased, 1, &base); },
        [] { glDrawElementsInstancedBaseVertex(kStrip, 4, kShort, kBased, 1, 2); },
    });
}

TEST_F(UnitArrays, instances_are_seen) {
    if (const auto why = lacks(42)) GTEST_SKIP() << *why;
    expect_all_half_hidden({
        [] { glDrawArraysInstanced(kStrip, 2, 4, 1); },
        [] { glDrawElementsInstanced(kStrip, 4, kShort, nullptr, 1); },
        [] { glDrawArraysInstancedBaseInstance(kStrip, 2, 4, 1, 7); },
        [] { glDrawElementsInstancedBaseInstance(kStrip, 4, kShort, nullptr, 1, 7); },
        [] { glDrawElementsInstancedBaseVertexBaseInstance(kStrip, 4, kShort, kBased, 1, 2, 7); },
    });
    Seen three_times = kHalfHidden;
    three_times.projected *= 3;
    three_times.visible *= 3;
    expect_seen(three_times, [] { glDrawArraysInstanced(kStrip, 2, 4, 3); });
    expect_seen({}, [] { glDrawArraysInstanced(kStrip, 2, 4, 0); });
}

TEST_F(UnitArrays, indirect_arrays_are_seen) {
    if (const auto why = lacks(43)) GTEST_SKIP() << *why;
    bind_indirect<8>(
        {4, 1, 2, 0, 4, 0, 2, 0});  // count, instances, first, base instance; the second draws no instance
    expect_all_half_hidden({
        [] { glDrawArraysIndirect(kStrip, nullptr); },
        [] { glMultiDrawArraysIndirect(kStrip, nullptr, 1, 0); },
        [] { glMultiDrawArraysIndirect(kStrip, nullptr, 2, 16); },
    });
}

TEST_F(UnitArrays, indirect_elements_are_seen) {
    if (const auto why = lacks(43)) GTEST_SKIP() << *why;
    bind_indirect<10>(
        {4, 1, 4, 2, 0, 4, 0, 4, 2, 0});  // count, instances, first index, base vertex, base instance
    expect_all_half_hidden({
        [] { glDrawElementsIndirect(kStrip, kShort, nullptr); },
        [] { glMultiDrawElementsIndirect(kStrip, kShort, nullptr, 2, 20); },
    });
}

// The number of draws is in a buffer too.
TEST_F(UnitArrays, indirect_draws_with_an_indirect_number_are_seen) {
    if (const auto why = lacks("GL_ARB_indirect_parameters")) GTEST_SKIP() << *why;
    const GLuint one = 1;
    glBindBuffer(GL_PARAMETER_BUFFER_ARB, spare_buffer());
    glBufferData(GL_PARAMETER_BUFFER_ARB, sizeof(one), &one, GL_STATIC_DRAW);
    bind_indirect<8>({4, 1, 2, 0, 4, 1, 2, 0});
    expect_seen(kHalfHidden, [] { glMultiDrawArraysIndirectCountARB(kStrip, nullptr, 0, 2, 0); });
    bind_indirect<10>({4, 1, 4, 2, 0, 4, 1, 4, 2, 0});
    expect_seen(kHalfHidden, [] { glMultiDrawElementsIndirectCountARB(kStrip, kShort, nullptr, 0, 2, 0); });
}

TEST_F(UnitArrays, client_arrays_are_seen) {
    const Arrays arrays;
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
    glVertexPointer(3, GL_FLOAT, 0, arrays.corners.data());
    expect_all_half_hidden({
        [] { glDrawArrays(kStrip, 2, 4); },
        [&] { glDrawElements(kStrip, 4, kShort, arrays.indices.data()); },
        [&] {
            glInterleavedArrays(GL_V3F, 0, arrays.corners.data());
            glDrawArrays(kStrip, 2, 4);
        },
    });
}

// Restart indices cut a strip in two.
TEST_F(UnitArrays, a_restarted_strip_is_seen) {
    if (const auto why = lacks(31)) GTEST_SKIP() << *why;
    const std::array<GLushort, 7> indices = {2, 3, 4, 0xFFFF, 3, 4, 5};
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, sizeof(indices), indices.data(), GL_STATIC_DRAW);
    glEnable(GL_PRIMITIVE_RESTART);
    glPrimitiveRestartIndex(0xFFFF);
    expect_seen(kHalfHidden, [] { glDrawElements(kStrip, 7, kShort, nullptr); });
    glDisable(GL_PRIMITIVE_RESTART);
}

// What a transform feedback recorded is drawn by its own commands.
TEST_F(UnitArrays, draws_of_recorded_vertices_are_seen) {
    if (const auto why = lacks(42)) GTEST_SKIP() << *why;
    const GLuint program = use_recording_program(
        "#version 130\n"
        "out vec3 corner;\n"
        "void main() { corner = gl_Vertex.xyz; gl_Position = gl_Vertex; }\n",
        "corner");
    GLuint feedback = 0;
    glGenTransformFeedbacks(1, &feedback);
    glBindTransformFeedback(GL_TRANSFORM_FEEDBACK, feedback);
    glBindBuffer(GL_TRANSFORM_FEEDBACK_BUFFER, spare_buffer());
    glBufferData(GL_TRANSFORM_FEEDBACK_BUFFER, 1024, nullptr, GL_STATIC_DRAW);
    glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, spare_buffer());
    glEnable(GL_RASTERIZER_DISCARD);
    glBeginTransformFeedback(GL_TRIANGLES);
    glDrawArrays(kStrip, 2, 4);
    glEndTransformFeedback();
    glDisable(GL_RASTERIZER_DISCARD);
    glUseProgram(0);
    glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 0);
    glBindBuffer(GL_ARRAY_BUFFER, spare_buffer());
    glVertexPointer(3, GL_FLOAT, 0, nullptr);
    expect_all_half_hidden({
        [&] { glDrawTransformFeedback(GL_TRIANGLES, feedback); },
        [&] { glDrawTransformFeedbackStream(GL_TRIANGLES, feedback, 0); },
        [&] { glDrawTransformFeedbackInstanced(GL_TRIANGLES, feedback, 1); },
        [&] { glDrawTransformFeedbackStreamInstanced(GL_TRIANGLES, feedback, 0, 1); },
    });
    glBindTransformFeedback(GL_TRANSFORM_FEEDBACK, 0);
    glDeleteTransformFeedbacks(1, &feedback);
    glDeleteProgram(program);
}

}  // namespace
}  // namespace conformance
