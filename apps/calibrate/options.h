// SPDX-License-Identifier: MIT
// The command line of calibrate, checked.
#pragma once

#include <stdexcept>
#include <string>

namespace apps {

struct CalibrateOptions {
    std::string platform = "egl";
    int width = 1024;
    int height = 768;
    std::string output;  // empty: stdout
    bool force = false;
    std::string name;  // of the device; never empty after parsing
    std::string json;  // empty: none; -: stdout
    std::string time = "wall";
    bool quick = false;
    std::string help;  // what to print instead of running, if not empty
};

/// Why a command line cannot be run, as one sentence.
struct CalibrateBadUse : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Throws CalibrateBadUse.
CalibrateOptions parse_calibrate_options(int argc, const char* const* argv);

}  // namespace apps
