// SPDX-License-Identifier: MIT
// What a boolean query says (AOQ2-02, AOQ2-03, AOQ2-08, AOQ2-09, AOQ2-12) and conditional rendering by it
// (AOQ2-14).
#include "arb_occlusion_query2/any_test.h"

namespace conformance {
namespace {

class AnyResult : public EachAnyTest {};

INSTANTIATE_TEST_SUITE_P(, AnyResult, ::testing::ValuesIn(kBooleanTargets), target_name);

constexpr Rect kRect = {3, 5, 20, 10};

// AOQ2-02. ARB_occlusion_query2, 4.1.6: "the samples-boolean state is set to TRUE if any fragment or sample
// passes the depth test", and "is written to the corresponding query object as the query result value".
TEST_P(AnyResult, however_many_samples_pass_the_result_is_one) {
    draw_occluder();
    const Query query(target());
    EXPECT_EQ(query.count([] { draw_point(40, 40, kNear); }), 1u);
    EXPECT_EQ(query.count([] { draw_rect(kWhole, kNear); }), 1u);
    EXPECT_EQ(query.count([] {
        for (int i = 0; i < 100; ++i) draw_point(i % kSurfaceSize, 3, kNear / 2);
    }),
              1u);
}

// AOQ2-02, AOQ2-08. ARB_ES3_compatibility, 4.1.7: a conservative one may be TRUE "in some other
// implementation-dependent cases"; around nothing it is FALSE, for no fragment is there to be mistaken.
TEST_P(AnyResult, where_no_sample_passes_the_result_is_zero) {
    draw_occluder();
    const Query query(target());
    const GLuint occluded = query.count([] { draw_rect(kRect, kFar); });
    EXPECT_LE(occluded, is_conservative() ? 1u : 0u);
    EXPECT_EQ(query.count([] {}), 0u);
}

// AOQ2-08. ARB_ES3_compatibility, 4.1.7: "at the expense of false positives": there are no false negatives.
TEST_P(AnyResult, one_visible_sample_anywhere_is_not_missed) {
    draw_occluder();
    const Query query(target());
    for (int at = 0; at < kSurfaceSize; at += 7) {
        EXPECT_EQ(query.count([at] {
            draw_rect(kWhole, kFar);
            draw_point(at, kSurfaceSize - 1 - at, kNear);
            draw_rect(kWhole, kFar);
        }),
                  1u)
            << at;
    }
}

// AOQ2-09. EXT_occlusion_query_boolean, issue 13, of applying the less precise test at random: "No. This
// would violate the GL repeatability principle."
TEST_P(AnyResult, the_same_commands_give_the_same_result) {
    const Query query(target());
    const auto behind_a_half = [&](int column) {
        clear();
        glEnable(GL_DEPTH_TEST);
        draw_rect({0, 0, kSurfaceSize / 2, kSurfaceSize}, kMiddle);
        return query.count([column] { draw_rect({column, 8, 8, 8}, kFar); });
    };
    for (const int column : {0, 20, 25, 31, 32, 40}) {
        const GLuint first = behind_a_half(column);
        if (column > 24) {
            EXPECT_EQ(first, 1u) << "visible from column " << column;
        }
        for (int again = 0; again < 5; ++again) EXPECT_EQ(behind_a_half(column), first) << column;
    }
}

// AOQ2-12. ARB_occlusion_query2, 4.1.6: the state is set when a sample passes; what covers it afterwards does
// not set it back.
TEST_P(AnyResult, what_passed_and_was_covered_later_has_passed) {
    clear();
    glEnable(GL_DEPTH_TEST);
    const Query query(target());
    EXPECT_EQ(query.count([] {
        draw_rect(kRect, kFar);
        draw_rect(kWhole, kNear);
    }),
              1u);
    EXPECT_EQ(query.count([] {
        draw_rect(kRect, kNear / 2);
        clear();
    }),
              1u);
    draw_rect(kWhole, 0.0f);
    EXPECT_EQ(query.result(), 1u);
}

// AOQ2-03. ARB_timer_query, 6.1.12: a result is read by four commands; GL 4.5, 2.2.2: TRUE is 1 to each.
TEST_P(AnyResult, every_get_gives_the_same_boolean) {
    for (const GLuint expected : {1u, 0u}) {
        const Query query(target());
        EXPECT_EQ(query.count([=] {
            if (expected == 1) draw_rect(kRect, kMiddle);
        }),
                  expected);
        GLint narrow = -1;
        GLint64 wide_signed = -1;
        GLuint64 wide = kUntouched;
        glGetQueryObjectiv(query.name(), GL_QUERY_RESULT, &narrow);
        glGetQueryObjecti64v(query.name(), GL_QUERY_RESULT, &wide_signed);
        glGetQueryObjectui64v(query.name(), GL_QUERY_RESULT, &wide);
        EXPECT_EQ(narrow, static_cast<GLint>(expected));
        EXPECT_EQ(wide_signed, static_cast<GLint64>(expected));
        EXPECT_EQ(wide, expected);
    }
}

// AOQ2-14. ARB_occlusion_query2, 2.15: rendering commands are discarded "if the result (ANY_SAMPLES_PASSED)
// is false", and are not "if the result is true".
TEST_P(AnyResult, conditional_rendering_goes_by_the_boolean) {
    draw_occluder();
    const Query query(target());
    for (const bool visible : {true, false}) {
        glClear(GL_COLOR_BUFFER_BIT);
        glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
        const GLuint result = query.count([=] {
            if (visible) draw_rect(kRect, kNear);
        });
        glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
        EXPECT_EQ(result, visible ? 1u : 0u);
        glBeginConditionalRender(query.name(), GL_QUERY_WAIT);
        draw_rect({32, 32, 8, 8}, 0.0f);
        glEndConditionalRender();
        EXPECT_TRUE(no_error());
        EXPECT_EQ(drawn_pixels(), visible ? 8 * 8 : 0);
        glClear(GL_DEPTH_BUFFER_BIT);
    }
}

}  // namespace
}  // namespace conformance
