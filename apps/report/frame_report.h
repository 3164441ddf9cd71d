// SPDX-License-Identifier: MIT
// What a walkthrough reports: JSON lines, one object to a frame and then one summary. Field names are an
// interface: other programs read them. Milliseconds of wall time, but `device_ms`, which is a device's; null
// where nothing was measured.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "apps/culling/statistic.h"
#include "apps/oracle/oracle.h"
#include "apps/render/gl_canvas.h"

namespace apps {

struct FrameRecord {
    int index = 0;  // of the path
    int swap = 0;   // swaps before it: what a monitor under GL calls the frame
    std::vector<ObjectId> drawn;
    std::uint64_t drawn_triangles = 0;
    std::uint64_t frustum_triangles = 0;  // that view-frustum culling over the same tree would draw
    Counters counters;
    Tally tally;                      // what the culler counted beside
    double frame_ms = 0;              // from the clear to the end of glFinish
    std::optional<double> device_ms;  // from swap to swap, on the clock of an emulated device
    std::optional<Verdict> verdict;
};

/// One object to a frame: `frame`, `drawn_triangles`, ... as docs name them.
std::vector<nlohmann::ordered_json> frame_lines(const std::vector<FrameRecord>& frames);

/// frame_ms of each frame of an earlier run; throws std::runtime_error, one sentence, where there is no such
/// thing.
std::vector<double> read_baseline(const std::filesystem::path& file);

/// The means of every field, the speed-ups over `baseline` (if not empty) and then the facts of `run`.
nlohmann::ordered_json summary_of(const std::vector<nlohmann::ordered_json>& lines,
                                  const std::vector<double>& baseline, const nlohmann::ordered_json& run);

/// Writes lines and summary; "-" is the standard output. Throws std::runtime_error where it cannot.
void write_report(const std::string& file, const std::vector<nlohmann::ordered_json>& lines,
                  const nlohmann::ordered_json& summary);

}  // namespace apps
