// SPDX-License-Identifier: MIT
// H. Hey, R. F. Tobler, W. Purgathofer, Real-Time Occlusion Culling with a Lazy Occlusion Grid, 2001: table
// 1, and its five programs as commands to a timeline. An object goes through the first two like this, as
// section 3 tells:
//
//   LOG, PQ    depths of its box are read; it is found visible, and sorted in (work); it is drawn
//   BOG, HZB   it is found visible (work); it is drawn; depths of its box are read
//
// so that a draw is over before the processor goes on, except for the last. What the paper's program spent
// beside GL, and what the paper does not tell of its scenes, is in LogProgram: fitted, with two numbers of
// the machine, to the 20 times.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "occlusion_unit/timeline.h"

namespace papers {

enum class LogMethod : std::uint8_t { kLog, kBog, kHzb, kPq, kNoCulling };

struct LogScene {
    std::string_view name;
    std::uint64_t width = 0;
    std::uint64_t height = 0;
    std::uint64_t drawn = 0;    // triangles, with any of the four methods
    std::uint64_t in_view = 0;  // triangles, without
    double tiles_a_box = 0;     // of 32 x 32 pixels, at 640 x 480
    bool is_city = false;
};

struct LogRow {
    LogScene scene;
    LogMethod method = LogMethod::kLog;
    std::uint64_t pixels_read = 0;
    double milliseconds = 0;
};

struct LogProgram {
    double frame_ms = 7.5;     // work in a frame with culling: boxes are clipped, tested and sorted
    double pyramid_ns = 31.3;  // by pixel that is read, to keep HZB's pyramid: 28 cycles
    double city_vertices =
        1.24;  // those of a city's triangle, each "a primitive object", in those of the forest
    // Fragments, in screens: of what is drawn with culling, and of all of the forest that is in view. All of
    // the city takes its 0.74 s for vertices, however many of them lie on each other.
    double forest_layers = 2.7;
    double city_layers = 4.4;
    double whole_forest_layers = 17.3;
    // Not fitted: the city's boxes hold up to 1500 triangles.
    std::uint64_t triangles_a_draw = 1000;
};

// The table, in its order: forest and city, each small and large, each by the five methods.
std::span<const LogRow> log_table();

// Milliseconds that the machine takes for a frame of <row>.
double log_frame_ms(const occlusion_unit::Profile& profile, occlusion_unit::Effects effects,
                    const LogRow& row, const LogProgram& program = {});

}  // namespace papers
