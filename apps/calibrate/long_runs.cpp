// SPDX-License-Identifier: MIT
// The benchmarks that need more than a burst: a FIFO is full only after much work, and a swap needs windows
// of several sizes.
#include <fmt/format.h>

#include <algorithm>

#include "apps/calibrate/terms.h"

namespace apps {
namespace {

// What is left to do when <x> draws have been given, against how many they were.
struct Backlog {
    std::vector<Series> sweep;

    double left(std::size_t at) const {
        return sweep[at].median_of(&Times::total) - sweep[at].median_of(&Times::submit);
    }
    double share() const { return left(sweep.size() - 1) / sweep.back().median_of(&Times::total); }
    // Four times the work leaves about as much as a quarter of it: there is an end to what may be left.
    bool has_end() const { return left(sweep.size() - 1) < 1.3 * left(sweep.size() - 3); }
    double end() const { return (left(sweep.size() - 1) + left(sweep.size() - 2)) / 2; }
};

Backlog measure_backlog(Bench& bench, const std::string& name, std::initializer_list<int> counts,
                        const std::function<void()>& draw) {
    std::vector<Burst> bursts;
    for (const int count : counts)
        bursts.push_back({double(count), 1, [&draw, count] {
                              for (int i = 0; i < count; ++i) draw();
                          }});
    Backlog backlog{bench.sampler.measure(bursts)};
    bench.findings.keep(name, backlog.sweep);
    return backlog;
}

std::string told(const Backlog& backlog) {
    return fmt::format("{:.1f} % of the time of {} draws is left when they are given{}",
                       100 * backlog.share(), backlog.sweep.back().x,
                       backlog.has_end() ? "" : " and grows with them");
}

}  // namespace

void measure_fifo(Bench& bench) {
    Stage& stage = bench.stage;
    const Costs& costs = bench.findings.costs;
    constexpr int kTriangles = 2048;
    const Backlog vertices = measure_backlog(bench, "backlog of vertices", {8, 16, 32, 64, 128, 256},
                                             [&] { stage.mesh(kTriangles, MeshSize::kSubPixel); });
    const Backlog fill =
        measure_backlog(bench, "backlog of fill", {16, 32, 64, 128, 256}, [&] { stage.quad(3); });

    // The last draw is taken while the FIFO is just not full, so one draw's work comes on top, less what was
    // worked off while it was given.
    const double on_top = costs.gpu_batch - costs.batch;
    const double of_vertices = vertices.end() - on_top - kTriangles * costs.triangle;
    const double of_fill =
        fill.end() - on_top - double(stage.width()) * stage.height() * 9 / 64 * costs.fragment;
    Term term{"fifo_us",
              (of_vertices + of_fill) / 2,
              std::min(of_vertices, of_fill),
              std::max(of_vertices, of_fill),
              0,
              0,
              "what is left to do when draws have to wait",
              ""};
    constexpr double kAlike = 2;
    if (!vertices.has_end() || !fill.has_end() || term.low <= 0 || term.high > kAlike * term.low)
        term.lack = fmt::format("no one FIFO explains what is left: vertices, {}; fill, {}", told(vertices),
                                told(fill));
    bench.findings.add(term);
}

void measure_swaps(std::string_view name, int width, int height, Sampler& sampler, Findings& findings) {
    std::vector<Series> sweep;
    for (const int quarters : {1, 2, 3, 4, 5}) {
        const int w = width * quarters / 4 / 8 * 8, h = height * quarters / 4 / 8 * 8;
        const std::unique_ptr<Platform> platform = open_platform(name, w, h);
        Stage stage(*platform, w, h);
        constexpr int kFrames = 8;
        const Burst frames{double(w) * h, kFrames, [&] {
                               for (int i = 0; i < kFrames; ++i) {
                                   stage.mesh(2, MeshSize::kSubPixel);
                                   platform->swap_buffers();
                               }
                           }};
        sweep.push_back(sampler.measure({frames}).front());
    }
    findings.keep("frames of a small draw", sweep);
    const SweepFit fit = fit_sweep(sweep, &Times::total);
    findings.add(rate_term("swapped_pixels_per_second", fit, "frames of a small draw, by window size"));
    const double draw = findings.costs.batch + findings.costs.gpu_batch;
    if (findings.shown("swapped_pixels_per_second") != nullptr) {
        findings.add(intercept_term("swap_us", fit, draw, "the same line at no pixels, less the draw",
                                    "a swap costs nothing beside its pixels"));
        return;
    }
    std::vector<double> all;
    for (const Series& series : sweep)
        for (const Times& times : series.rounds) all.push_back(times.total - draw);
    const Quartiles spread = quartiles(std::move(all));
    Term term{"swap_us",
              spread.middle,
              spread.low,
              spread.high,
              0,
              0,
              "frames of a small draw less the draw, whatever the window",
              ""};
    if (!stands_out(term)) term.lack = "a swap costs nothing beyond the spread of rounds";
    findings.add(term);
}

}  // namespace apps
