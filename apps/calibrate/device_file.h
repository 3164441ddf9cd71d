// SPDX-License-Identifier: MIT
// A device file of the emulator: what was found, with how well it fits beside each number.
#pragma once

#include <stdexcept>
#include <string>

#include "apps/calibrate/findings.h"

namespace apps {

/// Where and how it was measured.
struct Circumstances {
    std::string name;  // of the device
    std::string renderer;
    std::string version;
    std::string cpu;
    std::string threads;  // LP_NUM_THREADS; empty where it means nothing
    std::string platform;
    std::string time;  // wall or gl
    int width = 0;
    int height = 0;
    int rounds = 0;
    double disturbed_share = 0;
};

/// Microseconds measured and predicted, and how far apart.
std::string line_of(const Check& check);

/// The text, in TOML. A term that is not shown is a comment.
std::string device_file(const Findings& findings, const Circumstances& how);

nlohmann::ordered_json raw_report(const Findings& findings, const Circumstances& how);

/// Why a file cannot be written, as one sentence.
struct FileError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Throws FileError if <path> holds a file that calibrate did not write, unless <force>, or cannot be
/// written.
void check_output(const std::string& path, bool force);

/// All of it or nothing: written beside <path> and renamed. Special files (/dev/null, a pipe) are written
/// straight. Throws FileError.
void write_whole(const std::string& path, const std::string& text);

}  // namespace apps
