// SPDX-License-Identifier: MIT
// What each register holds, alone and beside the others.
#include "emu_occlusion_unit/unit_test.h"

namespace conformance {
namespace {

class Registers : public UnitTest {};

// 17.3.5.1: "<registers> has a bit for each register that is armed; the others are not kept."
TEST_F(Registers, each_register_alone_holds_its_value_and_the_others_nothing) {
    for (const GLbitfield bit : kEachRegister) {
        SCOPED_TRACE(bit);
        draw_left_occluder();
        expect_record(ask(bit, draw_half_hidden), bit, kHalfHidden);
    }
}

// 17.3.5.1: "What a register holds does not depend on which other registers are armed."
TEST_F(Registers, every_combination_holds_the_same_values) {
    for (GLbitfield armed = 1; armed <= kAllRegisters; ++armed) {
        SCOPED_TRACE(armed);
        draw_left_occluder();
        expect_record(ask(armed, draw_half_hidden), armed, kHalfHidden);
    }
}

// 17.3.5.1: "the flag and the counters to 0, NEAREST_DEPTH to the far value, and SCREEN_BOX to the empty
// rectangle".
TEST_F(Registers, a_query_without_a_drawing_is_empty) {
    expect_seen({}, [] {});
    glEnable(GL_DEPTH_TEST);
    expect_seen({}, [] { draw_rect({0, 0, 0, 0}, kNear); });
    far_depth(GL_ZERO);
    expect_seen({.nearest = 0.0f}, [] {});
    far_depth(GL_ONE);
}

// 17.3.5.1: "VISIBLE is 1 if and only if VISIBLE_HITS would not be 0"; the others are of visible samples
// only.
TEST_F(Registers, what_is_hidden_is_projected_only) {
    draw_occluder();
    expect_seen(hidden(kAll), [] { draw_rect(kWhole, kFar); });
}

TEST_F(Registers, one_visible_pixel_is_told_with_its_depth_and_place) {
    glEnable(GL_DEPTH_TEST);
    expect_seen(seen(1, {37, 5, 1, 1}, kNear), [] { draw_point(37, 5, kNear); });
    expect_seen(seen(1, {0, 0, 1, 1}, kNear), [] { draw_point(0, 0, kNear); });
    expect_seen(seen(1, {kSize - 1, kSize - 1, 1, 1}, kNear),
                [] { draw_point(kSize - 1, kSize - 1, kNear); });
}

// 17.3.5.1: "SCREEN_BOX is enlarged as far as necessary to include the pixel."
TEST_F(Registers, the_box_spans_all_visible_pixels_of_several_drawings) {
    draw_left_occluder();
    expect_seen({.projected = 3, .visible = 2, .nearest = kFar, .box = {40, 3, 60, 50}}, [] {
        draw_point(60, 3, kFar);
        draw_point(2, 60, kFar);  // hidden
        draw_point(40, 50, kFar);
    });
}

// 17.3.5.1: "NEAREST_DEPTH becomes the nearer of its value and the sample's depth", be it first or last.
TEST_F(Registers, the_nearest_of_several_drawings_counts) {
    glEnable(GL_DEPTH_TEST);
    const Rect low = {0, 0, 8, 8};
    const Rect high = {16, 16, 8, 8};
    const Seen both = {.projected = 128, .visible = 128, .nearest = kNear, .box = {0, 0, 23, 23}};
    expect_seen(both, [&] {
        draw_rect(low, kNear);
        draw_rect(high, kFar);
    });
    clear();
    expect_seen(both, [&] {
        draw_rect(low, kFar);
        draw_rect(high, kNear);
    });
}

// 17.3.5.1: the unit is stepped by each sample: also by one that a later sample of the query covers or hides.
TEST_F(Registers, a_query_sees_the_depths_that_it_writes) {
    glEnable(GL_DEPTH_TEST);
    expect_seen(
        {.projected = 2 * kAll, .visible = kAll, .nearest = kMiddle, .box = {0, 0, kSize - 1, kSize - 1}},
        [] {
            draw_rect(kWhole, kMiddle);
            draw_rect(kWhole, kFar);
        });
    clear();
    expect_seen(
        {.projected = 2 * kAll, .visible = 2 * kAll, .nearest = kNear, .box = {0, 0, kSize - 1, kSize - 1}},
        [] {
            draw_rect(kWhole, kMiddle);
            draw_rect(kWhole, kNear);
        });
}

// The same within one draw: three layers from back to front, and from front to back.
TEST_F(Registers, samples_of_one_draw_see_the_depths_of_that_draw) {
    glEnable(GL_DEPTH_TEST);
    const auto layers = [](std::array<float, 3> depths) {
        return [=] {
            glBegin(GL_QUADS);
            for (const float depth : depths) {
                glVertex3f(8.0f, 8.0f, depth);
                glVertex3f(24.0f, 8.0f, depth);
                glVertex3f(24.0f, 24.0f, depth);
                glVertex3f(8.0f, 24.0f, depth);
            }
            glEnd();
        };
    };
    expect_seen({.projected = 768, .visible = 768, .nearest = kNear, .box = {8, 8, 23, 23}},
                layers({kFar, kMiddle, kNear}));
    clear();
    expect_seen({.projected = 768, .visible = 256, .nearest = kNear, .box = {8, 8, 23, 23}},
                layers({kNear, kMiddle, kFar}));
}

// 17.3.5.1: "BeginOcclusionUnitEMU resets the armed registers".
TEST_F(Registers, a_second_query_of_an_object_starts_anew) {
    const Query query;
    draw_left_occluder();
    begin_unit(kAllRegisters, query.name());
    draw_half_hidden();
    end_unit();
    begin_unit(GL_PROJECTED_HITS_BIT_EMU | GL_SCREEN_BOX_BIT_EMU, query.name());
    draw_rect({40, 40, 2, 2}, kNear);
    end_unit();
    Record record{};
    get_records(query.name(), 0, 1, &record);
    expect_record(record, GL_PROJECTED_HITS_BIT_EMU | GL_SCREEN_BOX_BIT_EMU, seen(4, {40, 40, 2, 2}, kNear));
}

// What is drawn before and after a query, and between two of them, steps nothing.
TEST_F(Registers, queries_count_their_own_drawings_only) {
    const std::array<Query, 3> queries;
    draw_left_occluder();
    glDepthMask(GL_FALSE);
    for (const Query& query : queries) {
        draw_rect(kWhole, kNear);
        begin_unit(kAllRegisters, query.name());
        draw_half_hidden();
        end_unit();
        draw_rect(kWhole, kNear);
    }
    for (const Query& query : queries) {
        Record record{};
        get_records(query.name(), 0, 1, &record);
        expect_record(record, kAllRegisters, kHalfHidden);
    }
}

// 17.3.5.1: a query watches: colours, depths and stencil values become what they become without one.
TEST_F(Registers, what_is_drawn_is_the_same_inside_a_query) {
    const auto picture = [](bool is_inside) {
        draw_left_occluder();
        glEnable(GL_STENCIL_TEST);
        glStencilFunc(GL_ALWAYS, 0, 0xFF);
        glStencilOp(GL_KEEP, GL_INVERT, GL_INCR);
        glEnable(GL_BLEND);
        glBlendFunc(GL_ONE, GL_ONE);
        glColor4f(0.25f, 0.5f, 0.125f, 0.5f);
        const auto draw = [] {
            draw_half_hidden();
            draw_rect({20, 12, 30, 30}, kNear);
            draw_half_hidden();
        };
        if (is_inside) {
            ask(kAllRegisters, draw);
        } else {
            draw();
        }
        glDisable(GL_STENCIL_TEST);
        glDisable(GL_BLEND);
        glColor4f(1.0f, 1.0f, 1.0f, 1.0f);
        std::vector<GLubyte> stencil(kAll);
        glReadPixels(0, 0, kSize, kSize, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, stencil.data());
        return std::tuple(read_colours(), read_depths(), stencil);
    };
    const auto without = picture(false);
    EXPECT_EQ(picture(true), without);
}

}  // namespace
}  // namespace conformance
