// SPDX-License-Identifier: MIT
// The grids of H. Hey, R. F. Tobler, W. Purgathofer, Real-Time Occlusion Culling With A Lazy Occlusion Grid,
// 2001: tiles over the depth buffer, each with what is known of its occlusion and a flag that it is outdated.
// The state version (section 3) knows free, partial or full; the zfar version (section 4) the furthest depth.
#pragma once

#include <vector>

#include "apps/culling/culler.h"
#include "apps/culling/screen_box.h"

namespace apps {

/// Tiles of the screen, row by row from below; those of the last column and row may be cut by its edge.
class TileGrid {
  public:
    TileGrid() = default;
    TileGrid(int width_pixels, int height_pixels, int tile_pixels);

    /// What a rectangle has of a tile. Internal: all of the tile that is on the screen.
    struct Part {
        std::uint32_t tile;
        bool is_internal;  // else a border tile
        Rectangle pixels;  // of the rectangle in the tile
    };

    /// Of a rectangle inside the screen: its tiles, row by row. Valid until the next call.
    const std::vector<Part>& parts_of(const Rectangle& rectangle);

    Rectangle pixels_of(std::uint32_t tile) const;
    std::uint32_t size() const { return static_cast<std::uint32_t>(columns_ * rows_); }

  private:
    int width_ = 0, height_ = 0, tile_ = 1;
    int columns_ = 0, rows_ = 0;
    std::vector<Part> parts_;
};

enum class TileState : std::uint8_t { kFree, kPartial, kFull };

/// For draws that come in the order of two_lists.h.
class StateGrid {
  public:
    struct Tile {
        TileState state = TileState::kFree;
        bool is_outdated = false;
        bool operator==(const Tile&) const = default;
    };

    /// `asks_together`: of one box the outdated internal tiles are asked about in one call, and then the
    /// border tiles; else each by itself, until one tells that the box is visible.
    StateGrid(int tile_pixels, bool asks_together)
        : tile_pixels_(tile_pixels), asks_together_(asks_together) {}

    /// All tiles free and up to date.
    void clear(const View& view);

    /// The four steps of section 3. Step 4 looks at a part of a tile only, so it leaves the tile as it was.
    bool is_occluded(Frame& frame, const ScreenBox& box);

    /// Something was drawn: outdates the tiles that the box touches, but full ones, which stay full.
    void outdate(const ScreenBox& box);

    /// Of the tiles that the box touches, brings those up to date that are not full.
    void update(Frame& frame, const ScreenBox& box);

    const Tile& tile(std::uint32_t index) const { return tiles_[index]; }
    const TileGrid& grid() const { return grid_; }

  private:
    int tile_pixels_;
    bool asks_together_;
    TileGrid grid_;
    std::vector<Tile> tiles_;
    std::vector<TileGrid::Part> open_;
};

/// For draws in any order, best front to back.
class ZfarGrid {
  public:
    struct Tile {
        DepthSteps zfar =
            kFarStep;  // nothing in the tile is further; when outdated too, since depths only fall
        bool is_outdated = false;
        bool is_drawn = false;  // something may have been drawn there since the clear
        bool operator==(const Tile&) const = default;
    };

    /// As StateGrid's.
    ZfarGrid(int tile_pixels, bool asks_together)
        : tile_pixels_(tile_pixels), asks_together_(asks_together) {}

    /// All tiles at the far end and up to date.
    void clear(const View& view);

    /// The four steps with depths compared: a box is occluded in a tile whose zfar, outdated or not, lies
    /// before the box. Only of tiles that leave it open are depths asked for.
    bool is_occluded(Frame& frame, const ScreenBox& box);

    /// The same for many boxes at once, in at most two calls: one for outdated tiles, whole, that boxes which
    /// are open have all of or, together, as many pixels of; then one for the parts of border tiles that are
    /// open still. 1 for each box that is occluded.
    std::vector<std::uint8_t> are_occluded(Frame& frame, std::span<const ScreenBox> boxes);

    void outdate(const ScreenBox& box);

    const Tile& tile(std::uint32_t index) const { return tiles_[index]; }
    const TileGrid& grid() const { return grid_; }

  private:
    /// True if the box shows in an internal tile or an empty one, as far as the tiles that are up to date
    /// tell.
    bool shows(const ScreenBox& box, const std::vector<TileGrid::Part>& parts) const;

    /// Asks about whole tiles, in one call.
    void refresh(Frame& frame, const std::vector<std::uint32_t>& tiles);

    int tile_pixels_;
    bool asks_together_;
    TileGrid grid_;
    std::vector<Tile> tiles_;
    std::vector<TileGrid::Part> open_;
};

/// The knobs of all cullers with a grid.
inline constexpr Knob kTileKnob = {"tile", 32, 8, 128, "pixels to the side of a tile"};
inline constexpr Knob kParallelKnob = {
    "parallel", 0, 0, 1, "1: all tiles that a box needs in one call, more of them than one by one"};

extern const Statistic kTilesTested;

}  // namespace apps
