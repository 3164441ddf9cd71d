// SPDX-License-Identifier: MIT
// Occlusion queries while contexts and surfaces change (CTX-01, CTX-02, CTX-05 to CTX-08).
#include <cstdlib>

#include "contexts/asking.h"

namespace conformance {
namespace {

constexpr Rect kSeven = {3, 5, 7, 1};
constexpr Rect kFive = {20, 30, 1, 5};

class Current : public ContextTest {};

INSTANTIATE_TEST_SUITE_P(Each, Current, every_way(), way_name);

// CTX-01. GL 4.5, 5: "Each context has its own set of state"; 4.2: the active query object is such state.
TEST_P(Current, what_is_asked_in_one_context_is_nothing_to_another) {
    const Context other;
    asking().begin();
    ASSERT_TRUE(other.make_current(surface()));
    use_pixel_coordinates();
    EXPECT_FALSE(asking().active());
    draw_rect(kWhole, kMiddle);
    EXPECT_EQ(ask([] { draw_rect(kSeven, kMiddle); }), as_told(7));
    EXPECT_EQ(ask([] {}), 0u);
    EXPECT_TRUE(no_error());
    come_back();
    EXPECT_TRUE(asking().active());
    asking().end();
    EXPECT_EQ(asking().result(), 0u) << "what the other context drew was counted";
}

// CTX-01. The other way round: a query in the second context does not stop the one in the first.
TEST_P(Current, contexts_that_take_turns_count_each_for_itself) {
    const Context other;
    ASSERT_TRUE(other.make_current(surface()));
    use_pixel_coordinates();
    {
        const auto others = GetParam().make();
        others->begin();
        come_back();
        asking().begin();
        draw_rect(kSeven, kMiddle);
        ASSERT_TRUE(other.make_current(surface()));
        draw_rect(kFive, kMiddle);
        others->end();
        EXPECT_EQ(others->result(), as_told(5));
        come_back();
        draw_rect(kFive, kMiddle);
        asking().end();
        EXPECT_EQ(asking().result(), as_told(12));
        ASSERT_TRUE(other.make_current(surface()));
    }
    EXPECT_TRUE(no_error());
}

// CTX-02. GL 4.5, 2.5: being current or not is nothing that a command of the GL does; nothing of the state
// may change.
TEST_P(Current, a_query_outlives_being_not_current) {
    asking().begin();
    draw_rect(kSeven, kMiddle);
    for (int i = 0; i < 3; ++i) {
        Context::release_current();
        come_back();
        EXPECT_TRUE(asking().active());
    }
    draw_rect(kFive, kMiddle);
    asking().end();
    Context::release_current();
    come_back();
    EXPECT_FALSE(asking().active());
    EXPECT_EQ(asking().result(), as_told(12));
}

// CTX-05. A context's state goes with it; an address that is used again is a new context.
TEST_P(Current, a_context_that_dies_while_it_asks_leaves_nothing_behind) {
    for (int i = 0; i < 20; ++i) {
        SCOPED_TRACE(i);
        const Context next;
        ASSERT_TRUE(next.make_current(surface()));
        use_pixel_coordinates();
        EXPECT_FALSE(asking().active());
        EXPECT_EQ(ask([] {}), 0u);
        EXPECT_EQ(ask([] { draw_rect(kSeven, kMiddle); }), as_told(7));
        EXPECT_TRUE(no_error());
        const auto left = GetParam().make();
        left->begin();
        draw_rect(kWhole, kMiddle);
        if (i % 2 == 0) left->end();  // the result is left pending, else the query active
        left->leave_to_context();
        glFinish();  // without it Mesa 22.3 itself writes into a query that it freed
        Context::release_current();
    }
}

// CTX-06. Nothing in GLX or EGL forbids to close a connection while contexts live, and the process has to end
// well.
TEST_P(Current, the_connection_may_close_before_the_contexts_go) {
    ::testing::FLAGS_gtest_death_test_style = "threadsafe";
    EXPECT_EXIT(
        {
            asking().begin();
            draw_rect(kWhole, kMiddle);
            glFinish();
            close_platform();
            std::exit(0);
        },
        ::testing::ExitedWithCode(0), "");
}

// CTX-07. GL 4.5, 4.2: a query counts between its begin and its end; which surface is drawn to is no part of
// it.
TEST_P(Current, a_query_goes_on_over_a_change_of_surface) {
    const Surface other;
    asking().begin();
    draw_rect(kSeven, kMiddle);
    come_back(other);
    draw_rect(kFive, kMiddle);
    come_back();
    asking().end();
    EXPECT_EQ(asking().result(), as_told(12));
    asking().begin();
    come_back(other);
    asking().end();
    EXPECT_EQ(asking().result(), 0u);
}

// CTX-08. GL 4.5, 5: query objects are not shared; neither is the state of the HP test.
TEST_P(Current, contexts_that_share_objects_share_no_query) {
    const Context other({}, &context());
    ASSERT_TRUE(other);
    asking().begin();
    draw_rect(kSeven, kMiddle);
    ASSERT_TRUE(other.make_current(surface()));
    use_pixel_coordinates();
    EXPECT_FALSE(asking().active());
    draw_rect(kWhole, kMiddle);
    EXPECT_EQ(ask([] { draw_rect(kFive, kMiddle); }), as_told(5));
    EXPECT_TRUE(no_error());
    come_back();
    asking().end();
    EXPECT_EQ(asking().result(), as_told(7));
}

}  // namespace
}  // namespace conformance
