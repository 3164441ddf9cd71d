// SPDX-License-Identifier: MIT
// The samples-passed count beside the colour buffer, and what happens around a running query (ARB-49 to
// ARB-54).
#include "arb_occlusion_query/arb_test.h"
#include "harness/objects.h"

namespace conformance {
namespace {

class Counting : public ArbTest {};

// ARB-49. ARB 4.1.6A: "the samples-passed count increases by 1 for each fragment" that passes the depth test.
TEST_F(Counting, the_count_is_the_number_of_pixels_drawn) {
    draw_occluder();
    const Query query;
    const GLuint near = query.count([] { draw_rect({3, 5, 20, 10}, kNear); });
    EXPECT_EQ(near, 20u * 10u);
    EXPECT_EQ(drawn_pixels(), 20 * 10);
    EXPECT_EQ(query.count([] { draw_rect({3, 5, 20, 10}, kFar); }), 0u);
    EXPECT_EQ(query.count([] {
        draw_rect({0, 0, 64, 64}, kNear);  // fails where the first rectangle stands
        draw_rect({0, 0, 64, 64}, kFar);
    }),
              64u * 64u - 20u * 10u);
    EXPECT_EQ(drawn_pixels(), 64 * 64);
}

// ARB-49. ARB, issues: "We are counting immediately after _both_ the depth and stencil tests, i.e., samples
// that pass both."; earlier tests remove fragments.
TEST_F(Counting, each_fragment_test_takes_its_share) {
    const Query query;
    const auto whole = [&] { return query.count([] { draw_rect(kWhole, kMiddle); }); };
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, 0, 32, 32);
    EXPECT_EQ(whole(), 32u * 32u);
    glDisable(GL_SCISSOR_TEST);
    glEnable(GL_STENCIL_TEST);
    glStencilFunc(GL_EQUAL, 1, 0xFF);
    EXPECT_EQ(whole(), 0u);
    glDisable(GL_STENCIL_TEST);
    glEnable(GL_ALPHA_TEST);
    glAlphaFunc(GL_LESS, 0.5f);
    EXPECT_EQ(whole(), 0u);
    glDisable(GL_ALPHA_TEST);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    EXPECT_EQ(whole(), 64u * 64u);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

// ARB-49. A clear draws no fragments.
TEST_F(Counting, a_clear_does_not_count) {
    const Query query;
    EXPECT_EQ(query.count([] { clear(); }), 0u);
}

// ARB-51. ARB_timer_query, issue 6: queries of different targets may be active at the same time.
TEST_F(Counting, queries_of_different_targets_do_not_disturb_each_other) {
    if (const auto why = lacks(33)) GTEST_SKIP() << *why;
    const Query samples;
    const Query time(GL_TIME_ELAPSED);
    const Query primitives(GL_PRIMITIVES_GENERATED);
    samples.begin();
    time.begin();
    primitives.begin();
    draw_triangle(kMiddle);
    time.end();
    samples.end();
    draw_triangle(kMiddle);
    primitives.end();
    EXPECT_EQ(samples.result(), static_cast<GLuint>(drawn_pixels()));
    EXPECT_GT(samples.result(), 0u);
    EXPECT_EQ(primitives.result(), 2u);
    EXPECT_GT(time.result(), 0u);
    EXPECT_TRUE(no_error());
}

// ARB-52. ARB, New State: no state of a query has an attribute group.
TEST_F(Counting, the_attribute_stack_does_not_touch_the_active_query) {
    const Query query;
    EXPECT_EQ(query.count([&] {
        glPushAttrib(GL_ALL_ATTRIB_BITS);
        draw_samples(3);
        glPopAttrib();
        EXPECT_EQ(current_query(GL_SAMPLES_PASSED), static_cast<GLint>(query.name()));
        draw_samples(4);
    }),
              7u);
    glPushAttrib(GL_ALL_ATTRIB_BITS);
    query.begin();
    glPopAttrib();
    EXPECT_EQ(current_query(GL_SAMPLES_PASSED), static_cast<GLint>(query.name()));
    query.end();
}

// ARB-53. NewList, EndList and CallList are no part of a query's state.
TEST_F(Counting, a_query_goes_on_while_lists_are_compiled_and_called) {
    const Query query;
    const GLuint list = glGenLists(1);
    EXPECT_EQ(query.count([list] {
        draw_samples(3);
        glNewList(list, GL_COMPILE);
        draw_samples(40);
        glEndList();
        draw_samples(4);
        glCallList(list);
    }),
              3u + 4u + 40u);
}

// ARB-53. A flush, a finish or a swap inside a query is no end of it.
TEST_F(Counting, a_query_goes_on_over_flush_finish_and_swap) {
    const Query query;
    EXPECT_EQ(query.count([&] {
        draw_samples(1);
        glFlush();
        draw_samples(2);
        glFinish();
        draw_samples(4);
        surface().swap();
        draw_samples(8);
    }),
              15u);
}

// ARB-53. The active query is state of the context: being not current does not end it.
TEST_F(Counting, a_query_goes_on_when_the_context_is_current_again) {
    const Query query;
    const Context other;
    EXPECT_EQ(query.count([&] {
        draw_samples(3);
        ASSERT_TRUE(other.make_current(surface()));
        use_pixel_coordinates();
        draw_rect(kWhole, kMiddle);
        EXPECT_EQ(current_query(GL_SAMPLES_PASSED), 0);
        come_back();
        draw_samples(4);
    }),
              7u);
}

// ARB-54. A context may die at any time; what was active dies with it.
TEST_F(Counting, a_context_may_die_with_its_query_active) {
    for (int i = 0; i < 4; ++i) {
        const Context short_lived;
        ASSERT_TRUE(short_lived.make_current(surface()));
        EXPECT_EQ(current_query(GL_SAMPLES_PASSED), 0);
        use_pixel_coordinates();
        glBeginQuery(GL_SAMPLES_PASSED, 1);
        draw_samples(64);
        EXPECT_TRUE(no_error());
        glFinish();  // Mesa 22.3 frees an active query while its rasteriser still counts into it
        Context::release_current();
    }
    come_back();
    const Query query;
    EXPECT_EQ(query.count([] { draw_samples(5); }), 5u);
}

}  // namespace
}  // namespace conformance
