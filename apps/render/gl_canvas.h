// SPDX-License-Identifier: MIT
// The canvas of a culler on real GL: a Renderer that draws and a Machine that answers, with what they cost.
#pragma once

#include <memory>
#include <optional>

#include "apps/culling/canvas.h"
#include "apps/platform/device_clock.h"
#include "apps/query/conditional_render.h"
#include "apps/query/depth_regions.h"
#include "apps/query/occlusion_test.h"
#include "apps/render/renderer.h"

namespace apps {

/// The ways to ask that a context has; null what it has not.
struct Machine {
    std::unique_ptr<OcclusionTest> test;
    std::unique_ptr<ConditionalRender> conditions;
    std::unique_ptr<DepthRegions> regions;
    DeviceClock* clock = nullptr;
};

struct Counters {
    std::uint64_t queries = 0;
    std::uint64_t query_boxes = 0;  // proxies drawn in them
    std::uint64_t polls = 0;
    std::uint64_t results_waited = 0;  // fetched before a poll had said that they were there
    std::uint64_t pixels_read = 0;     // of a depth buffer
    std::uint64_t region_waits = 0;    // of the CPU, for a depth buffer to be finished
    double stall_ms = 0;               // in the blocking fetch of answers and depths, and nowhere else
};

class GlCanvas final : public Canvas {
  public:
    GlCanvas(Renderer& renderer, Machine& machine) : renderer_(renderer), machine_(machine) {}

    void draw(std::span<const ObjectId> objects) override { renderer_.draw(objects); }
    QueryId ask(std::span<const Box> proxies) override;
    bool is_answered(QueryId query) override;
    std::uint32_t samples(QueryId query) override;
    void draw_on_condition(QueryId query, Condition condition, std::span<const ObjectId> objects) override;
    std::vector<std::uint8_t> are_occluded(std::span<const Rectangle> regions) override;
    std::vector<float> furthest_depths(std::span<const Rectangle> regions) override;
    std::vector<float> read_depths(const Rectangle& region) override;
    void work(std::chrono::nanoseconds time) override;

    const Counters& counters() const { return counters_; }

  private:
    OcclusionTest& test() const;
    DepthRegions& regions() const;
    void count_regions(std::span<const Rectangle> regions);

    Renderer& renderer_;
    Machine& machine_;
    Counters counters_;
    std::optional<QueryId> answered_;  // the last that a poll found answered
};

}  // namespace apps
