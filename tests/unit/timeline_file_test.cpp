// SPDX-License-Identifier: MIT
// The timeline's file, fed by a timeline without GL: what its lanes hold, and that nothing spoils it.
#include "context/timeline_file.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "figure_one.h"

namespace glext_emu {
namespace {

using nlohmann::json;
using occlusion_unit::Picoseconds;
using occlusion_unit::Timeline;
using occlusion_unit::TimeSums;

class TimelineFiles : public testing::Test {
  protected:
    TimelineFiles() {
        char folder[] = "/tmp/timeline_file_XXXXXX";
        folder_ = mkdtemp(folder);
    }
    ~TimelineFiles() override { std::filesystem::remove_all(folder_); }

    std::string path(const char* name = "timeline.json") const { return folder_ / name; }

    std::vector<json> events() const {
        std::ifstream stream(path());
        return json::parse(stream).at("traceEvents");
    }

    // Slices of a lane; of one name, if there is one.
    std::vector<json> slices(std::string_view category, std::string_view name = "") const {
        std::vector<json> found;
        for (const json& event : events()) {
            const bool is_it = event["ph"] == "X" && event["cat"] == category;
            if (is_it && (name.empty() || event["name"] == name)) found.push_back(event);
        }
        return found;
    }

    std::filesystem::path folder_;
};

Picoseconds sum_ps(const std::vector<json>& slices) {
    Picoseconds sum = 0;
    for (const json& slice : slices) sum += slice["args"]["ps"].get<Picoseconds>();
    return sum;
}

// As viewers do.
std::int64_t nanoseconds(const json& microseconds) {
    return std::llround(microseconds.get<double>() * 1000);
}

template <typename Feed>
void feed(const std::string& path, FrameRange frames, Feed feed) {
    SharedJsonFile file(path, kTimelineKind);
    TimelineFile lanes(file, 1, frames, "machine");
    Timeline timeline(figure_one_machine(), occlusion_unit::all_effects(), &lanes);
    feed(timeline);
}

TEST_F(TimelineFiles, the_slices_of_stop_and_wait_are_those_of_its_sums) {
    TimeSums sums;
    feed(path(), {}, [&](Timeline& timeline) { sums = stop_and_wait(timeline); });
    EXPECT_EQ(slices("cpu", "stall").size(), 7U);
    EXPECT_EQ(sum_ps(slices("cpu", "stall")), sums.stall);
    EXPECT_EQ(sum_ps(slices("cpu", "drain")), sums.drain);
    EXPECT_EQ(sum_ps(slices("gpu", "starvation")), sums.starvation);
    EXPECT_EQ(sum_ps(slices("cpu")), sums.cpu);
    EXPECT_EQ(sum_ps(slices("gpu")), sums.gpu_busy + sums.starvation);
    const std::vector<json> frames = slices("frame");
    ASSERT_EQ(frames.size(), 1U);
    EXPECT_EQ(frames[0]["args"]["ps"], sums.cpu);
    EXPECT_EQ(frames[0]["args"]["is_whole"], true);
    EXPECT_DOUBLE_EQ(frames[0]["args"]["stall_ms"].get<double>(), static_cast<double>(sums.stall) / 1e9);
}

TEST_F(TimelineFiles, the_better_order_has_less_of_both_kinds_of_waiting) {
    TimeSums first;
    TimeSums second;
    feed(path(), {}, [&](Timeline& timeline) { first = stop_and_wait(timeline); });
    const Picoseconds first_stalls = sum_ps(slices("cpu", "stall"));
    std::filesystem::remove(path());
    feed(path(), {}, [&](Timeline& timeline) { second = better_order(timeline); });
    EXPECT_LT(sum_ps(slices("cpu", "stall")) * 2, first_stalls);
    EXPECT_LT(second.starvation * 2, first.starvation);
    EXPECT_EQ(slices("gpu").size() - slices("gpu", "starvation").size(), 13U) << "7 queries, 6 objects";
}

// The times are of no whole nanosecond; a viewer drops a slice that begins before the end of another.
TEST_F(TimelineFiles, slices_of_a_lane_meet_to_the_nanosecond) {
    feed(path(), {}, [](Timeline& timeline) {
        for (int frame = 0; frame < 40; ++frame) stop_and_wait(timeline);
    });
    for (const char* lane : {"cpu", "gpu"}) {
        std::int64_t end = 0;
        for (const json& slice : slices(lane)) {
            ASSERT_EQ(nanoseconds(slice["ts"]), end) << slice;
            end = nanoseconds(slice["ts"]) + nanoseconds(slice["dur"]);
        }
        EXPECT_GT(end, 0);
    }
}

TEST_F(TimelineFiles, a_query_is_a_flow_from_its_command_to_its_work_to_its_result) {
    feed(path(), {}, better_order);
    std::map<std::string, std::string> phases;
    std::map<std::string, std::vector<std::int64_t>> times;
    std::size_t ends_of_stalls = 0;
    for (const json& event : events()) {
        const std::string phase = event["ph"];
        if (phase != "s" && phase != "t" && phase != "f") continue;
        phases[event["id"]] += phase;
        times[event["id"]].push_back(nanoseconds(event["ts"]));
        if (phase == "f" && event.contains("bp")) ++ends_of_stalls;
    }
    EXPECT_EQ(phases.size(), 7U);
    for (const auto& [id, phase] : phases) {
        EXPECT_EQ(phase, "stf") << id;
        EXPECT_TRUE(std::ranges::is_sorted(times[id]));
    }
    // The other results were there when they were wanted, and go to what came next.
    EXPECT_EQ(ends_of_stalls, slices("cpu", "stall").size());
    EXPECT_LT(ends_of_stalls, 7U);
}

TEST_F(TimelineFiles, no_flow_goes_back_in_time_where_the_gpu_works_ahead) {
    SharedJsonFile file(path(), kTimelineKind);
    {
        TimelineFile lanes(file, 1, {}, "machine");
        occlusion_unit::Effects effects = occlusion_unit::all_effects();
        effects.reset(static_cast<std::size_t>(occlusion_unit::Effect::kStarvation));
        Timeline timeline(figure_one_machine(), effects, &lanes);
        stop_and_wait(timeline);
    }
    std::map<std::string, std::int64_t> begun;
    int works_ahead = 7;
    for (const json& event : events()) {
        if (event["ph"] == "s") begun[event["id"]] = nanoseconds(event["ts"]);
        if (event["ph"] != "t" && event["ph"] != "f") continue;
        EXPECT_GE(nanoseconds(event["ts"]), begun.at(event["id"]));
        if (event["ph"] == "t") --works_ahead;
    }
    EXPECT_GT(works_ahead, 0);
}

TEST_F(TimelineFiles, a_flow_ends_at_the_poll_that_sees_the_result) {
    feed(path(), {}, [](Timeline& timeline) {
        const auto result = timeline.query({.count = 4000});
        timeline.poll(result.query);
        ASSERT_FALSE(timeline.has_come(result));
        timeline.work(result.available - timeline.cpu());
        timeline.poll(result.query);
        timeline.poll(result.query);
    });
    std::vector<std::int64_t> ends;
    for (const json& event : events())
        if (event["ph"] == "f") ends.push_back(nanoseconds(event["ts"]));
    const std::vector<json> polls = slices("cpu", "poll 1");
    ASSERT_EQ(ends.size(), 1U);
    ASSERT_EQ(polls.size(), 3U);
    EXPECT_GT(ends[0], nanoseconds(polls[1]["ts"]));
    EXPECT_LT(ends[0], nanoseconds(polls[2]["ts"]));
}

TEST_F(TimelineFiles, commands_wait_in_the_fifo_and_a_full_one_presses_back) {
    TimeSums sums;
    feed(path(), {}, [&](Timeline& timeline) {
        for (int i = 0; i < 20; ++i) timeline.draw({.triangles = 2400, .fragments = {}});
        sums = timeline.swap(0);
    });
    std::map<std::string, std::int64_t> begun;
    double fullest_us = 0;
    int waited = 0;
    for (const json& event : events()) {
        if (event["ph"] == "b") begun[event["id"]] = nanoseconds(event["ts"]);
        if (event["ph"] == "e") {
            EXPECT_LE(begun.at(event["id"]), nanoseconds(event["ts"]));
            ++waited;
        }
        if (event["ph"] == "C") fullest_us = std::max(fullest_us, event["args"]["us"].get<double>());
    }
    EXPECT_EQ(static_cast<int>(begun.size()), waited);
    EXPECT_GT(waited, 10);
    EXPECT_GT(sums.back_pressure, 0);
    EXPECT_EQ(sum_ps(slices("cpu", "back-pressure")), sums.back_pressure);
    // What it holds, and the command that came last.
    EXPECT_GT(fullest_us, 60);
    EXPECT_LT(fullest_us, 60 + 1.01 * 2400 * 0.009417477);
}

TEST_F(TimelineFiles, only_the_frames_that_are_asked_for_are_written) {
    feed(path(), {.first = 2, .last = 3}, [](Timeline& timeline) {
        for (int frame = 0; frame < 6; ++frame) stop_and_wait(timeline);
    });
    const std::vector<json> frames = slices("frame");
    ASSERT_EQ(frames.size(), 2U);
    EXPECT_EQ(frames[0]["name"], "frame 2");
    EXPECT_EQ(frames[1]["name"], "frame 3");
    EXPECT_EQ(slices("cpu", "stall").size(), 14U);
    EXPECT_EQ(slices("cpu").front()["ts"], frames[0]["ts"]);
    EXPECT_EQ(slices("cpu", "draw").front()["args"]["draw"], 1) << "the first of its frame";
}

TEST_F(TimelineFiles, a_frame_that_does_not_end_is_told_as_far_as_it_came) {
    feed(path(), {}, [](Timeline& timeline) { timeline.work(5'000'000); });
    ASSERT_EQ(slices("frame").size(), 1U);
    EXPECT_EQ(slices("frame")[0]["args"]["is_whole"], false);
    EXPECT_EQ(slices("frame")[0]["args"]["ps"], 5'000'000);
}

TEST_F(TimelineFiles, the_file_is_whole_while_it_is_written) {
    SharedJsonFile file(path(), kTimelineKind);
    TimelineFile lanes(file, 1, {}, "machine");
    Timeline timeline(figure_one_machine(), occlusion_unit::all_effects(), &lanes);
    std::size_t before = 0;
    for (int i = 0; i < 4; ++i) {
        for (int frame = 0; frame < 6; ++frame) stop_and_wait(timeline);
        const std::size_t now = events().size();
        EXPECT_GT(now, before) << "nothing is kept for long";
        before = now;
    }
}

TEST_F(TimelineFiles, a_child_writes_its_own_lanes_and_nothing_of_its_parent) {
    {
        SharedJsonFile file(path(), kTimelineKind);
        TimelineFile lanes(file, 1, {}, "machine");
        Timeline timeline(figure_one_machine(), occlusion_unit::all_effects(), &lanes);
        const auto result = timeline.query({.count = 4000});
        hold_timeline_files();
        SharedJsonFile::before_fork();
        const pid_t child = fork();
        SharedJsonFile::after_fork(child == 0);
        release_timeline_files();
        timeline.wait(result);
        stop_and_wait(timeline);
        if (child == 0) {
            end_timeline_files();
            _exit(0);
        }
        int status = 1;
        ASSERT_EQ(waitpid(child, &status, 0), child);
        ASSERT_EQ(status, 0);
    }
    std::map<int, std::map<std::string, int>> flows;
    std::map<int, bool> is_whole;
    std::map<int, int> names;
    for (const json& event : events()) {
        const int pid = event["pid"];
        if (event["name"] == "query" && event.contains("id")) ++flows[pid][event["ph"]];
        if (event["name"] == "frame 0") is_whole[pid] = event["args"]["is_whole"];
        if (event["name"] == "process_name") ++names[pid];
    }
    ASSERT_EQ(is_whole.size(), 2U);
    const int parent = getpid();
    for (const auto& [pid, whole] : is_whole) {
        EXPECT_EQ(whole, pid == parent);
        EXPECT_EQ(names[pid], 1);
        EXPECT_EQ(flows[pid]["s"], pid == parent ? 8 : 7);
        EXPECT_EQ(flows[pid]["f"], pid == parent ? 8 : 7);
    }
}

TEST_F(TimelineFiles, two_contexts_share_a_file_and_no_lane) {
    {
        SharedJsonFile file(path(), kTimelineKind);
        TimelineFile lanes[] = {{file, 1, {}, "machine"}, {file, 2, {}, "machine"}};
        for (TimelineFile& of : lanes) {
            Timeline timeline(figure_one_machine(), occlusion_unit::all_effects(), &of);
            stop_and_wait(timeline);
        }
    }
    std::set<json> lanes;
    std::set<json> flows;
    for (const json& slice : slices("cpu")) lanes.insert(slice["tid"]);
    for (const json& event : events())
        if (event["ph"] == "s") flows.insert(event["id"]);
    EXPECT_EQ(lanes.size(), 2U);
    EXPECT_EQ(flows.size(), 14U);
}

TEST_F(TimelineFiles, a_file_of_another_kind_is_left_alone_and_told) {
    // A trace of somebody else's begins like ours.
    const std::string precious = "{\"traceEvents\":[\n]}\n";
    std::ofstream(path()) << precious;
    testing::internal::CaptureStderr();
    feed(path(), {}, [](Timeline& timeline) {
        for (int frame = 0; frame < 3; ++frame) stop_and_wait(timeline);
    });
    EXPECT_EQ(testing::internal::GetCapturedStderr(),
              "glext_emu: the timeline " + path() + " is not a timeline, so nothing is written to it.\n");
    std::ifstream stream(path());
    EXPECT_EQ(std::string(std::istreambuf_iterator<char>(stream), {}), precious);
}

TEST_F(TimelineFiles, a_file_that_cannot_be_opened_is_told_once_and_the_time_goes_on) {
    testing::internal::CaptureStderr();
    TimeSums sums;
    feed(path("no/such/folder.json"), {}, [&](Timeline& timeline) {
        for (int frame = 0; frame < 3; ++frame) sums = stop_and_wait(timeline);
    });
    EXPECT_GT(sums.stall, 0);
    const std::string told = testing::internal::GetCapturedStderr();
    EXPECT_EQ(told, "glext_emu: the timeline " + path("no/such/folder.json") + " cannot be opened.\n");
}

}  // namespace
}  // namespace glext_emu
