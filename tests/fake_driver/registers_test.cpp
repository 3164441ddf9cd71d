// SPDX-License-Identifier: MIT
// Arming one register of the Occlusion Unit never pays for another: what a watched draw makes the driver do,
// name by name. Questions (Get*, Is*, which answer from the driver's memory) are told apart from effects (all
// else).
#include <GL/glext_emu.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "fake_driver.h"

namespace {

using fake_driver::find;
using Strings = std::vector<std::string>;

constexpr GLbitfield kVisible = GL_VISIBLE_BIT_EMU;
constexpr GLbitfield kProjectedHits = GL_PROJECTED_HITS_BIT_EMU;
constexpr GLbitfield kVisibleHits = GL_VISIBLE_HITS_BIT_EMU;
constexpr GLbitfield kNearestDepth = GL_NEAREST_DEPTH_BIT_EMU;
constexpr GLbitfield kScreenBox = GL_SCREEN_BOX_BIT_EMU;

bool is_question(const std::string& name) {
    return name.starts_with("glGet") || name.starts_with("glIs") || name.starts_with("glCheck");
}

int count_of(const Strings& log, std::string_view name) {
    return static_cast<int>(std::ranges::count(log, name));
}

class registers : public testing::Test {
  protected:
    void SetUp() override {
        ASSERT_NE(fake_driver::make_context(), nullptr);
        ASSERT_NE(begin_, nullptr) << "the device has no GL_EMU_occlusion_unit";
        find<void (*)(GLenum)>("glEnable")(GL_DEPTH_TEST);
        find<void (*)(GLsizei, GLuint*)>("glGenQueries")(1, &query_);
    }

    void draw() { find<void (*)(GLenum, GLint, GLsizei)>("glDrawArrays")(GL_TRIANGLES, 0, 3); }

    void write_nothing() {
        find<void (*)(GLboolean)>("glDepthMask")(GL_FALSE);
        find<void (*)(GLboolean, GLboolean, GLboolean, GLboolean)>("glColorMask")(0, 0, 0, 0);
    }

    // What the driver does in a query of <armed> with <draws> draws, from Begin to End, when it is not the
    // first of its kind: programs are compiled and objects made once.
    Strings calls_of_query(GLbitfield armed, int draws) {
        for (int round = 0; round < 2; ++round) {
            fake_driver::clear_log();
            begin_(armed, query_);
            for (int i = 0; i < draws; ++i) draw();
            end_();
            log_ = fake_driver::log();
            GLocclusionrecordEMU record{};
            get_(query_, 0, 1, &record);
        }
        return log_;
    }

    // What one draw more makes the driver do.
    Strings effects_of_draw(GLbitfield armed) {
        const Strings one = effects(calls_of_query(armed, 1));
        const Strings two = effects(calls_of_query(armed, 2));
        Strings more = two;
        for (const std::string& name : one) {
            const auto found = std::ranges::find(more, name);
            EXPECT_NE(found, more.end()) << "the second draw takes back " << name;
            if (found != more.end()) more.erase(found);
        }
        return fake_driver::counted(more);
    }

    static Strings effects(Strings log) {
        std::erase_if(log, is_question);
        return log;
    }

    GLuint query_ = 0;
    Strings log_;
    const PFNGLBEGINOCCLUSIONUNITEMUPROC begin_ =
        find<PFNGLBEGINOCCLUSIONUNITEMUPROC>("glBeginOcclusionUnitEMU");
    const PFNGLENDOCCLUSIONUNITEMUPROC end_ = find<PFNGLENDOCCLUSIONUNITEMUPROC>("glEndOcclusionUnitEMU");
    const PFNGLGETOCCLUSIONRECORDSEMUPROC get_ =
        find<PFNGLGETOCCLUSIONRECORDSEMUPROC>("glGetOcclusionRecordsEMU");
};

TEST_F(registers, a_query_without_draws_makes_the_driver_do_nothing) {
    EXPECT_EQ(effects(calls_of_query(GL_ALL_REGISTERS_EMU, 0)), Strings{});
}

TEST_F(registers, visible_hits_are_one_query_of_the_drivers_around_all_draws) {
    for (const GLbitfield armed : {kVisible, kVisibleHits, kVisible | kVisibleHits}) {
        EXPECT_EQ(effects(calls_of_query(armed, 3)),
                  (Strings{"glBeginQuery", "glDrawArrays", "glDrawArrays", "glDrawArrays", "glEndQuery"}));
        EXPECT_EQ(effects_of_draw(armed), Strings{"glDrawArrays"});
    }
}

// Whether MULTISAMPLE is on says what the driver counts (CNT-34).
TEST_F(registers, with_visible_hits_alone_a_draw_asks_for_nothing_but_multisample) {
    const Strings one = fake_driver::counted(calls_of_query(kVisibleHits, 1));
    Strings expected = calls_of_query(kVisibleHits, 1);
    expected.insert(expected.end(), {"glIsEnabled", "glDrawArrays"});
    EXPECT_EQ(fake_driver::counted(calls_of_query(kVisibleHits, 2)), fake_driver::counted(expected));
}

// The second rasterisation, its count, and what hides it: no colour, no depth test, which writes no depth
// either.
TEST_F(registers, projected_hits_are_a_second_rasterisation_and_its_masks) {
    const Strings second{"glBeginQuery", "glDisable", "glDrawArrays x2", "glEnable", "glEndQuery"};
    Strings masked = second;
    // Two draw buffers, each put back.
    masked.insert(masked.begin() + 1, {"glColorMask", "glColorMaski x2", "glDepthMask x2"});
    EXPECT_EQ(effects_of_draw(kProjectedHits), masked);
    // What a culler's box asks: it writes nothing anyhow.
    write_nothing();
    EXPECT_EQ(effects_of_draw(kProjectedHits), second);
}

TEST_F(registers, where_every_fragment_passes_projected_hits_need_no_second_rasterisation) {
    find<void (*)(GLenum)>("glDepthFunc")(GL_ALWAYS);
    EXPECT_EQ(effects_of_draw(kProjectedHits), Strings{"glDrawArrays"});
    EXPECT_EQ(effects_of_draw(kProjectedHits | kVisibleHits), Strings{"glDrawArrays"});
    find<void (*)(GLenum)>("glDepthFunc")(GL_LESS);
    find<void (*)(GLenum)>("glDisable")(GL_DEPTH_TEST);
    EXPECT_EQ(effects_of_draw(kProjectedHits), Strings{"glDrawArrays"});
}

TEST_F(registers, marks_are_made_without_any_query_of_the_drivers) {
    for (const GLbitfield armed : {kNearestDepth, kScreenBox, kNearestDepth | kScreenBox}) {
        const Strings log = calls_of_query(armed, 2);
        EXPECT_EQ(count_of(log, "glBeginQuery"), 0) << armed;
        EXPECT_EQ(count_of(log, "glEndQuery"), 0) << armed;
    }
}

// A stage of the layer's own, and the memory that it marks: bound around the draw where the draw writes
// nothing anyhow, else around a second one.
const Strings kMarked{"glBindBuffersBase x2", "glDrawArrays", "glShaderStorageBlockBinding",
                      "glUseProgram x2"};

TEST_F(registers, marks_of_a_box_that_writes_nothing_are_made_by_the_draw_itself) {
    write_nothing();
    for (const GLbitfield armed : {kNearestDepth, kScreenBox, kNearestDepth | kScreenBox}) {
        EXPECT_EQ(effects_of_draw(armed), kMarked) << armed;
    }
}

TEST_F(registers, marks_of_a_draw_that_writes_are_a_second_rasterisation_and_its_masks) {
    Strings second = kMarked;
    second[1] = "glDrawArrays x2";
    second.insert(second.begin() + 1, {"glColorMask", "glColorMaski x2", "glDepthMask x2"});
    for (const GLbitfield armed : {kNearestDepth, kScreenBox, kNearestDepth | kScreenBox}) {
        EXPECT_EQ(effects_of_draw(armed), second) << armed;
    }
}

TEST_F(registers, marks_are_made_by_at_most_one_further_rasterisation_of_each_draw) {
    for (const GLbitfield armed : {kNearestDepth, kScreenBox, kNearestDepth | kScreenBox}) {
        EXPECT_LE(count_of(calls_of_query(armed, 3), "glDrawArrays"), 2 * 3) << armed;
    }
}

TEST_F(registers, nothing_is_read_back_before_the_record_is_asked_for) {
    for (GLbitfield armed = 1; armed <= GL_ALL_REGISTERS_EMU; ++armed) {
        for (const std::string& name : calls_of_query(armed, 2)) {
            EXPECT_FALSE(name == "glReadPixels" || name == "glFinish" || name == "glGetTexImage" ||
                         name.starts_with("glGetQueryObject") || name.starts_with("glMap") ||
                         (name.starts_with("glGet") && name.ends_with("BufferSubData")))
                << name << " for registers " << armed;
        }
    }
}

TEST_F(registers, counting_registers_touch_no_memory_no_program_and_no_framebuffer) {
    for (GLbitfield armed = 1; armed < kNearestDepth; ++armed) {
        for (const std::string& name : effects(calls_of_query(armed, 2))) {
            EXPECT_FALSE(name.find("Buffer") != std::string::npos ||
                         name.find("Program") != std::string::npos ||
                         name.find("Framebuffer") != std::string::npos ||
                         name.find("Image") != std::string::npos || name.find("Copy") != std::string::npos)
                << name << " for registers " << armed;
        }
    }
}

// What two groups of registers cost together is what each costs alone, the program's own draw counted once.
TEST_F(registers, groups_of_registers_cost_what_each_of_them_costs_alone) {
    for (const GLbitfield marks : {kNearestDepth, kScreenBox, kNearestDepth | kScreenBox}) {
        Strings sum = effects(calls_of_query(marks, 1));
        sum.erase(std::ranges::find(sum, "glDrawArrays"));
        const Strings counted = effects(calls_of_query(kProjectedHits | kVisibleHits, 1));
        sum.insert(sum.end(), counted.begin(), counted.end());
        EXPECT_EQ(fake_driver::counted(effects(calls_of_query(marks | kProjectedHits | kVisibleHits, 1))),
                  fake_driver::counted(sum));
    }
}

TEST_F(registers, after_the_query_a_draw_makes_one_call_again) {
    calls_of_query(GL_ALL_REGISTERS_EMU, 2);
    fake_driver::clear_log();
    draw();
    EXPECT_EQ(fake_driver::log(), Strings{"glDrawArrays"});
}

}  // namespace
