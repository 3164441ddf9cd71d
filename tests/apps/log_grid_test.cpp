// SPDX-License-Identifier: MIT
// The state version's grid, tile by tile: Hey et al. 2001, section 3, and what it leaves unsaid. A view of
// 80 x 50 pixels under tiles of 32 has 3 x 2 tiles; the last column is 16 wide, the last row 18 high.
#include "log_fixture.h"

namespace {

using apps::Rectangle;
using apps::StateGrid;
using apps::TileState;
using apps_test::box_over;
using apps_test::EmptyFrame;
using Calls = std::vector<std::vector<Rectangle>>;

constexpr StateGrid::Tile kFree{TileState::kFree, false};
constexpr StateGrid::Tile kPartial{TileState::kPartial, false};
constexpr StateGrid::Tile kFull{TileState::kFull, false};

constexpr Rectangle kTile0{0, 0, 32, 32};
constexpr Rectangle kTile1{32, 0, 32, 32};
constexpr Rectangle kBothTiles{0, 0, 64, 32};

struct StateOfTiles : testing::Test {
    StateOfTiles() { grid.clear(on.view); }

    /// Draws, as far as the depth buffer and the grid can tell.
    void draw(const Rectangle& covered, const Rectangle& box) {
        on.canvas.cover(covered);
        grid.outdate(box_over(box));
    }
    void draw(const Rectangle& covered) { draw(covered, covered); }
    bool is_occluded(const Rectangle& pixels) { return grid.is_occluded(on.frame, box_over(pixels)); }

    EmptyFrame on{80, 50};
    StateGrid grid{32, false};
};

TEST_F(StateOfTiles, is_free_after_a_clear_and_answers_without_a_query) {
    EXPECT_EQ(grid.grid().size(), 6U);
    EXPECT_FALSE(is_occluded(kTile0));          // step 1, an internal tile
    EXPECT_FALSE(is_occluded({3, 4, 10, 10}));  // step 2, a border tile
    EXPECT_TRUE(on.canvas.calls.empty());
    EXPECT_EQ(on.count("tiles_tested"), 2U);
    EXPECT_EQ(on.count("tiles_without_query"), 2U);
}

TEST_F(StateOfTiles, of_internal_tiles_is_found_by_one_query_of_the_whole_and_kept) {
    draw(kTile0);
    EXPECT_EQ(grid.tile(0), (StateGrid::Tile{TileState::kFree, true}));
    EXPECT_TRUE(is_occluded(kTile0));
    EXPECT_EQ(grid.tile(0), kFull);
    draw({32, 0, 31, 32}, kTile1);
    EXPECT_FALSE(is_occluded(kTile1));
    EXPECT_EQ(grid.tile(1), kPartial);
    const Calls expected{{kTile0}, {kTile1}};
    EXPECT_EQ(on.canvas.calls, expected);
    EXPECT_TRUE(is_occluded(kTile0));
    EXPECT_FALSE(is_occluded(kTile1));
    EXPECT_EQ(on.canvas.calls, expected) << "asked again of tiles that are up to date";
    EXPECT_EQ(on.count("internal_queries"), 2U);
}

TEST_F(StateOfTiles, is_left_alone_by_queries_of_a_part) {
    draw(kTile0);
    const Rectangle part{2, 3, 20, 10};
    EXPECT_TRUE(is_occluded(part));
    EXPECT_TRUE(is_occluded(part));
    EXPECT_EQ(on.canvas.calls, (Calls{{part}, {part}}));
    EXPECT_EQ(grid.tile(0), (StateGrid::Tile{TileState::kFree, true}));
    EXPECT_EQ(on.count("border_queries"), 2U);
}

TEST_F(StateOfTiles, that_is_partial_and_up_to_date_is_asked_about_where_a_box_covers_a_part) {
    draw({0, 0, 20, 32}, kTile0);
    EXPECT_FALSE(is_occluded(kTile0));
    EXPECT_EQ(grid.tile(0), kPartial);
    EXPECT_TRUE(is_occluded({0, 0, 20, 20}));
    EXPECT_FALSE(is_occluded({10, 0, 20, 20}));
    EXPECT_EQ(on.canvas.calls, (Calls{{kTile0}, {{0, 0, 20, 20}}, {{10, 0, 20, 20}}}));
    EXPECT_EQ(grid.tile(0), kPartial);
    EXPECT_EQ(on.count("tiles_tested"), 3U) << "a tile that two steps look at is one tile";
}

TEST_F(StateOfTiles, that_is_full_is_never_outdated_nor_asked_about_again) {
    draw(kTile0);
    EXPECT_TRUE(is_occluded(kTile0));
    on.canvas.calls.clear();
    draw(kTile0);
    EXPECT_EQ(grid.tile(0), kFull);
    EXPECT_TRUE(is_occluded(kTile0));
    EXPECT_TRUE(is_occluded({5, 5, 9, 9}));
    EXPECT_TRUE(on.canvas.calls.empty());
}

// The four steps, in their order: of a box that shows in every kind of tile, the first kind answers.
TEST_F(StateOfTiles, is_looked_at_in_four_steps) {
    // Tile 0 free, 1 to be internal and outdated, 2 a border tile: 16 wide, of which the box has 10.
    const Rectangle wide{0, 0, 74, 32};
    draw({32, 0, 32, 32});
    EXPECT_FALSE(is_occluded(wide)) << "step 1: tile 0 is internal, up to date and not full";
    const Rectangle right{32, 0, 42, 32};
    EXPECT_FALSE(is_occluded(right)) << "step 2: tile 2 is a border tile, up to date and free";
    EXPECT_TRUE(on.canvas.calls.empty());
    draw({64, 0, 5, 32}, {64, 0, 16, 32});
    EXPECT_FALSE(is_occluded(right));
    EXPECT_EQ(on.canvas.calls, (Calls{{kTile1}, {{64, 0, 10, 32}}}))
        << "step 3, the whole of tile 1, which is full, before step 4, the box's part of tile 2";
    EXPECT_EQ(grid.tile(1), kFull);
    EXPECT_TRUE(grid.tile(2).is_outdated);
}

TEST_F(StateOfTiles, that_shows_ends_the_asking_which_begins_at_the_top) {
    draw({20, 0, 60, 50}, {0, 0, 80, 50});
    EXPECT_FALSE(is_occluded({0, 0, 80, 50}));
    EXPECT_EQ(on.canvas.calls, (Calls{{{64, 32, 16, 18}}, {{32, 32, 32, 18}}, {{0, 32, 32, 18}}}))
        << "the upper row is full but for its first tile";
    EXPECT_TRUE(grid.tile(0).is_outdated);
    EXPECT_EQ(grid.tile(3), kPartial);
    EXPECT_EQ(grid.tile(4), kFull);
}

TEST_F(StateOfTiles, at_the_edge_of_the_screen_is_internal_where_a_box_covers_what_is_on_it) {
    const Rectangle corner{64, 32, 16, 18};
    draw(corner);
    EXPECT_TRUE(is_occluded(corner));
    EXPECT_EQ(on.canvas.calls, (Calls{{corner}}));
    EXPECT_EQ(grid.tile(5), kFull) << "a border tile would have kept its state";

    EmptyFrame odd(333, 241);
    StateGrid large(32, false);
    large.clear(odd.view);
    EXPECT_EQ(large.grid().size(), 11U * 8U);
    EXPECT_EQ(large.grid().pixels_of(87), (Rectangle{320, 224, 13, 17}));
}

TEST_F(StateOfTiles, is_all_outdated_by_a_draw_that_may_be_anywhere) {
    const apps::ScreenBox unknown = apps::screen_box(on.view, {glm::vec3(-1), glm::vec3(1)});
    ASSERT_FALSE(unknown.is_known);
    draw(kTile0);
    EXPECT_TRUE(is_occluded(kTile0));
    grid.outdate(unknown);
    EXPECT_EQ(grid.tile(0), kFull);
    for (std::uint32_t tile = 1; tile < 6; ++tile) EXPECT_TRUE(grid.tile(tile).is_outdated) << tile;
}

TEST_F(StateOfTiles, is_found_for_a_whole_box_in_one_call_where_tiles_are_asked_about_together) {
    StateGrid together(32, true);
    together.clear(on.view);
    on.canvas.cover(kBothTiles);
    on.canvas.cover({64, 0, 16, 20});
    together.outdate(box_over({0, 0, 80, 32}));
    EXPECT_TRUE(together.is_occluded(on.frame, box_over({0, 0, 70, 20})));
    EXPECT_TRUE(together.is_occluded(on.frame, box_over(kBothTiles)));
    EXPECT_EQ(on.canvas.calls.size(), 2U) << "three border tiles, then two internal ones";
    EXPECT_EQ(on.canvas.calls[0].size(), 3U);
    EXPECT_EQ(on.canvas.calls[1], (std::vector{kTile1, kTile0}));
    EXPECT_EQ(together.tile(1), kFull);
}

TEST_F(StateOfTiles, of_the_busy_grid_is_brought_up_to_date_whole_unless_it_is_full) {
    on.canvas.cover({0, 0, 40, 32});
    grid.update(on.frame, box_over({20, 0, 20, 32}));
    EXPECT_EQ(on.canvas.calls, (Calls{{kTile0}, {kTile1}}));
    EXPECT_EQ(grid.tile(0), kFull);
    EXPECT_EQ(grid.tile(1), kPartial);
    EXPECT_EQ(grid.tile(2), kFree);
    grid.update(on.frame, box_over({20, 0, 20, 32}));
    EXPECT_EQ(on.canvas.calls.back(), (std::vector{kTile1}));
    EXPECT_EQ(on.canvas.calls.size(), 3U);
    EXPECT_EQ(on.count("tile_updates"), 3U);
}

TEST_F(StateOfTiles, does_not_matter_to_a_box_without_pixels) {
    EXPECT_TRUE(is_occluded({80, 3, 0, 20}));
    EXPECT_TRUE(is_occluded({7, 7, 0, 0}));
    EXPECT_EQ(on.count("tiles_tested"), 0U);
}

}  // namespace
