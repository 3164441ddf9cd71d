// SPDX-License-Identifier: MIT
// The timeline as a file: what CPU, FIFO and GPU of the device did when, in the Trace Event format
// (docs.google.com/document/d/1CvAClvFfyA5R-PhYUmn5OOQtYMH4h6I0nSsKchNAySU), which ui.perfetto.dev and
// chrome://tracing open. Each context has its lanes in the program's group:
//
//   frames   a slice for each frame, with its sums
//   CPU      what the CPU did, and where it waited: stall, back-pressure, drain; instants: results to be seen
//   FIFO     each command of the GPU from when it was queued until it began (asynchronous slices, since they
//            overlap), and a counter: microseconds of work that the GPU had before it
//   GPU      what the GPU did, and where it had nothing to do: starvation
//
// A query is a flow from its command to its work to the stall or poll that fetched its result, or to what
// came next where the result was there.
//
// Viewers keep nanoseconds and drop a slice that overlaps the next by one, so the ends of slices are rounded
// down to nanoseconds; the exact length is beside, in picoseconds: "args":{"ps":..}.
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "context/settings.h"
#include "context/shared_json_file.h"
#include "occlusion_unit/timeline.h"

namespace glext_emu {

struct Context;

// One for each context; <file> outlives it.
class TimelineFile final : public occlusion_unit::TimelineListener {
  public:
    TimelineFile(SharedJsonFile& file, std::uint64_t context, FrameRange frames, std::string device);
    ~TimelineFile() override;

    void span(const occlusion_unit::Span& span) override;
    void result(std::uint64_t query, occlusion_unit::Picoseconds done,
                occlusion_unit::Picoseconds available) override;
    void fetched(std::uint64_t query, occlusion_unit::Picoseconds time) override;
    void frame(std::uint64_t index, occlusion_unit::Picoseconds end,
               const occlusion_unit::TimeSums& sums) override;

    // The frame that has begun is written as far as it has come; the context does no more. Does nothing while
    // another call is under way.
    void end();

  private:
    enum Lane : std::uint8_t { kFrames, kCpu, kFifo, kGpu };
    static constexpr std::size_t kLanes = 4;
    struct OpenFlow {
        std::uint64_t query = 0;
        occlusion_unit::Picoseconds begin = 0;
        occlusion_unit::Picoseconds available = INT64_MAX;
    };

    void begin_process();
    OpenFlow* find_flow(std::uint64_t query);
    void cpu_span(const occlusion_unit::Span& span);
    void gpu_span(const occlusion_unit::Span& span);
    void add_names();
    // The flow of what the GPU does for its query.
    void add_step(const occlusion_unit::Span& span);
    void add_slice(Lane lane, const occlusion_unit::Span& span);
    // <is_within> a slice, or at the beginning of the next.
    void add_flow(char phase, Lane lane, std::int64_t at_ns, std::uint64_t query, bool is_within = true);
    void add_wait_in_fifo(const occlusion_unit::Span& span);
    // The GPU has <work> before it at <at>.
    void add_fifo_level(occlusion_unit::Picoseconds at, occlusion_unit::Picoseconds work);
    // <sums> are null for a frame that does not end.
    void add_frame(occlusion_unit::Picoseconds end, const occlusion_unit::TimeSums* sums);
    std::uint64_t thread_of(Lane lane) const;
    std::uint64_t id_of(std::uint64_t number) const;
    void write();

    SharedJsonFile& file_;
    const std::uint64_t context_;
    const FrameRange frames_;
    const std::string device_;
    std::mutex mutex_;
    std::string text_;  // what is being made

    bool is_wanted_;  // the frame
    bool has_names_ = false;
    std::uint64_t generation_;
    std::uint64_t pid_;

    std::uint64_t frame_index_ = 0;
    occlusion_unit::Picoseconds frame_begin_ = 0;
    occlusion_unit::Picoseconds cpu_ = 0;  // the end of what was told of it
    bool is_frame_whole_ = true;           // false: it began in the process that forked
    std::uint64_t draws_ = 0;              // of the frame
    bool has_cpu_draw_ = false;            // the last of them is not yet on the GPU
    std::uint64_t fifo_commands_ = 0;
    std::vector<OpenFlow> flows_;  // by the last digits of the query
};

// Who writes down what happens in <ctx>; null where no timeline is wanted.
std::unique_ptr<occlusion_unit::TimelineListener> open_timeline_file(const Context& ctx);

// At exit: ends those that are open, and writes what is kept.
void end_timeline_files();
// Around fork, the file's own doors excepted.
void hold_timeline_files();
void release_timeline_files();

}  // namespace glext_emu
