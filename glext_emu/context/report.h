// SPDX-License-Identifier: MIT
// The report: one JSON object that is valid at any time, however the program ends. Each write replaces the
// closing brackets by new records and the brackets again, under a lock, so that processes of one run can
// share a file:
//
//   {"glext_emu_report":1,"records":[
//   {"kind":"context","pid":..,"program":..,"context":..,"platform":..,"device":..,"clock":..,"renderer":..,"version":..},
//   {"kind":"frame","pid":..,"context":..,"frame":..,"queries_begun":..,"polls":..,"waits":..,"stall_ms":..,
//    "results":..,"draws":..,"triangles":.. or null}
//   ]}
//
// A frame ends at a buffer swap; what follows the last swap is a frame of its own if anything happened in it.
#pragma once

#include <atomic>
#include <chrono>
#include <mutex>
#include <string>

namespace glext_emu {

struct Context;

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
    // Writes what is buffered.
    void flush();

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
