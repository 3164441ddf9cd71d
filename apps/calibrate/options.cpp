// SPDX-License-Identifier: MIT
#include "apps/calibrate/options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <filesystem>

namespace apps {
namespace {

constexpr const char* kFooter = R"(
What each number of the table [time] is measured by, and how far to trust it: docs/calibrate.md.

examples
  calibrate                                    print a device file; the table on stderr says how well it fits
  calibrate --output mine.toml                 write it
  glext-emu run --device ./mine.toml --clock device -- PROGRAM      run a program in that machine's time
  calibrate --quick --json - --output /dev/null    every sample, as JSON
  LP_NUM_THREADS=2 calibrate                   llvmpipe with two threads; 0 unless given
)";

int side_of(const std::string& text, const std::string& size) {
    int value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || value < 256 || value > 4096 ||
        value % 32 != 0)
        throw CalibrateBadUse(
            fmt::format("--size is WIDTHxHEIGHT, multiples of 32 from 256 to 4096, not \"{}\"", size));
    return value;
}

void check(CalibrateOptions& options, const std::string& size) {
    if (!size.empty()) {
        const std::size_t x = size.find('x');
        options.width = side_of(size.substr(0, x), size);
        options.height = side_of(x == std::string::npos ? "" : size.substr(x + 1), size);
    }
    if (options.platform != "egl" && options.platform != "glx")
        throw CalibrateBadUse(fmt::format("--platform is egl or glx, not \"{}\"", options.platform));
    if (options.time != "wall" && options.time != "gl")
        throw CalibrateBadUse(fmt::format("--time is wall or gl, not \"{}\"", options.time));
    if (options.force && options.output.empty()) throw CalibrateBadUse("--force needs --output");
    if (options.json == "-" && options.output.empty())
        throw CalibrateBadUse("--json - and the device file cannot both go to stdout: give an --output");
    if (options.name.empty()) options.name = std::filesystem::path(options.output).stem().string();
    if (options.name.empty()) options.name = "this-machine";
}

}  // namespace

CalibrateOptions parse_calibrate_options(int argc, const char* const* argv) {
    CalibrateOptions options;
    std::string size;
    CLI::App app(
        "Measures what drawing, asking and reading cost on this machine's OpenGL, fits the model of the "
        "emulator's "
        "device clock to it, and writes the result as a device file.",
        "calibrate");
    app.footer(kFooter);
    app.add_option("--platform", options.platform, "egl (no display needed) or glx (a window)")
        ->capture_default_str();
    app.add_option("--size", size, "WIDTHxHEIGHT of the window in pixels; 1024x768 unless given");
    app.add_option("--output", options.output, "write the device file there and not to stdout");
    app.add_flag("--force", options.force, "even over a file that calibrate did not write");
    app.add_option("--name", options.name, "of the device; that of the file unless given");
    app.add_option("--json", options.json, "write every sample and fit there; - is stdout");
    app.add_flag("--quick", options.quick, "in a few seconds, with fewer rounds");
    app.add_option("--time", options.time,
                   "wall, or gl: by GL's own TIMESTAMP, which under the emulator's device clock is that "
                   "of the emulated machine")
        ->capture_default_str();
    try {
        app.parse(argc, argv);
    } catch (const CLI::CallForHelp&) {
        options.help = app.help();
        return options;
    } catch (const CLI::ParseError& error) {
        throw CalibrateBadUse(error.what());
    }
    check(options, size);
    return options;
}

}  // namespace apps
