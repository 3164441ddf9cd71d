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

#include "context/shared_json_file.h"
#include "launcher/commands.h"

namespace glext_emu::launcher {
namespace {

namespace fs = std::filesystem;

// <length> bytes of <file> from <at>; fewer where it is shorter.
std::string bytes_of(std::ifstream& file, std::uintmax_t at, std::size_t length) {
    std::string bytes(length, '\0');
    file.clear();
    file.seekg(static_cast<std::streamoff>(at));
    file.read(bytes.data(), static_cast<std::streamsize>(length));
    bytes.resize(static_cast<std::size_t>(file.gcount()));
    return bytes;
}

// An empty file of <kind>, over an older one; nothing else is overwritten.
void start_file(const JsonFileKind& kind, const std::string& path) {
    std::error_code ignored;
    const std::uintmax_t size = fs::exists(path, ignored) ? fs::file_size(path, ignored) : 0;
    if (size != 0) {
        std::ifstream old(path, std::ios::binary);
        const bool is_one = size >= kind.head.size() + kind.tail.size() &&
                            bytes_of(old, 0, kind.head.size()) == kind.head &&
                            bytes_of(old, size - kind.tail.size(), kind.tail.size()) == kind.tail;
        if (!is_one) throw BadUse(fmt::format("{} exists and is not a {}.", path, kind.name));
    }
    std::ofstream file(path, std::ios::trunc);
    file << kind.head << kind.tail;
    if (!file.flush()) throw BadUse(fmt::format("the {} {} cannot be written.", kind.name, path));
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
        if (!options.report.empty()) start_file(kReportKind, options.report);
        if (!options.timeline.empty()) start_file(kTimelineKind, options.timeline);
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
