// SPDX-License-Identifier: MIT
// The report: one JSON object that is valid at any time, however the program ends, and that the processes of
// a run share:
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

#include "context/shared_json_file.h"
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

    // Around fork, for the timeline's file too, so that the child finds the doors open.
    static void before_fork();
    static void after_fork(bool is_child);

    bool is_wanted() const { return file_.is_wanted(); }
    void begin_context(const Context& ctx);
    void end_frame(Context& ctx);
    void end_context(Context& ctx);
    // <query>, one of <ctx>, has the registers <record>.
    void add_probe(const Context& ctx, const ProbedQuery& query, const occlusion_unit::Record& record);
    // What the effects of the device's time were worth to <ctx>.
    void add_effects(const Context& ctx);

  private:
    Report();
    void add_frame(Context& ctx);

    static std::atomic<Report*> made_;

    SharedJsonFile file_;
};

}  // namespace glext_emu
