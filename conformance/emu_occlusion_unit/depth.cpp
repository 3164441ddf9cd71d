// SPDX-License-Identifier: MIT
// The depth test and the depth of a sample: functions, masks, the far end, and what changes a depth.
#include <algorithm>

#include "emu_occlusion_unit/unit_test.h"

namespace conformance {
namespace {

class UnitDepth : public UnitTest {
  protected:
    // Three columns of pixels: nearer than, equal to and farther than what is drawn at kMiddle.
    static void draw_steps() {
        clear();
        glEnable(GL_DEPTH_TEST);
        glDepthFunc(GL_ALWAYS);
        glDepthMask(GL_TRUE);
        draw_rect({0, 0, 16, kSize}, kNear);
        draw_rect({16, 0, 16, kSize}, kMiddle);
        draw_rect({32, 0, 16, kSize}, kFar);
    }
};

struct Function {
    GLenum function;
    Rect visible;
};

constexpr Rect kSteps = {0, 4, 48, 8};
constexpr std::array<Function, 7> kConnected = {{{GL_NEVER, {0, 0, 0, 0}},
                                                 {GL_LESS, {32, 4, 16, 8}},
                                                 {GL_LEQUAL, {16, 4, 32, 8}},
                                                 {GL_EQUAL, {16, 4, 16, 8}},
                                                 {GL_GEQUAL, {0, 4, 32, 8}},
                                                 {GL_GREATER, {0, 4, 16, 8}},
                                                 {GL_ALWAYS, {0, 4, 48, 8}}}};

// 17.3.5.1: "a sample that passes the depth test is visible"; 17.3.5.2: functions that need not be
// determined.
TEST_F(UnitDepth, every_depth_function_decides_what_is_visible) {
    for (const GLboolean mask : {GL_TRUE, GL_FALSE}) {
        for (const Function& one : kConnected) {
            SCOPED_TRACE(error_name(one.function));
            draw_steps();
            glDepthFunc(one.function);
            glDepthMask(mask);
            Seen expected = seen(48 * 8, one.visible, kMiddle);
            if (one.visible.area() == 0) expected = hidden(48 * 8);
            const bool is_against = one.function == GL_GREATER || one.function == GL_GEQUAL;
            expect_seen_or_undetermined(is_against ? GL_NEAREST_DEPTH_BIT_EMU : 0, expected,
                                        [] { draw_rect(kSteps, kMiddle); });
        }
    }
}

// NOTEQUAL: two columns that do not touch.
TEST_F(UnitDepth, not_equal_depths_are_visible) {
    draw_steps();
    glDepthFunc(GL_NOTEQUAL);
    expect_seen_or_undetermined(GL_NEAREST_DEPTH_BIT_EMU,
                                {.projected = 384, .visible = 256, .nearest = kMiddle, .box = {0, 4, 47, 11}},
                                [] { draw_rect(kSteps, kMiddle); });
}

// 17.3.5.2: a register that is not determined is missing from all of its places; the others hold.
TEST_F(UnitDepth, an_undetermined_depth_is_an_error_and_never_a_number) {
    draw_steps();
    glDepthFunc(GL_NOTEQUAL);
    const Query query;
    begin_unit(kAllRegisters, query.name());
    draw_rect(kSteps, kMiddle);
    end_unit();
    EXPECT_TRUE(no_error()) << "drawing raises no error";
    const bool is_determined = (get_unit(query.name(), GL_REGISTERS_EMU) & GL_NEAREST_DEPTH_BIT_EMU) != 0;
    const GLuint bits = get_unit(query.name(), GL_NEAREST_DEPTH_EMU);
    EXPECT_TRUE(error_is(is_determined ? GL_NO_ERROR : GL_INVALID_OPERATION));
    EXPECT_EQ(bits != kUntouched, is_determined);
    EXPECT_EQ(get_unit(query.name(), GL_VISIBLE_HITS_EMU), 256u);
    EXPECT_EQ(get_unit(query.name(), GL_PROJECTED_HITS_EMU), 384u);
}

// 17.3.5.1: "Where the depth test is disabled ... every sample that reaches the test is visible", with its
// depth.
TEST_F(UnitDepth, without_a_depth_test_everything_is_visible) {
    draw_steps();
    glDisable(GL_DEPTH_TEST);
    expect_seen(seen(48 * 8, kSteps, kMiddle), [] { draw_rect(kSteps, kMiddle); });
}

// 17.3.5.1: "whether or not it is written".
TEST_F(UnitDepth, the_depth_mask_does_not_matter) {
    for (const GLboolean mask : {GL_TRUE, GL_FALSE}) {
        draw_left_occluder();
        glDepthMask(mask);
        expect_seen(kHalfHidden, draw_half_hidden);
    }
    glDepthMask(GL_TRUE);
}

// 17.3.5.1: "With ONE the nearer of two depths is the smaller, with ZERO, for reversed depth, the larger."
TEST_F(UnitDepth, with_reversed_depth_the_nearest_is_the_largest) {
    far_depth(GL_ZERO);
    glDepthFunc(GL_GREATER);
    glEnable(GL_DEPTH_TEST);
    for (const bool is_ascending : {true, false}) {
        clear(0.0f);
        draw_rect(kLeft, kMiddle);
        const Seen expected = {
            .projected = 2 * 512, .visible = 256 + 512, .nearest = kFar, .box = {16, 8, 47, 39}};
        expect_seen(expected, [&] {
            draw_rect({16, 8, 32, 16}, is_ascending ? kNear : kFar);
            draw_rect({16, 24, 32, 16}, is_ascending ? kFar : kNear);
        });
    }
    clear(0.0f);
    draw_rect(kLeft, kMiddle);
    expect_seen({.projected = 512, .nearest = 0.0f}, [] { draw_rect({0, 8, 32, 16}, kNear); });
    far_depth(GL_ONE);
}

// 17.3.5.1: "A query uses the value of FAR_DEPTH_EMU at its begin."
TEST_F(UnitDepth, the_far_end_is_that_of_the_begin) {
    glDisable(GL_DEPTH_TEST);
    const auto draw_both = [] {
        draw_rect({0, 0, 4, 4}, kNear);
        draw_rect({0, 0, 4, 4}, kFar);
    };
    Seen expected = {.projected = 32, .visible = 32, .nearest = kNear, .box = {0, 0, 3, 3}};
    expect_seen(expected, [&] {
        far_depth(GL_ZERO);
        draw_both();
    });
    expected.nearest = kFar;
    expect_seen(expected, [&] {
        far_depth(GL_ONE);
        draw_both();
    });
}

// 17.3.5.1: "the value that the depth buffer holds when the sample's depth is written to it": bit by bit what
// ReadPixels returns. A plane whose every pixel has another depth; its smallest is the first column's.
TEST_F(UnitDepth, the_nearest_depth_is_bit_by_bit_what_the_buffer_holds) {
    glEnable(GL_DEPTH_TEST);
    for (const float slope : {0.009f, -0.0071f}) {
        clear();
        const Record record = ask(kAllRegisters, [&] {
            glBegin(GL_QUADS);
            for (const auto& [x, y] : {std::pair{3, 5}, {50, 5}, {50, 21}, {3, 21}}) {
                glVertex3f(static_cast<GLfloat>(x), static_cast<GLfloat>(y),
                           kMiddle + slope * static_cast<GLfloat>(x) + 0.001f * static_cast<GLfloat>(y));
            }
            glEnd();
        });
        const auto depths = read_depths({3, 5, 47, 16});
        EXPECT_EQ(record.nearest_depth, *std::ranges::min_element(depths));
        EXPECT_EQ(record.visible_hits, 47u * 16u);
    }
}

// The same where nothing is written.
TEST_F(UnitDepth, an_unwritten_depth_is_the_same_number) {
    glEnable(GL_DEPTH_TEST);
    const auto draw = [] {
        glBegin(GL_TRIANGLES);
        glVertex3f(1.0f, 2.0f, 0.31f);
        glVertex3f(60.0f, 7.0f, 0.77f);
        glVertex3f(13.0f, 55.0f, 0.53f);
        glEnd();
    };
    glDepthMask(GL_FALSE);
    const Record unwritten = ask(kAllRegisters, draw);
    glDepthMask(GL_TRUE);
    draw();
    const auto depths = read_depths();
    EXPECT_EQ(unwritten.nearest_depth, *std::ranges::min_element(depths));
}

// 17.3.5.1: "It includes depth range, polygon offset, depth clamping".
TEST_F(UnitDepth, the_depth_range_moves_the_depth) {
    glEnable(GL_DEPTH_TEST);
    glDepthRange(0.5, 1.0);
    expect_seen(seen(16, {8, 8, 4, 4}, 0.625f), [] { draw_rect({8, 8, 4, 4}, kNear); });
    glDepthRange(1.0, 0.0);
    clear();
    expect_seen(seen(16, {8, 8, 4, 4}, kFar), [] { draw_rect({8, 8, 4, 4}, kNear); });
    glDepthRange(0.0, 1.0);
}

TEST_F(UnitDepth, polygon_offset_moves_the_depth_and_what_is_visible) {
    draw_left_occluder();
    glEnable(GL_POLYGON_OFFSET_FILL);
    constexpr int kUnits = 1024;  // of the smallest step that the format resolves
    glPolygonOffset(0.0f, -kUnits);
    const Rect across = {16, 8, 32, 8};
    Record record = ask(kAllRegisters, [&] { draw_rect(across, kMiddle); });
    Seen expected = seen(256, across, read_depths({16, 8, 1, 1}).front());
    EXPECT_LT(expected.nearest, kMiddle);
    EXPECT_GT(expected.nearest, kMiddle - 4 * kUnits * kDepthStep24);
    expect_record(record, kAllRegisters, expected);
    EXPECT_EQ(record.nearest_depth, expected.nearest);
    glPolygonOffset(0.0f, kUnits);
    record = ask(kAllRegisters, [] { draw_rect({16, 32, 32, 8}, kMiddle); });
    expected = seen(256, {kHalf, 32, 16, 8}, read_depths({40, 32, 1, 1}).front());
    EXPECT_GT(expected.nearest, kMiddle);
    expect_record(record, kAllRegisters, expected);
    glDisable(GL_POLYGON_OFFSET_FILL);
}

TEST_F(UnitDepth, depth_clamping_keeps_what_clipping_takes) {
    glEnable(GL_DEPTH_TEST);
    const auto before_the_near_plane = [] { draw_rect({8, 8, 16, 16}, -0.5f); };
    expect_seen({}, before_the_near_plane);
    glEnable(GL_DEPTH_CLAMP);
    expect_seen(seen(256, {8, 8, 16, 16}, 0.0f), before_the_near_plane);
    glDepthFunc(GL_LEQUAL);
    expect_seen(seen(256, {40, 8, 16, 16}, 1.0f), [] { draw_rect({40, 8, 16, 16}, 1.5f); });
    glDisable(GL_DEPTH_CLAMP);
}

}  // namespace
}  // namespace conformance
