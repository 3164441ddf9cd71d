// SPDX-License-Identifier: MIT
#include "context/settings.h"

#include <sys/auxv.h>
#include <unistd.h>

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
        if (key == "device") {
            device_name = value;
        } else if (key == "clock") {
            const auto latency = occlusion_unit::Latency::parse(value);
            if (!latency) {
                result.error = "`" + std::string(value) +
                               "` is not a clock, expected none, wall=MICROSECONDS, calls=N or frames=N.";
                return result;
            }
            settings.latency = *latency;
        } else if (key == "report") {
            settings.report_path = value;
        } else if (key == "probe") {
            if (value != "unit") {
                result.error = "`" + std::string(value) + "` is not a probe, expected unit.";
                return result;
            }
            settings.probes_unit = true;
        } else if (key == "driver") {
            if (!is_driver_name(value)) {
                result.error =
                    "`" + std::string(value) + "` is not a driver, expected a GLVND vendor's name.";
                return result;
            }
            settings.driver = value;
        } else if (key == "doctor") {
            settings.doctor_path = value;
        } else {
            result.error =
                "`" + std::string(item) + "` is not a setting, expected device=, clock=, report= or probe=.";
            return result;
        }
    }
    if (settings.probes_unit && settings.report_path.empty()) {
        result.error = "The probe writes into the report, so probe= wants report=FILE.";
        return result;
    }
    DeviceOrError device = load_device(device_name);
    if (device.device) {
        settings.device = std::move(*device.device);
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
        return made;
    }();
    return *instance;
}

}  // namespace glext_emu
