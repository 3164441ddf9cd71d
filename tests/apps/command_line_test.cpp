// SPDX-License-Identifier: MIT
// walkthrough as a program: its exit status, its one sentence on bad use, and the report that other programs
// read.
#include <dlfcn.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

struct Result {
    int status;
    std::string output;  // both streams
};

// `variables` as a shell sets them before a command.
Result run(const std::string& arguments, const std::string& variables = "") {
    FILE* pipe = popen((variables + " " WALKTHROUGH " " + arguments + " 2>&1").c_str(), "r");
    Result result{};
    std::array<char, 4096> part{};
    while (const std::size_t read = std::fread(part.data(), 1, part.size(), pipe))
        result.output.append(part.data(), read);
    result.status = WEXITSTATUS(pclose(pipe));
    return result;
}

struct Walkthrough : testing::Test {
    Walkthrough() { fs::create_directories(folder); }
    ~Walkthrough() override { fs::remove_all(folder); }

    std::vector<Json> lines(const fs::path& file) const {
        std::vector<Json> all;
        std::ifstream in(file);
        for (std::string line; std::getline(in, line);) all.push_back(Json::parse(line));
        return all;
    }

    fs::path folder = fs::temp_directory_path() / ("walkthrough_test_" + std::to_string(getpid()));
};

TEST_F(Walkthrough, answers_bad_use_with_one_sentence_and_status_two) {
    std::ofstream(folder / "no_report") << "hello\n";
    std::ofstream(folder / "short_report") << R"({"frame": 0, "frame_ms": 1.5})" << '\n';
    const std::pair<std::string, std::string> uses[] = {
        {"--culler fast", "fast"},
        {"--scene atlantis", "atlantis"},
        {"--size 640", "640"},
        {"--size 0x480", "0x480"},
        {"--frames 0", "0"},
        {"--frames many", "many"},
        {"--scale 0", "0"},
        {"--scale nan", "nan"},
        {"--platform web", "web"},
        {"--moving 1.5", "1.5"},
        {"--split object", "model"},
        {"--moving nan", "nan"},
        {"--moving 0.1 --tree kd", "bvh"},
        {"--work-us -1", "-1"},
        {"--work-us nan", "nan"},
        {"--set proxy_growth=0", "0"},
        {"--set proxy_growth", "proxy_growth"},
        {"--set speed=3", "speed"},
        {"--culler none --set proxy_growth=1", "none"},
        {"--image-frame 120", "120"},
        {"--label word", "word"},
        {"--oracle-cache file", "--oracle"},
        {"--nonsense", "--nonsense"},
        {"--baseline /nowhere", "/nowhere"},
        {"--frames 2 --baseline " + (folder / "no_report").string(), "no_report"},
        {"--frames 2 --baseline " + (folder / "short_report").string(), "1"},
        {"--scale 0.01 --frames 1 --json /nowhere/report", "/nowhere/report"}};
    for (const auto& [arguments, culprit] : uses) {
        const Result result = run(arguments);
        EXPECT_EQ(result.status, 2) << arguments;
        EXPECT_EQ(std::count(result.output.begin(), result.output.end(), '\n'), 1)
            << arguments << ": " << result.output;
        EXPECT_TRUE(result.output.starts_with("walkthrough: ")) << result.output;
        EXPECT_NE(result.output.find(culprit), std::string::npos) << result.output;
    }
}

TEST_F(Walkthrough, reports_a_line_a_frame_and_their_means) {
    const fs::path report = folder / "report";
    const std::string common = "--scale 0.02 --frames 3 --size 160x120 --json " + report.string();
    ASSERT_EQ(
        run(common + " --oracle --label clock=wall=5 --oracle-cache " + (folder / "truth").string()).status,
        0);
    const std::vector<Json> all = lines(report);
    ASSERT_EQ(all.size(), 4U);
    const std::vector<std::string> fields = {
        "frame",           "swap",         "drawn_triangles", "drawn_objects",   "frustum_triangles",
        "queries",         "query_boxes",  "polls",           "results_waited",  "pixels_read",
        "region_waits",    "tiles_tested", "stall_ms",        "frame_ms",        "device_ms",
        "visible_objects", "false_culls",  "wrong_pixels",    "contested_pixels"};
    const Json& summary = all.back().at("summary");
    for (std::size_t frame = 0; frame < 3; ++frame) {
        EXPECT_EQ(all[frame].size(), fields.size());
        for (const std::string& field : fields) EXPECT_TRUE(all[frame].contains(field)) << field;
        EXPECT_EQ(all[frame]["frame"], frame);
        EXPECT_LE(all[frame]["stall_ms"], all[frame]["frame_ms"]);
        EXPECT_LE(all[frame]["drawn_triangles"], all[frame]["frustum_triangles"]);
        EXPECT_GE(all[frame]["drawn_objects"], all[frame]["visible_objects"]);
        EXPECT_TRUE(all[frame]["device_ms"].is_null());
    }
    const auto queries = [&](std::size_t frame) { return all[frame]["queries"].get<double>(); };
    EXPECT_DOUBLE_EQ(summary["queries"].get<double>(), (queries(0) + queries(1) + queries(2)) / 3);
    EXPECT_EQ(summary["clock"], "wall=5");
    for (const char* fact : {"scene", "culler", "device", "size", "scale", "seed", "mesa", "cpu", "frames"})
        EXPECT_TRUE(summary.contains(fact)) << fact;
    EXPECT_TRUE(summary["device_ms"].is_null());

    // The cached truth gives the same verdicts, and a run is as fast as itself on average.
    ASSERT_EQ(
        run("--oracle --oracle-cache " + (folder / "truth").string() + " --baseline " + report.string() +
            " --scale 0.02 --frames 3 --size 160x120 --json " + (folder / "again").string())
            .status,
        0);
    const std::vector<Json> again = lines(folder / "again");
    for (std::size_t frame = 0; frame < 3; ++frame)
        for (const char* field : {"drawn_triangles", "queries", "visible_objects", "false_culls",
                                  "wrong_pixels", "contested_pixels"})
            EXPECT_EQ(again[frame][field], all[frame][field]) << field;
    EXPECT_GT(again.back()["summary"]["speedup_mean_of_ratios"], 0.0);
    EXPECT_GT(again.back()["summary"]["speedup_ratio_of_means"], 0.0);
}

TEST_F(Walkthrough, walks_around_a_model_of_ones_own) {
    std::ofstream model(folder / "steps.obj");
    for (int step = 0; step < 100; ++step)  // a stair of quads, y up
        for (const char* corner : {"0 0", "1 0", "1 1", "0 1"})
            model << "v " << corner << ' ' << step << '\n';
    for (int step = 0; step < 100; ++step)
        model << "f " << 4 * step + 1 << ' ' << 4 * step + 2 << ' ' << 4 * step + 3 << ' ' << 4 * step + 4
              << '\n';
    model.close();
    const fs::path report = folder / "report";
    const std::string common = " --frames 4 --size 64x48 --oracle --json " + report.string();
    ASSERT_EQ(run("--scene " + (folder / "steps.obj").string() + common).status, 0);
    const Json summary = lines(report).back()["summary"];
    EXPECT_EQ(summary["scene_triangles"], 200);
    EXPECT_GT(summary["visible_objects"], 0);
    std::ofstream(folder / "not_a_model.obj") << "hello\n";
    EXPECT_EQ(run("--scene " + (folder / "not_a_model.obj").string() + common).status, 2);
}

TEST_F(Walkthrough, walks_the_same_way_in_memory_by_osmesa) {
    const auto seen_on = [&](const std::string& platform) {
        const fs::path report = folder / platform;
        const Result result = run("--scale 0.02 --frames 2 --size 160x120 --oracle --platform " + platform +
                                  " --json " + report.string());
        EXPECT_EQ(result.status, 0) << result.output;
        std::vector<Json> seen;
        for (const Json& line : lines(report)) {
            if (!line.contains("frame")) continue;
            EXPECT_GT(line["queries"], 0);
            EXPECT_GT(line["visible_objects"], 0);
            for (const char* field : {"drawn_triangles", "queries", "visible_objects", "wrong_pixels"})
                seen.push_back(line[field]);
        }
        return seen;
    };
    void* const library = dlopen("libOSMesa.so.8", RTLD_NOW);
    if (library == nullptr) GTEST_SKIP() << "no libOSMesa here";
    EXPECT_EQ(seen_on("osmesa"), seen_on("egl"));
}

TEST_F(Walkthrough, says_so_where_there_is_no_osmesa) {
    std::ofstream(folder / "libOSMesa.so.8") << "no library";
    const Result result = run("--platform osmesa --scale 0.02", "LD_LIBRARY_PATH=" + folder.string());
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(std::count(result.output.begin(), result.output.end(), '\n'), 1) << result.output;
    EXPECT_NE(result.output.find("libOSMesa.so.8"), std::string::npos) << result.output;
}

TEST_F(Walkthrough, ignores_a_damaged_cache) {
    std::ofstream(folder / "truth") << R"({"key": 5, "truths": "none"})";
    EXPECT_EQ(
        run("--scale 0.01 --frames 1 --size 64x48 --oracle --oracle-cache " + (folder / "truth").string())
            .status,
        0);
}

TEST_F(Walkthrough, writes_three_pictures_of_the_size_of_its_view) {
    ASSERT_EQ(run("--scale 0.02 --frames 2 --size 96x64 --image-frame 1 --images " +
                  (folder / "new" / "folder").string())
                  .status,
              0);
    for (const char* name : {"view.png", "above.png", "nodes.png"}) {
        std::ifstream in(folder / "new" / "folder" / name, std::ios::binary);
        std::array<unsigned char, 24> head{};
        in.read(reinterpret_cast<char*>(head.data()), head.size());
        // PNG: eight bytes of signature, then IHDR with width and height as 32 bit big-endian from byte 16.
        EXPECT_EQ(std::string(head.begin() + 1, head.begin() + 4), "PNG") << name;
        EXPECT_EQ(head[19], 96) << name;
        EXPECT_EQ(head[23], 64) << name;
    }
}

TEST_F(Walkthrough, lists_its_scenes_and_cullers_as_json) {
    const Result result = run("--list");
    ASSERT_EQ(result.status, 0);
    const Json list = Json::parse(result.output);
    std::map<std::string, int> triangles;
    for (const Json& scene : list["scenes"]) {
        triangles[scene["name"]] = scene["triangles"];
        EXPECT_GT(scene["objects"], 1'000);
    }
    // Tables of the papers.
    EXPECT_EQ(triangles, (std::map<std::string, int>{{"log-forest", 1'694'426},
                                                     {"log-city", 34'034'176},
                                                     {"chc-teapots", 11'520'000},
                                                     {"chc-city", 1'036'146},
                                                     {"chc-plant", 12'748'510}}));
    std::vector<std::string> names;
    for (const Json& culler : list["cullers"]) {
        names.push_back(culler["name"]);
        EXPECT_TRUE(culler["conservative"].is_boolean() && culler["needs"].is_array());
        for (const Json& knob : culler["knobs"])
            EXPECT_TRUE(knob["range"][0] <= knob["default"] && knob["default"] <= knob["range"][1]);
    }
    const std::vector<std::string> known = {
        "none",      "frustum",  "stop-and-wait", "ideal", "chc", "chc++", "conditional",
        "log-state", "log-zfar", "log-coherent",  "bog",   "hzb", "pq"};
    EXPECT_EQ(names, known);
    std::set<std::string> counts;
    for (const Json& statistic : list["statistics"]) {
        EXPECT_FALSE(std::string(statistic["meaning"]).empty());
        EXPECT_TRUE(counts.insert(statistic["name"]).second) << "two statistics of one name";
    }
    EXPECT_TRUE(counts.contains("tiles_tested") && counts.contains("pull_ups"));
}

}  // namespace
