// SPDX-License-Identifier: MIT
// One event of the Trace Event format, written as it is described: first its fields, then its arguments.
// Whole numbers only, since printf's decimal point is the locale's.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace glext_emu {

class TraceEvent {
  public:
    // Appends to <out>, after a comma if there is something. <phase> is the format's "ph"; <number>, if it is
    // not 0, ends the name: "query 17". <name> and <category> are plain words. Of a <category> there may be
    // none.
    TraceEvent(std::string& out, char phase, std::uint64_t process, std::uint64_t thread,
               std::string_view category, std::string_view name, std::uint64_t number = 0);
    // Ends it.
    ~TraceEvent();
    TraceEvent(const TraceEvent&) = delete;
    TraceEvent& operator=(const TraceEvent&) = delete;

    TraceEvent& at(std::int64_t nanoseconds);
    TraceEvent& lasting(std::int64_t nanoseconds);
    // 16 digits of base 16, as viewers read ids.
    TraceEvent& id(std::uint64_t id);
    TraceEvent& field(std::string_view key, std::string_view plain_text);

    TraceEvent& argument(std::string_view key, std::uint64_t value);
    // Exact, in milliseconds.
    TraceEvent& milliseconds(std::string_view key, std::int64_t picoseconds);
    TraceEvent& microseconds(std::string_view key, std::int64_t picoseconds);
    // Text with its quotes, or true, or false.
    TraceEvent& json(std::string_view key, std::string_view value);

  private:
    void add_key(std::string_view key);
    void add_argument_key(std::string_view key);

    std::string& out_;
    bool has_arguments_ = false;
};

}  // namespace glext_emu
