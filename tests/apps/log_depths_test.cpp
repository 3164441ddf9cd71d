// SPDX-License-Identifier: MIT
// The zfar version's grid and the pyramid of HZB; and all of them against every pixel of a depth buffer.
#include "apps/culling/hzb_pyramid.h"
#include "apps/scene/random.h"
#include "log_fixture.h"

namespace {

using apps::DepthPyramid;
using apps::DepthSteps;
using apps::kFarStep;
using apps::Rectangle;
using apps::ScreenBox;
using apps::StateGrid;
using apps::ZfarGrid;
using apps_test::box_over;
using apps_test::EmptyFrame;
using Calls = std::vector<std::vector<Rectangle>>;

constexpr Rectangle kTile0{0, 0, 32, 32};
constexpr Rectangle kPart{4, 4, 20, 20};

struct FurthestOfTiles : testing::Test {
    FurthestOfTiles() { grid.clear(on.view); }

    void draw(const Rectangle& covered, DepthSteps depth) {
        on.canvas.cover(covered, depth);
        grid.outdate(box_over(covered, depth));
    }
    bool is_occluded(const Rectangle& pixels, DepthSteps znear) {
        return grid.is_occluded(on.frame, box_over(pixels, znear));
    }

    EmptyFrame on{80, 50};
    ZfarGrid grid{32, false};
};

TEST_F(FurthestOfTiles, is_asked_for_once_and_kept) {
    EXPECT_FALSE(is_occluded(kTile0, 5000));
    EXPECT_FALSE(is_occluded(kPart, 5000)) << "nothing was drawn there";
    EXPECT_TRUE(on.canvas.calls.empty());
    draw(kTile0, 3000);
    EXPECT_TRUE(is_occluded(kTile0, 5000));
    EXPECT_EQ(on.canvas.calls, (Calls{{kTile0}}));
    EXPECT_EQ(grid.tile(0), (ZfarGrid::Tile{3000, false, true}));
    EXPECT_FALSE(is_occluded(kTile0, 2000));
    EXPECT_TRUE(is_occluded(kPart, 5000));
    EXPECT_EQ(on.canvas.calls.size(), 1U);
}

TEST_F(FurthestOfTiles, hides_what_lies_behind_it_even_when_it_is_outdated) {
    draw(kTile0, 3000);
    EXPECT_TRUE(is_occluded(kTile0, 5000));
    draw(kPart, 1000);
    EXPECT_TRUE(grid.tile(0).is_outdated);
    EXPECT_TRUE(is_occluded(kTile0, 5000));
    EXPECT_TRUE(is_occluded(kPart, 5000));
    EXPECT_EQ(on.canvas.calls.size(), 1U);
    EXPECT_TRUE(grid.tile(0).is_outdated) << "nothing was asked, so nothing is known better";
    EXPECT_FALSE(is_occluded(kTile0, 2000));
    EXPECT_EQ(on.canvas.calls.size(), 2U) << "what does not decide is refreshed";
    EXPECT_EQ(grid.tile(0), (ZfarGrid::Tile{3000, false, true}));
}

TEST_F(FurthestOfTiles, is_left_alone_by_queries_of_a_part_and_needs_them_only_where_it_does_not_decide) {
    draw(kTile0, 3000);
    EXPECT_TRUE(is_occluded(kTile0, 5000));
    draw(kPart, 1000);
    const auto before = grid.tile(0);
    EXPECT_TRUE(is_occluded(kPart, 2000)) << "the part is nearer than the tile's furthest";
    EXPECT_EQ(on.canvas.calls.back(), (std::vector{kPart}));
    EXPECT_EQ(grid.tile(0), before);
    EXPECT_EQ(on.count("border_queries"), 1U);
}

TEST_F(FurthestOfTiles, hides_nothing_at_its_own_depth) {
    draw(kTile0, 3000);
    EXPECT_FALSE(is_occluded(kTile0, 3000));
    EXPECT_TRUE(is_occluded(kTile0, 3001));
}

TEST_F(FurthestOfTiles, is_asked_for_many_boxes_in_two_calls) {
    draw({0, 0, 64, 50}, 3000);
    draw(kPart, 1000);
    const ScreenBox boxes[] = {
        box_over({0, 0, 64, 32}, 5000),   // hidden by two internal tiles
        box_over(kPart, 2000),            // hidden, by its part only
        box_over({33, 1, 4, 4}, 2000),    // shows
        box_over({64, 0, 16, 50}, 5000),  // shows where nothing was drawn
    };
    EXPECT_EQ(grid.are_occluded(on.frame, boxes), (std::vector<std::uint8_t>{1, 1, 0, 0}));
    ASSERT_EQ(on.canvas.calls.size(), 2U);
    EXPECT_EQ(on.canvas.calls[0], (std::vector<Rectangle>{kTile0, {32, 0, 32, 32}}));
    EXPECT_EQ(on.canvas.calls[1], (std::vector<Rectangle>{kPart, {33, 1, 4, 4}}));
}

TEST(Pyramid, has_levels_up_to_one_texel_over_odd_sizes_too) {
    DepthPyramid pyramid;
    pyramid.clear(333, 241);
    EXPECT_EQ(pyramid.levels(), 10);
    pyramid.clear(1, 1);
    EXPECT_EQ(pyramid.levels(), 1);
}

TEST(Pyramid, finds_one_far_pixel_wherever_it_is) {
    for (const auto& [width, height] : {std::pair{7, 5}, {16, 16}, {17, 9}}) {
        std::vector<float> near(static_cast<std::size_t>(width * height), 0.25F);
        const ScreenBox box = box_over({0, 0, width, height}, kFarStep / 2);
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                DepthPyramid pyramid;
                pyramid.clear(width, height);
                pyramid.put({0, 0, width, height}, near);
                EXPECT_TRUE(pyramid.is_hidden(box));
                const float far = 1;
                pyramid.put({x, y, 1, 1}, {&far, 1});
                EXPECT_FALSE(pyramid.is_hidden(box)) << x << ' ' << y;
                EXPECT_EQ(pyramid.is_hidden(box_over({0, 0, x, height}, kFarStep / 2)), true);
            }
    }
}

// Rectangles drawn ever further away and boxes tested behind all that was drawn, as the two lists do: every
// method must say what the pixels say, at every tile size, on a view that is a multiple of none.
TEST(EveryMethod, answers_what_the_pixels_say) {
    for (const int tile : {8, 13, 32, 128}) {
        EmptyFrame on(167, 121);
        StateGrid lazy(tile, false), together(tile, true), busy(tile, false);
        ZfarGrid zfar(tile, false), zfar_together(tile, true), batched(tile, true);
        DepthPyramid pyramid;
        for (StateGrid* grid : {&lazy, &together, &busy}) grid->clear(on.view);
        for (ZfarGrid* grid : {&zfar, &zfar_together, &batched}) grid->clear(on.view);
        pyramid.clear(167, 121);
        apps::Random random(static_cast<std::uint64_t>(tile));
        const auto rectangle = [&](int most) {
            const int x = random.below(167);
            const int y = random.below(121);
            return Rectangle{x, y, std::min(167 - x, 1 + random.below(most)),
                             std::min(121 - y, 1 + random.below(most))};
        };
        int hidden = 0;
        for (int round = 0; round < 300; ++round) {
            const DepthSteps depth = 1000 + 10 * round;
            const Rectangle drawn = rectangle(60);
            const ScreenBox drawn_box = box_over(drawn, depth);
            on.canvas.cover(drawn, depth);
            lazy.outdate(drawn_box);
            together.outdate(drawn_box);
            busy.update(on.frame, drawn_box);
            zfar.outdate(drawn_box);
            zfar_together.outdate(drawn_box);
            batched.outdate(drawn_box);
            pyramid.put(drawn, on.canvas.read_depths(drawn));

            std::vector<ScreenBox> boxes;
            for (int k = 0; k < 4; ++k) boxes.push_back(box_over(rectangle(100), depth + 5));
            const auto answers = batched.are_occluded(on.frame, boxes);
            for (std::size_t k = 0; k < boxes.size(); ++k) {
                const ScreenBox& box = boxes[k];
                const bool truth = on.canvas.furthest(box.pixels) < box.znear;
                hidden += truth;
                ASSERT_EQ(lazy.is_occluded(on.frame, box), truth);
                ASSERT_EQ(together.is_occluded(on.frame, box), truth);
                ASSERT_EQ(busy.is_occluded(on.frame, box), truth);
                ASSERT_EQ(zfar.is_occluded(on.frame, box), truth);
                ASSERT_EQ(zfar_together.is_occluded(on.frame, box), truth);
                ASSERT_EQ(answers[k] != 0, truth);
                ASSERT_EQ(pyramid.is_hidden(box), truth);
                // In any order: boxes before what was drawn last.
                ScreenBox nearer = box;
                nearer.znear = 1000 + random.below(depth - 999);
                const bool nearer_truth = on.canvas.furthest(nearer.pixels) < nearer.znear;
                ASSERT_EQ(zfar.is_occluded(on.frame, nearer), nearer_truth);
                ASSERT_EQ(batched.are_occluded(on.frame, {&nearer, 1})[0] != 0, nearer_truth);
            }
        }
        EXPECT_GT(hidden, 300);
        EXPECT_LT(hidden, 1100);
    }
}

}  // namespace
