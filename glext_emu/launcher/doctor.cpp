// SPDX-License-Identifier: MIT
#include <fmt/core.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <set>
#include <thread>

#include "launcher/commands.h"
#include "launcher/elf_file.h"

namespace glext_emu::launcher {
namespace {

using namespace std::chrono_literals;

// A file that the layer writes its facts to; gone with this object.
class Notebook {
  public:
    Notebook() {
        const int file = mkstemp(path_);
        if (file < 0) throw BadUse("no file can be made in /tmp for the doctor's notes.");
        close(file);
    }
    ~Notebook() { unlink(path_); }
    Notebook(const Notebook&) = delete;
    Notebook& operator=(const Notebook&) = delete;

    std::string path() const { return path_; }
    std::vector<std::string> lines() const {
        std::vector<std::string> all;
        std::set<std::string> seen;
        std::ifstream file(path_);
        for (std::string line; std::getline(file, line);) {
            if (seen.insert(line).second) all.push_back(line);
        }
        return all;
    }

  private:
    char path_[32] = "/tmp/glext-emu-doctor-XXXXXX";
};

struct Ending {
    int status = 0;
    bool was_ended = false;  // by us
};

Ending run_for(const std::vector<std::string>& program, const Environment& environment, int seconds) {
    std::vector<char*> arguments;
    for (const std::string& word : program) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);

    const pid_t child = fork();
    if (child < 0) throw BadUse("no process can be made.");
    if (child == 0) {
        environment.apply();
        execvp(arguments[0], arguments.data());
        _exit(127);
    }
    Ending ending;
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(seconds);
    while (waitpid(child, &ending.status, WNOHANG) == 0) {
        if (std::chrono::steady_clock::now() > end) {
            ending.was_ended = true;
            kill(child, SIGTERM);
            std::this_thread::sleep_for(200ms);
            if (waitpid(child, &ending.status, WNOHANG) == 0) {
                kill(child, SIGKILL);
                waitpid(child, &ending.status, 0);
            }
            return ending;
        }
        std::this_thread::sleep_for(20ms);
    }
    return ending;
}

// Why the layer saw nothing, as far as the program's file tells.
std::string why_nothing(const std::string& path, const std::string& front) {
    struct stat info {};
    if (stat(path.c_str(), &info) == 0 && (info.st_mode & (S_ISUID | S_ISGID)) != 0) {
        return "it is set-uid or set-gid, and such programs are left alone.";
    }
    const ElfFile elf = read_elf(path);
    if (elf.is_elf && !elf.is_64_bit) return "it is a 32-bit program, and this layer is built for 64 bits.";
    if (elf.is_elf && !elf.has_interpreter)
        return "it is statically linked, so nothing can be loaded into it.";
    if (front == "export")
        return "it made no GL context in that time, by none of the GL libraries that it has.";
    return "no GLVND driver was loaded: it made no GL context in that time, or with OSMesa or a libGL of its "
           "own "
           "that is not GLVND's; for such a program there is --front export.";
}

}  // namespace

int doctor(const RunOptions& options, int seconds) {
    const std::vector<std::string>& program = options.program;
    if (program.empty())
        throw BadUse("there is no program to look at, expected `glext-emu doctor -- program args`.");
    const std::string path = find_program(program.front());
    if (path.empty() || access(path.c_str(), X_OK) != 0) {
        throw BadUse(fmt::format("{} is not a program that can be run.", program.front()));
    }
    const Notebook notebook;
    const Environment environment = environment_for(options, notebook.path());
    const Ending ending = run_for(program, environment, seconds);

    const std::vector<std::string> lines = notebook.lines();
    for (const std::string& line : lines) fmt::print("{}\n", line);
    if (ending.was_ended) {
        fmt::print("{}: ended after {} s\n", program.front(), seconds);
    } else if (WIFSIGNALED(ending.status)) {
        fmt::print("{}: died of signal {}\n", program.front(), WTERMSIG(ending.status));
    } else {
        fmt::print("{}: ended with status {}\n", program.front(), WEXITSTATUS(ending.status));
    }
    if (!lines.empty()) {
        fmt::print("The layer is under this program.\n");
        return 0;
    }
    fmt::print("The layer is not under this program: {}\n", why_nothing(path, environment.front));
    return 1;
}

}  // namespace glext_emu::launcher
