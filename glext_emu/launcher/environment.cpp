// SPDX-License-Identifier: MIT
// How the layer gets under a program: the variables that the dynamic linker, GLVND and the layer read.
#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <sstream>

#include "context/settings.h"
#include "launcher/commands.h"
#include "launcher/elf_file.h"

namespace glext_emu::launcher {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kSeam = "libglext_emu.so";
constexpr std::string_view kExports = "libglext_emu_exports.so";
constexpr std::string_view kVendor = "libGLX_glextemu.so.0";
constexpr std::string_view kVendorName = "glextemu";          // as libGLX knows it
constexpr std::string_view kVendorFile = "50_glextemu.json";  // as libEGL does
constexpr const char* kGlxVendor = "__GLX_VENDOR_LIBRARY_NAME";
constexpr const char* kEglVendors = "__EGL_VENDOR_LIBRARY_FILENAMES";

std::string variable(const char* name) {
    const char* value = std::getenv(name);
    return value == nullptr ? "" : value;
}

// Beside the launcher as it is built and as it is installed.
fs::path layer_file(std::string_view name) {
    const fs::path here = fs::read_symlink("/proc/self/exe").parent_path();
    for (const char* place : {"../lib", "../lib/x86_64-linux-gnu", "."}) {
        fs::path file = (here / place / name).lexically_normal();
        if (!fs::exists(file)) continue;
        // ld.so and GLVND separate their lists by these.
        if (file.string().find_first_of(": ;") != std::string::npos)
            throw BadUse(fmt::format("{} cannot be loaded: its path holds a space, a colon or a semicolon.",
                                     file.string()));
        return file;
    }
    throw BadUse(fmt::format("{} is neither in ../lib nor beside {}.", name, here.string()));
}

// A path that stays right when the program changes its folder, and that the comma list can hold.
std::string absolute(const std::string& path) {
    std::string whole = fs::absolute(path).lexically_normal().string();
    if (whole.find(',') != std::string::npos)
        throw BadUse(fmt::format("{}: a path must not hold a comma.", whole));
    return whole;
}

bool needs(const std::string& program, std::string_view library) {
    const std::vector<std::string> needed = read_elf(program).needed;
    return std::ranges::any_of(needed, [&](const std::string& name) { return name.starts_with(library); });
}

// <library>, or nothing, first, so that no other interposer stands between it and the program; the layer's
// libraries that were there before dropped; a sanitizer's runtime before everything, since it insists.
std::optional<std::string> preload_with(const std::string& library, const std::string& program) {
    std::string preload;
    const auto add = [&](const std::string& item) { preload += (preload.empty() ? "" : ":") + item; };
    if (!library.empty()) {
        for (const std::string& needed : read_elf(program).needed) {
            if (needed.starts_with("libasan.so") || needed.starts_with("libtsan.so")) add(needed);
        }
        add(library);
    }
    std::string list = variable("LD_PRELOAD");
    std::ranges::replace(list, ' ', ':');
    std::istringstream items(list);
    for (std::string item; std::getline(items, item, ':');) {
        const fs::path name = fs::path(item).filename();
        if (!item.empty() && name != kSeam && name != kExports) add(item);
    }
    return preload.empty() ? std::nullopt : std::optional(preload);
}

bool is_under_vendor() {
    return variable(kGlxVendor) == kVendorName;
}

// The driver that GLVND would load without the layer, as far as the environment tells; empty where it does
// not.
std::string driver_before() {
    if (!is_under_vendor()) return variable(kGlxVendor);
    const SettingsOrError outer = parse_settings(std::getenv("GLEXT_EMU"));
    return outer.error.empty() ? outer.settings.driver : "";
}

std::string front_for(const RunOptions& options, const std::string& program) {
    if (options.front.empty()) return needs(program, "libOSMesa") ? "export" : "seam";
    if (options.front != "seam" && options.front != "vendor" && options.front != "export")
        throw BadUse(fmt::format("`{}` is not a front end, expected seam, vendor or export.", options.front));
    return options.front;
}

}  // namespace

void Environment::apply() const {
    for (const auto& [name, value] : variables) {
        if (value) {
            setenv(name.c_str(), value->c_str(), 1);
        } else {
            unsetenv(name.c_str());
        }
    }
}

Environment environment_for(const RunOptions& options, const std::string& doctor_file) {
    const bool is_path =
        options.device.find('/') != std::string::npos || std::string_view(options.device).ends_with(".toml");
    std::string settings =
        "device=" + (is_path ? absolute(options.device) : options.device) + ",clock=" + options.clock;
    if (!options.report.empty()) settings += ",report=" + absolute(options.report);
    if (!options.timeline.empty()) settings += ",timeline=" + absolute(options.timeline);
    if (!options.frames.empty()) settings += ",frames=" + options.frames;
    if (!options.without.empty()) {
        std::string effects = options.without;
        std::ranges::replace(effects, ',', '+');
        settings += ",without=" + effects;
    }
    if (options.counts_all_fragments) settings += ",fragments=all";
    if (options.is_dry) settings += ",dry=1";
    if (!options.probe.empty()) {
        if (options.report.empty())
            throw BadUse("--probe writes into the report, so it wants --report FILE.");
        settings += ",probe=" + options.probe;
    }
    if (!doctor_file.empty()) settings += ",doctor=" + doctor_file;

    const std::string program = find_program(options.program.front());
    Environment environment;
    environment.front = front_for(options, program);
    auto& variables = environment.variables;
    const std::string driver = driver_before();
    if (environment.front == "vendor") {
        const fs::path folder = layer_file(kVendor).parent_path();
        const std::string path = variable("LD_LIBRARY_PATH");
        if (!driver.empty()) settings += ",driver=" + driver;
        variables[kGlxVendor] = kVendorName;
        variables[kEglVendors] = layer_file(kVendorFile).string();
        variables["LD_LIBRARY_PATH"] = folder.string() + (path.empty() ? "" : ":" + path);
        variables["LD_PRELOAD"] = preload_with("", program);
    } else {
        const bool is_export = environment.front == "export";
        variables["LD_PRELOAD"] = preload_with(layer_file(is_export ? kExports : kSeam).string(), program);
        if (is_under_vendor()) {
            variables[kGlxVendor] = driver.empty() ? std::nullopt : std::optional(driver);
            variables[kEglVendors] = std::nullopt;
        }
    }
    const SettingsOrError parsed = parse_settings(settings.c_str());
    if (!parsed.error.empty()) throw BadUse(parsed.error);
    variables["GLEXT_EMU"] = settings;
    return environment;
}

}  // namespace glext_emu::launcher
