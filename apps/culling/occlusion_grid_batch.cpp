// SPDX-License-Identifier: MIT
// Many boxes in two calls, for machines that answer about many rectangles at once ("support of parallel
// pixel-level occlusion queries", the future work of Hey et al. 2001).
#include "apps/culling/occlusion_grid.h"

namespace apps {
namespace {

const Statistic kBatches{"box_batches", "sets of boxes tested together"};
const Statistic kTilesRefreshed{"tiles_refreshed", "queries of whole tiles for all boxes of a batch"};
const Statistic kBorderParts{"border_parts", "queries of border tiles' parts for a batch"};

struct Question {
    std::size_t box;
    Rectangle pixels;
};

}  // namespace

bool ZfarGrid::shows(const ScreenBox& box, const std::vector<TileGrid::Part>& parts) const {
    return std::any_of(parts.begin(), parts.end(), [&](const TileGrid::Part& part) {
        const Tile& tile = tiles_[part.tile];
        const bool decides = !tile.is_drawn || (part.is_internal && !tile.is_outdated);
        return decides && !box.is_behind(tile.zfar);
    });
}

void ZfarGrid::refresh(Frame& frame, const std::vector<std::uint32_t>& tiles) {
    frame.tally.add(kTilesRefreshed, tiles.size());
    if (tiles.empty()) return;
    std::vector<Rectangle> wholes;
    wholes.reserve(tiles.size());
    for (const std::uint32_t tile : tiles) wholes.push_back(grid_.pixels_of(tile));
    const std::vector<float> answers = frame.canvas.furthest_depths(wholes);
    for (std::size_t i = 0; i < tiles.size(); ++i) tiles_[tiles[i]] = {steps_of(answers[i]), false, true};
}

std::vector<std::uint8_t> ZfarGrid::are_occluded(Frame& frame, std::span<const ScreenBox> boxes) {
    frame.tally.add(kBatches);
    std::vector<std::uint8_t> result(boxes.size(), 1);
    std::vector<std::uint64_t> open_pixels(tiles_.size(), 0);  // of an outdated tile, over the open boxes
    std::vector<std::uint32_t> wanted;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        const auto& parts = grid_.parts_of(boxes[i].pixels);
        frame.tally.add(kTilesTested, parts.size());
        if (shows(boxes[i], parts)) {
            result[i] = 0;
            continue;
        }
        for (const auto& part : parts) {
            const Tile& tile = tiles_[part.tile];
            if (!tile.is_outdated || boxes[i].is_behind(tile.zfar)) continue;
            const std::uint64_t whole = grid_.pixels_of(part.tile).pixels();
            std::uint64_t& sum = open_pixels[part.tile];
            if (sum < whole && sum + part.pixels.pixels() >= whole) wanted.push_back(part.tile);
            sum += part.pixels.pixels();
        }
    }
    refresh(frame, wanted);

    std::vector<Question> questions;
    std::vector<Rectangle> rectangles;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        if (!result[i]) continue;
        const auto& parts = grid_.parts_of(boxes[i].pixels);
        if (shows(boxes[i], parts)) {
            result[i] = 0;
            continue;
        }
        for (const auto& part : parts)
            if (!boxes[i].is_behind(tiles_[part.tile].zfar)) questions.push_back({i, part.pixels});
    }
    frame.tally.add(kBorderParts, questions.size());
    if (questions.empty()) return result;
    for (const Question& question : questions) rectangles.push_back(question.pixels);
    const std::vector<float> answers = frame.canvas.furthest_depths(rectangles);
    for (std::size_t i = 0; i < questions.size(); ++i)
        if (!boxes[questions[i].box].is_behind(steps_of(answers[i]))) result[questions[i].box] = 0;
    return result;
}

}  // namespace apps
