// SPDX-License-Identifier: MIT
// The papers' times out of the shipped devices: how far the timeline, with what a device's file says and with
// what a paper counts, is from what the paper measured. Each test prints its table; docs/timing.md shows them
// and says how many numbers were fitted.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "chc_paper.h"
#include "context/device.h"
#include "log_paper.h"

namespace papers {
namespace {

using occlusion_unit::all_effects;
using occlusion_unit::Effect;
using occlusion_unit::Effects;
using occlusion_unit::Profile;

Profile profile_of(std::string_view name) {
    const glext_emu::DeviceOrError result = glext_emu::load_device(name);
    EXPECT_TRUE(result.device && result.device->time) << name << ": " << result.error;
    return result.device && result.device->time ? result.device->time->profile : Profile{};
}

Effects without(Effect effect) {
    return all_effects().reset(static_cast<std::size_t>(effect));
}

std::string_view name_of(Effect effect) {
    return occlusion_unit::kEffectNames[static_cast<std::size_t>(effect)];
}

// Relative errors.
class Errors {
  public:
    double add(double paper, double ours) {
        errors_.push_back(ours / paper - 1);
        return errors_.back();
    }
    std::size_t count() const { return errors_.size(); }
    double rms() const {
        double sum = 0;
        for (const double error : errors_) sum += error * error;
        return std::sqrt(sum / static_cast<double>(errors_.size()));
    }
    double worst() const {
        double worst = 0;
        for (const double error : errors_) worst = std::max(worst, std::abs(error));
        return worst;
    }
    void print(const std::string& of) const {
        std::printf("| %s: %zu values | | | rms %.1f %%, worst %.1f %% |\n", of.c_str(), count(), 100 * rms(),
                    100 * worst());
    }

  private:
    std::vector<double> errors_;
};

void print_head() {
    std::printf("| | paper ms | ours ms | error |\n|---|---|---|---|\n");
}

void print_row(std::string_view scene, std::string_view what, double paper, double ours) {
    std::printf("| %.*s %.*s | %.2f | %.2f | %+.1f %% |\n", static_cast<int>(scene.size()), scene.data(),
                static_cast<int>(what.size()), what.data(), paper, ours, 100 * (ours / paper - 1));
}

constexpr std::string_view kLogNames[] = {"LOG", "BOG", "HZB", "PQ", "no culling"};

Errors log_errors(const Profile& profile, Effects effects, bool prints) {
    Errors errors;
    for (const LogRow& row : log_table()) {
        const double ours = log_frame_ms(profile, effects, row);
        errors.add(row.milliseconds, ours);
        const std::string scene = std::string(row.scene.name) + " " + std::to_string(row.scene.width);
        if (prints) print_row(scene, kLogNames[static_cast<std::size_t>(row.method)], row.milliseconds, ours);
    }
    return errors;
}

TEST(PaperTimes, the_20_rows_of_the_lazy_occlusion_grid_come_out_of_the_geforce2) {
    print_head();
    const Errors errors = log_errors(profile_of("geforce2-gts"), all_effects(), true);
    errors.print("LOG");
    EXPECT_EQ(errors.count(), 20u);
    EXPECT_LE(errors.rms(), 0.035);
    EXPECT_LE(errors.worst(), 0.095);
}

TEST(PaperTimes, the_lazy_occlusion_grid_is_missed_without_each_effect_that_it_calls_for) {
    const Profile profile = profile_of("geforce2-gts");
    for (const Effect effect : {Effect::kReadCost, Effect::kFill, Effect::kStarvation}) {
        const Errors errors = log_errors(profile, without(effect), false);
        errors.print("LOG without " + std::string(name_of(effect)));
        EXPECT_GT(errors.rms(), 0.05);
    }
    // These it does not call for: it asks no query, and what it draws is in video memory.
    for (const Effect effect : {Effect::kLatency, Effect::kDriverCopy, Effect::kMultisampling})
        EXPECT_LE(log_errors(profile, without(effect), false).rms(), 0.035) << name_of(effect);
}

// The paper's own figure, without flushing the pipeline.
TEST(PaperTimes, the_geforce2_reads_34783_tiles_a_second) {
    occlusion_unit::Timeline timeline(profile_of("geforce2-gts"));
    for (int tile = 0; tile < 34'783; ++tile) timeline.read(32 * 32);
    EXPECT_NEAR(static_cast<double>(timeline.cpu()), 1e12, 1e12 * 0.001);
}

constexpr std::pair<ChcMethod, std::string_view> kFittedMethods[] = {{ChcMethod::kFrustum, "VFC"},
                                                                     {ChcMethod::kStopAndWait, "S&W"},
                                                                     {ChcMethod::kCoherent, "CHC"},
                                                                     {ChcMethod::kIdeal, "ideal"}};

Errors chc_errors(const Profile& profile, Effects effects, bool prints,
                  std::span<const ChcScene> scenes = chc_table()) {
    Errors errors;
    for (const ChcScene& scene : scenes) {
        for (const auto& [method, name] : kFittedMethods) {
            const ChcTimes paper = paper_times(scene, method);
            const ChcTimes ours = chc_times(profile, effects, scene, method);
            errors.add(paper.frame_ms, ours.frame_ms);
            if (prints) print_row(scene.name, name, paper.frame_ms, ours.frame_ms);
            if (method != ChcMethod::kStopAndWait) continue;
            errors.add(paper.wait_ms, ours.wait_ms);
            if (prints) print_row(scene.name, "S&W's wait", paper.wait_ms, ours.wait_ms);
        }
    }
    return errors;
}

TEST(PaperTimes, the_15_values_of_coherent_hierarchical_culling_come_out_of_the_geforce_fx) {
    print_head();
    const Errors errors = chc_errors(profile_of("geforce-fx-5950"), all_effects(), true);
    errors.print("CHC");
    EXPECT_EQ(errors.count(), 15u);
    EXPECT_LE(errors.rms(), 0.03);
    EXPECT_LE(errors.worst(), 0.072);
}

TEST(PaperTimes, coherent_hierarchical_culling_is_missed_without_each_effect_that_it_calls_for) {
    const Profile profile = profile_of("geforce-fx-5950");
    for (const Effect effect : {Effect::kLatency, Effect::kDriverCopy, Effect::kFill, Effect::kStarvation}) {
        const Errors errors = chc_errors(profile, without(effect), false);
        errors.print("CHC without " + std::string(name_of(effect)));
        EXPECT_GT(errors.rms(), 0.05);
    }
    // These it does not call for.
    for (const Effect effect : {Effect::kMultisampling, Effect::kReadCost})
        EXPECT_LE(chc_errors(profile, without(effect), false).rms(), 0.03) << name_of(effect);
}

TEST(PaperTimes, stop_and_wait_waits_far_less_when_results_have_no_latency) {
    const Profile profile = profile_of("geforce-fx-5950");
    for (const ChcScene& scene : chc_table()) {
        const ChcTimes ours = chc_times(profile, without(Effect::kLatency), scene, ChcMethod::kStopAndWait);
        EXPECT_LT(ours.wait_ms, 0.9 * scene.waiting.wait_ms) << scene.name;
    }
}

// The boxes' sizes, which the paper does not tell, make up for another latency, until those of the teapots
// are nothing.
TEST(PaperTimes, a_latency_of_2_to_6_us_comes_out_alike_and_one_of_7_does_not) {
    struct Guess {
        double latency_us;
        double boxes[3];  // those that fit best
        bool is_good;
    };
    constexpr Guess kGuesses[] = {{2, {8'200, 44'300, 115'000}, true},
                                  {4, {4'000, 36'700, 107'000}, true},
                                  {6, {0, 29'100, 100'000}, true},
                                  {7, {0, 25'500, 96'000}, false}};
    for (const Guess& guess : kGuesses) {
        Profile profile = profile_of("geforce-fx-5950");
        profile.result_latency = std::llround(guess.latency_us * 1e6);
        std::vector<ChcScene> scenes(chc_table().begin(), chc_table().end());
        for (std::size_t i = 0; i < scenes.size(); ++i) scenes[i].mean_box = guess.boxes[i];
        const Errors errors = chc_errors(profile, all_effects(), false, scenes);
        errors.print("CHC with " + std::to_string(std::llround(guess.latency_us)) + " us");
        EXPECT_EQ(errors.rms() < 0.032, guess.is_good) << guess.latency_us;
    }
}

// Of CHC's waits that of the teapots gave the FIFO its length; those of city and plant, and table 2, were
// never fitted. With t_av = 2 the city alone can be held against the paper: the teapots draw more than is
// known there, and the plant takes less than "ideal".
TEST(PaperTimes, what_was_not_fitted_is_told) {
    const Profile profile = profile_of("geforce-fx-5950");
    print_head();
    for (const ChcScene& scene : chc_table()) {
        const ChcTimes coherent = chc_times(profile, all_effects(), scene, ChcMethod::kCoherent);
        const ChcTimes sparse = chc_times(profile, all_effects(), scene, ChcMethod::kSparse);
        print_row(scene.name, "CHC's wait", scene.coherent.wait_ms, coherent.wait_ms);
        print_row(scene.name, "CHC, t_av = 2", scene.sparse.frame_ms, sparse.frame_ms);
        if (scene.name == "city") {
            EXPECT_NEAR(sparse.frame_ms, scene.sparse.frame_ms, 0.05 * scene.sparse.frame_ms);
        }
        if (scene.name == "teapots") {
            EXPECT_NEAR(coherent.wait_ms, scene.coherent.wait_ms, 0.05 * scene.coherent.wait_ms);
        } else {
            EXPECT_LT(coherent.wait_ms, scene.coherent.wait_ms) << "the traversal here has no pull-downs";
        }
    }
}

TEST(PaperTimes, without_back_pressure_coherent_culling_waits_for_all_that_was_drawn) {
    const ChcScene& teapots = chc_table()[0];
    const ChcTimes ours = chc_times(profile_of("geforce-fx-5950"), without(Effect::kBackPressure), teapots,
                                    ChcMethod::kCoherent);
    EXPECT_GT(ours.wait_ms, 10 * teapots.coherent.wait_ms);
    EXPECT_NEAR(ours.frame_ms, teapots.coherent.frame_ms, 0.05 * teapots.coherent.frame_ms);
}

}  // namespace
}  // namespace papers
