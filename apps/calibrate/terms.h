// SPDX-License-Identifier: MIT
// The benchmarks: each isolates a term or two of the model by a sweep over sizes. What each does is told in
// docs/calibrate.md.
#pragma once

#include <string_view>

#include "apps/calibrate/findings.h"
#include "apps/calibrate/sampler.h"
#include "apps/calibrate/stage.h"

namespace apps {

/// What the other benchmarks build on; a machine that does not show them is too restless to calibrate.
constexpr std::string_view kNeeded[] = {"batch_us", "triangles_per_second",       "fragments_per_second",
                                        "query_us", "depth_fragments_per_second", "gpu_query_us",
                                        "poll_us",  "read_pixels_per_second"};

struct Bench {
    Stage& stage;
    Sampler& sampler;
    Findings& findings;
};

/// batch_us, gpu_batch_us, triangles_per_second, copied_triangle_ns.
void measure_draws(Bench& bench);
/// fragments_per_second.
void measure_fill(Bench& bench);
/// query_us, gpu_query_us, depth_fragments_per_second, result_latency_us, poll_us.
void measure_queries(Bench& bench);
/// cleared_pixels_per_second.
void measure_clears(Bench& bench);
/// read_us, read_pixels_per_second.
void measure_reads(Bench& bench);
/// fifo_us.
void measure_fifo(Bench& bench);

/// swap_us, swapped_pixels_per_second, from a window of each of several sizes; each is opened in turn and
/// closed again, so no other may be open.
void measure_swaps(std::string_view platform, int width, int height, Sampler& sampler, Findings& findings);

/// The held-out mixes.
void check_mixes(Bench& bench);

}  // namespace apps
