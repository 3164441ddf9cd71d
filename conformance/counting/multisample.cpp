// SPDX-License-Identifier: MIT
// Samples of a 4x framebuffer (CNT-33 to CNT-39). ARB 4.1.6A: "the samples-passed count increases by the
// number of samples whose coverage bit is set. However, implementations, at their discretion, are allowed to
// instead increase the samples-passed count by the value of SAMPLES if any sample in the fragment is
// covered."
#include <array>
#include <optional>

#include "counting/counters.h"

namespace conformance {
namespace {

constexpr int kSamples = 4;

class SamplesCount : public CountingTest {
  protected:
    void SetUp() override {
        ASSERT_NO_FATAL_FAILURE(CountingTest::SetUp());
        if (IsSkipped()) return;
        if (const auto why = lacks(32)) GTEST_SKIP() << *why;
        framebuffer_.emplace(Framebuffer::Shape{.samples = kSamples});
        clear();
        ASSERT_EQ(get_integer(GL_SAMPLES), kSamples);
        ASSERT_EQ(get_integer(GL_SAMPLE_BUFFERS), 1);
    }

    void TearDown() override {
        framebuffer_.reset();
        CountingTest::TearDown();
    }

    // So many samples of so many fragments are covered: the precise number, or SAMPLES for each fragment.
    static void expect_samples(std::uint64_t samples, std::uint64_t fragments, const Draw& draw) {
        expect_one_of({samples, kSamples * fragments}, draw);
    }

  private:
    std::optional<Framebuffer> framebuffer_;
};

COUNT_WITH_EACH(SamplesCount);

// CNT-33. All samples are covered: both countings agree.
TEST_P(SamplesCount, of_a_covered_pixel_every_sample_counts) {
    expect_count(kSamples * kAll, draw_whole);
    draw_occluder();
    expect_count(0, [] { draw_rect(kWhole, kFar); });
    expect_count(kSamples * kAll / 4, [] { draw_rect(kQuarter, kNear); });
}

// CNT-34. ARB, issues: "We count samples, not pixels -- even if MULTISAMPLE is disabled but SAMPLE_BUFFERS
// is 1."
TEST_P(SamplesCount, samples_count_also_where_multisample_is_disabled) {
    glDisable(GL_MULTISAMPLE);
    expect_count(kSamples * kAll, draw_whole);
    expect_count(0, [] {});
    draw_occluder();
    expect_count(0, [] { draw_rect(kWhole, kFar); });
    expect_count(kSamples * kAll, [] { draw_rect(kWhole, kNear); });
}

// CNT-35. GL 4.5, 14.9.3: SAMPLE_MASK takes samples out of the coverage.
TEST_P(SamplesCount, a_sample_mask_leaves_its_samples) {
    glEnable(GL_SAMPLE_MASK);
    for (const auto& [mask, samples] : {std::pair{0x1u, 1u}, {0x6u, 2u}, {0xFu, 4u}}) {
        glSampleMaski(0, mask);
        expect_samples(samples * kAll, kAll, draw_whole);
    }
    glSampleMaski(0, 0x0);
    expect_count(0, draw_whole);
}

// CNT-36. GL 4.5, 14.9.3: SAMPLE_COVERAGE_VALUE says which part of the samples is left.
TEST_P(SamplesCount, sample_coverage_leaves_its_part) {
    glEnable(GL_SAMPLE_COVERAGE);
    glSampleCoverage(0.5f, GL_FALSE);
    expect_samples(2 * kAll, kAll, draw_whole);
    glSampleCoverage(0.5f, GL_TRUE);
    expect_samples(2 * kAll, kAll, draw_whole);
    glSampleCoverage(1.0f, GL_FALSE);
    expect_count(kSamples * kAll, draw_whole);
    glSampleCoverage(0.0f, GL_FALSE);
    expect_count(0, draw_whole);
}

// CNT-37. GL 4.5, 14.9.3: SAMPLE_ALPHA_TO_COVERAGE: all samples at alpha 1, none at alpha 0.
TEST_P(SamplesCount, alpha_to_coverage_leaves_its_part) {
    glEnable(GL_SAMPLE_ALPHA_TO_COVERAGE);
    expect_count(kSamples * kAll, draw_whole);
    glColor4f(1.0f, 1.0f, 1.0f, 0.5f);
    expect_samples(2 * kAll, kAll, draw_whole);
    glColor4f(1.0f, 1.0f, 1.0f, 0.0f);
    expect_count(0, draw_whole);
}

// CNT-38. GL 4.5, 14.6.3: a sample is covered where its own position is inside the polygon. The triangle's
// long edge runs through the pixels of one diagonal; the positions say which of their samples lie below it.
TEST_P(SamplesCount, at_an_edge_the_samples_inside_count) {
    std::uint64_t inside = 0;
    for (GLuint sample = 0; sample < kSamples; ++sample) {
        std::array<GLfloat, 2> position{};
        glGetMultisamplefv(GL_SAMPLE_POSITION, sample, position.data());
        ASSERT_NE(position[0] + position[1], 1.0f) << "a sample lies on the edge";
        inside += position[0] + position[1] < 1.0f ? 1u : 0u;
    }
    ASSERT_GT(inside, 0u);
    constexpr std::uint64_t kBelow = kSize * (kSize - 1) / 2;  // pixels that are wholly inside
    expect_samples(kSamples * kBelow + inside * kSize, kBelow + kSize, [] { draw_triangle(kMiddle); });
}

// CNT-38. A triangle so thin that it holds no pixel's centre, but the one sample that it was laid around.
TEST_P(SamplesCount, one_covered_sample_of_a_pixel_counts) {
    std::array<GLfloat, 2> position{};
    glGetMultisamplefv(GL_SAMPLE_POSITION, 0, position.data());
    const GLfloat x = 20.0f + position[0];
    const GLfloat y = 30.0f + position[1];
    constexpr GLfloat kReach = 0.05f;
    expect_samples(1, 1, [=] {
        glBegin(GL_TRIANGLES);
        glVertex3f(x - kReach, y - kReach, kMiddle);
        glVertex3f(x + kReach, y - kReach, kMiddle);
        glVertex3f(x, y + kReach, kMiddle);
        glEnd();
    });
}

// CNT-39. GL 4.5, 14.3.1.1: sample shading runs the shader per sample; a sample still counts once.
TEST_P(SamplesCount, sample_shading_does_not_multiply_the_count) {
    if (const auto why = lacks(40, "GL_ARB_sample_shading")) GTEST_SKIP() << *why;
    glEnable(GL_SAMPLE_SHADING);
    glMinSampleShading(1.0f);
    const Program program({.vertex = kFixedVertexSource,
                           .fragment = "#version 130\n"
                                       "#extension GL_ARB_sample_shading : require\n"
                                       "void main() { gl_FragColor = vec4(float(gl_SampleID + 1)); }\n"});
    expect_count(kSamples * kAll, draw_whole);
    glEnable(GL_SAMPLE_MASK);
    glSampleMaski(0, 0x1);
    expect_samples(kAll, kAll, draw_whole);
}

// CNT-39. A shader that discards by sample leaves the others; gl_SampleID makes it run per sample by itself.
TEST_P(SamplesCount, a_sample_that_the_shader_discards_does_not_count) {
    if (const auto why = lacks(40, "GL_ARB_sample_shading")) GTEST_SKIP() << *why;
    const Program program({.vertex = kFixedVertexSource,
                           .fragment = "#version 130\n"
                                       "#extension GL_ARB_sample_shading : require\n"
                                       "void main() {\n"
                                       "    if (gl_SampleID != 2) discard;\n"
                                       "    gl_FragColor = gl_Color;\n"
                                       "}\n"});
    expect_samples(kAll, kAll, draw_whole);
}

}  // namespace
}  // namespace conformance
