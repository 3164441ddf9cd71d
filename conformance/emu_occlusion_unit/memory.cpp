// SPDX-License-Identifier: MIT
// Shaders that write to memory: 17.3.5.1: "... they are not affected by the unit, nor are the results of
// transform feedback and of shaders that write to memory." 17.3.5.2: registers that need not be determined
// then.
#include <string>

#include "emu_occlusion_unit/unit_test.h"

namespace conformance {
namespace {

// <statement> is executed for each fragment; <declaration> says on what.
std::string writing_shader(const char* declaration, const char* statement) {
    return std::string("#version 430 compatibility\n") + declaration +
           "\nvoid main() {\n"
           "    " +
           statement +
           "\n"
           "    gl_FragColor = vec4(1.0);\n"
           "}\n";
}

// In a query of the unit, or bare. What the shader in use writes is there afterwards.
void draw_and_wait(bool is_inside) {
    if (is_inside) {
        expect_seen_or_undetermined(kMayBeUndetermined, kHalfHidden, draw_half_hidden);
    } else {
        draw_half_hidden();
    }
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
    glFinish();
}

class UnitMemory : public UnitTest {
  protected:
    void SetUp() override {
        ASSERT_NO_FATAL_FAILURE(UnitTest::SetUp());
        if (IsSkipped()) return;
        if (const auto why = lacks(43)) GTEST_SKIP() << *why;
        draw_left_occluder();
    }

    // Both counts in buffer <target>, word 0, of one execution of the shader for each fragment.
    static void expect_equal_counts(GLenum target, const std::string& shader) {
        const Program program({.vertex = kFixedVertexSource, .fragment = shader});
        GLuint buffer = 0;
        glGenBuffers(1, &buffer);
        const auto count = [&](bool is_inside) {
            const GLuint zero = 0;
            glBindBufferBase(target, 0, buffer);
            glBufferData(target, sizeof(zero), &zero, GL_DYNAMIC_READ);
            draw_depth_only_again();
            draw_and_wait(is_inside);
            GLuint counted = kUntouched;
            glGetBufferSubData(target, 0, sizeof(counted), &counted);
            return counted;
        };
        const GLuint without = count(false);
        EXPECT_EQ(without, 768u) << "the driver runs the shader before the depth test";
        EXPECT_EQ(count(true), without);
        glBindBufferBase(target, 0, 0);
        glDeleteBuffers(1, &buffer);
    }

  private:
    // The buffers as draw_left_occluder left them: the last drawing wrote its depth on the right.
    static void draw_depth_only_again() {
        glEnable(GL_SCISSOR_TEST);
        glScissor(kHalf, 0, kHalf, kSize);
        glClear(GL_DEPTH_BUFFER_BIT);
        glDisable(GL_SCISSOR_TEST);
    }
};

TEST_F(UnitMemory, buffer_variables_are_written_once_a_fragment) {
    expect_equal_counts(GL_SHADER_STORAGE_BUFFER,
                        writing_shader("layout(std430, binding = 0) buffer Counts { uint count; };",
                                       "atomicAdd(count, 1u);"));
}

TEST_F(UnitMemory, atomic_counters_are_incremented_once_a_fragment) {
    expect_equal_counts(
        GL_ATOMIC_COUNTER_BUFFER,
        writing_shader("layout(binding = 0) uniform atomic_uint count;", "atomicCounterIncrement(count);"));
}

TEST_F(UnitMemory, images_are_written_once_a_fragment) {
    GLuint image = 0;
    glGenTextures(1, &image);
    glBindTexture(GL_TEXTURE_2D, image);
    glTexStorage2D(GL_TEXTURE_2D, 1, GL_R32UI, kSize, kSize);
    const std::string shader = writing_shader("layout(r32ui, binding = 0) uniform uimage2D hits;",
                                              "imageAtomicAdd(hits, ivec2(gl_FragCoord.xy), 1u);");
    const auto hits = [&](bool is_inside) {
        const std::vector<GLuint> zeros(kAll);
        glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, kSize, kSize, GL_RED_INTEGER, GL_UNSIGNED_INT, zeros.data());
        draw_left_occluder();
        const Program program({.vertex = kFixedVertexSource, .fragment = shader});
        glBindImageTexture(0, image, 0, GL_FALSE, 0, GL_READ_WRITE, GL_R32UI);
        draw_and_wait(is_inside);
        std::vector<GLuint> values(kAll);
        glGetTexImage(GL_TEXTURE_2D, 0, GL_RED_INTEGER, GL_UNSIGNED_INT, values.data());
        return values;
    };
    const auto without = hits(false);
    EXPECT_EQ(without[10 * kSize + 10], 1u);
    EXPECT_EQ(hits(true), without);
    glDeleteTextures(1, &image);
}

}  // namespace
}  // namespace conformance
