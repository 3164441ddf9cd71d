// SPDX-License-Identifier: MIT
// calibrate: a device file of the machine it runs on. Exit status: 0 done; 1 the machine was too restless to
// fit what everything else builds on; 2 bad use, said in one sentence.
#include <fmt/format.h>
#include <malloc.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>

#include "apps/calibrate/device_file.h"
#include "apps/calibrate/options.h"
#include "apps/calibrate/terms.h"
#include "apps/report/progress_bar.h"

namespace {

using namespace apps;

struct TooRestless : std::runtime_error {
    using std::runtime_error::runtime_error;
};

std::string cpu_name() {
    std::ifstream in("/proc/cpuinfo");
    for (std::string line; std::getline(in, line);)
        if (line.starts_with("model name")) return line.substr(line.find(": ") + 2);
    return "an unnamed processor";
}

double wall_microseconds() {
    const auto now = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration<double, std::micro>(now).count();
}

std::function<double()> clock_of(const std::string& time, Platform& platform) {
    if (time == "wall") return wall_microseconds;
    if (!platform.has_extension("GL_ARB_timer_query") && !platform.is_at_least(3, 3))
        throw PlatformError("this GL has no GL_ARB_timer_query, so --time gl cannot tell the time");
    const auto get = reinterpret_cast<PFNGLGETINTEGER64VPROC>(platform.function("glGetInteger64v"));
    return [get] {
        GLint64 nanoseconds = 0;
        get(GL_TIMESTAMP, &nanoseconds);
        return 1e-3 * static_cast<double>(nanoseconds);
    };
}

// What is not the machine's is kept out. Of the environment, what the user has set stays.
void set_conditions(const CalibrateOptions& options) {
    // Whatever a display's refresh holds back would be measured as a swap.
    if (options.platform == "glx") {
        setenv("vblank_mode", "0", 0);
        setenv("__GL_SYNC_TO_VBLANK", "0", 0);
    }
    // llvmpipe's time depends on its threads.
    setenv("LP_NUM_THREADS", "0", 0);
    // A software rasteriser frees what a flush has drawn. Returned to the system, it costs page after page
    // when it is wanted again: once a flush holds more than the 128 KiB that malloc keeps, draws cost three
    // times as much.
    constexpr int kKept = 1 << 30, kAhead = 64 << 20;
    mallopt(M_TRIM_THRESHOLD, kKept);
    mallopt(M_MMAP_THRESHOLD, 32 << 20);
    mallopt(M_TOP_PAD, kAhead);
}

std::string first_lack(const Findings& findings) {
    for (const std::string_view key : kNeeded)
        if (findings.shown(key) == nullptr) return std::string(key);
    return "";
}

// Everything that one window is enough for.
void measure_in_window(const CalibrateOptions& options, int rounds, Findings& findings, Circumstances& how) {
    const std::unique_ptr<Platform> platform = open_platform(options.platform, options.width, options.height);
    Stage stage(*platform, options.width, options.height);
    how.renderer = platform->renderer();
    how.version = platform->version();
    if (how.renderer.find("llvmpipe") != std::string::npos) how.threads = std::getenv("LP_NUM_THREADS");
    fmt::print(stderr, "calibrate: {}, {}{}\n", how.renderer, how.cpu,
               how.threads.empty() ? "" : ", LP_NUM_THREADS=" + how.threads);

    Sampler sampler(
        clock_of(options.time, *platform), [&] { stage.finish(); }, rounds);
    Bench bench{stage, sampler, findings};
    constexpr void (*kSteps[])(Bench&) = {measure_draws, measure_fill, measure_queries, measure_clears,
                                          measure_reads};
    // What is needed and drowned in what others did to the machine is measured again.
    constexpr int kTries = 3;
    for (int attempt = 0; attempt < kTries && !first_lack(findings).empty(); ++attempt) {
        ProgressBar bar("measuring", static_cast<int>(std::size(kSteps)));
        for (const auto step : kSteps) {
            step(bench);
            bar.step();
        }
    }
    if (const std::string lack = first_lack(findings); !lack.empty()) {
        const auto term = std::ranges::find(findings.terms, lack, &Term::key);
        throw TooRestless(fmt::format("{} could not be fitted: {}", lack, term->lack));
    }
    {
        ProgressBar bar("checking", 2);
        measure_fifo(bench);
        bar.step();
        check_mixes(bench);
        bar.step();
    }
    how.disturbed_share = sampler.disturbed_share();
    if (const GLenum error = glGetError(); error != GL_NO_ERROR)
        throw PlatformError(fmt::format("GL reported error {:#x} while it was measured", error));
}

void print_table(const Findings& findings, double disturbed_share) {
    for (const Term& term : findings.terms) {
        if (!term.lack.empty())
            fmt::print(stderr, "  {:<27}          -  {}\n", term.key, term.lack);
        else
            fmt::print(stderr, "  {:<27} {:>10.4g}  {:.3g} to {:.3g}, R^2 {:.4f}, rms {:.1f} %: {}\n",
                       term.key, term.value, term.low, term.high, term.r2, term.rms_percent, term.way);
    }
    fmt::print(stderr, "held out, in microseconds: measured, predicted, error\n");
    for (const Check& check : findings.checks) fmt::print(stderr, "  {}\n", line_of(check));
    fmt::print(stderr, "{:.0f} % of the samples were taken while others had a share of the processor\n",
               100 * disturbed_share);
}

void run(const CalibrateOptions& options) {
    if (!options.output.empty()) check_output(options.output, options.force);
    set_conditions(options);
    Circumstances how;
    how.name = options.name;
    how.cpu = cpu_name();
    how.platform = options.platform;
    how.time = options.time;
    how.width = options.width;
    how.height = options.height;
    how.rounds = options.quick ? 5 : 21;

    Findings findings;
    measure_in_window(options, how.rounds, findings, how);
    if (options.time == "wall") {
        Sampler sampler(wall_microseconds, glFinish, how.rounds);
        measure_swaps(options.platform, options.width, options.height, sampler, findings);
    }
    print_table(findings, how.disturbed_share);
    if (!options.json.empty()) {
        const std::string report = raw_report(findings, how).dump(1) + '\n';
        if (options.json == "-")
            fmt::print("{}", report);
        else
            write_whole(options.json, report);
    }
    const std::string text = device_file(findings, how);
    if (options.output.empty())
        fmt::print("{}", text);
    else
        write_whole(options.output, text);
}

}  // namespace

int main(int argc, char** argv) {
    try {
        const CalibrateOptions options = parse_calibrate_options(argc, argv);
        if (!options.help.empty())
            fmt::print("{}", options.help);
        else
            run(options);
        return 0;
    } catch (const TooRestless& error) {
        fmt::print(stderr, "calibrate: {}\n", error.what());
        return 1;
    } catch (const std::exception& error) {
        fmt::print(stderr, "calibrate: {}\n", error.what());
        return 2;
    }
}
