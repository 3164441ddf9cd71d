// SPDX-License-Identifier: MIT
#include "log_paper.h"

#include <cmath>

#include "parts.h"

namespace papers {
namespace {

using occlusion_unit::Effects;
using occlusion_unit::Profile;
using occlusion_unit::Timeline;

constexpr double kTilePixels = 32 * 32;
constexpr double kSmallWidth = 640;

constexpr LogScene kForest = {"forest", 640, 480, 7'009, 147'969, 14.6, false};
constexpr LogScene kLargeForest = {"forest", 1280, 960, 7'510, 147'969, 14.6, false};
constexpr LogScene kCity = {"city", 640, 480, 11'981, 1'964'918, 17.7, true};
constexpr LogScene kLargeCity = {"city", 1280, 960, 11'775, 1'964'918, 17.7, true};

constexpr LogRow kTable[] = {
    {kForest, LogMethod::kLog, 198'621, 18},         {kForest, LogMethod::kBog, 2'288'217, 73},
    {kForest, LogMethod::kHzb, 2'682'035, 162},      {kForest, LogMethod::kPq, 5'880'310, 152},
    {kForest, LogMethod::kNoCulling, 0, 45},         {kLargeForest, LogMethod::kLog, 424'713, 31},
    {kLargeForest, LogMethod::kBog, 6'844'437, 216}, {kLargeForest, LogMethod::kHzb, 10'729'627, 632},
    {kLargeForest, LogMethod::kPq, 23'495'623, 611}, {kLargeForest, LogMethod::kNoCulling, 0, 52},
    {kCity, LogMethod::kLog, 283'306, 21},           {kCity, LogMethod::kBog, 1'272'965, 45},
    {kCity, LogMethod::kHzb, 1'361'715, 87},         {kCity, LogMethod::kPq, 6'032'486, 158},
    {kCity, LogMethod::kNoCulling, 0, 741},          {kLargeCity, LogMethod::kLog, 312'053, 33},
    {kLargeCity, LogMethod::kBog, 4'230'168, 138},   {kLargeCity, LogMethod::kHzb, 5'417'068, 328},
    {kLargeCity, LogMethod::kPq, 24'042'029, 630},   {kLargeCity, LogMethod::kNoCulling, 0, 742},
};

// LOG and BOG read tiles, the others boxes, whose size is that of the tiles that the paper counts for one.
std::uint64_t reads_of(const LogRow& row) {
    const bool reads_tiles = row.method == LogMethod::kLog || row.method == LogMethod::kBog;
    const double scale = static_cast<double>(row.scene.width) / kSmallWidth;
    const double pixels = reads_tiles ? kTilePixels : row.scene.tiles_a_box * kTilePixels * scale * scale;
    return rounded(static_cast<double>(row.pixels_read) / pixels);
}

double layers_of(const LogRow& row, const LogProgram& program) {
    if (row.method != LogMethod::kNoCulling)
        return row.scene.is_city ? program.city_layers : program.forest_layers;
    return row.scene.is_city ? 0 : program.whole_forest_layers;
}

}  // namespace

std::span<const LogRow> log_table() {
    return kTable;
}

double log_frame_ms(const Profile& profile, Effects effects, const LogRow& row, const LogProgram& program) {
    const LogScene& scene = row.scene;
    const std::uint64_t pixels = scene.width * scene.height;
    const bool is_culled = row.method != LogMethod::kNoCulling;
    const bool reads_first = row.method == LogMethod::kLog || row.method == LogMethod::kPq;
    const std::uint64_t triangles = is_culled ? scene.drawn : scene.in_view;
    const std::uint64_t draws = (triangles + program.triangles_a_draw - 1) / program.triangles_a_draw;
    const std::uint64_t reads = reads_of(row);
    // What the vertex stage has to do, as triangles of the forest.
    const std::uint64_t vertices =
        rounded(static_cast<double>(triangles) * (scene.is_city ? program.city_vertices : 1.0));
    const std::uint64_t fragments = rounded(static_cast<double>(pixels) * layers_of(row, program));
    const double pyramid_ns = row.method == LogMethod::kHzb ? program.pyramid_ns : 0;

    Timeline timeline(profile, effects);
    timeline.clear(pixels);
    std::uint64_t read = 0;
    const auto read_depths = [&](std::uint64_t draw) {
        for (std::uint64_t left = part(reads, draw, draws); left != 0; --left) {
            const std::uint64_t box = part(row.pixels_read, read++, reads);
            timeline.read(box);
            timeline.work(picoseconds(static_cast<double>(box) * pyramid_ns * 1e-6));
        }
    };
    for (std::uint64_t draw = 0; draw < draws; ++draw) {
        if (reads_first) read_depths(draw);
        if (is_culled) timeline.work(picoseconds(program.frame_ms / static_cast<double>(draws)));
        timeline.draw(
            {.triangles = part(vertices, draw, draws), .fragments = {.count = part(fragments, draw, draws)}});
        if (!reads_first) read_depths(draw);
    }
    return milliseconds(timeline.swap(pixels).cpu);
}

}  // namespace papers
