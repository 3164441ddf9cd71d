// SPDX-License-Identifier: MIT
#include "context/device.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <span>

#define TOML_EXCEPTIONS 0
#define TOML_ENABLE_UNRELEASED_FEATURES 0
// What the parser asserts of a table's header it checks again and tells as an error: a damaged file is to
// give a sentence in debug builds too.
#define TOML_ASSERT(expr) static_cast<void>(0)
#include <toml++/toml.h>

namespace glext_emu {
namespace {

struct Builtin {
    std::string_view name;
    std::string_view text;
};
constexpr Builtin kBuiltins[] = {
#include "builtin_devices.inc"
};

constexpr std::string_view kCanEmulate[] = {
    "GL_HP_occlusion_test",          "GL_HP_visibility_test",     "GL_NV_occlusion_query",
    "GL_NVX_conditional_render",     "GL_SGIX_instruments",       "GL_SGIX_occlusion_instrument",
    "GL_SGIX_depth_pass_instrument", "GL_EMU_depth_region_query", "GL_EMU_occlusion_unit"};
// A device file larger than this is not one.
constexpr long kLongestFile = 1 << 20;

std::string quoted_list(std::span<const std::string_view> words) {
    std::string list;
    for (const std::string_view word : words) {
        if (!list.empty()) list += ", ";
        list += word;
    }
    return list;
}

// Reads keys of one table, remembers the first thing that is wrong.
class Reader {
  public:
    Reader(const toml::table& table, std::string_view file, std::string& error)
        : table_(table), file_(file), error_(error) {}

    void allow_only(std::span<const std::string_view> keys) {
        for (const auto& [key, value] : table_) {
            if (std::ranges::find(keys, key.str()) != keys.end()) continue;
            complain(key.source().begin.line,
                     "unknown key `" + std::string(key.str()) + "`, expected one of " + quoted_list(keys));
        }
    }

    void string(std::string_view key, std::string& out, bool required) {
        const toml::node* node = table_.get(key);
        if (node == nullptr) {
            if (required) complain(1, "`" + std::string(key) + "` is missing, expected a string");
        } else if (const auto value = node->value_exact<std::string>()) {
            out = *value;
        } else {
            complain(line(*node), "`" + std::string(key) + "` is not a string");
        }
    }

    void integer(std::string_view key, int low, int high, std::optional<int>& out) {
        const toml::node* node = table_.get(key);
        if (node == nullptr) return;
        const auto value = node->value_exact<std::int64_t>();
        if (value && *value >= low && *value <= high) {
            out = static_cast<int>(*value);
        } else {
            complain(line(*node), "`" + std::string(key) + "` is not a whole number from " +
                                      std::to_string(low) + " to " + std::to_string(high));
        }
    }

    // A number from <low> to <high>, times <scale>, rounded.
    void number(std::string_view key, double low, double high, double scale, std::int64_t& out) {
        if (const auto value = number(key, low, high)) out = std::llround(*value * scale);
    }

    std::optional<double> number(std::string_view key, double low, double high) {
        const toml::node* node = table_.get(key);
        if (node == nullptr) return std::nullopt;
        const auto value = node->is_number() ? node->value<double>() : std::nullopt;
        if (value && *value >= low && *value <= high) return value;
        char range[96];
        std::snprintf(range, sizeof range, "` is not a number from %g to %g", low, high);
        complain(line(*node), "`" + std::string(key) + range);
        return std::nullopt;
    }

    void extensions(std::string_view key, std::vector<std::string>& out) {
        const toml::node* node = table_.get(key);
        if (node == nullptr) return;
        const toml::array* array = node->as_array();
        if (array == nullptr) {
            return complain(line(*node), "`" + std::string(key) + "` is not a list of extension names");
        }
        for (const toml::node& element : *array) {
            const auto name = element.value_exact<std::string>();
            if (!name || !name->starts_with("GL_") || name->find(' ') != std::string::npos) {
                return complain(line(element), "`" + std::string(key) +
                                                   "` holds something other than an extension name such as "
                                                   "\"GL_ARB_occlusion_query\"");
            }
            out.push_back(*name);
        }
    }

    const toml::table* table(std::string_view key) {
        const toml::node* node = table_.get(key);
        if (node == nullptr) return nullptr;
        if (!node->is_table()) complain(line(*node), "`" + std::string(key) + "` is not a table");
        return node->as_table();
    }

    void complain(unsigned line, const std::string& what) {
        if (error_.empty()) error_ = std::string(file_) + ":" + std::to_string(line) + ": " + what + ".";
    }
    unsigned line_of(std::string_view key) const { return line(*table_.get(key)); }

  private:
    static unsigned line(const toml::node& node) { return node.source().begin.line; }

    const toml::table& table_;
    std::string_view file_;
    std::string& error_;
};

// "1.5": one digit, a point, one digit, from 1.0 to 4.6.
std::optional<GlVersion> parse_version(std::string_view text) {
    const auto digit = [](char c) { return c >= '0' && c <= '9'; };
    if (text.size() != 3 || !digit(text[0]) || text[1] != '.' || !digit(text[2])) return std::nullopt;
    const GlVersion version{text[0] - '0', text[2] - '0'};
    if (version < GlVersion{1, 0} || version > GlVersion{4, 6}) return std::nullopt;
    return version;
}

using occlusion_unit::Profile;

// The keys of [time], each with what a unit of it is in that of the profile.
struct TimeKey {
    std::string_view key;
    std::int64_t Profile::*member;
    enum class Kind { kSpan, kEach, kRate, kSize } kind;
};
constexpr double kPicosecondsPerMicrosecond = 1e6;
constexpr double kFemtosecondsPerNanosecond = 1e6;
constexpr double kFemtosecondsPerSecond = 1e15;
constexpr double kBytesPerMegabyte = 1 << 20;
constexpr TimeKey kTimeKeys[] = {
    {"swap_us", &Profile::swap, TimeKey::Kind::kSpan},
    {"batch_us", &Profile::batch, TimeKey::Kind::kSpan},
    {"query_us", &Profile::query, TimeKey::Kind::kSpan},
    {"poll_us", &Profile::poll, TimeKey::Kind::kSpan},
    {"read_us", &Profile::read, TimeKey::Kind::kSpan},
    {"copied_triangle_ns", &Profile::copied_triangle, TimeKey::Kind::kEach},
    {"gpu_batch_us", &Profile::gpu_batch, TimeKey::Kind::kSpan},
    {"triangles_per_second", &Profile::triangle, TimeKey::Kind::kRate},
    {"fragments_per_second", &Profile::fragment, TimeKey::Kind::kRate},
    {"depth_fragments_per_second", &Profile::depth_fragment, TimeKey::Kind::kRate},
    {"cleared_pixels_per_second", &Profile::cleared_pixel, TimeKey::Kind::kRate},
    {"swapped_pixels_per_second", &Profile::swapped_pixel, TimeKey::Kind::kRate},
    {"gpu_query_us", &Profile::gpu_query, TimeKey::Kind::kSpan},
    {"result_latency_us", &Profile::result_latency, TimeKey::Kind::kSpan},
    {"region_pixels_per_second", &Profile::region_pixel, TimeKey::Kind::kRate},
    {"fifo_us", &Profile::fifo, TimeKey::Kind::kSpan},
    {"read_pixels_per_second", &Profile::read_pixel, TimeKey::Kind::kRate},
    {"video_memory_mb", &Profile::video_memory, TimeKey::Kind::kSize},
};

void read_time_key(Reader& time, const TimeKey& key, Profile& profile) {
    constexpr double kHourUs = 3.6e9;
    std::int64_t& out = profile.*key.member;
    switch (key.kind) {
        case TimeKey::Kind::kSpan:
            return time.number(key.key, 0, kHourUs, kPicosecondsPerMicrosecond, out);
        case TimeKey::Kind::kEach:
            return time.number(key.key, 0, 1e9, kFemtosecondsPerNanosecond, out);
        case TimeKey::Kind::kRate:
            if (const auto rate = time.number(key.key, 1, 1e15))
                out = std::llround(kFemtosecondsPerSecond / *rate);
            return;
        case TimeKey::Kind::kSize:
            return time.number(key.key, 0, 1e7, kBytesPerMegabyte, out);
    }
}

// The time of the built-in device <name>, which other devices may build on.
std::optional<MachineTime> time_of_builtin(std::string_view name);

void read_time(const toml::table& table, std::string_view file, bool may_have_base, Device& device,
               std::string& error) {
    Reader time(table, file, error);
    static const std::vector<std::string_view> known = [] {
        std::vector<std::string_view> keys = {"source", "quality", "base"};
        for (const TimeKey& key : kTimeKeys) keys.push_back(key.key);
        return keys;
    }();
    time.allow_only(known);

    MachineTime machine;
    std::string base;
    time.string("base", base, false);
    if (!base.empty()) {
        const auto found = may_have_base ? time_of_builtin(base) : std::nullopt;
        if (found) {
            machine = *found;
        } else {
            time.complain(time.line_of("base"),
                          "`base` does not name a built-in device that has a [time] without a base");
        }
    }
    time.string("source", machine.source, true);
    time.string("quality", machine.quality, true);
    static constexpr std::string_view kQualities[] = {"fitted", "indicative", "assumed"};
    if (error.empty() && std::ranges::find(kQualities, machine.quality) == std::end(kQualities)) {
        time.complain(time.line_of("quality"), "`quality` is none of " + quoted_list(kQualities));
    }
    for (const TimeKey& key : kTimeKeys) read_time_key(time, key, machine.profile);
    // A program that polls until a result is there has to come to an end.
    if (error.empty() && machine.profile.poll <= 0)
        time.complain(time.line_of("poll_us"), "`poll_us` is zero, so polling would take for ever");
    device.time = std::move(machine);
}

}  // namespace

bool Device::emulates(std::string_view extension) const {
    return std::ranges::find(emulate, extension) != emulate.end();
}

bool Device::hides(std::string_view extension) const {
    return std::ranges::find(hide, extension) != hide.end();
}

bool Device::is_pass_through() const {
    return !gl_version && emulate.empty() && hide.empty() && !counter_bits;
}

std::vector<std::string_view> builtin_device_names() {
    std::vector<std::string_view> names;
    for (const Builtin& builtin : kBuiltins) names.push_back(builtin.name);
    return names;
}

namespace {

DeviceOrError parse(std::string_view text, std::string_view file, bool may_have_base) {
    DeviceOrError result;
    const toml::parse_result parsed = toml::parse(text, file);
    if (!parsed) {
        result.error = std::string(file) + ":" + std::to_string(parsed.error().source().begin.line) + ": " +
                       std::string(parsed.error().description()) + ".";
        return result;
    }

    Device device;
    Reader root(parsed.table(), file, result.error);
    static constexpr std::string_view kRootKeys[] = {"name",       "description", "source", "year",
                                                     "gl_version", "extensions",  "query",  "unit",
                                                     "region",     "time"};
    root.allow_only(kRootKeys);
    root.string("name", device.name, true);
    root.string("description", device.description, true);
    root.string("source", device.source, true);
    root.integer("year", 1980, 2100, device.year);

    std::string version;
    root.string("gl_version", version, false);
    if (result.error.empty() && parsed.table().contains("gl_version")) {
        device.gl_version = parse_version(version);
        if (!device.gl_version) {
            root.complain(root.line_of("gl_version"),
                          "`gl_version` is not a version from \"1.0\" to \"4.6\"");
        }
    }
    if (const toml::table* table = root.table("extensions")) {
        Reader extensions(*table, file, result.error);
        static constexpr std::string_view kKeys[] = {"emulate", "hide"};
        extensions.allow_only(kKeys);
        extensions.extensions("emulate", device.emulate);
        extensions.extensions("hide", device.hide);
        for (const std::string& name : device.emulate) {
            if (std::ranges::find(kCanEmulate, name) != std::end(kCanEmulate)) continue;
            extensions.complain(extensions.line_of("emulate"),
                                name + " cannot be emulated, expected one of " + quoted_list(kCanEmulate));
        }
        if (device.emulates("GL_NV_occlusion_query") && !device.emulates("GL_HP_occlusion_test")) {
            extensions.complain(extensions.line_of("emulate"),
                                "GL_NV_occlusion_query requires GL_HP_occlusion_test beside it");
        }
    }
    if (const toml::table* table = root.table("query")) {
        Reader query(*table, file, result.error);
        static constexpr std::string_view kKeys[] = {"counter_bits"};
        query.allow_only(kKeys);
        query.integer("counter_bits", 1, 64, device.counter_bits);
    }
    if (const toml::table* table = root.table("unit")) {
        Reader unit(*table, file, result.error);
        static constexpr std::string_view kKeys[] = {"counter_bits",    "max_shapes", "pipes",
                                                     "coordinate_bits", "depth_bits", "report_queue"};
        unit.allow_only(kKeys);
        unit.integer("counter_bits", 1, 64, device.unit_counter_bits);
        unit.integer("max_shapes", 1, 65536, device.unit_max_shapes);
        unit.integer("pipes", 1, 64, device.unit_pipes);
        unit.integer("coordinate_bits", 1, 16, device.unit_coordinate_bits);
        unit.integer("depth_bits", 1, 32, device.unit_depth_bits);
        unit.integer("report_queue", 1, 65536, device.unit_report_queue);
    }
    if (const toml::table* table = root.table("region")) {
        Reader region(*table, file, result.error);
        static constexpr std::string_view kKeys[] = {"max_regions", "depth_bits"};
        region.allow_only(kKeys);
        region.integer("max_regions", 1, 65536, device.max_regions);
        region.integer("depth_bits", 1, 32, device.region_depth_bits);
    }
    if (const toml::table* table = root.table("time"))
        read_time(*table, file, may_have_base, device, result.error);
    if (result.error.empty()) result.device = std::move(device);
    return result;
}

std::optional<MachineTime> time_of_builtin(std::string_view name) {
    const auto builtin = std::ranges::find(kBuiltins, name, &Builtin::name);
    if (builtin == std::end(kBuiltins)) return std::nullopt;
    const DeviceOrError base = parse(builtin->text, builtin->name, false);
    return base.device ? base.device->time : std::nullopt;
}

}  // namespace

DeviceOrError parse_device(std::string_view text, std::string_view file) {
    return parse(text, file, true);
}

DeviceOrError load_device(std::string_view name_or_path) {
    if (name_or_path.find('/') == std::string_view::npos && !name_or_path.ends_with(".toml")) {
        const auto builtin = std::ranges::find(kBuiltins, name_or_path, &Builtin::name);
        if (builtin != std::end(kBuiltins)) return parse_device(builtin->text, builtin->name);
        return {std::nullopt, "there is no device `" + std::string(name_or_path) + "`; built in are " +
                                  quoted_list(builtin_device_names()) +
                                  ", and a path to a .toml file names your own."};
    }
    const std::string path(name_or_path);
    std::FILE* file = std::fopen(path.c_str(), "rbe");
    if (file == nullptr) return {std::nullopt, path + ": this device file cannot be opened."};
    std::string text(kLongestFile + 1, '\0');
    text.resize(std::fread(text.data(), 1, text.size(), file));
    const bool failed = std::ferror(file) != 0;
    std::fclose(file);
    if (failed) return {std::nullopt, path + ": this device file cannot be read."};
    if (text.size() > static_cast<std::size_t>(kLongestFile)) {
        return {std::nullopt, path + ": a device file is at most one megabyte."};
    }
    return parse_device(text, path);
}

}  // namespace glext_emu
