// SPDX-License-Identifier: MIT
// Frames to JSON, and their means.
#include "apps/report/frame_report.h"

#include <algorithm>
#include <fstream>
#include <iostream>
#include <stdexcept>

#include "apps/culling/occlusion_grid.h"

namespace apps {

using Json = nlohmann::ordered_json;

std::vector<Json> frame_lines(const std::vector<FrameRecord>& frames) {
    std::vector<Json> lines;
    std::vector<const Statistic*> counted;
    for (const Statistic* statistic : Statistic::all())
        if (std::any_of(frames.begin(), frames.end(),
                        [&](const FrameRecord& frame) { return frame.tally.has(*statistic); }))
            counted.push_back(statistic);
    for (const FrameRecord& f : frames) {
        Json line{{"frame", f.index},
                  {"swap", f.swap},
                  {"drawn_triangles", f.drawn_triangles},
                  {"drawn_objects", f.drawn.size()},
                  {"frustum_triangles", f.frustum_triangles},
                  {"queries", f.counters.queries},
                  {"results_waited", f.counters.results_waited},
                  {"query_boxes", f.counters.query_boxes},
                  {"polls", f.counters.polls},
                  {"pixels_read", f.counters.pixels_read},
                  {"region_waits", f.counters.region_waits},
                  {"tiles_tested", f.tally.of(kTilesTested)},
                  {"stall_ms", f.counters.stall_ms},
                  {"frame_ms", f.frame_ms},
                  {"device_ms", f.device_ms ? Json(*f.device_ms) : Json(nullptr)}};
        for (const Statistic* statistic : counted)
            line[std::string(statistic->name())] = f.tally.of(*statistic);
        if (f.verdict) {
            line["visible_objects"] = f.verdict->visible_objects;
            line["false_culls"] = f.verdict->false_culls;
            line["wrong_pixels"] = f.verdict->wrong_pixels;
            line["contested_pixels"] = f.verdict->contested_pixels;
        }
        lines.push_back(std::move(line));
    }
    return lines;
}

std::vector<double> read_baseline(const std::filesystem::path& file) {
    std::ifstream in(file);
    if (!in) throw std::runtime_error("the baseline " + file.string() + " cannot be read");
    std::vector<double> result;
    for (std::string text; std::getline(in, text);) {
        const auto line = Json::parse(text, nullptr, false);
        const bool is_frame = line.is_object() && line.contains("frame_ms") && line["frame_ms"].is_number();
        const bool is_summary = line.is_object() && line.contains("summary");
        if (is_frame) result.push_back(line["frame_ms"].get<double>());
        if (!is_frame && !is_summary)
            throw std::runtime_error("the baseline " + file.string() +
                                     " is not the JSON lines of a walkthrough");
    }
    return result;
}

Json summary_of(const std::vector<Json>& lines, const std::vector<double>& baseline, const Json& run) {
    Json summary = Json::object();
    for (const auto& [key, first] : lines.front().items()) {
        if (key == "frame" || key == "swap") continue;
        double sum = 0;
        double count = 0;
        for (const Json& line : lines) {
            if (!line.contains(key)) continue;  // a frame that was not judged
            sum += line[key].is_number() ? line[key].get<double>() : 0;
            ++count;
        }
        summary[key] = first.is_null() ? Json(nullptr) : Json(sum / count);
    }
    if (!baseline.empty()) {
        double ratios = 0;
        double before = 0;
        double after = 0;
        for (std::size_t i = 0; i < lines.size(); ++i) {
            const auto now = lines[i]["frame_ms"].get<double>();
            ratios += baseline[i] / now;
            before += baseline[i];
            after += now;
        }
        summary["speedup_mean_of_ratios"] = ratios / static_cast<double>(lines.size());
        summary["speedup_ratio_of_means"] = before / after;
    }
    summary["frames"] = lines.size();
    summary.update(run);
    return summary;
}

void write_report(const std::string& file, const std::vector<Json>& lines, const Json& summary) {
    std::ofstream out_file;
    if (file != "-") out_file.open(file);
    std::ostream& out = file == "-" ? std::cout : out_file;
    for (const Json& line : lines) out << line.dump() << '\n';
    out << Json{{"summary", summary}}.dump() << std::endl;
    if (!out) throw std::runtime_error("the report " + file + " cannot be written");
}

}  // namespace apps
