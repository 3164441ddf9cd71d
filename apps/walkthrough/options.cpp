// SPDX-License-Identifier: MIT
// Parses and checks the command line. Every refusal names what was given and what would have been taken.
#include "apps/walkthrough/options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <optional>

#include "apps/scene/scenes.h"

namespace apps {
namespace {

std::pair<std::string, std::string> split_pair(const std::string& text, const char* option) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0)
        throw BadUse(fmt::format("{} takes name=value, not \"{}\"", option, text));
    return {text.substr(0, equals), text.substr(equals + 1)};
}

template <class Number>
Number number_of(const std::string& text, const std::string& what) {
    Number value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size())
        throw BadUse(fmt::format("{} is a number, not \"{}\"", what, text));
    return value;
}

void read_size(const std::string& text, Options& options) {
    const std::size_t x = text.find('x');
    if (x == std::string::npos) throw BadUse(fmt::format("--size is WIDTHxHEIGHT, not \"{}\"", text));
    options.width = number_of<int>(text.substr(0, x), "the width of --size");
    options.height = number_of<int>(text.substr(x + 1), "the height of --size");
    if (std::min(options.width, options.height) < 1 || std::max(options.width, options.height) > 8192)
        throw BadUse(fmt::format("--size is from 1x1 to 8192x8192 pixels, not \"{}\"", text));
}

void read_sections(const std::string& text, Options& options) {
    const std::size_t x = text.find('x');
    if (x == std::string::npos) throw BadUse(fmt::format("--sections is COUNTxFRAMES, not \"{}\"", text));
    options.sections = number_of<int>(text.substr(0, x), "the count of --sections");
    options.section_frames = number_of<int>(text.substr(x + 1), "the frames of --sections");
    if (options.sections < 1 || options.section_frames < 1 ||
        static_cast<long long>(options.sections) * options.section_frames > options.frames)
        throw BadUse(fmt::format("--sections {} is not a part of {} frames", text, options.frames));
}

template <class List>
std::string names_of(const List& list) {
    std::vector<std::string_view> names;
    for (const auto& entry : list) {
        if constexpr (std::is_pointer_v<std::remove_cvref_t<decltype(entry)>>)
            names.push_back(entry->name);
        else
            names.push_back(entry.name);
    }
    return fmt::format("{}", fmt::join(names, ", "));
}

void read_knobs(const std::vector<std::string>& settings, const CullerRecipe& culler, KnobValues& values) {
    values = culler.knob_values();
    for (const std::string& setting : settings) {
        const auto [name, text] = split_pair(setting, "--set");
        const auto knob = std::find_if(culler.knobs.begin(), culler.knobs.end(),
                                       [&](const Knob& k) { return k.name == name; });
        if (knob == culler.knobs.end())
            throw BadUse(culler.knobs.empty() ? fmt::format("{} has no knobs to --set", culler.name)
                                              : fmt::format("{} has no knob \"{}\" to --set: it has {}",
                                                            culler.name, name, names_of(culler.knobs)));
        const auto value = number_of<double>(text, fmt::format("--set {}", name));
        if (!(value >= knob->low && value <= knob->high))
            throw BadUse(
                fmt::format("--set {} is from {} to {}, not {}", name, knob->low, knob->high, value));
        values[name] = value;
    }
}

/// Refuses `value` unless it is one of `allowed` or, left to be chosen, empty.
void check_choice(const char* option, const std::string& value, std::initializer_list<const char*> allowed) {
    if (value.empty() || std::find(allowed.begin(), allowed.end(), value) != allowed.end()) return;
    throw BadUse(fmt::format("{} is {}, not \"{}\"", option, fmt::join(allowed, " or "), value));
}

void read_split(const std::string& split, std::optional<long long> most, Options& options) {
    if ((!split.empty() || most) && find_scene(options.scene))
        throw BadUse("--split and --leaf-triangles cut model files, not generated scenes");
    check_choice("--split", split, {"size", "object"});
    if (split == "object") options.split = {ModelSplit::By::kObject, ModelSplit::kMostOfAMesh};
    if (!most) return;
    if (*most < 1) throw BadUse(fmt::format("--leaf-triangles is at least 1, not {}", *most));
    options.split.most_triangles = static_cast<std::size_t>(*most);
}

void read_work(double work_us, Options& options) {
    constexpr double kMostMicroseconds = 1e9;
    if (!(work_us >= 0 && work_us <= kMostMicroseconds))
        throw BadUse(fmt::format("--work-us is from 0 to {:.0f}, not {}", kMostMicroseconds, work_us));
    options.work = std::chrono::nanoseconds(std::llround(work_us * 1000));
}

void check(const Options& options) {
    if (options.frames < 1) throw BadUse(fmt::format("--frames is at least 1, not {}", options.frames));
    if (options.image_frame < 0 || options.image_frame >= options.frames)
        throw BadUse(
            fmt::format("--image-frame is from 0 to {}, not {}", options.frames - 1, options.image_frame));
    check_choice("--platform", options.platform, {"egl", "glx", "osmesa"});
    check_choice("--tree", options.tree, {"kd", "bvh"});
    if (!(options.moving >= 0 && options.moving <= 1))
        throw BadUse(fmt::format("--moving is from 0 to 1, not {}", options.moving));
    if (options.moving > 0 && options.tree == "kd")
        throw BadUse("--moving needs a tree that can be refitted: --tree bvh, not kd");
    check_choice("--test", options.test,
                 {"GL_ARB_occlusion_query", "GL_NV_occlusion_query", "GL_HP_occlusion_test"});
    check_choice("--regions", options.regions, {"GL_EMU_depth_region_query", "glReadPixels"});
    if (options.judge_every < 1)
        throw BadUse(fmt::format("--judge-every is at least 1, not {}", options.judge_every));
    if (options.judge_every > 1 && !options.oracle) throw BadUse("--judge-every needs --oracle");
    if (!options.oracle_cache.empty() && !options.oracle) throw BadUse("--oracle-cache needs --oracle");
    const SceneRecipe* scene = find_scene(options.scene);
    if (!scene && !std::filesystem::is_regular_file(options.scene))
        throw BadUse(
            fmt::format("--scene is {} or a model file, not \"{}\"", names_of(scenes()), options.scene));
    if (scene && !(options.scale >= scene->smallest_scale && options.scale <= scene->largest_scale))
        throw BadUse(fmt::format("--scale of {} is from {} to {}, not {}", scene->name, scene->smallest_scale,
                                 scene->largest_scale, options.scale));
    if (!scene && options.scale != 1) throw BadUse("--scale changes generated scenes, not model files");
}

}  // namespace

Options parse_options(int argc, const char* const* argv) {
    Options options;
    std::string size;
    std::string sections;
    std::string split;
    std::optional<long long> leaf_triangles;
    double work_us = 0;
    std::vector<std::string> settings;
    std::vector<std::string> labels;
    CLI::App app(
        "Walks a camera through a scene with one occlusion culler, on whatever GL there is, and reports each "
        "frame.",
        "walkthrough");
    app.add_option("--scene", options.scene, "a scene of --list, or a model file")->capture_default_str();
    app.add_option("--culler", options.culler, "a culler of --list")->capture_default_str();
    app.add_option("--platform", options.platform, "egl (no display needed), glx (a window) or osmesa")
        ->capture_default_str();
    app.add_option("--size", size, "WIDTHxHEIGHT in pixels; 640x480 unless given");
    app.add_option("--frames", options.frames, "frames over the whole path")->capture_default_str();
    app.add_option(
        "--sections", sections,
        "COUNTxFRAMES: walk only so many parts of the path, of so many frames each, evenly spread");
    app.add_option("--work-us", work_us,
                   "the program's own work in a frame, microseconds on a device's clock (GL_EMU_device_time)")
        ->capture_default_str();
    app.add_option("--scale", options.scale, "share of a generated scene's triangles")->capture_default_str();
    app.add_option("--seed", options.seed, "of a generated scene")->capture_default_str();
    app.add_option("--tree", options.tree, "kd or bvh; that of the scene's paper unless given");
    app.add_option("--moving", options.moving,
                   "share of the small objects, 0 to 1, that move about; the tree is then a bvh")
        ->capture_default_str();
    app.add_option(
        "--split", split,
        "what is an object of a model file: size (neighbouring triangles, unless given), or object "
        "(a mesh of the file)");
    app.add_option("--leaf-triangles", leaf_triangles,
                   fmt::format("most in an object of a model file, {} unless given, {} with --split object",
                               ModelSplit::kNeighbours, ModelSplit::kMostOfAMesh));
    app.add_flag("--unshared", options.unshared,
                 "give each object a mesh of its own: more memory than the device may have");
    app.add_option("--test", options.test,
                   "the extension to ask by: GL_ARB_occlusion_query, GL_NV_occlusion_query or "
                   "GL_HP_occlusion_test; the first of them that the machine has unless given");
    app.add_option("--regions", options.regions,
                   "how to ask for depths: GL_EMU_depth_region_query or glReadPixels; the first of them that "
                   "the machine has unless given");
    app.add_option("--set", settings, "name=value of a knob of the culler")->allow_extra_args(false);
    app.add_option("--json", options.json,
                   "write the report there, a line a frame and a summary; - is stdout");
    app.add_option("--baseline", options.baseline,
                   "an earlier --json of as many frames: report speed-ups over it");
    app.add_flag("--oracle", options.oracle,
                 "compare each frame with the exact visible set; false culls exit 1");
    app.add_option("--judge-every", options.judge_every, "compare only every so many frames")
        ->capture_default_str();
    app.add_option("--oracle-cache", options.oracle_cache, "keep the exact sets there for the next run");
    app.add_option("--images", options.images, "write view.png, above.png and nodes.png into that folder");
    app.add_option("--image-frame", options.image_frame, "of which frame")->capture_default_str();
    app.add_option("--label", labels, "key=value, a word of yours for the summary")->allow_extra_args(false);
    app.add_flag("--list", options.list, "print scenes, cullers and knobs as JSON");
    try {
        app.parse(argc, argv);
    } catch (const CLI::CallForHelp&) {
        options.help = app.help();
        return options;
    } catch (const CLI::ParseError& error) {
        throw BadUse(error.what());
    }
    if (options.list) return options;
    if (!size.empty()) read_size(size, options);
    if (!sections.empty()) read_sections(sections, options);
    read_split(split, leaf_triangles, options);
    read_work(work_us, options);
    const CullerRecipe* culler = find_culler(options.culler);
    if (!culler)
        throw BadUse(fmt::format("--culler is one of {}, not \"{}\"", names_of(cullers()), options.culler));
    read_knobs(settings, *culler, options.knobs);
    for (const std::string& label : labels)
        options.labels.insert_or_assign(split_pair(label, "--label").first,
                                        split_pair(label, "--label").second);
    check(options);
    return options;
}

}  // namespace apps
