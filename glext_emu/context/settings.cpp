// SPDX-License-Identifier: MIT
#include "context/settings.h"

#include <sys/auxv.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <climits>
#include <cstdio>
#include <cstdlib>

namespace glext_emu {

bool Settings::steps_aside() const {
    return off ||
           (device.name == "native" && device.is_pass_through() &&
            latency.kind == occlusion_unit::ClockKind::kNone && report_path.empty() && doctor_path.empty());
}

namespace {

// Part of a library's name, so no path; and not this layer's own, which would stand before itself.
bool is_driver_name(std::string_view name) {
    return !name.empty() && name != "glextemu" && name.find('/') == std::string_view::npos;
}

std::string quoted(std::string_view text) {
    return "`" + std::string(text) + "`";
}

// "A..B", "A.." or "A".
std::optional<FrameRange> parse_frames(std::string_view text) {
    const auto dots = text.find("..");
    const auto number = [](std::string_view digits, std::uint64_t& out) {
        const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), out);
        return error == std::errc{} && end == digits.data() + digits.size();
    };
    FrameRange range;
    if (!number(text.substr(0, dots), range.first)) return std::nullopt;
    if (dots == std::string_view::npos) {
        range.last = range.first;
    } else if (const std::string_view last = text.substr(dots + 2); !last.empty()) {
        if (!number(last, range.last) || range.last < range.first) return std::nullopt;
    }
    return range;
}

bool switch_off(std::string_view names, occlusion_unit::Effects& effects) {
    while (!names.empty()) {
        const std::string_view name = names.substr(0, names.find('+'));
        names.remove_prefix(std::min(names.size(), name.size() + 1));
        const auto found = std::ranges::find(occlusion_unit::kEffectNames, name);
        if (found == occlusion_unit::kEffectNames.end()) return false;
        effects.reset(static_cast<std::size_t>(found - occlusion_unit::kEffectNames.begin()));
    }
    return true;
}

// A key, what reads its value, and what is said of a value that it does not take.
struct KeyReader {
    std::string_view key;
    bool (*read)(std::string_view value, Settings& settings);
    const char* complaint = "";
};
constexpr KeyReader kReaders[] = {
    {"device", [](std::string_view, Settings&) { return true; }},  // read last
    {"clock",
     [](std::string_view value, Settings& settings) {
         const auto latency = occlusion_unit::Latency::parse(value);
         if (latency) settings.latency = *latency;
         return latency.has_value();
     },
     " is not a clock, expected none, wall=MICROSECONDS, calls=N, frames=N or device."},
    {"report",
     [](std::string_view value, Settings& settings) {
         settings.report_path = value;
         return true;
     }},
    {"timeline",
     [](std::string_view value, Settings& settings) {
         settings.timeline_path = value;
         return true;
     }},
    {"frames",
     [](std::string_view value, Settings& settings) {
         const auto frames = parse_frames(value);
         if (frames) settings.timeline_frames = *frames;
         return frames.has_value();
     },
     " is not a range of frames, expected A..B, A.. or A."},
    {"without",
     [](std::string_view value, Settings& settings) { return switch_off(value, settings.effects); },
     " is not a list of effects, expected some of latency, back-pressure, fill, driver-copy, multisampling, "
     "read-cost, starvation, saturation, depth-quantisation."},
    {"fragments",
     [](std::string_view value, Settings& settings) {
         settings.counts_all_fragments = value == "all";
         return value == "all" || value == "some";
     },
     " is not a choice for fragments=, expected all or some."},
    {"dry",
     [](std::string_view value, Settings& settings) {
         settings.is_dry = value == "1";
         return value == "0" || value == "1";
     },
     " is not a choice for dry=, expected 0 or 1."},
    {"probe",
     [](std::string_view value, Settings& settings) {
         settings.probes_unit = true;
         return value == "unit";
     },
     " is not a probe, expected unit."},
    {"driver",
     [](std::string_view value, Settings& settings) {
         settings.driver = value;
         return is_driver_name(value);
     },
     " is not a driver, expected a GLVND vendor's name."},
    {"doctor",
     [](std::string_view value, Settings& settings) {
         settings.doctor_path = value;
         return true;
     }},
};

// One sentence where settings do not go together, else nothing.
std::string contradiction(const Settings& settings) {
    if (settings.probes_unit && settings.report_path.empty())
        return "The probe writes into the report, so probe= wants report=FILE.";
    if (settings.latency.kind != occlusion_unit::ClockKind::kDevice) {
        const char* const needy = !settings.timeline_path.empty() ? "A timeline"
                                  : settings.is_dry               ? "A dry run"
                                                                  : nullptr;
        if (needy != nullptr)
            return std::string(needy) + " is about the device's time, so it wants the clock `device`.";
    } else if (!settings.device.time) {
        return "The device " + quoted(settings.device.name) +
               " has no [time], so the clock `device` has nothing to go by.";
    }
    const FrameRange& frames = settings.timeline_frames;
    const bool chooses_frames = frames.first != FrameRange{}.first || frames.last != FrameRange{}.last;
    if (chooses_frames && settings.timeline_path.empty())
        return "Frames are chosen for the timeline, so there has to be a file for it.";
    return "";
}

}  // namespace

SettingsOrError parse_settings(const char* text) {
    SettingsOrError result;
    Settings& settings = result.settings;
    std::string_view device_name = "native";
    std::string_view rest = text == nullptr ? "" : text;
    if (rest == "0") {
        settings.off = true;
        return result;
    }
    while (!rest.empty()) {
        const std::string_view item = rest.substr(0, rest.find(','));
        rest.remove_prefix(std::min(rest.size(), item.size() + 1));
        const std::string_view key = item.substr(0, item.find('='));
        const std::string_view value = item.substr(std::min(item.size(), key.size() + 1));
        const auto reader = std::ranges::find(kReaders, key, &KeyReader::key);
        if (reader == std::end(kReaders)) {
            result.error = quoted(item) +
                           " is not a setting, expected device=, clock=, report=, timeline=, frames=, "
                           "without=, fragments=, dry= or probe=.";
        } else if (!reader->read(value, settings)) {
            result.error = quoted(value) + reader->complaint;
        }
        if (!result.error.empty()) return result;
        if (key == "device") device_name = value;
    }
    DeviceOrError device = load_device(device_name);
    if (device.device) {
        settings.device = std::move(*device.device);
        result.error = contradiction(settings);
    } else {
        result.error = std::move(device.error);
    }
    return result;
}

namespace {

// A path that stays right when the program changes its folder; the empty one stays empty.
std::string absolute(const std::string& path) {
    char folder[PATH_MAX];
    if (path.empty() || path.front() == '/' || getcwd(folder, sizeof folder) == nullptr) return path;
    return std::string(folder) + "/" + path;
}

}  // namespace

const Settings& settings() {
    // Leaked on purpose: GL may be called after static destructors have run.
    static const Settings* const instance = [] {
        auto* made = new Settings;
        if (getauxval(AT_SECURE) != 0) {
            made->off = true;
            return made;
        }
        SettingsOrError parsed = parse_settings(std::getenv("GLEXT_EMU"));
        if (!parsed.error.empty()) {
            std::fprintf(stderr, "glext_emu: %s\n", parsed.error.c_str());
            _exit(2);
        }
        *made = std::move(parsed.settings);
        made->report_path = absolute(made->report_path);
        made->timeline_path = absolute(made->timeline_path);
        return made;
    }();
    return *instance;
}

}  // namespace glext_emu
