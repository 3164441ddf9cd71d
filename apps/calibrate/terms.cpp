// SPDX-License-Identifier: MIT
// The order within a sweep's numbers: a count of things in a burst is chosen so that the burst takes a
// millisecond or two on a software rasteriser, too short to be interrupted often.
#include "apps/calibrate/terms.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace apps {
namespace {

// As often as makes <most> things of it in all.
int times_for(double size, double most, int least, int limit) {
    return std::clamp(static_cast<int>(most / size), least, limit);
}

// One command, to be given <few> and <many> times.
struct Repeated {
    double x = 0;
    int few = 1;
    int many = 2;
    std::function<void()> run;
};

// What one more of each costs: a burst's beginning, when the GPU waits for the first command, and its end,
// when the CPU waits for the last, are none of it.
std::vector<Series> measure_one_more(Bench& bench, const std::string& name,
                                     const std::vector<Repeated>& commands) {
    std::vector<Burst> bursts;
    for (const Repeated& command : commands)
        for (const int count : {command.few, command.many})
            bursts.push_back({command.x, 1,
                              [&command, count] {
                                  for (int i = 0; i < count; ++i) command.run();
                              },
                              [&bench] { bench.stage.restart(); }});
    const auto measured = bench.sampler.measure(bursts);
    std::vector<Series> each;
    for (std::size_t i = 0; i < commands.size(); ++i)
        each.push_back(difference(measured[2 * i + 1], measured[2 * i], commands[i].many - commands[i].few));
    bench.findings.keep(name, each);
    return each;
}

}  // namespace

void measure_draws(Bench& bench) {
    Stage& stage = bench.stage;
    std::vector<Burst> tiny;
    for (const int count : {32, 64, 128, 256, 512})
        tiny.push_back({double(count), 1, [&stage, count] {
                            for (int i = 0; i < count; ++i) stage.mesh(2, MeshSize::kSubPixel);
                        }});
    const auto calls = bench.sampler.measure(tiny);
    bench.findings.keep("draw commands of two triangles", calls);
    bench.findings.add(slope_term("batch_us", fit_sweep(calls, &Times::submit), "tiny draws, until given"));

    std::vector<Repeated> meshes;
    for (const int triangles : {16, 64, 256, 1024, 2048, 4096, 8192, 16384}) {
        const int count = times_for(triangles, 16384, 1, 128);
        const int few = std::max(1, count / 8);
        meshes.push_back({double(triangles), few, few + count,
                          [&stage, triangles] { stage.mesh(triangles, MeshSize::kSubPixel); }});
    }
    const auto drawn = measure_one_more(bench, "batches of sub-pixel triangles", meshes);
    // Where the GPU, or whatever works off the triangles, is the slower of the two.
    const SweepFit work = fit_sweep(drawn, &Times::total, 2 * bench.findings.costs.batch);
    bench.findings.add(rate_term("triangles_per_second", work, "sub-pixel triangles in buffers, until done"));
    bench.findings.add(intercept_term("gpu_batch_us", work, 0, "the same line at no triangles",
                                      "nothing is left at no triangles"));

    std::vector<Burst> both;
    for (const int triangles : {256, 512, 1024, 2048, 4096}) {
        both.push_back({double(triangles), 4, [&stage, triangles] {
                            for (int i = 0; i < 4; ++i) stage.mesh(triangles, MeshSize::kSubPixel);
                        }});
        both.push_back({double(triangles), 4, [&stage, triangles] {
                            for (int i = 0; i < 4; ++i) stage.client_mesh(triangles);
                        }});
    }
    const auto pairs = bench.sampler.measure(both);
    std::vector<Series> kept, copied;
    for (std::size_t i = 0; i < pairs.size(); ++i) (i % 2 == 0 ? kept : copied).push_back(pairs[i]);
    bench.findings.keep("triangles in buffers", kept);
    bench.findings.keep("triangles in client memory", copied);
    const SweepFit in_buffers = fit_sweep(kept, &Times::submit);
    const SweepFit in_memory = fit_sweep(copied, &Times::submit);
    Term term = slope_term("copied_triangle_ns", in_memory, "client memory less buffers, until given", 1000);
    term.value -= 1000 * in_buffers.line.slope;
    term.low -= 1000 * in_buffers.slope.high;
    term.high -= 1000 * in_buffers.slope.low;
    if (term.lack.empty() && !stands_out(term))
        term.lack = "client memory costs no more than buffers, beyond the spread of rounds";
    bench.findings.add(term);
}

void measure_fill(Bench& bench) {
    Stage& stage = bench.stage;
    const double pixels = double(stage.width()) * stage.height();
    std::vector<Repeated> quads;
    for (const int eighths : {1, 2, 3, 4, 5, 6, 7, 8}) {
        const double area = pixels * eighths * eighths / 64;
        const int few = times_for(area, 1e5, 1, 8);
        quads.push_back(
            {area, few, few + times_for(area, 1e6, 1, 64), [&stage, eighths] { stage.quad(eighths); }});
    }
    const auto filled = measure_one_more(bench, "quads with colour and depth", quads);
    const SweepFit fit = fit_sweep(filled, &Times::total, 2 * bench.findings.costs.batch);
    bench.findings.add(rate_term("fragments_per_second", fit, "quads with colour and depth, until done"));
}

void measure_queries(Bench& bench) {
    Stage& stage = bench.stage;
    Findings& findings = bench.findings;
    const auto restart = [&stage] { stage.restart(); };
    std::vector<Burst> given;
    for (const int count : {8, 16, 24, 32, 48, 64})
        given.push_back({double(count), 1,
                         [&stage, count] {
                             for (int i = 0; i < count; ++i) stage.query(4);
                         },
                         restart});
    const auto calls = bench.sampler.measure(given);
    findings.keep("queries of a small box", calls);
    findings.add(slope_term("query_us", fit_sweep(calls, &Times::submit), "queries of a box, until given"));

    const int largest = std::min(stage.width(), stage.height());
    std::vector<Repeated> boxes;
    std::vector<Burst> waited;
    for (const int side : {4, 8, 16, 32, 64, 128, 192, 256, 320}) {
        if (side > largest) continue;
        const double fragments = box_fragments(side);
        boxes.push_back({fragments, 2, 10, [&stage, side] { stage.query(side); }});
        if (side > 256) continue;
        constexpr int kTrips = 8;
        waited.push_back({fragments, kTrips,
                          [&stage, side] {
                              for (std::size_t i = 0; i < kTrips; ++i) {
                                  stage.query(side);
                                  stage.wait(i);
                              }
                          },
                          restart});
    }
    const auto together = measure_one_more(bench, "queries of boxes, all at once", boxes);
    const SweepFit work = fit_sweep(together, &Times::total, 1.5 * findings.costs.query);
    findings.add(rate_term("depth_fragments_per_second", work, "queries of boxes at once, until done"));
    findings.add(intercept_term("gpu_query_us", work, 0, "the same line at no fragments",
                                "nothing is left at no fragments"));

    const auto alone = bench.sampler.measure(waited);
    findings.keep("queries of boxes, each waited for", alone);
    findings.add(intercept_term("result_latency_us", fit_sweep(alone, &Times::submit),
                                findings.costs.query + findings.costs.gpu_query,
                                "stop and wait, at no fragments, less query_us and gpu_query_us",
                                "a wait takes no longer than the query and its work"));

    std::vector<Burst> asked;
    for (const int count : {100, 200, 400, 800, 1600})
        asked.push_back({double(count), 1,
                         [&stage, count] {
                             for (int i = 0; i < count; ++i) stage.poll();
                         },
                         [&stage] {
                             stage.restart();
                             stage.query(4);
                             stage.wait(0);
                         }});
    const auto polls = bench.sampler.measure(asked);
    findings.keep("polls of a result that is there", polls);
    findings.add(slope_term("poll_us", fit_sweep(polls, &Times::submit), "polls of a result that is there"));
}

void measure_clears(Bench& bench) {
    Stage& stage = bench.stage;
    if (!stage.has_framebuffers()) {
        bench.findings.add({"cleared_pixels_per_second", 0, 0, 0, 0, 0, "", "GL has no framebuffer objects"});
        return;
    }
    std::vector<Burst> clears;
    for (const int eighths : {2, 3, 4, 5, 6, 7, 8}) {
        const int width = stage.width() * eighths / 8, height = stage.height() * eighths / 8;
        constexpr int kClears = 4;
        clears.push_back({double(width) * height, kClears,
                          [&stage] {
                              for (int i = 0; i < kClears; ++i) {
                                  stage.clear();
                                  stage.mesh(2, MeshSize::kSubPixel);
                                  stage.flush();
                              }
                          },
                          [&stage, width, height] { stage.use_framebuffer(width, height); }});
    }
    const auto cleared = bench.sampler.measure(clears);
    stage.use_framebuffer(0, 0);
    bench.findings.keep("clears of framebuffer objects", cleared);
    bench.findings.add(rate_term("cleared_pixels_per_second", fit_sweep(cleared, &Times::total),
                                 "clears of framebuffer objects, a flush each"));
}

void measure_reads(Bench& bench) {
    Stage& stage = bench.stage;
    const int largest = std::min(stage.width(), stage.height());
    std::vector<Burst> reads;
    for (const int side : {4, 8, 16, 32, 64, 128, 192, 256, 384}) {
        if (side > largest) continue;
        const int count = times_for(side * side, 5e4, 2, 8);
        reads.push_back({double(side) * side, double(count), [&stage, side, count] {
                             for (int i = 0; i < count; ++i) {
                                 stage.mesh(2, MeshSize::kSubPixel);
                                 stage.read(side);
                             }
                         }});
    }
    const auto times = bench.sampler.measure(reads);
    bench.findings.keep("depths read after a small draw", times);
    const SweepFit fit = fit_sweep(times, &Times::submit);
    bench.findings.add(rate_term("read_pixels_per_second", fit, "depths read after a small draw"));
    bench.findings.add(intercept_term(
        "read_us", fit, bench.findings.costs.batch + bench.findings.costs.gpu_batch,
        "the same line at no pixels, less the draw", "a read costs nothing beside its pixels"));
}

}  // namespace apps
