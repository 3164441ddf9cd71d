// SPDX-License-Identifier: MIT
#include "figure_one.h"

#include <array>

namespace glext_emu {
namespace {

using occlusion_unit::Picoseconds;
using occlusion_unit::ResultTime;
using occlusion_unit::Timeline;

constexpr Picoseconds kMicrosecond = occlusion_unit::kPicosecondsPerMicrosecond;
constexpr int kObjects = 7;
constexpr int kHidden = 5;

class Frame {
  public:
    explicit Frame(Timeline& timeline) : timeline_(timeline) {}

    void ask(int object) { results_[static_cast<std::size_t>(object)] = timeline_.query({.count = 4000}); }
    void draw() { timeline_.draw({.triangles = 1200, .fragments = {}}); }
    // Fetches the result, and draws the object or culls it.
    void decide(int object) {
        timeline_.wait(results_[static_cast<std::size_t>(object)]);
        if (object == kHidden) {
            timeline_.work(4 * kMicrosecond);
        } else {
            draw();
        }
    }
    // Of an object that is drawn: for the next frame.
    void note(int object) { timeline_.wait(results_[static_cast<std::size_t>(object)]); }

  private:
    Timeline& timeline_;
    std::array<ResultTime, kObjects + 1> results_{};
};

}  // namespace

occlusion_unit::Profile figure_one_machine() {
    occlusion_unit::Profile machine;
    machine.swap = 2 * kMicrosecond;
    machine.batch = 9 * kMicrosecond;
    machine.query = 6 * kMicrosecond;
    // Of no whole nanosecond, so that the rounding of a file shows.
    machine.triangle = 9'417'477;
    machine.fragment = 1'042'131;
    machine.depth_fragment = 1'042'131;
    machine.gpu_query = 1'234'567;
    machine.result_latency = 7'890'123;
    machine.fifo = 60 * kMicrosecond;
    return machine;
}

occlusion_unit::TimeSums stop_and_wait(Timeline& timeline) {
    Frame frame(timeline);
    for (int object = 1; object <= kObjects; ++object) {
        frame.ask(object);
        frame.decide(object);
    }
    return timeline.swap(0);
}

occlusion_unit::TimeSums better_order(Timeline& timeline) {
    Frame frame(timeline);
    frame.ask(1);
    frame.ask(4);
    frame.draw();
    frame.ask(2);
    frame.decide(1);
    frame.ask(6);
    frame.draw();
    frame.ask(3);
    frame.decide(2);
    frame.ask(5);
    frame.decide(3);
    frame.ask(7);
    frame.decide(5);
    frame.note(4);
    frame.note(6);
    frame.decide(7);
    return timeline.swap(0);
}

}  // namespace glext_emu
