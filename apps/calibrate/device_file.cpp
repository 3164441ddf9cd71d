// SPDX-License-Identifier: MIT
#include "apps/calibrate/device_file.h"

#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <fstream>

namespace apps {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kFirstLine = "# Written by calibrate; ";

// The order of the table, as the docs have it.
constexpr std::array kKeys = {"swap_us",
                              "batch_us",
                              "query_us",
                              "poll_us",
                              "read_us",
                              "copied_triangle_ns",
                              "gpu_batch_us",
                              "triangles_per_second",
                              "fragments_per_second",
                              "depth_fragments_per_second",
                              "cleared_pixels_per_second",
                              "swapped_pixels_per_second",
                              "gpu_query_us",
                              "result_latency_us",
                              "fifo_us",
                              "read_pixels_per_second"};

std::string quoted(const std::string& text) {
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') out += '\\';
        out += static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? ' ' : c;
    }
    return out + '"';
}

std::string fit_of(const Term& term) {
    const std::string line =
        term.r2 > 0 ? fmt::format("; R^2 {:.4f}, rms {:.1f} %", term.r2, term.rms_percent) : "";
    return fmt::format("{:.3g} to {:.3g}{}", term.low, term.high, line);
}

std::string how_measured(const Circumstances& how) {
    const std::string threads = how.threads.empty() ? "" : fmt::format(", LP_NUM_THREADS={}", how.threads);
    return fmt::format("measured by calibrate: {}, {}{}, {}, {} x {}, {} time", how.renderer, how.cpu,
                       threads, how.platform, how.width, how.height, how.time);
}

}  // namespace

std::string line_of(const Check& check) {
    return fmt::format("{:8.0f} {:8.0f} {:+6.1f} %  {}{}", check.measured_us, check.predicted_us,
                       check.error_percent(), check.what,
                       check.is_disturbed ? " (others had a share of the processor)" : "");
}

std::string device_file(const Findings& findings, const Circumstances& how) {
    std::string text = fmt::format(
        "{}what each number means and how it is measured: docs/calibrate.md\n"
        "# {} rounds, {:.0f} % of the samples taken while others had a share of the processor\n"
        "name = {}\ndescription = {}\nsource = {}\n\n[extensions]\n\n"
        "# After each number: the quartiles of single rounds; of the line that it comes from, R^2 and the "
        "rms\n"
        "# of the relative residuals. A line with R^2 below {} gives no number.\n"
        "[time]\nsource = {}\nquality = \"fitted\"\n",
        kFirstLine, how.rounds, 100 * how.disturbed_share, quoted(how.name),
        quoted("fitted to " + how.renderer), quoted(how_measured(how)), kLeastR2, quoted(how_measured(how)));
    for (const char* key : kKeys) {
        const auto term = std::find_if(findings.terms.begin(), findings.terms.end(),
                                       [&](const Term& t) { return t.key == key; });
        if (term == findings.terms.end()) continue;
        if (term->lack.empty())
            text += fmt::format("{} = {:.4g}  # {}\n", key, term->value, fit_of(*term));
        else
            text += fmt::format("# {} is left out: {}\n", key, term->lack);
    }
    text += "\n# Mixes that nothing was fitted to, in microseconds: measured, predicted, error.\n";
    for (const Check& check : findings.checks) text += "#   " + line_of(check) + '\n';
    return text;
}

nlohmann::ordered_json raw_report(const Findings& findings, const Circumstances& how) {
    nlohmann::ordered_json report = {{"name", how.name},
                                     {"renderer", how.renderer},
                                     {"version", how.version},
                                     {"cpu", how.cpu},
                                     {"lp_num_threads", how.threads},
                                     {"platform", how.platform},
                                     {"time", how.time},
                                     {"size", fmt::format("{}x{}", how.width, how.height)},
                                     {"rounds", how.rounds},
                                     {"disturbed_share", how.disturbed_share}};
    for (const Term& term : findings.terms) {
        nlohmann::ordered_json& entry = report["terms"][term.key];
        entry = {{"value", nullptr},
                 {"low", term.low},
                 {"high", term.high},
                 {"r2", term.r2},
                 {"rms_percent", term.rms_percent},
                 {"way", term.way}};
        if (term.lack.empty())
            entry["value"] = term.value;
        else
            entry["left_out"] = term.lack;
    }
    report["checks"] = nlohmann::ordered_json::array();
    for (const Check& check : findings.checks)
        report["checks"].push_back({{"what", check.what},
                                    {"measured_us", check.measured_us},
                                    {"predicted_us", check.predicted_us},
                                    {"error_percent", check.error_percent()},
                                    {"disturbed", check.is_disturbed}});
    report["sweeps"] = findings.sweeps;
    return report;
}

void check_output(const std::string& path, bool force) {
    std::error_code ignored;
    if (fs::is_directory(path, ignored)) throw FileError(fmt::format("{} is a folder", path));
    const fs::path folder = fs::absolute(path).parent_path();
    if (!fs::is_directory(folder, ignored))
        throw FileError(fmt::format("there is no folder {}", folder.string()));
    if (force || !fs::is_regular_file(path, ignored)) return;
    std::ifstream in(path);
    std::string line;
    std::getline(in, line);
    if (!line.starts_with(kFirstLine))
        throw FileError(fmt::format("{} is there and not by calibrate; --force writes over it", path));
}

void write_whole(const std::string& path, const std::string& text) {
    std::error_code error;
    const bool is_special = fs::exists(path, error) && !fs::is_regular_file(path, error);
    // Through a link to the file itself, so that the link stays.
    const fs::path target = fs::exists(path, error) ? fs::canonical(path, error) : fs::path(path);
    const std::string beside =
        is_special ? path : target.string() + fmt::format(".{}.part", static_cast<long>(getpid()));
    {
        std::ofstream out(beside, std::ios::binary | std::ios::trunc);
        out << text;
        out.close();
        if (!out) {
            if (!is_special) fs::remove(beside, error);
            throw FileError(fmt::format("{} cannot be written", path));
        }
    }
    if (is_special) return;
    fs::rename(beside, target, error);
    if (!error) return;
    const std::string reason = error.message();
    fs::remove(beside, error);
    throw FileError(fmt::format("{} cannot be written: {}", path, reason));
}

}  // namespace apps
