// SPDX-License-Identifier: MIT
// Questions to GL: state first, so that nothing but the proxies is between begin and end.
#include "apps/render/gl_canvas.h"

#include <chrono>
#include <stdexcept>
#include <utility>

#include "apps/platform/gl.h"

namespace apps {
namespace {

/// Adds the time from its making to its end.
class Stall {
  public:
    explicit Stall(double& sum_ms) : sum_ms_(sum_ms), start_(std::chrono::steady_clock::now()) {}
    Stall(const Stall&) = delete;
    Stall& operator=(const Stall&) = delete;
    ~Stall() {
        const auto end = std::chrono::steady_clock::now();
        sum_ms_ += std::chrono::duration<double, std::milli>(end - start_).count();
    }

  private:
    double& sum_ms_;
    std::chrono::steady_clock::time_point start_;
};

}  // namespace

OcclusionTest& GlCanvas::test() const {
    if (!machine_.test) throw std::logic_error("a culler asked on a machine without an occlusion test");
    return *machine_.test;
}

DepthRegions& GlCanvas::regions() const {
    if (!machine_.regions) throw std::logic_error("a culler asked for depths that it had not said it needs");
    return *machine_.regions;
}

QueryId GlCanvas::ask(std::span<const Box> proxies) {
    renderer_.use_proxies();
    const QueryId query = test().begin();
    renderer_.draw_proxies(proxies);
    test().end();
    ++counters_.queries;
    counters_.query_boxes += proxies.size();
    return query;
}

bool GlCanvas::is_answered(QueryId query) {
    ++counters_.polls;
    if (!test().is_available(query)) return false;
    answered_ = query;
    return true;
}

std::uint32_t GlCanvas::samples(QueryId query) {
    if (std::exchange(answered_, std::nullopt) == query) return test().fetch(query);
    ++counters_.results_waited;
    const Stall stall(counters_.stall_ms);
    return test().fetch(query);
}

void GlCanvas::draw_on_condition(QueryId query, Condition condition, std::span<const ObjectId> objects) {
    if (!machine_.conditions) throw std::logic_error("conditional drawing on a machine without it");
    renderer_.use_forwards();
    machine_.conditions->begin(query, condition);
    renderer_.draw(objects);
    machine_.conditions->end();
}

void GlCanvas::count_regions(std::span<const Rectangle> regions) {
    for (const Rectangle& region : regions) counters_.pixels_read += region.pixels();
    counters_.region_waits += this->regions().waits_for(regions.size());
}

std::vector<std::uint8_t> GlCanvas::are_occluded(std::span<const Rectangle> regions) {
    count_regions(regions);
    const Stall stall(counters_.stall_ms);
    return this->regions().are_occluded(regions);
}

std::vector<float> GlCanvas::furthest_depths(std::span<const Rectangle> regions) {
    count_regions(regions);
    const Stall stall(counters_.stall_ms);
    return this->regions().furthest_depths(regions);
}

std::vector<float> GlCanvas::read_depths(const Rectangle& region) {
    counters_.pixels_read += region.pixels();
    ++counters_.region_waits;
    const Stall stall(counters_.stall_ms);
    std::vector<float> depths(region.pixels());
    glReadPixels(region.x, region.y, region.width, region.height, GL_DEPTH_COMPONENT, GL_FLOAT,
                 depths.data());
    return depths;
}

void GlCanvas::work(std::chrono::nanoseconds time) {
    if (machine_.clock) machine_.clock->work(time);
}

}  // namespace apps
