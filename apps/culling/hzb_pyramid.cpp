// SPDX-License-Identifier: MIT
// Levels are reduced only over what was put, and looked at only where a coarser texel does not decide.
#include "apps/culling/hzb_pyramid.h"

namespace apps {

void DepthPyramid::clear(int width_pixels, int height_pixels) {
    levels_.clear();
    for (int width = width_pixels, height = height_pixels;;
         width = (width + 1) / 2, height = (height + 1) / 2) {
        levels_.push_back({width, height, std::vector(static_cast<std::size_t>(width * height), kFarStep)});
        if (width == 1 && height == 1) return;
    }
}

void DepthPyramid::put(const Rectangle& rectangle, std::span<const float> depths) {
    if (rectangle.pixels() == 0) return;
    int x0 = rectangle.x;
    int y0 = rectangle.y;
    int x1 = x0 + rectangle.width - 1;
    int y1 = y0 + rectangle.height - 1;
    std::size_t next = 0;
    for (int y = y0; y <= y1; ++y)
        for (int x = x0; x <= x1; ++x) levels_[0].at(x, y) = steps_of(depths[next++]);
    for (std::size_t level = 1; level < levels_.size(); ++level) {
        const Level& below = levels_[level - 1];
        x0 /= 2, y0 /= 2, x1 /= 2, y1 /= 2;
        for (int y = y0; y <= y1; ++y)
            for (int x = x0; x <= x1; ++x) {
                const int right = std::min(2 * x + 1, below.width - 1);
                const int above = std::min(2 * y + 1, below.height - 1);
                levels_[level].at(x, y) = std::max({below.at(2 * x, 2 * y), below.at(right, 2 * y),
                                                    below.at(2 * x, above), below.at(right, above)});
            }
    }
}

bool DepthPyramid::is_hidden(const ScreenBox& box) const {
    return box.pixels.pixels() == 0 || is_hidden(box, levels() - 1, 0, 0);
}

bool DepthPyramid::is_hidden(const ScreenBox& box, int level, int x, int y) const {
    const Level& here = levels_[static_cast<std::size_t>(level)];
    const Rectangle& r = box.pixels;
    const bool misses = x >= here.width || y >= here.height || x << level >= r.x + r.width ||
                        y << level >= r.y + r.height || (x + 1) << level <= r.x || (y + 1) << level <= r.y;
    if (misses || box.is_behind(here.at(x, y))) return true;
    if (level == 0) return false;
    return is_hidden(box, level - 1, 2 * x, 2 * y) && is_hidden(box, level - 1, 2 * x + 1, 2 * y) &&
           is_hidden(box, level - 1, 2 * x, 2 * y + 1) && is_hidden(box, level - 1, 2 * x + 1, 2 * y + 1);
}

}  // namespace apps
