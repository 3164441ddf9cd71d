// SPDX-License-Identifier: MIT
#include "context/doctor.h"

#include <errno.h>
#include <fcntl.h>
#include <unistd.h>

#include <string>

#include "context/settings.h"

namespace glext_emu {

void doctor_note(const char* fact) {
    if (settings().doctor_path.empty()) return;
    const std::string line = std::string(program_invocation_short_name) + ": " + fact + "\n";
    const int file = open(settings().doctor_path.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC);
    if (file < 0) return;
    // One short write to a file opened for appending is not mixed with another process's.
    [[maybe_unused]] const ssize_t written = write(file, line.data(), line.size());
    close(file);
}

}  // namespace glext_emu
