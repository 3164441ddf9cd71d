// SPDX-License-Identifier: MIT
#include <errno.h>
#include <fcntl.h>
#include <fmt/core.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "launcher/commands.h"

namespace glext_emu::launcher {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kReportStart = "{\"glext_emu_report\":1,";
constexpr std::string_view kEmptyReport = "{\"glext_emu_report\":1,\"records\":[\n]}\n";

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

int run(const RunOptions& options) {
    if (options.program.empty())
        throw BadUse("there is no program to run, expected `glext-emu run -- program args`.");
    const char* wish = std::getenv("GLEXT_EMU");
    if (wish == nullptr || std::strcmp(wish, "0") != 0) {
        const Environment environment = environment_for(options);
        if (!options.report.empty()) start_report(options.report);
        if (options.is_verbose) {
            for (const auto& [name, value] : environment.variables) {
                if (value) fmt::print(stderr, "{}={} ", name, *value);
            }
            fmt::print(stderr, "{}\n", options.program.front());
        }
        environment.apply();
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
