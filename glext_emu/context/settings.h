// SPDX-License-Identifier: MIT
// What the layer was asked to do: the environment variable GLEXT_EMU, a comma list of key=value.
//
//   device=NAME_OR_PATH   a built-in device or a .toml file           default native
//   clock=CLOCK           none, wall=US, calls=N, frames=N, device    default none
//   report=FILE           JSON report of queries and draws            default none
//   timeline=FILE         Trace Event file of the device's time       default none
//   frames=A..B           the frames that it holds, from 0            default all
//   without=A+B           effects of the device's time switched off   default none
//   fragments=all         of every draw, not of a part of many             default some
//   dry=1                 draws are counted, not rasterised           default off
//   probe=unit            the Occlusion Unit watches the program's queries and reports   default none
//   driver=NAME           the GLVND vendor that the vendor library stands before   default mesa
//   doctor=FILE           the launcher's `doctor` listens here        default none
//
// GLEXT_EMU=0 switches everything off. This is the only place that reads the environment.
#pragma once

#include <string>
#include <string_view>

#include "context/device.h"
#include "occlusion_unit/clock.h"
#include "occlusion_unit/timeline.h"

namespace glext_emu {

struct FrameRange {
    std::uint64_t first = 0;
    std::uint64_t last = ~std::uint64_t{0};  // it too
};

struct Settings {
    bool off = false;
    Device device;
    occlusion_unit::Latency latency;
    std::string report_path;
    bool probes_unit = false;   // only with a report
    std::string timeline_path;  // only with the device's clock, as what follows
    FrameRange timeline_frames;
    occlusion_unit::Effects effects = occlusion_unit::all_effects();
    bool counts_all_fragments = false;
    bool is_dry = false;
    std::string driver;  // empty: mesa
    std::string doctor_path;

    // True where the layer has nothing to do and leaves the driver alone.
    bool steps_aside() const;
};

struct SettingsOrError {
    Settings settings;
    std::string error;  // one sentence, or empty
};

// <text> is the value of GLEXT_EMU, null where it is unset.
SettingsOrError parse_settings(const char* text);

// The settings of this process, read once. A wrong setting is told in one sentence on stderr and ends the
// program with status 2 before it has a context: it must not believe in results of a machine that is not
// there.
const Settings& settings();

}  // namespace glext_emu
