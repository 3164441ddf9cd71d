// SPDX-License-Identifier: MIT
// The machine in time: a processor (CPU) that makes commands, a FIFO that holds them, a graphics processor
// (GPU) that works them off in order. Fed with commands it moves two clocks; nothing else moves them, so the
// same commands always take the same time. Three ways to lose time are kept apart:
//
//   stall           the CPU waits for a result, or for pixels
//   back-pressure   the CPU waits because the FIFO is full
//   starvation      the GPU has nothing to do although the frame is not over
//
// With c and g the two clocks, and K the work that the FIFO holds:
//
//   draw     c = max(c, g-K) + batch;  g = max(g, c) + max(vertices, fragments);  c += copied triangles
//   query    c = max(c, g-K) + query;  g = max(g, c) + gpu_query + fragments;  its result is there at g +
//   latency result   c = max(c, when it is there) read     c = max(c, g) + read + pixels;  g = c finish, swap
//   c = max(c, g)
//
// A model with these terms and a program's counts reproduces the frame times of the LOG (2001) and CHC (2004)
// papers (tests/unit/paper_times_test.cpp). That a stage works while the other does, hence max(vertices,
// fragments), is how such pipelines are built; that one FIFO of a fixed amount of work stands for all their
// buffers is the simplification.
#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <string_view>

#include "occlusion_unit/profile.h"

namespace occlusion_unit {

// What a machine does that a simpler one would not; each can be switched off to see what it is worth.
enum class Effect : std::uint8_t {
    kLatency,            // a result takes its time after its query's work
    kBackPressure,       // the FIFO ends
    kFill,               // fragments cost
    kDriverCopy,         // triangles outside video memory cost
    kMultisampling,      // samples cost, not pixels
    kReadCost,           // pixels that are read back cost
    kStarvation,         // the GPU cannot work ahead of the CPU
    kSaturation,         // counters end (the timeline knows nothing of it; nor of the next)
    kDepthQuantisation,  // depths have as many bits as the device's buffer
};
constexpr std::size_t kEffectCount = 9;
using Effects = std::bitset<kEffectCount>;
constexpr std::array<std::string_view, kEffectCount> kEffectNames = {
    "latency",   "back-pressure", "fill",       "driver-copy",       "multisampling",
    "read-cost", "starvation",    "saturation", "depth-quantisation"};
constexpr Effects all_effects() {
    return Effects{(1ULL << kEffectCount) - 1};
}

// Fragments that the rasteriser makes, whether they pass a test or not.
struct Fragments {
    std::uint64_t count = 0;
    std::uint32_t samples = 1;  // of each
    bool is_depth_only = false;
};

// Of a run of draw commands.
struct DrawWork {
    std::uint64_t batches = 1;
    std::uint64_t triangles = 0;
    std::uint64_t copied_triangles = 0;  // those of them that the driver copies
    Fragments fragments = {};
};

enum class Lane : std::uint8_t { kCpu, kGpu };
enum class Activity : std::uint8_t {
    kDraw,
    kQuery,
    kClear,
    kRead,
    kRegion,
    kSwap,
    kPoll,
    kProgram,       // the program's own work
    kStall,         // CPU: waits for a result, or for pixels
    kBackPressure,  // CPU: waits for room in the FIFO
    kDrain,         // CPU: waits at a swap or Finish until all work is done
    kStarvation,    // GPU: has nothing to do
    kCondition,     // GPU: waits for the result that a conditional draw depends on
};

struct Span {
    Lane lane = Lane::kCpu;
    Activity activity = Activity::kDraw;
    Picoseconds begin = 0;
    Picoseconds end = 0;
    std::uint64_t query = 0;  // the query that it belongs to, waits for or asks about; 0: none
    std::uint64_t triangles = 0;
    std::uint64_t fragments = 0;
    Picoseconds queued = 0;  // GPU work: when it came into the FIFO, where it waited until <begin>
};

// Of a frame, or of all of them.
struct TimeSums {
    Picoseconds cpu = 0;  // the frame's time: from swap to swap
    Picoseconds gpu_busy = 0;
    Picoseconds stall = 0;
    Picoseconds result_stall = 0;  // of that, waits for results of queries
    Picoseconds back_pressure = 0;
    Picoseconds starvation = 0;
    Picoseconds drain = 0;
    // What single effects cost on the clock that they belong to.
    Picoseconds fill = 0;           // GPU time of fragments, beyond that of their vertices
    Picoseconds multisampling = 0;  // of that, what samples cost more than pixels
    Picoseconds driver_copy = 0;
    Picoseconds read_cost = 0;
    Picoseconds latency = 0;          // of waits for results, what was waited after the query's work was done
    std::uint64_t results_asked = 0;  // fetched, polled, or waited for by the GPU
    std::uint64_t copied_triangles = 0;
    std::uint64_t pixels_read = 0;
    std::uint64_t multisampled_fragments = 0;

    TimeSums& operator+=(const TimeSums& other);
};

// Is told what happens, in the order in which commands are fed; times of one lane never fall.
class TimelineListener {
  public:
    virtual ~TimelineListener() = default;
    virtual void span(const Span& span) = 0;
    // The work of <query> was done at <done>; the CPU may see its result at <available>.
    virtual void result(std::uint64_t query, Picoseconds done, Picoseconds available) = 0;
    // The program has the result of <query> at <time> on the CPU, after a stall or without one.
    virtual void fetched(std::uint64_t query, Picoseconds time) {
        static_cast<void>(query);
        static_cast<void>(time);
    }
    // A frame is over: number <index> from 0, at <end> on the CPU.
    virtual void frame(std::uint64_t index, Picoseconds end, const TimeSums& sums) = 0;
};

// When a query's work is done, and when its result may be seen.
struct ResultTime {
    std::uint64_t query = 0;  // 1, 2, ...
    Picoseconds done = 0;
    Picoseconds available = 0;
};

class Timeline {
  public:
    explicit Timeline(const Profile& profile, Effects effects = all_effects(),
                      TimelineListener* listener = nullptr)
        : profile_(profile), effects_(effects), listener_(listener) {}

    // Commands.
    void draw(const DrawWork& work);
    // A query with the bounding volume that it asks about, or <shapes> queries in one command; geometry that
    // is drawn for its own sake within it comes as a draw before.
    ResultTime query(const Fragments& volume, std::uint64_t shapes = 1);
    // <count> depth regions of <pixels> pixels in all, in one command.
    ResultTime regions(std::uint64_t count, std::uint64_t pixels);
    void clear(std::uint64_t pixels, std::uint32_t samples = 1);
    void poll(std::uint64_t query = 0);
    // The CPU needs the result: a stall, unless it is there.
    void wait(const ResultTime& result);
    // The GPU needs it.
    void wait_on_gpu(const ResultTime& result);
    // The CPU waits no longer than until <end>.
    void wait_until(Picoseconds end, std::uint64_t query = 0);
    void read(std::uint64_t pixels);
    // Pixels go to a buffer object, for which the CPU does not wait.
    void copy(std::uint64_t pixels);
    // When the GPU has done all that was fed before: a timestamp, which is seen as late as a query's result.
    ResultTime stamp();
    void finish();
    // Ends the frame; <pixels> are copied to the window. Returns the frame's sums.
    TimeSums swap(std::uint64_t pixels);
    // The program's own work on the CPU.
    void work(Picoseconds span);

    Picoseconds cpu() const { return cpu_; }
    Picoseconds gpu() const { return gpu_; }
    bool has_come(const ResultTime& result) const { return cpu_ >= result.available; }
    std::uint64_t frame_index() const { return frame_index_; }
    // Since the last swap; <cpu> is up to now.
    TimeSums frame_sums() const;
    // Since the beginning.
    TimeSums total_sums() const;

  private:
    bool has(Effect effect) const { return effects_[static_cast<std::size_t>(effect)]; }
    void tell(const Span& span);
    void make_room();
    void spend(Activity activity, Picoseconds span, std::uint64_t query = 0, std::uint64_t triangles = 0);
    void stall_until(Picoseconds end, Activity activity, Picoseconds& sum, std::uint64_t query = 0);
    // GPU work that the CPU has made ready at <ready>.
    void execute(Activity activity, Picoseconds ready, Picoseconds span, Span about);
    // What <count> times <samples> things at <each> take.
    Picoseconds fill_of(std::uint64_t count, std::uint32_t samples, Femtoseconds each);
    Picoseconds fill_of(const Fragments& fragments);
    ResultTime end_of(std::uint64_t query);

    Profile profile_;
    Effects effects_;
    TimelineListener* listener_;
    Picoseconds cpu_ = 0;
    Picoseconds gpu_ = 0;
    Picoseconds frame_begin_ = 0;
    std::uint64_t frame_index_ = 0;
    std::uint64_t queries_ = 0;
    TimeSums sums_;   // of the frame
    TimeSums total_;  // of the frames before
};

}  // namespace occlusion_unit
