// SPDX-License-Identifier: MIT
// How long a result lives and whose it is: many tests in a row, swaps, framebuffers, contexts (HP-38 to
// HP-41).
#include "harness/objects.h"
#include "hp_occlusion_test/hp_test.h"

namespace conformance {
namespace {

class ResultLifetime : public HpTest {};

// HP-38. GL 4.5, 2.1, as ARB_occlusion_query amends it: "queries and pixel read operations return state
// consistent with complete execution of all previously invoked GL commands".
TEST_F(ResultLifetime, a_read_needs_no_flush_before_it) {
    draw_occluder();
    glDepthMask(GL_FALSE);
    EXPECT_TRUE(result_of([] {
        for (int i = 0; i < 200; ++i) draw_rect(kWhole, kFar);
        draw_point(kSurfaceSize - 1, kSurfaceSize - 1, kNear);
    }));
}

// HP-39. HP, Overview: each read sets the state "up for a new bounding box test".
TEST_F(ResultLifetime, a_thousand_tests_are_independent) {
    draw_occluder();
    glDepthMask(GL_FALSE);
    unsigned random = 137;  // any seed: the extension's number
    for (int box = 0; box < 1000; ++box) {
        random = random * 1664525u + 1013904223u;  // Numerical Recipes' generator
        const bool visible = (random >> 31) != 0;
        const Rect rect = {static_cast<int>(random >> 8 & 31u), static_cast<int>(random >> 13 & 31u), 4, 4};
        ASSERT_EQ(result_of([&] { draw_rect(rect, visible ? kNear : kFar); }), visible) << "box " << box;
    }
}

// HP-40. HP, New State: only reading clears the result.
TEST_F(ResultLifetime, the_result_survives_a_swap_of_buffers) {
    pass_one_fragment();
    surface().swap();
    EXPECT_TRUE(read_result());
}

// HP-40, of the draw framebuffer.
TEST_F(ResultLifetime, the_result_survives_a_change_of_framebuffer) {
    if (const auto why = lacks(30)) GTEST_SKIP() << *why;
    pass_one_fragment();
    {
        const Framebuffer framebuffer({});
        EXPECT_TRUE(result_of([] {})) << "the result belongs to the context, not to the framebuffer";
        pass_one_fragment();
    }
    EXPECT_TRUE(read_result());
}

// HP-40, of the context's being current. GL, 2.1: state belongs to the context.
TEST_F(ResultLifetime, the_result_survives_being_not_current) {
    pass_one_fragment();
    Context::release_current();
    come_back();
    EXPECT_TRUE(read_result());

    const Surface other;
    glEnable(GL_OCCLUSION_TEST_HP);
    draw_point(0, 0, 0.0f);
    come_back(other);
    EXPECT_TRUE(test_enabled());
    glDisable(GL_OCCLUSION_TEST_HP);
    come_back();
    EXPECT_TRUE(read_result());
    EXPECT_FALSE(test_enabled());
}

// HP-40, of a test that runs across the change.
TEST_F(ResultLifetime, a_test_goes_on_over_a_change_of_surface) {
    const Surface other;
    glEnable(GL_OCCLUSION_TEST_HP);
    come_back(other);
    use_pixel_coordinates();
    clear();
    draw_rect(kWhole, kMiddle);
    come_back();
    glDisable(GL_OCCLUSION_TEST_HP);
    EXPECT_TRUE(read_result());
}

void each_context_has_its_own(const Context& here, const Context& there, const Surface& surface) {
    ASSERT_TRUE(there.make_current(surface));
    use_pixel_coordinates();
    clear();
    EXPECT_FALSE(test_enabled());
    EXPECT_FALSE(read_result());

    ASSERT_TRUE(here.make_current(surface));
    glEnable(GL_OCCLUSION_TEST_HP);
    draw_point(0, 0, 0.0f);

    ASSERT_TRUE(there.make_current(surface));
    EXPECT_FALSE(test_enabled()) << "the enable leaked into another context";
    draw_point(1, 0, 0.0f);
    EXPECT_FALSE(read_result()) << "the result leaked into another context";

    ASSERT_TRUE(here.make_current(surface));
    EXPECT_TRUE(test_enabled());
    glDisable(GL_OCCLUSION_TEST_HP);
    EXPECT_TRUE(read_result()) << "a read in another context cleared the result";
    EXPECT_TRUE(no_error());
}

// HP-41. GL, 2.1: state belongs to the context; enable and result are no object, so they are never shared.
TEST_F(ResultLifetime, two_contexts_do_not_mix) {
    const Context other;
    ASSERT_TRUE(other);
    each_context_has_its_own(context(), other, surface());
}

TEST_F(ResultLifetime, two_contexts_that_share_objects_do_not_mix) {
    const Context other({}, &context());
    ASSERT_TRUE(other);
    each_context_has_its_own(context(), other, surface());
}

// HP-41. The next context starts clean, also when it gets the address of one that died with the test enabled.
TEST_F(ResultLifetime, a_context_that_dies_with_the_test_enabled_leaves_nothing_behind) {
    for (int i = 0; i < 8; ++i) {
        const Context short_lived;
        ASSERT_TRUE(short_lived.make_current(surface()));
        EXPECT_FALSE(test_enabled());
        EXPECT_FALSE(read_result());
        use_pixel_coordinates();
        glEnable(GL_OCCLUSION_TEST_HP);
        draw_point(0, 0, 0.0f);
        Context::release_current();
    }
}

}  // namespace
}  // namespace conformance
