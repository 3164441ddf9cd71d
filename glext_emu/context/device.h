// SPDX-License-Identifier: MIT
// A device: which occlusion hardware the program is to believe in. Read from TOML; the built-in ones are part
// of the library, a user's own is a file.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "occlusion_unit/profile.h"

namespace glext_emu {

struct GlVersion {
    int major = 0;
    int minor = 0;
    auto operator<=>(const GlVersion&) const = default;
};

// A device's time, its table [time].
struct MachineTime {
    std::string source;   // where the numbers come from
    std::string quality;  // "fitted" to published times, "indicative" where few were published, or "assumed"
    occlusion_unit::Profile profile;
};

struct Device {
    std::string name;
    std::string description;
    std::string source;
    std::optional<int> year;
    std::optional<GlVersion> gl_version;  // of compatibility contexts; the driver's where absent
    std::vector<std::string> emulate;     // extensions that the driver lacks and the layer supplies
    std::vector<std::string> hide;        // extensions that the program is not to see
    std::optional<int> counter_bits;  // width of the samples-passed counter, 1..64; the driver's where absent

    // Of the proposed extensions; what is absent is as docs/extensions and docs/hardware.md say.
    std::optional<int> unit_counter_bits;     // width of the unit's two counters in a report, 1..64
    std::optional<int> unit_max_shapes;       // shapes in one call, 1..65536
    std::optional<int> unit_pipes;            // partial units, one beside the depth test of each pipe, 1..64
    std::optional<int> unit_coordinate_bits;  // of a window coordinate, 1..16
    std::optional<int> unit_depth_bits;       // of a depth, 1..32
    std::optional<int> unit_report_queue;     // records that wait to be read, 1..65536
    std::optional<int> max_regions;           // depth regions in one call, 1..65536
    std::optional<int> region_depth_bits;     // of the depth that a region query answers with, 1..32

    std::optional<MachineTime> time;  // without it the device has no clock of its own

    bool emulates(std::string_view extension) const;
    bool hides(std::string_view extension) const;
    // True where the program sees the driver as it is.
    bool is_pass_through() const;
};

// A device, or one sentence that says what is wrong, with file and line.
struct DeviceOrError {
    std::optional<Device> device;
    std::string error;
};

// The file names, without extension, of the built-in devices.
std::vector<std::string_view> builtin_device_names();

// <name_or_path> is a built-in name, or a path: anything that holds a slash or ends in ".toml".
DeviceOrError load_device(std::string_view name_or_path);

// Reads a device from TOML <text>; <file> is what errors call it.
DeviceOrError parse_device(std::string_view text, std::string_view file);

}  // namespace glext_emu
