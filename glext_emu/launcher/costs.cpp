// SPDX-License-Identifier: MIT
// `glext-emu devices --cost`: the query hardware of a device, and what it is built of. The counts are
// occlusion_unit's; here is which device has which hardware, and how the table looks.
#include <fmt/core.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "context/device.h"
#include "launcher/commands.h"
#include "occlusion_unit/cost.h"

namespace glext_emu::launcher {
namespace {

using occlusion_unit::HardwareCost;
using occlusion_unit::HardwareSizes;
using occlusion_unit::Parts;

struct Row {
    std::string hardware;
    HardwareSizes sizes;
    HardwareCost cost;
};

struct UnitRegister {
    std::uint32_t bit;
    const char* name;
};
constexpr UnitRegister kUnitRegisters[] = {{occlusion_unit::kVisible, "visible flag"},
                                           {occlusion_unit::kProjectedHits, "projected hits"},
                                           {occlusion_unit::kVisibleHits, "visible hits"},
                                           {occlusion_unit::kNearestDepth, "nearest depth"},
                                           {occlusion_unit::kScreenBox, "screen box"}};

// Query objects of ARB_occlusion_query: core since 1.5, hidden below it.
bool has_arb_counter(const Device& device) {
    return !device.is_pass_through() && (!device.hides("GL_ARB_occlusion_query") ||
                                         (device.gl_version && *device.gl_version >= GlVersion{1, 5}));
}

HardwareSizes sizes_of(const Device& device) {
    HardwareSizes sizes;
    sizes.pipes = device.unit_pipes.value_or(sizes.pipes);
    sizes.coordinate_bits = device.unit_coordinate_bits.value_or(sizes.coordinate_bits);
    sizes.depth_bits = device.unit_depth_bits.value_or(sizes.depth_bits);
    sizes.report_queue = device.unit_report_queue.value_or(sizes.report_queue);
    return sizes;
}

// The driver's own query hardware, where nothing is emulated and nothing hidden, is nobody's statement: no
// rows.
std::vector<Row> query_hardware(const Device& device) {
    std::vector<Row> rows;
    if (device.emulates("GL_HP_occlusion_test")) {
        HardwareSizes sizes = sizes_of(device);
        sizes.report_queue = 0;  // the flag itself is read
        rows.push_back({"HP flag", sizes, unit_cost(sizes, occlusion_unit::kVisible)});
    }
    if (device.emulates("GL_HP_visibility_test")) {
        rows.push_back({"HP flags", sizes_of(device), unit_cost(sizes_of(device), occlusion_unit::kVisible)});
    }
    if (device.emulates("GL_SGIX_occlusion_instrument")) {
        rows.push_back(
            {"SGIX flag", sizes_of(device), unit_cost(sizes_of(device), occlusion_unit::kVisible)});
    }
    if (device.emulates("GL_SGIX_depth_pass_instrument")) {
        rows.push_back(
            {"SGIX counter", sizes_of(device), unit_cost(sizes_of(device), occlusion_unit::kVisibleHits)});
    }
    const bool has_nv = device.emulates("GL_NV_occlusion_query");
    if (has_nv || has_arb_counter(device)) {
        HardwareSizes sizes = sizes_of(device);
        sizes.counter_bits = device.counter_bits.value_or(sizes.counter_bits);
        rows.push_back(
            {has_nv ? "NV counter" : "ARB counter", sizes, unit_cost(sizes, occlusion_unit::kVisibleHits)});
    }
    if (device.emulates("GL_EMU_depth_region_query")) {
        HardwareSizes sizes = sizes_of(device);
        if (device.max_regions == 1) sizes.report_queue = 0;  // the answer waits where it was found
        rows.push_back({"region query", sizes, region_query_cost(sizes)});
    }
    if (device.emulates("GL_EMU_occlusion_unit")) {
        HardwareSizes sizes = sizes_of(device);
        sizes.counter_bits = device.unit_counter_bits.value_or(64);
        for (const UnitRegister& one : kUnitRegisters) {
            rows.push_back({std::string("+ ") + one.name, sizes, register_cost(sizes, one.bit)});
        }
        rows.push_back({"Occlusion Unit", sizes, unit_cost(sizes, occlusion_unit::kAllRegisters)});
    }
    return rows;
}

std::string parts_text(const Parts& parts) {
    return fmt::format("{:>5} {:>5} {:>5} {:>5}", parts.register_bits, parts.adder_bits,
                       parts.comparator_bits, parts.gates);
}

nlohmann::json as_json_object(const Parts& parts) {
    return {{"register_bits", parts.register_bits},     {"adders", parts.adders},
            {"adder_bits", parts.adder_bits},           {"comparators", parts.comparators},
            {"comparator_bits", parts.comparator_bits}, {"gates", parts.gates}};
}

nlohmann::json as_json_object(const Row& row) {
    return {{"hardware", row.hardware},
            {"pipes", row.sizes.pipes},
            {"counter_bits", row.sizes.counter_bits},
            {"coordinate_bits", row.sizes.coordinate_bits},
            {"depth_bits", row.sizes.depth_bits},
            {"report_queue", row.sizes.report_queue},
            {"each_pipe", as_json_object(row.cost.pipe)},
            {"shared", as_json_object(row.cost.shared)},
            {"queue", as_json_object(row.cost.queue)},
            {"total", as_json_object(row.cost.total())}};
}

// What the costs take for granted because the device does not say it.
std::vector<std::string> assumed(const Device& device) {
    std::vector<std::string> keys;
    if (!device.unit_pipes) keys.push_back("pipes");
    if (!device.unit_coordinate_bits) keys.push_back("coordinate_bits");
    if (!device.unit_depth_bits) keys.push_back("depth_bits");
    if (!device.unit_report_queue) keys.push_back("report_queue");
    return keys;
}

}  // namespace

int print_costs(const std::vector<std::string>& names, bool as_json) {
    std::vector<std::string> wanted = names;
    if (wanted.empty()) {
        const std::vector<std::string_view> builtin = builtin_device_names();
        wanted.assign(builtin.begin(), builtin.end());
    }
    std::vector<Device> devices;
    for (const std::string& name : wanted) {
        const DeviceOrError loaded = load_device(name);
        if (!loaded.device) throw BadUse(loaded.error);
        devices.push_back(*loaded.device);
    }

    nlohmann::json all = nlohmann::json::array();
    if (!as_json) {
        fmt::print("{:<24} {:<16} {:<13} {:<23} {:<23} {:<23}\n", "", "", "", "in each pipe", "shared",
                   "queue");
        fmt::print("{:<24} {:<16} {:>5} {:>7}", "device", "hardware", "pipes", "reports");
        for (int part = 0; part < 3; ++part)
            fmt::print(" {:>5} {:>5} {:>5} {:>5}", "reg", "add", "cmp", "gate");
        fmt::print("\n");
    }
    for (const Device& device : devices) {
        nlohmann::json rows = nlohmann::json::array();
        for (const Row& row : query_hardware(device)) {
            rows.push_back(as_json_object(row));
            if (as_json) continue;
            fmt::print("{:<24} {:<16} {:>5} {:>7} {} {} {}\n", device.name, row.hardware,
                       fmt::format("{}{}", row.sizes.pipes, device.unit_pipes ? "" : "*"),
                       fmt::format("{}{}", row.sizes.report_queue,
                                   row.sizes.report_queue == 0 || device.unit_report_queue ? "" : "*"),
                       parts_text(row.cost.pipe), parts_text(row.cost.shared), parts_text(row.cost.queue));
        }
        if (!as_json && rows.empty()) fmt::print("{:<24} the driver's, whatever it is\n", device.name);
        all.push_back({{"name", device.name}, {"assumed", assumed(device)}, {"cost", rows}});
    }
    if (as_json) {
        fmt::print("{}\n", all.dump(2));
        return 0;
    }
    const HardwareSizes defaults;
    fmt::print(
        "\n{}\n{}\n", "Bits of registers, adders and comparators, and gates of two inputs.",
        "Rows with + are the registers of the Occlusion Unit; its own row has the queue's control too.");
    fmt::print(
        "* not stated by the device: {} pipes, {} reports; likewise {} bits a coordinate, {} a depth.\n",
        defaults.pipes, defaults.report_queue, defaults.coordinate_bits, defaults.depth_bits);
    return 0;
}

}  // namespace glext_emu::launcher
