// SPDX-License-Identifier: MIT
// Tiles: which a box covers, what is known of them, and what has to be asked.
#include "apps/culling/occlusion_grid.h"

#include <ranges>

namespace apps {

const Statistic kTilesTested{"tiles_tested", "tiles looked at for a box, with and without a query"};

namespace {

const Statistic kTilesWithoutQuery{"tiles_without_query", "tiles tested that no query was made for"};
const Statistic kInternalQueries{"internal_queries", "queries of whole tiles inside a box"};
const Statistic kBorderQueries{"border_queries", "queries of the part of a tile that a box covers"};
const Statistic kUpdates{"tile_updates", "queries of whole tiles right after a draw"};

/// What the test of a box counts.
class Count {
  public:
    explicit Count(Frame& frame) : tally_(frame.tally) {}
    Count(const Count&) = delete;
    Count& operator=(const Count&) = delete;
    ~Count() {
        tally_.add(kTilesTested, tested_);
        tally_.add(kTilesWithoutQuery, tested_ - asked_);
    }
    void test() { ++tested_; }
    void ask(const Statistic& kind, std::size_t count = 1) {
        asked_ += count;
        tally_.add(kind, count);
    }

  private:
    Tally& tally_;
    std::uint64_t tested_ = 0, asked_ = 0;
};

Rectangle intersection(const Rectangle& a, const Rectangle& b) {
    const int x = std::max(a.x, b.x);
    const int y = std::max(a.y, b.y);
    return {x, y, std::min(a.x + a.width, b.x + b.width) - x, std::min(a.y + a.height, b.y + b.height) - y};
}

std::vector<Rectangle> rectangles_of(std::span<const TileGrid::Part> parts) {
    std::vector<Rectangle> rectangles;
    rectangles.reserve(parts.size());
    for (const TileGrid::Part& part : parts) rectangles.push_back(part.pixels);
    return rectangles;
}

}  // namespace

TileGrid::TileGrid(int width_pixels, int height_pixels, int tile_pixels)
    : width_(width_pixels),
      height_(height_pixels),
      tile_(tile_pixels),
      columns_((width_pixels + tile_pixels - 1) / tile_pixels),
      rows_((height_pixels + tile_pixels - 1) / tile_pixels) {
}

Rectangle TileGrid::pixels_of(std::uint32_t tile) const {
    const int x = static_cast<int>(tile) % columns_ * tile_;
    const int y = static_cast<int>(tile) / columns_ * tile_;
    return {x, y, std::min(tile_, width_ - x), std::min(tile_, height_ - y)};
}

const std::vector<TileGrid::Part>& TileGrid::parts_of(const Rectangle& rectangle) {
    parts_.clear();
    if (rectangle.width <= 0 || rectangle.height <= 0) return parts_;
    for (int row = rectangle.y / tile_; row * tile_ < rectangle.y + rectangle.height; ++row)
        for (int column = rectangle.x / tile_; column * tile_ < rectangle.x + rectangle.width; ++column) {
            const auto tile = static_cast<std::uint32_t>(row * columns_ + column);
            const Rectangle whole = pixels_of(tile);
            const Rectangle part = intersection(whole, rectangle);
            parts_.push_back({tile, part == whole, part});
        }
    return parts_;
}

void StateGrid::clear(const View& view) {
    grid_ = TileGrid(view.width, view.height, tile_pixels_);
    tiles_.assign(grid_.size(), {});
}

bool StateGrid::is_occluded(Frame& frame, const ScreenBox& box) {
    Count count(frame);
    const auto& parts = grid_.parts_of(box.pixels);
    // Step 1: "if one of the BVol's up-to-date internal tiles is not in full-state".
    for (const auto& part : parts) {
        const Tile& tile = tiles_[part.tile];
        if (!part.is_internal || tile.is_outdated) continue;
        count.test();
        if (tile.state != TileState::kFull) return false;
    }
    // Step 2: "if one of the BVol's up-to-date border tiles is in free-state".
    for (const auto& part : parts) {
        const Tile& tile = tiles_[part.tile];
        if (part.is_internal || tile.is_outdated) continue;
        count.test();
        if (tile.state == TileState::kFree) return false;
    }
    // Steps 3 and 4: "test each outdated internal tile of the BVol with a pixel-level query in the tile's
    // whole area", and "each border tile of the BVol which is outdated or in partially occluded-state with a
    // pixel-level query in the intersection area". From above, in both versions: where one thing stands
    // behind another, what shows of it shows mostly at its top, so that fewer tiles are asked about.
    for (const bool is_internal : {true, false}) {
        open_.clear();
        for (const auto& part : std::views::reverse(parts)) {
            const Tile& tile = tiles_[part.tile];
            const bool is_open = tile.is_outdated || (!is_internal && tile.state == TileState::kPartial);
            if (part.is_internal == is_internal && is_open) open_.push_back(part);
        }
        const std::size_t step = asks_together_ ? open_.size() : 1;
        for (std::size_t first = 0; first < open_.size(); first += step) {
            const std::span asked = std::span(open_).subspan(first, step);
            for (const auto& part : asked)
                if (tiles_[part.tile].is_outdated) count.test();  // the others were in step 2
            count.ask(is_internal ? kInternalQueries : kBorderQueries, asked.size());
            const auto answers = frame.canvas.are_occluded(rectangles_of(asked));
            if (is_internal)
                for (std::size_t i = 0; i < asked.size(); ++i)
                    tiles_[asked[i].tile] = {answers[i] ? TileState::kFull : TileState::kPartial, false};
            if (std::find(answers.begin(), answers.end(), 0) != answers.end()) return false;
        }
    }
    return true;
}

void StateGrid::outdate(const ScreenBox& box) {
    for (const auto& part : grid_.parts_of(box.pixels)) {
        Tile& tile = tiles_[part.tile];
        if (tile.state != TileState::kFull) tile.is_outdated = true;
    }
}

void StateGrid::update(Frame& frame, const ScreenBox& box) {
    std::vector<Rectangle> wholes;
    open_.clear();
    for (const auto& part : grid_.parts_of(box.pixels))
        if (tiles_[part.tile].state != TileState::kFull) {
            open_.push_back(part);
            wholes.push_back(grid_.pixels_of(part.tile));
        }
    const std::size_t step = asks_together_ ? open_.size() : 1;
    for (std::size_t first = 0; first < open_.size(); first += step) {
        const auto answers = frame.canvas.are_occluded(std::span(wholes).subspan(first, step));
        for (std::size_t i = 0; i < step; ++i)
            tiles_[open_[first + i].tile] = {answers[i] ? TileState::kFull : TileState::kPartial, false};
    }
    frame.tally.add(kUpdates, open_.size());
}

void ZfarGrid::clear(const View& view) {
    grid_ = TileGrid(view.width, view.height, tile_pixels_);
    tiles_.assign(grid_.size(), {});
}

void ZfarGrid::outdate(const ScreenBox& box) {
    for (const auto& part : grid_.parts_of(box.pixels)) {
        tiles_[part.tile].is_outdated = true;
        tiles_[part.tile].is_drawn = true;
    }
}

bool ZfarGrid::is_occluded(Frame& frame, const ScreenBox& box) {
    Count count(frame);
    const auto& parts = grid_.parts_of(box.pixels);
    // Steps 1 and 2, with what is known. A tile's zfar bounds its part in the box too; that it is behind the
    // box's front decides only where the tile is internal, up to date or empty.
    for (const bool is_internal : {true, false})
        for (const auto& part : parts) {
            const Tile& tile = tiles_[part.tile];
            if (part.is_internal != is_internal || tile.is_outdated) continue;
            count.test();
            if (!box.is_behind(tile.zfar) && (is_internal || !tile.is_drawn)) return false;
        }
    // Steps 3 and 4, of tiles that what is known, outdated or not, does not call occluded.
    for (const bool is_internal : {true, false}) {
        open_.clear();
        for (const auto& part : std::views::reverse(parts)) {
            const Tile& tile = tiles_[part.tile];
            if (part.is_internal != is_internal || (is_internal && !tile.is_outdated)) continue;
            if (!box.is_behind(tile.zfar))
                open_.push_back(part);
            else if (tile.is_outdated)
                count.test();
        }
        const std::size_t step = asks_together_ ? open_.size() : 1;
        for (std::size_t first = 0; first < open_.size(); first += step) {
            const std::span asked = std::span(open_).subspan(first, step);
            for (const auto& part : asked)
                if (tiles_[part.tile].is_outdated) count.test();
            count.ask(is_internal ? kInternalQueries : kBorderQueries, asked.size());
            const auto answers = frame.canvas.furthest_depths(rectangles_of(asked));
            bool shows = false;
            for (std::size_t i = 0; i < asked.size(); ++i) {
                const DepthSteps zfar = steps_of(answers[i]);
                if (is_internal) tiles_[asked[i].tile] = {zfar, false, true};
                shows = shows || !box.is_behind(zfar);
            }
            if (shows) return false;
        }
    }
    return true;
}

}  // namespace apps
