// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "context/device.h"
#include "launcher/commands.h"

namespace glext_emu::launcher {
namespace {

std::string version_text(const Device& device) {
    return device.gl_version ? fmt::format("{}.{}", device.gl_version->major, device.gl_version->minor)
                             : "driver's";
}

nlohmann::json as_json_object(const Device& device) {
    nlohmann::json object = {{"name", device.name},
                             {"description", device.description},
                             {"source", device.source},
                             {"year", nullptr},
                             {"gl_version", nullptr},
                             {"emulate", device.emulate},
                             {"hide", device.hide},
                             {"counter_bits", nullptr},
                             {"unit", {}},
                             {"region", {}}};
    if (device.year) object["year"] = *device.year;
    if (device.gl_version) object["gl_version"] = version_text(device);
    if (device.counter_bits) object["counter_bits"] = *device.counter_bits;
    const auto put = [&object](const char* table, const char* key, const std::optional<int>& value) {
        object[table][key] = value ? nlohmann::json(*value) : nlohmann::json(nullptr);
    };
    put("unit", "counter_bits", device.unit_counter_bits);
    put("unit", "max_shapes", device.unit_max_shapes);
    put("unit", "pipes", device.unit_pipes);
    put("unit", "coordinate_bits", device.unit_coordinate_bits);
    put("unit", "depth_bits", device.unit_depth_bits);
    put("unit", "report_queue", device.unit_report_queue);
    put("region", "max_regions", device.max_regions);
    put("region", "depth_bits", device.region_depth_bits);
    object["time"] = nullptr;
    if (device.time) object["time"] = {{"source", device.time->source}, {"quality", device.time->quality}};
    return object;
}

}  // namespace

int list_devices(bool as_json) {
    nlohmann::json all = nlohmann::json::array();
    if (!as_json)
        fmt::print("{:<31} {:<5} {:<9} {:<11} {}\n", "device", "year", "OpenGL", "its time", "what it is");
    for (const std::string_view name : builtin_device_names()) {
        const DeviceOrError loaded = load_device(name);
        if (!loaded.device) throw BadUse(loaded.error);
        if (as_json) {
            all.push_back(as_json_object(*loaded.device));
        } else {
            fmt::print("{:<31} {:<5} {:<9} {:<11} {}\n", name,
                       loaded.device->year ? std::to_string(*loaded.device->year) : "-",
                       version_text(*loaded.device), loaded.device->time ? loaded.device->time->quality : "-",
                       loaded.device->description);
        }
    }
    if (as_json) fmt::print("{}\n", all.dump(2));
    return 0;
}

}  // namespace glext_emu::launcher
