// SPDX-License-Identifier: MIT
// glext-emu: puts the layer under a program.
#include <fmt/core.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstring>

#include "launcher/commands.h"

namespace {

constexpr const char* kFooter = R"(examples
  glext-emu run -- glxgears                                       the program on this machine's own GL
  glext-emu run --device visualize-fx -- ./my_program             1997: one boolean occlusion test at a time
  glext-emu run --device geforce-fx-5950 --clock wall=50 -- ...   2003: query objects, results 50 us late
  glext-emu run --device geforce-fx-5950 --clock device --timeline t.json -- ...   what its CPU and GPU did when
  glext-emu run --device mesa --report report.json -- ...         count queries, waits, draws per frame
  glext-emu run --probe unit --report report.json -- ...          what an Occlusion Unit would have told it
  glext-emu run --front vendor -- ...                             as a GLVND vendor library, without a preload
  glext-emu devices --cost proposed-occlusion-unit                what such hardware is built of
  glext-emu doctor -- ./my_program                                is the layer under it, and if not, why

GLEXT_EMU=0 in the environment switches the layer off.)";

}  // namespace

int main(int argc, char** argv) {
    using namespace glext_emu::launcher;

    CLI::App app{"Runs OpenGL programs on emulated occlusion-query hardware."};
    app.footer(kFooter);
    app.require_subcommand(1);

    RunOptions options;
    CLI::App* const run_command = app.add_subcommand("run", "run a program with the layer under it");
    run_command->prefix_command();
    run_command
        ->add_option("--device", options.device,
                     "a built-in device (see `glext-emu devices`) or a .toml file")
        ->capture_default_str();
    run_command
        ->add_option("--clock", options.clock,
                     "when results may be seen: none, wall=MICROSECONDS, calls=N or frames=N after the "
                     "query's end, or "
                     "device: in the time of the device itself, which timer queries tell too")
        ->capture_default_str();
    run_command->add_option("--report", options.report,
                            "write queries, waits and draws per frame to this JSON file");
    run_command->add_option("--timeline", options.timeline,
                            "with --clock device: write what CPU, FIFO and GPU did when to this file, which "
                            "ui.perfetto.dev opens");
    run_command->add_option("--frames", options.frames,
                            "the frames that the timeline holds: A..B, A.. or A, from 0; by itself all");
    run_command->add_option("--without", options.without,
                            "with --clock device: effects to switch off, with commas between them: latency, "
                            "back-pressure, fill, driver-copy, multisampling, read-cost, starvation, "
                            "saturation, depth-quantisation");
    run_command->add_flag("--all-fragments", options.counts_all_fragments,
                          "with --clock device: count the fragments of every query and draw; by itself those "
                          "of a quarter of them where a frame has more than 64 groups");
    run_command->add_flag("--dry", options.is_dry,
                          "with --clock device: count draws and do not rasterise them, for programs that "
                          "decide nothing by pixels");
    run_command->add_option(
        "--probe", options.probe,
        "unit: for each occlusion query of the program, write what the Occlusion Unit would "
        "have told it into the report");
    const char* const front_help =
        "how it gets under the program: seam, vendor or export (see docs/interposing.md); by itself export "
        "for a "
        "program that needs libOSMesa, else seam";
    run_command->add_option("--front", options.front, front_help);
    run_command->add_flag("-v,--verbose", options.is_verbose, "say how the program is started");

    bool as_json = false;
    CLI::App* const devices_command = app.add_subcommand("devices", "list the built-in devices");
    devices_command->add_flag("--json", as_json, "as one JSON array");
    bool is_cost = false;
    std::vector<std::string> cost_devices;
    CLI::Option* const cost_option =
        devices_command->add_flag("--cost", is_cost, "what the query hardware of devices is built of");
    devices_command->add_option("device", cost_devices, "with --cost: only these, built-in or .toml files")
        ->needs(cost_option);

    int seconds = 5;
    CLI::App* const doctor_command =
        app.add_subcommand("doctor", "say whether the layer gets under a program, and if not, why");
    doctor_command->prefix_command();
    doctor_command->add_option("--front", options.front, front_help);
    doctor_command->add_option("--seconds", seconds, "end the program after this many")
        ->capture_default_str()
        ->check(CLI::Range(1, 3600));

    // What follows `--` is the program's, whatever it looks like.
    char** const dashes =
        std::find_if(argv, argv + argc, [](const char* word) { return std::strcmp(word, "--") == 0; });
    std::vector<std::string> program(std::min(dashes + 1, argv + argc), argv + argc);
    try {
        app.parse(static_cast<int>(dashes - argv), argv);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) return app.exit(error);
        fmt::print(stderr, "glext-emu: {}; `glext-emu --help` shows the use.\n", error.what());
        return 2;
    }
    CLI::App* const command = app.get_subcommands().front();
    if (dashes == argv + argc) {
        program = command->remaining();
    } else if (command->remaining_size() != 0) {
        fmt::print(stderr, "glext-emu: `{}` is not an option; `glext-emu {} --help` shows the use.\n",
                   command->remaining().front(), command->get_name());
        return 2;
    }
    options.program = std::move(program);
    try {
        if (*run_command) return run(options);
        if (*devices_command) return is_cost ? print_costs(cost_devices, as_json) : list_devices(as_json);
        return doctor(options, seconds);
    } catch (const std::exception& error) {
        fmt::print(stderr, "glext-emu: {}\n", error.what());
        return 2;
    }
}
