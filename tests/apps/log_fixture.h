// SPDX-License-Identifier: MIT
// What the tests of the occlusion grids share: a depth buffer in memory that answers, and remembers what it
// was asked.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "apps/culling/culler.h"
#include "apps/culling/occlusion_grid.h"

namespace apps_test {

class FakeDepths final : public apps::Canvas {
  public:
    FakeDepths(int width, int height)
        : width_(width), depths_(static_cast<std::size_t>(width * height), apps::kFarStep) {}

    void draw(std::span<const apps::ObjectId>) override {}
    std::vector<std::uint8_t> are_occluded(std::span<const apps::Rectangle> regions) override {
        calls.emplace_back(regions.begin(), regions.end());
        std::vector<std::uint8_t> answers;
        for (const apps::Rectangle& region : regions) answers.push_back(furthest(region) < apps::kFarStep);
        return answers;
    }
    std::vector<float> furthest_depths(std::span<const apps::Rectangle> regions) override {
        calls.emplace_back(regions.begin(), regions.end());
        std::vector<float> answers;
        for (const apps::Rectangle& region : regions) answers.push_back(as_gl_tells(furthest(region)));
        return answers;
    }
    std::vector<float> read_depths(const apps::Rectangle& region) override {
        calls.push_back({region});
        std::vector<float> result;
        each(region, [&](apps::DepthSteps& depth) { result.push_back(as_gl_tells(depth)); });
        return result;
    }

    /// Draws a rectangle across the view: depths only fall.
    void cover(const apps::Rectangle& region, apps::DepthSteps depth = 1000) {
        each(region, [&](apps::DepthSteps& old) { old = std::min(old, depth); });
    }

    apps::DepthSteps furthest(const apps::Rectangle& region) {
        apps::DepthSteps result = 0;
        each(region, [&](apps::DepthSteps& depth) { result = std::max(result, depth); });
        return result;
    }

    std::vector<std::vector<apps::Rectangle>> calls;

  private:
    static float as_gl_tells(apps::DepthSteps depth) {
        return static_cast<float>(static_cast<double>(depth) / apps::kFarStep);
    }
    template <class Visit>
    void each(const apps::Rectangle& r, Visit&& visit) {
        for (int y = r.y; y < r.y + r.height; ++y)
            for (int x = r.x; x < r.x + r.width; ++x)
                visit(depths_.at(static_cast<std::size_t>(y * width_ + x)));
    }

    int width_;
    std::vector<apps::DepthSteps> depths_;
};

/// A frame over nothing, for what looks at depths only.
struct EmptyFrame {
    EmptyFrame(int width, int height)
        : view(apps::Camera{}, width, height), canvas(width, height), frame(0, scene, tree, view, canvas) {}

    std::uint64_t count(std::string_view name) const {
        for (const apps::Statistic* statistic : apps::Statistic::all())
            if (statistic->name() == name) return frame.tally.of(*statistic);
        ADD_FAILURE() << "no statistic is called " << name;
        return 0;
    }

    apps::Scene scene;
    apps::Tree tree;
    apps::View view;
    FakeDepths canvas;
    apps::Frame frame;
};

inline apps::ScreenBox box_over(const apps::Rectangle& pixels, apps::DepthSteps znear = 5000) {
    return {true, pixels, znear, znear + 100};
}

}  // namespace apps_test
