// SPDX-License-Identifier: MIT
// A JSON file that is valid at any time, however its program ends, and that the processes of a run share:
// each write replaces the closing brackets by new records and the brackets again, under a lock. Little is
// kept in memory. What goes wrong is told in one sentence on stderr, and the program goes on without the
// file.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <mutex>
#include <string>
#include <string_view>

namespace glext_emu {

// What stands around the records, by which a file of the kind is known.
struct JsonFileKind {
    std::string_view name;
    std::string_view head;
    std::string_view tail;
};
inline constexpr JsonFileKind kReportKind{"report", "{\"glext_emu_report\":1,\"records\":[", "\n]}\n"};
// The JSON object form of the Trace Event format.
inline constexpr JsonFileKind kTimelineKind{
    "timeline", "{\"traceEvents\":[",
    "\n],\"displayTimeUnit\":\"ms\",\"otherData\":{\"glext_emu_timeline\":1}}\n"};

// <text>, which may be null, with its quotes.
std::string json_string(const char* text);

class SharedJsonFile {
  public:
    // An empty <path>: the file is not wanted.
    SharedJsonFile(std::string path, const JsonFileKind& kind);
    ~SharedJsonFile();
    SharedJsonFile(const SharedJsonFile&) = delete;
    SharedJsonFile& operator=(const SharedJsonFile&) = delete;

    // False too once the file has failed.
    bool is_wanted() const { return is_wanted_; }
    // <records>: one, or several with ",\n" between them.
    void append(std::string_view records);
    // Writes what is kept.
    void flush();
    // False while a write is under way. It may be this thread's, which a signal has interrupted for good.
    bool is_idle();
    // How many forks lie between the first process and this one.
    std::uint64_t generation() const { return generation_; }

    // Around fork, for every file, so that the child finds the doors open; what happened before is the
    // parent's to write.
    static void before_fork();
    static void after_fork(bool is_child);

  private:
    void flush_locked();

    const std::string path_;
    const JsonFileKind& kind_;
    std::atomic<bool> is_wanted_;
    std::atomic<std::uint64_t> generation_{0};
    std::mutex mutex_;
    std::string buffer_;
    std::chrono::steady_clock::time_point last_flush_{};
    SharedJsonFile* next_ = nullptr;  // of all files
};

}  // namespace glext_emu
