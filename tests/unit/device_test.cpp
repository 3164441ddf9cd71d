// SPDX-License-Identifier: MIT
#include "context/device.h"

#include <gtest/gtest.h>

#include <random>

namespace glext_emu {
namespace {

constexpr std::string_view kGood =
    "name = \"mine\"\n"
    "description = \"a machine\"\n"
    "source = \"a book\"\n"
    "year = 2001\n"
    "gl_version = \"1.3\"\n"
    "[extensions]\n"
    "emulate = [\"GL_HP_occlusion_test\"]\n"
    "hide = [\"GL_ARB_occlusion_query\"]\n"
    "[query]\n"
    "counter_bits = 24\n"
    "[unit]\n"
    "counter_bits = 32\n"
    "max_shapes = 100\n"
    "pipes = 4\n"
    "coordinate_bits = 12\n"
    "depth_bits = 16\n"
    "report_queue = 8\n"
    "[region]\n"
    "max_regions = 1\n"
    "depth_bits = 16\n"
    "[time]\n"
    "source = \"a data sheet\"\n"
    "quality = \"assumed\"\n"
    "batch_us = 17\n"
    "triangles_per_second = 40e6\n"
    "copied_triangle_ns = 79.5\n"
    "video_memory_mb = 2\n"
    "poll_us = 0.25\n";

std::string replaced(std::string_view from, std::string_view to) {
    std::string text(kGood);
    const auto at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
}

TEST(Device, a_good_file_is_read_whole) {
    const DeviceOrError result = parse_device(kGood, "mine.toml");
    ASSERT_TRUE(result.device) << result.error;
    EXPECT_EQ(result.device->name, "mine");
    EXPECT_EQ(result.device->year, 2001);
    EXPECT_EQ(*result.device->gl_version, (GlVersion{1, 3}));
    EXPECT_TRUE(result.device->emulates("GL_HP_occlusion_test"));
    EXPECT_TRUE(result.device->hides("GL_ARB_occlusion_query"));
    EXPECT_FALSE(result.device->hides("GL_ARB_occlusion_query2"));
    EXPECT_EQ(result.device->counter_bits, 24);
    EXPECT_EQ(result.device->unit_counter_bits, 32);
    EXPECT_EQ(result.device->unit_max_shapes, 100);
    EXPECT_EQ(result.device->unit_pipes, 4);
    EXPECT_EQ(result.device->unit_coordinate_bits, 12);
    EXPECT_EQ(result.device->unit_depth_bits, 16);
    EXPECT_EQ(result.device->unit_report_queue, 8);
    EXPECT_EQ(result.device->max_regions, 1);
    EXPECT_EQ(result.device->region_depth_bits, 16);
    ASSERT_TRUE(result.device->time);
    EXPECT_EQ(result.device->time->source, "a data sheet");
    EXPECT_EQ(result.device->time->quality, "assumed");
    const occlusion_unit::Profile& profile = result.device->time->profile;
    EXPECT_EQ(profile.batch, 17'000'000);
    EXPECT_EQ(profile.triangle, 25'000'000);  // femtoseconds
    EXPECT_EQ(profile.copied_triangle, 79'500'000);
    EXPECT_EQ(profile.video_memory, 2 << 20);
    EXPECT_EQ(profile.poll, 250'000);
    EXPECT_EQ(profile.query, 0);
    EXPECT_FALSE(result.device->is_pass_through());
}

// One sentence, with the file, the line and what was expected.
TEST(Device, what_is_wrong_is_told_with_file_and_line) {
    struct Row {
        std::string text;
        std::string begins;
        std::string holds;
    };
    const Row rows[] = {
        {replaced("year = 2001", "yaer = 2001"), "f.toml:4: ", "unknown key `yaer`, expected one of name"},
        {replaced("year = 2001", "year = \"2001\""),
         "f.toml:4: ", "`year` is not a whole number from 1980 to 2100"},
        {replaced("year = 2001", "year = 20010"), "f.toml:4: ", "from 1980 to 2100"},
        {replaced("\"1.3\"", "1.3"), "f.toml:5: ", "`gl_version` is not a string"},
        {replaced("\"1.3\"", "\"7.3\""), "f.toml:5: ", "`gl_version` is not a version"},
        {replaced("name = \"mine\"", ""), "f.toml:1: ", "`name` is missing"},
        {replaced("[\"GL_HP_occlusion_test\"]", "\"GL_HP_occlusion_test\""), "f.toml:7: ", "is not a list"},
        {replaced("GL_HP_occlusion_test", "GL_HP_oclusion_test"), "f.toml:7: ", "cannot be emulated"},
        {replaced("\"GL_ARB_occlusion_query\"", "17"),
         "f.toml:8: ", "something other than an extension name"},
        {replaced("counter_bits = 24", "counter_bits = 65"), "f.toml:10: ", "from 1 to 64"},
        {replaced("counter_bits = 32", "counter_bits = 0"), "f.toml:12: ", "`counter_bits`"},
        {replaced("max_shapes = 100", "max_shapes = 65537"), "f.toml:13: ", "from 1 to 65536"},
        {replaced("pipes = 4", "pipes = 4.5"), "f.toml:14: ", "`pipes` is not a whole number from 1 to 64"},
        {replaced("coordinate_bits = 12", "coordinate_bits = 17"), "f.toml:15: ", "from 1 to 16"},
        {replaced("depth_bits = 16", "depth_bits = 33"), "f.toml:16: ", "from 1 to 32"},
        {replaced("report_queue = 8", "report_queue = -1"), "f.toml:17: ", "from 1 to 65536"},
        {replaced("report_queue = 8", "queue = 8"),
         "f.toml:17: ", "unknown key `queue`, expected one of counter"},
        {replaced("max_regions = 1", "max_regions = 65537"), "f.toml:19: ", "`max_regions`"},
        {replaced("batch_us = 17", "batch_us = -1"), "f.toml:24: ", "`batch_us` is not a number from 0"},
        {replaced("batch_us = 17", "batch_us = \"17\""), "f.toml:24: ", "`batch_us` is not a number"},
        {replaced("40e6", "0"), "f.toml:25: ", "`triangles_per_second` is not a number from 1"},
        {replaced("= 40e6", "= nan"), "f.toml:25: ", "`triangles_per_second` is not a number from 1"},
        {replaced("poll_us = 0.25", "poll_us = 0"), "f.toml:28: ", "polling would take for ever"},
        {replaced("poll_us", "pol_us"), "f.toml:28: ", "unknown key `pol_us`, expected one of source"},
        {replaced("\"assumed\"", "\"guessed\""),
         "f.toml:23: ", "`quality` is none of fitted, indicative, assumed"},
        {replaced("source = \"a data sheet\"", "base = \"mesa\""), "f.toml:22: ", "`base` does not name"},
        {replaced("[region]", "[regions]"), "f.toml:18: ", "unknown key `regions`, expected one of name"},
        {replaced("[query]", "query = 3"), "f.toml:", ""},
        {replaced("[query]", "[query"), "f.toml:9: ", ""},
        {replaced("[query]", "[\nquery]"), "f.toml:", "expected bare key"},
    };
    for (const Row& row : rows) {
        const DeviceOrError result = parse_device(row.text, "f.toml");
        EXPECT_FALSE(result.device) << row.text;
        EXPECT_TRUE(result.error.starts_with(row.begins)) << result.error;
        EXPECT_NE(result.error.find(row.holds), std::string::npos) << result.error;
        EXPECT_TRUE(result.error.ends_with(".")) << result.error;
    }
}

TEST(Device, every_built_in_device_is_good_and_has_its_own_name) {
    EXPECT_GE(builtin_device_names().size(), 4u);
    for (const std::string_view name : builtin_device_names()) {
        const DeviceOrError result = load_device(name);
        ASSERT_TRUE(result.device) << result.error;
        EXPECT_EQ(result.device->name, name);
        EXPECT_FALSE(result.device->source.empty());
    }
}

TEST(Device, an_nv_query_needs_the_hp_test_beside_it) {
    constexpr std::string_view kFile = R"(name = "n"
description = "d"
source = "s"
[extensions]
emulate = [EXTENSIONS]
)";
    const auto with = [&](std::string_view extensions) {
        std::string text(kFile);
        return parse_device(text.replace(text.find("EXTENSIONS"), 10, extensions), "f.toml");
    };
    EXPECT_TRUE(with(R"("GL_HP_occlusion_test", "GL_NV_occlusion_query")").device);
    EXPECT_TRUE(with(R"("GL_HP_occlusion_test")").device);
    const DeviceOrError alone = with(R"("GL_NV_occlusion_query")");
    EXPECT_FALSE(alone.device);
    EXPECT_EQ(alone.error, "f.toml:5: GL_NV_occlusion_query requires GL_HP_occlusion_test beside it.");
}

TEST(Device, the_proposed_and_the_forgotten_extensions_can_be_emulated) {
    for (const std::string_view name :
         {"GL_EMU_depth_region_query", "GL_EMU_occlusion_unit", "GL_SGIX_instruments",
          "GL_SGIX_occlusion_instrument", "GL_SGIX_depth_pass_instrument", "GL_HP_visibility_test"}) {
        const DeviceOrError result = parse_device(replaced("GL_HP_occlusion_test", name), "f.toml");
        ASSERT_TRUE(result.device) << result.error;
        EXPECT_TRUE(result.device->emulates(name));
    }
}

TEST(Device, the_driver_as_it_is_is_a_pass_through) {
    EXPECT_TRUE(load_device("native").device->is_pass_through());
    EXPECT_TRUE(load_device("mesa").device->is_pass_through());
    EXPECT_FALSE(load_device("visualize-fx").device->is_pass_through());
}

TEST(Device, what_is_not_there_is_told) {
    EXPECT_NE(load_device("voodoo").error.find("visualize-fx"), std::string::npos);
    EXPECT_NE(load_device("/no/such.toml").error.find("cannot be opened"), std::string::npos);
    EXPECT_NE(load_device("/").error.find("cannot be"), std::string::npos);
}

// Hostile files: any damage to a good file gives a device or a sentence, never a crash.
TEST(Device, a_damaged_file_never_crashes) {
    std::mt19937 random(20040601);
    for (int round = 0; round < 20'000; ++round) {
        std::string text(kGood);
        const int damages = 1 + static_cast<int>(random() % 6);
        for (int d = 0; d < damages && !text.empty(); ++d) {
            const std::size_t at = random() % text.size();
            switch (random() % 4) {
                case 0:
                    text[at] = static_cast<char>(random());
                    break;
                case 1:
                    text.erase(at, random() % 16);
                    break;
                case 2:
                    text.insert(at, text.substr(random() % text.size(), random() % 64));
                    break;
                default:
                    text.resize(at);
            }
        }
        const DeviceOrError result = parse_device(text, "f.toml");
        EXPECT_NE(result.device.has_value(), !result.error.empty());
    }
}

TEST(Device, deep_nesting_never_crashes) {
    for (const char bracket : {'[', '{'}) {
        const DeviceOrError result = parse_device("name = " + std::string(200'000, bracket), "f.toml");
        EXPECT_FALSE(result.device);
    }
}

}  // namespace
}  // namespace glext_emu
