// SPDX-License-Identifier: MIT
// The machine as a culler sees it: what draws, what asks. Real GL, or a test. What a culler calls here its
// recipe says that it needs (culler.h); a machine that cannot do it throws std::logic_error, as all of these
// do by themselves.
#pragma once

#include <chrono>
#include <cstdint>
#include <span>
#include <vector>

#include "apps/scene/scene.h"

namespace apps {

/// Pixels x <= i < x + width, y <= j < y + height; the origin is the lower left.
struct Rectangle {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;

    std::uint64_t pixels() const {
        return static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height);
    }
    bool operator==(const Rectangle&) const = default;
};

using QueryId = std::uint32_t;

/// What the GPU does with a conditional draw while the answer is not there, and where
/// (NV_conditional_render).
enum class Condition : std::uint8_t { kWait, kNoWait, kByRegionWait, kByRegionNoWait };

class Canvas {
  public:
    virtual ~Canvas() = default;

    virtual void draw(std::span<const ObjectId> objects) = 0;

    // Occlusion queries.

    /// Draws the proxies, unseen, inside one query, and does not wait.
    virtual QueryId ask(std::span<const Box> proxies);

    /// Polls; never waits.
    virtual bool is_answered(QueryId query);

    /// The samples that passed, 0 or 1 where the machine has but a flag; waits. It is taken once: the id may
    /// stand for another query afterwards.
    virtual std::uint32_t samples(QueryId query);

    /// The CPU does not learn whether it was drawn; samples() still has to be called.
    virtual void draw_on_condition(QueryId query, Condition condition, std::span<const ObjectId> objects);

    bool is_visible(const Box& proxy) { return samples(ask({&proxy, 1})) != 0; }

    // Depth regions, inside the view. Each waits until everything drawn so far is in the depth buffer; a
    // machine that takes many rectangles at once waits once.

    /// For each rectangle: 1 if nothing in it is at the far value, else 0.
    virtual std::vector<std::uint8_t> are_occluded(std::span<const Rectangle> regions);

    /// Of each rectangle the furthest depth, 0 near to 1 far.
    virtual std::vector<float> furthest_depths(std::span<const Rectangle> regions);

    /// All depths of a rectangle, row by row from below.
    virtual std::vector<float> read_depths(const Rectangle& region);

    /// Tells a machine with a time of its own that the program computed for so long.
    virtual void work(std::chrono::nanoseconds) {}
};

}  // namespace apps
