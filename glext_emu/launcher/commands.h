// SPDX-License-Identifier: MIT
// The launcher's commands. Each returns the status to exit with.
#pragma once

#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace glext_emu::launcher {

// Bad use: one sentence for the user, exit status 2.
struct BadUse : std::runtime_error {
    using std::runtime_error::runtime_error;
};

struct RunOptions {
    std::string device = "native";
    std::string clock = "none";
    std::string report;
    std::string probe;     // unit; empty: none
    std::string timeline;  // with the clock `device` only, as the three that follow
    std::string frames;    // A..B; empty: all
    std::string without;   // effects, with commas between them
    bool counts_all_fragments = false;
    bool is_dry = false;
    std::string front;  // seam, vendor or export; empty: what the program's file asks for
    bool is_verbose = false;
    std::vector<std::string> program;  // and its arguments
};

// Replaces this process by the program with the layer under it; returns only when that fails (126, 127 as
// shells do).
int run(const RunOptions& options);

int list_devices(bool as_json);

// What the query hardware of these devices, built-in or files, is built of; of all built-in ones if <names>
// is empty.
int print_costs(const std::vector<std::string>& names, bool as_json);

// Runs the program for at most <seconds> and says what the layer saw, or why it saw nothing.
int doctor(const RunOptions& options, int seconds);

// What a child process needs so that the layer is under it: variables and their values, none to be unset.
// Checked, throws BadUse.
struct Environment {
    std::string front;
    std::map<std::string, std::optional<std::string>> variables;
    void apply() const;
};
Environment environment_for(const RunOptions& options, const std::string& doctor_file = "");

// The file that execvp would run for <name>; empty if there is none.
std::string find_program(const std::string& name);

}  // namespace glext_emu::launcher
