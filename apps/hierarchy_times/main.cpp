// SPDX-License-Identifier: MIT
// hierarchy_times: how long the trees of a scene take to build and to refit, and how much memory. Of a scene
// with shared meshes both ways: over its objects, and over all of its triangles, each in a place of its own.
#include <fmt/format.h>
#include <sys/resource.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "apps/hierarchy/bvh.h"
#include "apps/hierarchy/kd_tree.h"
#include "apps/hierarchy/refit.h"
#include "apps/hierarchy/world.h"
#include "apps/scene/model.h"
#include "apps/scene/motion.h"

namespace {

using Json = nlohmann::ordered_json;

struct Options {
    std::string scene = "chc-city";
    double scale = 1;
    std::uint64_t seed = 1;
    std::size_t leaf_triangles = 1500;
    double moving = 0.1;
    bool soup = false;
    bool json = false;
};

double megabytes_so_far() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / 1024;
}

struct Seconds {
    double passed = 0;
    double of_all_threads = 0;

    Seconds& operator+=(const Seconds& other) {
        passed += other.passed;
        of_all_threads += other.of_all_threads;
        return *this;
    }
    Seconds operator/(double count) const { return {passed / count, of_all_threads / count}; }
};

Seconds seconds_of(const auto& work) {
    const auto start = std::chrono::steady_clock::now();
    const std::clock_t cpu_start = std::clock();
    work();
    return {std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(),
            static_cast<double>(std::clock() - cpu_start) / CLOCKS_PER_SEC};
}

/// Rows of name, seconds and what was built.
class Report {
  public:
    explicit Report(bool is_json) : is_json_(is_json) {}

    void add(const char* what, const Seconds& seconds, const Json& facts) {
        Json row{{"what", what},
                 {"seconds", seconds.passed},
                 {"cpu_seconds", seconds.of_all_threads},
                 {"peak_megabytes", megabytes_so_far()}};
        row.update(facts);
        if (is_json_) {
            fmt::print("{}\n", row.dump());
        } else {
            fmt::print("{:<29}{:>11.3f} ms{:>11.3f} ms of CPU{:>7.0f} MiB at most so far", what,
                       1000 * seconds.passed, 1000 * seconds.of_all_threads, megabytes_so_far());
            for (const auto& [name, value] : facts.items()) fmt::print("  {} {}", name, value.dump());
            fmt::print("\n");
        }
        std::fflush(stdout);
    }

    template <class Build>
    apps::Tree add_tree(const char* what, Build&& build) {
        apps::Tree tree;
        const Seconds seconds = seconds_of([&] { tree = build(); });
        std::uint32_t most = 0;
        for (const apps::Node& node : tree.nodes) most = std::max(most, node.count);
        add(what, seconds,
            {{"nodes", tree.nodes.size()}, {"leaves", tree.leaf_count()}, {"most_in_a_node", most}});
        return tree;
    }

  private:
    bool is_json_;
};

void add_refits(Report& report, apps::Scene& scene, apps::Tree& tree, const Options& options) {
    constexpr int kFrames = 20;
    const apps::Motion motion(scene, options.moving, options.seed);
    apps::Refitter refitter(tree, scene.objects.size());
    Seconds placing;
    Seconds few;
    Seconds all;
    for (int frame = 1; frame <= kFrames; ++frame) {
        placing += seconds_of([&] { motion.place(scene, frame); });
        few += seconds_of([&] { refitter.refit(tree, scene, motion.moving()); });
        all += seconds_of([&] { refit(tree, scene); });
    }
    const Json moving{{"moving", motion.moving().size()}};
    report.add("placing, a frame", placing / kFrames, moving);
    report.add("refit of what moved, a frame", few / kFrames, moving);
    report.add("refit of everything, a frame", all / kFrames, {{"nodes", tree.nodes.size()}});
}

void add_soup(Report& report, const apps::Scene& scene, const Options& options) {
    std::vector<apps::SoupTriangle> soup;
    const Seconds flattening = seconds_of([&] { soup = flattened(scene); });
    report.add("triangle soup", flattening, {{"triangles", soup.size()}});
    report.add_tree("BVH of the soup",
                    [&] { return apps::build_bvh(soup, {.leaf_triangles = options.leaf_triangles}); });
}

void run(const Options& options) {
    Report report(options.json);
    const apps::SceneRecipe* recipe = apps::find_scene(options.scene);
    if (!recipe && !std::filesystem::is_regular_file(options.scene))
        throw std::runtime_error(fmt::format(
            "--scene is a scene of walkthrough --list or a model file, not \"{}\"", options.scene));
    if (recipe && !(options.scale >= recipe->smallest_scale && options.scale <= recipe->largest_scale))
        throw std::runtime_error(fmt::format("--scale of {} is from {} to {}, not {}", recipe->name,
                                             recipe->smallest_scale, recipe->largest_scale, options.scale));
    apps::Scene scene;
    const Seconds building = seconds_of([&] {
        scene = recipe ? recipe->build(options.scale, options.seed) : apps::load_model(options.scene);
    });
    report.add("scene", building,
               {{"triangles", scene.triangle_count()},
                {"stored_triangles", scene.indices.size() / 3},
                {"objects", scene.objects.size()}});

    const std::size_t leaves =
        recipe ? leaf_count(*recipe, scene) : 1 + scene.triangle_count() / options.leaf_triangles;
    report.add_tree("kD-tree of objects", [&] { return apps::build_kd_tree(scene, leaves); });
    apps::Tree tree =
        report.add_tree("BVH of objects", [&] { return apps::build_bvh(scene, {.leaves = leaves}); });
    report.add_tree("BVH of objects, small leaves",
                    [&] { return apps::build_bvh(scene, {.leaf_triangles = options.leaf_triangles}); });
    if (options.soup) add_soup(report, scene, options);
    if (options.moving > 0) add_refits(report, scene, tree, options);
}

}  // namespace

int main(int argc, char** argv) {
    Options options;
    CLI::App app("Builds the hierarchies of a scene and prints what that takes.", "hierarchy_times");
    app.add_option("--scene", options.scene, "a scene of walkthrough --list, or a model file")
        ->capture_default_str();
    app.add_option("--scale", options.scale, "share of a generated scene's triangles")->capture_default_str();
    app.add_option("--seed", options.seed, "of a generated scene, and of what moves")->capture_default_str();
    app.add_option("--leaf-triangles", options.leaf_triangles, "most in a leaf")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    app.add_option("--moving", options.moving, "share of the small objects that move")
        ->check(CLI::Range(0.0, 1.0))
        ->capture_default_str();
    app.add_flag("--soup", options.soup,
                 "also flatten the scene: a tree over its triangles, not its objects");
    app.add_flag("--json", options.json, "print a JSON object a line");
    try {
        app.parse(argc, argv);
        run(options);
    } catch (const CLI::CallForHelp&) {
        fmt::print("{}", app.help());
    } catch (const std::exception& error) {
        fmt::print(stderr, "hierarchy_times: {}\n", error.what());
        return 2;
    }
    return 0;
}
