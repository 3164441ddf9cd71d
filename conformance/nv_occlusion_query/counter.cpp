// SPDX-License-Identifier: MIT
// The pixel counter itself: its width, what it counts, and that counting shows nowhere (NV-43 to NV-48).
#include <limits>

#include "harness/objects.h"
#include "nv_occlusion_query/nv_test.h"

namespace conformance {
namespace {

class NvCounter : public NvTest {};

GLint counter_bits() {
    return get_integer(GL_PIXEL_COUNTER_BITS_NV);
}

// NV-43. NV, New Implementation Dependent State: PIXEL_COUNTER_BITS_NV, minimum value 24.
TEST_F(NvCounter, the_counter_has_at_least_24_bits) {
    EXPECT_GE(counter_bits(), 24);
}

// NV-43. GL 4.5, 2.2.2: every Get returns the value in its own type.
TEST_F(NvCounter, every_get_returns_the_same_width_at_any_time) {
    const GLint bits = counter_bits();
    const auto expect_bits = [bits] {
        GLboolean boolean = 0xAA;
        GLfloat single = -1.0f;
        GLdouble twice = -1.0;
        glGetBooleanv(GL_PIXEL_COUNTER_BITS_NV, &boolean);
        glGetFloatv(GL_PIXEL_COUNTER_BITS_NV, &single);
        glGetDoublev(GL_PIXEL_COUNTER_BITS_NV, &twice);
        EXPECT_EQ(counter_bits(), bits);
        EXPECT_EQ(boolean, GL_TRUE);
        EXPECT_EQ(single, static_cast<GLfloat>(bits));
        EXPECT_EQ(twice, static_cast<GLdouble>(bits));
    };
    expect_bits();
    const NvQuery query;
    query.count([&] {
        draw_samples(5);
        expect_bits();
    });
    expect_bits();
    EXPECT_TRUE(no_error());
}

// NV-44. NV 4.1.6A: "It is recommended, but not required, that implementations handle this overflow case by
// saturating at 2^PIXEL_COUNTER_BITS_NV-1 and incrementing no further." Decided: saturates. Judged where an
// overflow takes less than a second.
TEST_F(NvCounter, a_counter_that_overflows_saturates) {
    const GLint bits = counter_bits();
    ASSERT_GT(bits, 0);
    if (bits > 20) GTEST_SKIP() << "a counter of " << bits << " bits takes too long to overflow";
    const NvQuery query;
    const GLuint largest = (GLuint{1} << bits) - 1;
    const auto draw = [](GLuint samples) {
        for (; samples >= 4096; samples -= 4096) draw_rect(kWhole, 0.0f);
        draw_samples(static_cast<int>(samples));
    };
    EXPECT_EQ(query.count([&] { draw(largest - 1); }), largest - 1);
    EXPECT_EQ(query.count([&] { draw(largest); }), largest);
    EXPECT_EQ(query.count([&] { draw(largest + 1); }), largest) << "wrapped to zero";
    EXPECT_EQ(query.count([&] { draw(2 * largest + 7); }), largest);
    GLint integer = -1;
    glGetOcclusionQueryivNV(query.name(), GL_PIXEL_COUNT_NV, &integer);
    EXPECT_EQ(integer, static_cast<GLint>(largest));
    EXPECT_EQ(query.count([] { draw_samples(5); }), 5u) << "the overflow outlived its query";
}

// NV-45. The two extensions have one counter: decided, the two widths agree.
TEST_F(NvCounter, both_extensions_tell_the_same_width) {
    if (const auto why = lacks(15, "GL_ARB_occlusion_query")) GTEST_SKIP() << *why;
    GLint bits = -1;
    glGetQueryiv(GL_SAMPLES_PASSED, GL_QUERY_COUNTER_BITS, &bits);
    EXPECT_EQ(bits, counter_bits());
}

// NV-46. NV, issues: "We are counting immediately after _both_ the depth and stencil tests, i.e., pixels that
// pass both"; earlier tests remove fragments, the write masks do not. The whole of section 5: counting.
TEST_F(NvCounter, each_fragment_test_takes_its_share) {
    draw_occluder();
    const NvQuery query;
    const auto near = [&] { return query.count([] { draw_rect(kWhole, kNear); }); };
    glDepthMask(GL_FALSE);
    EXPECT_EQ(near(), 4096u);
    EXPECT_EQ(query.count([] { draw_rect(kWhole, kFar); }), 0u);
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, 0, 32, 32);
    EXPECT_EQ(near(), 32u * 32u);
    glDisable(GL_SCISSOR_TEST);
    glEnable(GL_STENCIL_TEST);
    glStencilFunc(GL_EQUAL, 1, 0xFF);
    EXPECT_EQ(near(), 0u);
    glDisable(GL_STENCIL_TEST);
    glEnable(GL_ALPHA_TEST);
    glAlphaFunc(GL_LESS, 0.5f);
    EXPECT_EQ(near(), 0u);
    glDisable(GL_ALPHA_TEST);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    EXPECT_EQ(near(), 4096u);
}

// NV-47. NV 4.1.6A: "If the value of SAMPLE_BUFFERS is 1, then the pixel counter is incremented by the number
// of samples whose coverage bit is set"; issues: "This is true even if GL_MULTISAMPLE is disabled but
// GL_SAMPLE_BUFFERS is 1."
TEST_F(NvCounter, samples_are_counted_whether_multisampling_is_enabled_or_not) {
    if (const auto why = lacks(30, "GL_ARB_framebuffer_object")) GTEST_SKIP() << *why;
    const Framebuffer framebuffer({.samples = 4});
    clear();
    ASSERT_EQ(get_integer(GL_SAMPLE_BUFFERS), 1);
    const auto samples = static_cast<GLuint>(get_integer(GL_SAMPLES));
    ASSERT_GE(samples, 4u);
    const NvQuery query;
    EXPECT_EQ(query.count([] { draw_rect(kWhole, kMiddle); }), 4096u * samples);
    glDisable(GL_MULTISAMPLE);
    EXPECT_EQ(query.count([] { draw_rect(kWhole, kMiddle); }), 4096u * samples);
    glEnable(GL_MULTISAMPLE);
    EXPECT_TRUE(no_error());
}

// NV-48. NV, issues: an implementation is invariant when an active query "does not affect the operation of
// any other stage of the pipeline."
TEST_F(NvCounter, the_image_is_the_one_without_a_query) {
    const NvQuery query;
    const auto image = [&](bool counted) {
        clear();
        if (counted) query.begin();
        glEnable(GL_DEPTH_TEST);
        for (int i = 0; i < 16; ++i) {  // slanted, and through one another
            const auto x = static_cast<GLfloat>(4 * i);
            const float tilt = 0.06f * static_cast<float>(i);
            glBegin(GL_TRIANGLES);
            glColor3f(tilt, 1.0f - tilt, 0.5f);
            glVertex3f(x, 0.3f, tilt);
            glVertex3f(64.7f, x, 1.0f - tilt);
            glVertex3f(0.1f, 63.2f - x, 0.5f);
            glEnd();
        }
        glDisable(GL_DEPTH_TEST);
        if (counted) glEndOcclusionQueryNV();
        return std::pair(read_colours(), read_depths());
    };
    const auto without = image(false);
    const auto with = image(true);
    EXPECT_EQ(without.first, with.first) << "colours";
    EXPECT_EQ(without.second, with.second) << "depths";
    EXPECT_GT(query.result(), static_cast<GLuint>(drawn_pixels()) - 1u);
    EXPECT_GT(drawn_pixels(), 1000);
}

}  // namespace
}  // namespace conformance
