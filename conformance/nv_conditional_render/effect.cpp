// SPDX-License-Identifier: MIT
// When drawing is discarded: by mode, by result, by kind of query (COND-13 to COND-17, COND-23).
#include <algorithm>

#include "nv_conditional_render/conditional_test.h"

namespace conformance {
namespace {

class ConditionalEffect : public ConditionalTest {
  protected:
    // Pixels that a rectangle over everything leaves under a query.
    static int pixels_under(const Query& query, GLenum mode) {
        clear();
        under(query, mode, [] { draw_rect(kWhole, kNear); });
        return drawn_pixels();
    }
};

// COND-13. 2.X: "If <mode> is QUERY_WAIT_NV, the GL waits for the results of the query to be available and
// then uses the results to determine if subsequent rendering commands are discarded."
TEST_F(ConditionalEffect, with_wait_the_result_decides_though_nobody_has_read_it) {
    for (const auto outcome : {Answered::kHidden, Answered::kVisible}) {
        const Query query;
        query.begin();
        Answered::draw(outcome);
        query.end();
        EXPECT_EQ(pixels_under(query, GL_QUERY_WAIT), outcome == Answered::kVisible ? kWhole.area() : 0);
        EXPECT_EQ(query.result() != 0, outcome == Answered::kVisible);
    }
}

// COND-14. 2.X: all modes discard "if the result of the occlusion query is zero"; available results leave
// none of them a choice where every pixel contributed.
TEST_F(ConditionalEffect, every_mode_obeys_an_available_result) {
    const Answered hidden(Answered::kHidden);
    const Query visible;
    EXPECT_EQ(visible.count([] { draw_rect(kWhole, kNear); }), static_cast<GLuint>(kWhole.area()));
    for (const GLenum mode : kModes) {
        EXPECT_EQ(pixels_under(hidden, mode), 0) << mode;
        EXPECT_EQ(pixels_under(visible, mode), kWhole.area()) << mode;
    }
}

// COND-14, of one sample: a result is zero or it is not.
TEST_F(ConditionalEffect, a_single_sample_lets_everything_be_drawn) {
    const Query query;
    EXPECT_EQ(query.count([] { draw_rect({5, 5, 1, 1}, kNear); }), 1u);
    EXPECT_EQ(pixels_under(query, GL_QUERY_WAIT), kWhole.area());
    EXPECT_EQ(pixels_under(query, GL_QUERY_NO_WAIT), kWhole.area());
}

// COND-15. 2.X: "If <mode> is QUERY_NO_WAIT_NV, the GL may choose to unconditionally execute the subsequent
// rendering commands without waiting for the query to complete."
TEST_F(ConditionalEffect, without_waiting_a_pending_result_is_obeyed_or_all_is_drawn) {
    for (const GLenum mode : {GL_QUERY_NO_WAIT, GL_QUERY_BY_REGION_NO_WAIT}) {
        for (int round = 0; round < 20; ++round) {
            const auto outcome = round % 2 == 0 ? Answered::kHidden : Answered::kVisible;
            const Query query;
            query.begin();
            Answered::draw(outcome);
            draw_rect(kWhole, outcome == Answered::kVisible ? kNear : -1.0f);  // outside the clip volume
            query.end();
            const int pixels = pixels_under(query, mode);
            EXPECT_TRUE(pixels == kWhole.area() || (outcome == Answered::kHidden && pixels == 0)) << pixels;
        }
    }
}

// COND-16. 2.X: "If <mode> is QUERY_BY_REGION_WAIT_NV, the GL will also wait for occlusion query results and
// discard rendering commands if the result of the occlusion query is zero. [...] the rendering command
// results may not be discarded for any samples that contributed to the occlusion query sample count."
TEST_F(ConditionalEffect, by_region_every_sample_that_contributed_is_drawn) {
    for (const GLenum mode : {GL_QUERY_BY_REGION_WAIT, GL_QUERY_BY_REGION_NO_WAIT}) {
        for (const Rect& contributed : {Rect{0, 0, 64, 64}, Rect{3, 60, 2, 2}, Rect{31, 31, 2, 2}}) {
            const Query query;
            EXPECT_EQ(query.count([&] { draw_rect(contributed, kNear); }),
                      static_cast<GLuint>(contributed.area()));
            pixels_under(query, mode);
            EXPECT_EQ(drawn_pixels(contributed), contributed.area()) << mode;
        }
        EXPECT_EQ(pixels_under(Answered(Answered::kHidden), mode), 0) << mode;
    }
}

// COND-17. 2.X: "If the result (SAMPLES_PASSED) of the query is zero, or if the result (ANY_SAMPLES_PASSED or
// ANY_SAMPLES_PASSED_CONSERVATIVE) is false, all rendering commands [...] are discarded."
TEST_F(ConditionalEffect, every_occlusion_target_decides) {
    for (const GLenum target :
         {GL_SAMPLES_PASSED, GL_ANY_SAMPLES_PASSED, GL_ANY_SAMPLES_PASSED_CONSERVATIVE}) {
        if (target == GL_ANY_SAMPLES_PASSED && lacks(33, "GL_ARB_occlusion_query2")) continue;
        if (target == GL_ANY_SAMPLES_PASSED_CONSERVATIVE && lacks(43, "GL_ARB_ES3_compatibility")) continue;
        for (const GLenum mode : {GL_QUERY_WAIT, GL_QUERY_NO_WAIT}) {
            // A conservative query may be TRUE of something that failed, not of nothing at all.
            const Query nothing(target);
            EXPECT_EQ(nothing.count([] {}), 0u);
            EXPECT_EQ(pixels_under(nothing, mode), 0) << target;
            EXPECT_EQ(pixels_under(Answered(Answered::kVisible, target), mode), kWhole.area()) << target;
        }
    }
}

// COND-13, of a query that was created but never run: GL 4.5, 4.2, its result is zero.
TEST_F(ConditionalEffect, an_object_that_never_counted_discards) {
    if (const auto why = lacks(45, "GL_ARB_direct_state_access")) GTEST_SKIP() << *why;
    GLuint created = 0;
    glCreateQueries(GL_SAMPLES_PASSED, 1, &created);
    glBeginConditionalRender(created, GL_QUERY_WAIT);
    draw_rect(kWhole, kNear);
    glEndConditionalRender();
    EXPECT_EQ(drawn_pixels(), 0);
    glDeleteQueries(1, &created);
}

// COND-23. 2.X: "all rendering commands between BeginConditionalRenderNV and the corresponding
// EndConditionalRenderNV are discarded", and no others.
TEST_F(ConditionalEffect, drawing_after_the_block_is_not_conditional) {
    const Answered hidden(Answered::kHidden);
    for (int block = 0; block < 100; ++block) under(hidden, GL_QUERY_WAIT, [] { draw_rect(kWhole, kNear); });
    draw_rect({0, 2, 7, 1}, kNear);
    EXPECT_EQ(drawn_pixels(), 7);
    under(hidden, GL_QUERY_WAIT, [] { draw_rect(kWhole, kNear); });
    clear();
    draw_rect({0, 3, 8, 1}, kNear);
    EXPECT_EQ(drawn_pixels(), 8);
}

// COND-23, at the other end: a driver that collects what Begin and End draw has to draw it before the block
// begins.
TEST_F(ConditionalEffect, drawing_right_before_the_block_is_not_conditional) {
    const Answered hidden(Answered::kHidden);
    draw_rect({0, 0, 5, 1}, kNear);
    under(hidden, GL_QUERY_WAIT, [] { draw_rect(kWhole, kNear); });
    EXPECT_EQ(drawn_pixels(), 5);
}

}  // namespace
}  // namespace conformance
