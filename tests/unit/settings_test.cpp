// SPDX-License-Identifier: MIT
#include "context/settings.h"

#include <gtest/gtest.h>

namespace glext_emu {
namespace {

using occlusion_unit::ClockKind;

TEST(Settings, unset_means_that_the_layer_steps_aside) {
    for (const char* text :
         {static_cast<const char*>(nullptr), "", "device=native", "device=native,clock=none"}) {
        const SettingsOrError result = parse_settings(text);
        EXPECT_EQ(result.error, "");
        EXPECT_TRUE(result.settings.steps_aside());
    }
}

TEST(Settings, zero_switches_all_off) {
    EXPECT_TRUE(parse_settings("0").settings.off);
    EXPECT_TRUE(parse_settings("0").settings.steps_aside());
}

TEST(Settings, a_device_a_clock_or_a_report_keeps_the_layer_in) {
    for (const char* text : {"device=mesa", "clock=wall=5", "clock=calls=0", "report=/tmp/r.json"}) {
        const SettingsOrError result = parse_settings(text);
        EXPECT_EQ(result.error, "");
        EXPECT_FALSE(result.settings.steps_aside()) << text;
    }
}

TEST(Settings, all_keys_are_read) {
    const SettingsOrError result = parse_settings("device=visualize-fx,clock=frames=2,report=/tmp/a=b.json");
    EXPECT_EQ(result.error, "");
    EXPECT_EQ(result.settings.device.name, "visualize-fx");
    EXPECT_EQ(result.settings.latency.kind, ClockKind::kFrames);
    EXPECT_EQ(result.settings.latency.amount, 2u);
    EXPECT_EQ(result.settings.report_path, "/tmp/a=b.json");
}

TEST(Settings, the_probe_reports_so_it_wants_a_report) {
    const SettingsOrError result = parse_settings("probe=unit,report=/tmp/r.json");
    EXPECT_EQ(result.error, "");
    EXPECT_TRUE(result.settings.probes_unit);
    EXPECT_FALSE(result.settings.steps_aside());
    EXPECT_FALSE(parse_settings("report=/tmp/r.json").settings.probes_unit);
    EXPECT_NE(parse_settings("probe=unit").error.find("wants report=FILE"), std::string::npos);
    EXPECT_NE(parse_settings("probe=hp,report=/tmp/r.json").error.find("is not a probe, expected unit"),
              std::string::npos);
}

TEST(Settings, the_time_of_a_device_is_asked_for_with_its_clock) {
    const std::string device = "device=geforce-fx-5950,";
    const SettingsOrError result = parse_settings(
        (device + "clock=device,timeline=/tmp/t.json,frames=3..5,without=fill+latency,dry=1").c_str());
    EXPECT_EQ(result.error, "");
    EXPECT_EQ(result.settings.latency.kind, ClockKind::kDevice);
    EXPECT_EQ(result.settings.timeline_path, "/tmp/t.json");
    EXPECT_EQ(result.settings.timeline_frames.first, 3u);
    EXPECT_EQ(result.settings.timeline_frames.last, 5u);
    EXPECT_TRUE(result.settings.is_dry);
    for (std::size_t i = 0; i < occlusion_unit::kEffectCount; ++i) {
        const std::string_view name = occlusion_unit::kEffectNames[i];
        EXPECT_EQ(result.settings.effects[i], name != "fill" && name != "latency") << name;
    }
    const auto frames = [&](const char* range) {
        return parse_settings((device + "clock=device,timeline=/tmp/t.json,frames=" + range).c_str());
    };
    EXPECT_EQ(frames("7").settings.timeline_frames.last, 7u);
    EXPECT_EQ(frames("7..").settings.timeline_frames.last, ~std::uint64_t{0});
    for (const char* range : {"", "..", "5..3", "-1", "1..x", "1...2"})
        EXPECT_NE(frames(range).error.find("is not a range of frames"), std::string::npos) << range;
}

TEST(Settings, what_is_about_time_wants_a_device_that_has_one) {
    EXPECT_NE(parse_settings("device=mesa,clock=device").error.find("`mesa` has no [time]"),
              std::string::npos);
    EXPECT_NE(parse_settings("timeline=/tmp/t.json").error.find("wants the clock `device`"),
              std::string::npos);
    EXPECT_NE(parse_settings("device=geforce-fx-5950,dry=1").error.find("wants the clock `device`"),
              std::string::npos);
    EXPECT_NE(parse_settings("device=geforce-fx-5950,clock=device,frames=1..2")
                  .error.find("there has to be a file"),
              std::string::npos);
    EXPECT_NE(parse_settings("without=fil").error.find("is not a list of effects"), std::string::npos);
    EXPECT_NE(parse_settings("dry=2").error.find("is not a choice for dry="), std::string::npos);
}

TEST(Settings, what_is_wrong_is_told_in_one_sentence) {
    EXPECT_NE(parse_settings("clock=soon").error.find("is not a clock, expected none"), std::string::npos);
    EXPECT_NE(parse_settings("dveice=mesa").error.find("is not a setting, expected device="),
              std::string::npos);
    EXPECT_NE(parse_settings("mesa").error.find("is not a setting"), std::string::npos);
    EXPECT_NE(parse_settings("device=voodoo").error.find("no device `voodoo`"), std::string::npos);
}

}  // namespace
}  // namespace glext_emu
