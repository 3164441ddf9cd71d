// SPDX-License-Identifier: MIT
// The machine that is fitted, small: a CPU clock, a GPU clock and what commands cost on each. It is the model
// of the device files ([time], docs/adding.md), written a second time: a client does not know the layer.
// Terms that no benchmark here exercises are left out.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "apps/calibrate/commands.h"

namespace apps {

/// Microseconds, each; of one command, triangle, fragment or pixel.
struct Costs {
    double batch = 0;
    double query = 0;
    double read = 0;
    double gpu_batch = 0;
    double triangle = 0;
    double fragment = 0;
    double depth_fragment = 0;
    double cleared_pixel = 0;
    double gpu_query = 0;
    double latency = 0;
    double fifo = 0;  // 0: no end
    double read_pixel = 0;
};

class Model final : public Commands {
  public:
    Model(const Costs& costs, double window_pixels) : costs_(costs), window_pixels_(window_pixels) {}

    void mesh(int triangles, MeshSize size) override { draw(triangles, fragments_of(triangles, size)); }
    void quad(int eighths) override { draw(2, window_pixels_ * eighths * eighths / 64); }
    void query(int side) override {
        make_room();
        cpu_ += costs_.query;
        gpu_ = std::max(gpu_, cpu_) + costs_.gpu_query + box_fragments(side) * costs_.depth_fragment;
        results_.push_back(gpu_ + costs_.latency);
    }
    void wait(std::size_t query) override { cpu_ = std::max(cpu_, results_.at(query)); }
    void read(int side) override {
        cpu_ = std::max(cpu_, gpu_) + costs_.read + double{1} * side * side * costs_.read_pixel;
        gpu_ = cpu_;
    }
    void clear() override {
        make_room();
        gpu_ = std::max(gpu_, cpu_) + window_pixels_ * costs_.cleared_pixel;
    }
    void finish() override { cpu_ = std::max(cpu_, gpu_); }

    double microseconds() const { return cpu_; }

  private:
    void make_room() {
        if (costs_.fifo > 0) cpu_ = std::max(cpu_, gpu_ - costs_.fifo);
    }
    void draw(int triangles, double fragments) {
        make_room();
        cpu_ += costs_.batch;
        gpu_ = std::max(gpu_, cpu_) + costs_.gpu_batch +
               std::max(triangles * costs_.triangle, fragments * costs_.fragment);
    }

    Costs costs_;
    double window_pixels_;
    double cpu_ = 0;
    double gpu_ = 0;
    std::vector<double> results_;
};

}  // namespace apps
