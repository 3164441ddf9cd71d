// SPDX-License-Identifier: MIT
// What a context says of itself: version and extension strings of the device, made once from the driver's.
#pragma once

#include <GL/gl.h>

#include <optional>
#include <string>
#include <vector>

#include "context/device.h"

namespace glext_emu {

struct Context;

struct Advertised {
    bool version_differs = false;
    GlVersion version;  // the device's where it states one, else the driver's
    std::string version_string;
    std::string shading_language;  // empty: as the driver
    bool extensions_differ = false;
    std::vector<std::string> extensions;  // in the driver's order of GetStringi, what is emulated last
    std::string extension_string;  // in the driver's order of GetString, likewise; empty in core profiles

    bool has(std::string_view extension) const;
};

// Never freed: a program may keep the strings until it ends. Equal ones are made once.
const Advertised* advertise(Context& ctx, const Device& device);

}  // namespace glext_emu
