// SPDX-License-Identifier: MIT
// walkthrough: one culler, one scene, one camera path. Exit status: 0 done; 1 a conservative culler left out
// something visible (with --oracle); 2 bad use, said in one sentence.
#include <fmt/format.h>

#include <cstdio>

#include "apps/walkthrough/list.h"
#include "apps/walkthrough/walk.h"

namespace {

using apps::FrameRecord;

void print_summary(const nlohmann::ordered_json& s) {
    const auto number = [&](const char* key) { return s[key].get<double>(); };
    const double total = number("scene_triangles");
    fmt::print("{}, {} on {}, {} frames of {}\n", s["scene"].get<std::string>(),
               s["culler"].get<std::string>(), s["device"].get<std::string>(), s["frames"].get<int>(),
               s["size"].get<std::string>());
    fmt::print(
        "triangles   {:.0f} drawn a frame, {:.1f} % of the frustum's {:.0f}; {:.2f} % of the scene's "
        "{:.0f}\n",
        number("drawn_triangles"), 100 * number("drawn_triangles") / number("frustum_triangles"),
        number("frustum_triangles"), 100 * number("drawn_triangles") / total, total);
    fmt::print("frustum     {:.1f} % of the scene\n", 100 * number("frustum_triangles") / total);
    fmt::print("queries     {:.1f} a frame, {:.2f} ms stalled; the machine has {}\n", number("queries"),
               number("stall_ms"),
               s["occlusion_test"].is_null() ? "none" : s["occlusion_test"].get<std::string>());
    fmt::print("time        {:.2f} ms a frame\n", number("frame_ms"));
    if (!s["device_ms"].is_null()) fmt::print("            {:.3f} ms on the device\n", number("device_ms"));
    if (s.contains("speedup_mean_of_ratios"))
        fmt::print("speed-up    {:.2f} (mean of ratios), {:.2f} (ratio of means)\n",
                   number("speedup_mean_of_ratios"), number("speedup_ratio_of_means"));
    if (s.contains("false_culls"))
        fmt::print(
            "oracle      {:.1f} objects visible, {:g} false culls, {:g} wrong pixels, {:.1f} contested "
            "pixels a frame\n",
            number("visible_objects"), number("false_culls"), number("wrong_pixels"),
            number("contested_pixels"));
}

int run(const apps::Options& options) {
    std::vector<double> baseline;
    if (!options.baseline.empty()) {
        baseline = apps::read_baseline(options.baseline);
        const auto frame_count = static_cast<std::size_t>(
            options.sections == 0 ? options.frames : options.sections * options.section_frames);
        if (baseline.size() != frame_count)
            throw apps::BadUse(fmt::format("the baseline {} has {} frames and this walk {}", options.baseline,
                                           baseline.size(), frame_count));
    }
    apps::World world = apps::build_world(options);
    apps::Walk walk(world, options);
    const std::vector<FrameRecord> frames = walk.run();

    if (!options.images.empty()) walk.save_images();

    const auto lines = apps::frame_lines(frames);
    const auto summary = apps::summary_of(lines, baseline, walk.facts());
    if (!options.json.empty()) apps::write_report(options.json, lines, summary);
    if (options.json != "-") print_summary(summary);

    std::uint64_t false_culls = 0;
    for (const FrameRecord& frame : frames) false_culls += frame.verdict ? frame.verdict->false_culls : 0;
    const bool failed =
        false_culls > 0 && apps::find_culler(options.culler)->is_conservative_with(options.knobs);
    if (failed)
        fmt::print(stderr, "walkthrough: {} is conservative and left out {} visible objects\n",
                   options.culler, false_culls);
    return failed ? 1 : 0;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        const apps::Options options = apps::parse_options(argc, argv);
        if (!options.help.empty()) {
            fmt::print("{}", options.help);
            return 0;
        }
        if (options.list) {
            fmt::print("{}\n", apps::list_all().dump(2));
            return 0;
        }
        return run(options);
    } catch (const std::exception& error) {
        fmt::print(stderr, "walkthrough: {}\n", error.what());
        return 2;
    }
}
