// SPDX-License-Identifier: MIT
#include <errno.h>
#include <fcntl.h>
#include <fmt/core.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "context/settings.h"
#include "launcher/commands.h"
#include "launcher/elf_file.h"

namespace glext_emu::launcher {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kLibrary = "libglext_emu.so";
constexpr std::string_view kReportStart = "{\"glext_emu_report\":1,";
constexpr std::string_view kEmptyReport = "{\"glext_emu_report\":1,\"records\":[\n]}\n";

// Beside the launcher as it is built and as it is installed.
std::string layer_library() {
    const fs::path here = fs::read_symlink("/proc/self/exe").parent_path();
    for (const char* place : {"../lib", "../lib/x86_64-linux-gnu", "."}) {
        const fs::path library = (here / place / kLibrary).lexically_normal();
        if (fs::exists(library)) return library.string();
    }
    throw BadUse(fmt::format("{} is neither in ../lib nor beside {}.", kLibrary, here.string()));
}

// A path that stays right when the program changes its folder, and that the comma list can hold.
std::string absolute(const std::string& path) {
    std::string whole = fs::absolute(path).lexically_normal().string();
    if (whole.find(',') != std::string::npos)
        throw BadUse(fmt::format("{}: a path must not hold a comma.", whole));
    return whole;
}

// An empty report, over an older one; nothing else is overwritten.
void start_report(const std::string& path) {
    std::error_code ignored;
    if (fs::exists(path, ignored) && fs::file_size(path, ignored) != 0) {
        std::string start(kReportStart.size(), '\0');
        std::ifstream(path).read(start.data(), static_cast<std::streamsize>(start.size()));
        if (start != kReportStart) throw BadUse(fmt::format("{} exists and is not a report.", path));
    }
    std::ofstream file(path, std::ios::trunc);
    file << kEmptyReport;
    if (!file.flush()) throw BadUse(fmt::format("the report {} cannot be written.", path));
}

// Ours first, so that no other interposer stands between it and the program; earlier copies of it dropped; a
// sanitizer's runtime before everything, since it insists.
std::string preload_with(const std::string& library, const std::string& program) {
    std::string preload;
    const auto add = [&](const std::string& item) { preload += (preload.empty() ? "" : ":") + item; };
    for (const std::string& needed : read_elf(program).needed) {
        if (needed.starts_with("libasan.so") || needed.starts_with("libtsan.so")) add(needed);
    }
    // ld.so separates the list by both.
    if (library.find_first_of(": ") != std::string::npos) {
        throw BadUse(fmt::format("{} cannot be preloaded: its path holds a space or a colon.", library));
    }
    add(library);
    const char* before = std::getenv("LD_PRELOAD");
    std::string list = before == nullptr ? "" : before;
    std::ranges::replace(list, ' ', ':');
    std::istringstream items(list);
    for (std::string item; std::getline(items, item, ':');) {
        if (!item.empty() && fs::path(item).filename() != kLibrary) add(item);
    }
    return preload;
}

}  // namespace

std::string find_program(const std::string& name) {
    if (name.find('/') != std::string::npos) return name;
    const char* path = std::getenv("PATH");
    std::istringstream folders(path == nullptr ? "/usr/bin:/bin" : path);
    for (std::string folder; std::getline(folders, folder, ':');) {
        std::string candidate = (folder.empty() ? "." : folder) + "/" + name;
        if (access(candidate.c_str(), X_OK) == 0) return candidate;
    }
    return "";
}

Environment environment_for(const RunOptions& options, const std::string& doctor_file) {
    const bool is_path =
        options.device.find('/') != std::string::npos || std::string_view(options.device).ends_with(".toml");
    Environment environment;
    environment.settings =
        "device=" + (is_path ? absolute(options.device) : options.device) + ",clock=" + options.clock;
    if (!options.report.empty()) environment.settings += ",report=" + absolute(options.report);
    if (!doctor_file.empty()) environment.settings += ",doctor=" + doctor_file;

    const SettingsOrError parsed = parse_settings(environment.settings.c_str());
    if (!parsed.error.empty()) throw BadUse(parsed.error);
    environment.preload = preload_with(layer_library(), find_program(options.program.front()));
    return environment;
}

int run(const RunOptions& options) {
    if (options.program.empty())
        throw BadUse("there is no program to run, expected `glext-emu run -- program args`.");
    const char* wish = std::getenv("GLEXT_EMU");
    if (wish == nullptr || std::strcmp(wish, "0") != 0) {
        const Environment environment = environment_for(options);
        if (!options.report.empty()) start_report(options.report);
        if (options.is_verbose) {
            fmt::print(stderr, "LD_PRELOAD={} GLEXT_EMU={} {}\n", environment.preload, environment.settings,
                       options.program.front());
        }
        setenv("LD_PRELOAD", environment.preload.c_str(), 1);
        setenv("GLEXT_EMU", environment.settings.c_str(), 1);
    }

    std::vector<char*> arguments;
    for (const std::string& word : options.program) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    execvp(arguments[0], arguments.data());
    const int why = errno;
    fmt::print(stderr, "glext-emu: {} cannot be run: {}.\n", options.program.front(), std::strerror(why));
    return why == ENOENT ? 127 : 126;
}

}  // namespace glext_emu::launcher
