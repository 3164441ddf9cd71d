// SPDX-License-Identifier: MIT
// The report: one JSON object that is valid at any time, however the program ends. Each write replaces the
// closing brackets by new records and the brackets again, under a lock, so that processes of one run can
// share a file:
//
//   {"glext_emu_report":1,"records":[
//   {"kind":"context","pid":..,"program":..,"context":..,"platform":..,"device":..,"clock":..,"renderer":..,"version":..},
//   {"kind":"frame","pid":..,"context":..,"frame":..,"queries_begun":..,"polls":..,"waits":..,"stall_ms":..,
//    "results":..,"draws":..,"pixels_read":..,"triangles":.. or null}
//     under --clock device also, in milliseconds of the device's time: "device_ms" from swap to swap,
//     "gpu_busy_ms", "device_stall_ms", "back_pressure_ms", "starvation_ms", "drain_ms"
//   {"kind":"effect","pid":..,"context":..,"effect":..,"on":..,"called_for":..,"reason":..,"ms":.. or null}
//   {"kind":"probe","pid":..,"context":..,"frame":..,"query":..,"target":..,"draws":..,"far":0 or 1,
//    "visible":..,"projected_hits":..,"visible_hits":..,"nearest_depth":..,
//    "screen_box":[left,bottom,right,top] or null}
//   ]}
//
// An effect record says what an effect of the device's time was worth to the context, when it ends.
// A probe record is one of the program's queries, with its name; a register that cannot be told is null. They
// come when they are known, which may be frames later.
//
// A frame ends at a buffer swap; what follows the last swap is a frame of its own if anything happened in it.
#pragma once

#include <atomic>
#include <chrono>
#include <mutex>
#include <string>

#include "occlusion_unit/record.h"

namespace glext_emu {

struct Context;
struct ProbedQuery;

class Report {
  public:
    // One for the process, never freed.
    static Report& instance();

    // Does nothing in a process that never had a context.
    static void flush_at_exit();

    // Around fork, so that the child finds the door open; what happened before is the parent's to write.
    static void before_fork();
    static void after_fork(bool is_child);

    bool is_wanted() const { return is_wanted_; }
    void begin_context(const Context& ctx);
    void end_frame(Context& ctx);
    void end_context(Context& ctx);
    // <query>, one of <ctx>, has the registers <record>.
    void add_probe(const Context& ctx, const ProbedQuery& query, const occlusion_unit::Record& record);
    // Writes what is buffered.
    void flush();

    // What the effects of the device's time were worth to <ctx>.
    void add_effects(const Context& ctx);

  private:
    Report();
    void append(const std::string& record);
    void flush_locked();
    void add_frame(Context& ctx);

    static std::atomic<Report*> made_;

    std::string path_;
    std::atomic<bool> is_wanted_;  // false too once the file has failed
    std::mutex mutex_;
    std::string buffer_;
    std::chrono::steady_clock::time_point last_flush_{};
};

}  // namespace glext_emu
