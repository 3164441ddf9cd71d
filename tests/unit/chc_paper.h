// SPDX-License-Identifier: MIT
// J. Bittner, M. Wimmer, H. Piringer, W. Purgathofer, Coherent Hierarchical Culling, 2004: tables 1 and 2,
// and the four programs as commands to a timeline. The visible leaves are spread evenly over the traversal,
// and alike:
//
//   VFC, ideal    leaves are drawn, one after the other
//   S&W           a query, and a wait for it, again and again; after some of them the leaf is drawn
//   (section 3.3) CHC           figure 2: a visible leaf is asked about and drawn at once, an invisible node
//   is only asked about; before
//                 each node, results are fetched while the oldest one has come; at the end, they are waited
//                 for
//
// The synthetic traversal is one of a scene in which nothing changes: no node turns visible, so that nothing
// depends on a result of CHC's. What the paper does not tell is in ChcProgram.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "occlusion_unit/timeline.h"

namespace papers {

enum class ChcMethod : std::uint8_t {
    kFrustum,
    kStopAndWait,
    kCoherent,
    kIdeal,
    kSparse,  // CHC that asks about a visible leaf every third frame: t_av = 2 in table 2
};

struct ChcTimes {
    double frame_ms = 0;
    double wait_ms = 0;
};

struct ChcScene {
    std::string_view name;
    std::uint64_t frustum_triangles = 0;
    std::uint64_t visible_triangles = 0;   // of S&W, and ideal
    std::uint64_t coherent_triangles = 0;  // of CHC
    std::uint64_t waited_queries = 0;      // of S&W
    std::uint64_t coherent_queries = 0;
    std::uint64_t sparse_queries = 0;
    bool fits_video_memory = true;
    double mean_box = 0;  // pixels of a query of S&W; fitted to its wait
    ChcTimes frustum, waiting, coherent, ideal, sparse;
};

struct ChcProgram {
    double frame_ms = 0.44;  // work of a frame beside its leaves and queries, fitted
    std::uint64_t window_pixels = 1024 * 768;
};

// Table 1 in its order: teapots, city, power plant.
std::span<const ChcScene> chc_table();

// What the paper says of a frame by <method>, and what the machine takes for it.
ChcTimes paper_times(const ChcScene& scene, ChcMethod method);
ChcTimes chc_times(const occlusion_unit::Profile& profile, occlusion_unit::Effects effects,
                   const ChcScene& scene, ChcMethod method, const ChcProgram& program = {});

}  // namespace papers
