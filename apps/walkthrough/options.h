// SPDX-License-Identifier: MIT
// The command line of walkthrough, checked: whoever holds Options can run them.
#pragma once

#include <chrono>
#include <map>
#include <stdexcept>
#include <string>

#include "apps/culling/culler.h"
#include "apps/scene/model.h"

namespace apps {

/// Why a command line cannot be run, as one sentence.
struct BadUse : std::runtime_error {
    using std::runtime_error::runtime_error;
};

struct Options {
    std::string scene = "chc-city";  // a name of the list, or a model file
    std::string culler = "stop-and-wait";
    std::string platform = "egl";
    int width = 640;
    int height = 480;
    int frames = 120;
    int sections = 0;  // of the path, spread over it, that are walked; 0: all of it
    int section_frames = 0;
    std::chrono::nanoseconds work{0};  // of the program's own in a frame, on a device's clock
    double scale = 1;
    std::uint64_t seed = 1;
    double moving = 0;      // share of the small objects, 0..1
    std::string tree;       // "kd", "bvh", or empty for the scene's own
    ModelSplit split;       // of a model file
    bool unshared = false;  // each object with a mesh of its own
    std::string test;       // the extension to ask by; empty: the first that the machine has
    std::string regions;    // how to ask for depths; empty: as above
    KnobValues knobs;       // every knob of the culler
    std::string json;
    std::string baseline;
    bool oracle = false;
    int judge_every = 1;  // frames
    std::string oracle_cache;
    std::string images;
    int image_frame = 0;
    std::map<std::string, std::string> labels;

    bool list = false;
    std::string help;  // what to print instead of running, if not empty
};

/// Throws BadUse.
Options parse_options(int argc, const char* const* argv);

}  // namespace apps
