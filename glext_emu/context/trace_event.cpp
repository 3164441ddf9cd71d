// SPDX-License-Identifier: MIT
#include "context/trace_event.h"

#include <charconv>

namespace glext_emu {
namespace {

void add_number(std::string& out, std::uint64_t number) {
    char digits[20];
    out.append(digits, std::to_chars(digits, digits + sizeof digits, number).ptr);
}

// <number> / 10^<decimals>, which is not negative, without zeros at its end.
void add_decimal(std::string& out, std::int64_t number, int decimals) {
    std::int64_t unit = 1;
    for (int i = 0; i < decimals; ++i) unit *= 10;
    add_number(out, static_cast<std::uint64_t>(number / unit));
    std::int64_t rest = number % unit;
    if (rest != 0) out += '.';
    while (rest != 0) {
        unit /= 10;
        out += static_cast<char>('0' + rest / unit);
        rest %= unit;
    }
}

}  // namespace

TraceEvent::TraceEvent(std::string& out, char phase, std::uint64_t process, std::uint64_t thread,
                       std::string_view category, std::string_view name, std::uint64_t number)
    : out_(out) {
    if (!out_.empty()) out_ += ",\n";
    out_ += "{\"ph\":\"";
    out_ += phase;
    out_ += "\",\"pid\":";
    add_number(out_, process);
    out_ += ",\"tid\":";
    add_number(out_, thread);
    if (!category.empty()) field("cat", category);
    add_key("name");
    out_ += '"';
    out_ += name;
    if (number != 0) {
        out_ += ' ';
        add_number(out_, number);
    }
    out_ += '"';
}

TraceEvent::~TraceEvent() {
    out_ += has_arguments_ ? "}}" : "}";
}

void TraceEvent::add_key(std::string_view key) {
    out_ += ",\"";
    out_ += key;
    out_ += "\":";
}

void TraceEvent::add_argument_key(std::string_view key) {
    if (has_arguments_) return add_key(key);
    has_arguments_ = true;
    out_ += ",\"args\":{\"";
    out_ += key;
    out_ += "\":";
}

TraceEvent& TraceEvent::at(std::int64_t nanoseconds) {
    add_key("ts");
    add_decimal(out_, nanoseconds, 3);
    return *this;
}

TraceEvent& TraceEvent::lasting(std::int64_t nanoseconds) {
    add_key("dur");
    add_decimal(out_, nanoseconds, 3);
    return *this;
}

TraceEvent& TraceEvent::id(std::uint64_t id) {
    char digits[16];
    const char* const end = std::to_chars(digits, digits + sizeof digits, id, 16).ptr;
    add_key("id");
    out_ += '"';
    out_.append(sizeof digits - static_cast<std::size_t>(end - digits), '0');
    out_.append(static_cast<const char*>(digits), end);
    out_ += '"';
    return *this;
}

TraceEvent& TraceEvent::field(std::string_view key, std::string_view plain_text) {
    add_key(key);
    out_ += '"';
    out_ += plain_text;
    out_ += '"';
    return *this;
}

TraceEvent& TraceEvent::argument(std::string_view key, std::uint64_t value) {
    add_argument_key(key);
    add_number(out_, value);
    return *this;
}

TraceEvent& TraceEvent::milliseconds(std::string_view key, std::int64_t picoseconds) {
    add_argument_key(key);
    add_decimal(out_, picoseconds, 9);
    return *this;
}

TraceEvent& TraceEvent::microseconds(std::string_view key, std::int64_t picoseconds) {
    add_argument_key(key);
    add_decimal(out_, picoseconds, 6);
    return *this;
}

TraceEvent& TraceEvent::json(std::string_view key, std::string_view value) {
    add_argument_key(key);
    out_ += value;
    return *this;
}

}  // namespace glext_emu
