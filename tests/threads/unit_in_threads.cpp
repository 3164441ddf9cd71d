// SPDX-License-Identifier: MIT
// The proposed hardware in eight threads at once, whose contexts share their objects: queries of the
// Occlusion Unit over fixed function, over fragments that only the exact path can follow and out of display
// lists, shapes, and region queries, in an order of each thread's own. Every answer is known from what was
// drawn.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "thread_context.h"

// After glext.h with its prototypes, which it includes without.
#include <GL/glext_emu.h>

namespace threads {
namespace {

constexpr int kRounds = 150;  // of each thread
constexpr float kInFront = -0.5F;

// The name of each context's query that the shared list begins: query names belong to a context.
constexpr GLuint kListQuery = 1;

template <class Function>
Function command(const char* name) {
    return reinterpret_cast<Function>(eglGetProcAddress(name));
}

struct Commands {
    PFNGLBEGINOCCLUSIONUNITEMUPROC begin;
    PFNGLENDOCCLUSIONUNITEMUPROC end;
    PFNGLOCCLUSIONUNITSHAPESEMUPROC shapes;
    PFNGLGETOCCLUSIONRECORDSEMUPROC get_records;
    PFNGLGETDEPTHREGIONFVEMUPROC get_region;
    PFNGLQUERYDEPTHREGIONSEMUPROC query_regions;
};

const Commands& gl_emu() {
    static const Commands all = {
        command<PFNGLBEGINOCCLUSIONUNITEMUPROC>("glBeginOcclusionUnitEMU"),
        command<PFNGLENDOCCLUSIONUNITEMUPROC>("glEndOcclusionUnitEMU"),
        command<PFNGLOCCLUSIONUNITSHAPESEMUPROC>("glOcclusionUnitShapesEMU"),
        command<PFNGLGETOCCLUSIONRECORDSEMUPROC>("glGetOcclusionRecordsEMU"),
        command<PFNGLGETDEPTHREGIONFVEMUPROC>("glGetDepthRegionfvEMU"),
        command<PFNGLQUERYDEPTHREGIONSEMUPROC>("glQueryDepthRegionsEMU"),
    };
    return all;
}

// What the unit has to tell of a block.
bool tells(const GLocclusionrecordEMU& record, const Block& block) {
    constexpr float kRounding = 1e-6F;  // more than a step of 24 bits
    const std::array box = {record.box[0], record.box[1], record.box[2], record.box[3]};
    const std::array<GLint, 4> seen = {0, 0, block.in_front ? block.width - 1 : -1,
                                       block.in_front ? block.height - 1 : -1};
    const float nearest = block.in_front ? 0.25F : 1.0F;
    return record.registers == GL_ALL_REGISTERS_EMU && record.projected_hits == block.all_samples() &&
           record.visible_hits == block.samples() && record.visible == (block.in_front ? 1U : 0U) &&
           std::abs(record.nearest_depth - nearest) < kRounding && box == seen;
}

GLocclusionrecordEMU read_record(GLuint name) {
    GLocclusionrecordEMU record{};
    gl_emu().get_records(name, 0, 1, &record);
    return record;
}

// What one thread asks in its own, current context. Each question is right or counts as wrong.
class Inquirer {
  public:
    Inquirer(unsigned seed, GLuint shared_list) : random_(seed), shared_list_(shared_list) {
        glGenQueries(static_cast<GLsizei>(names_.size()), names_.data());
        draw_occluder();
    }

    int count_wrong_answers() {
        int wrong = 0;
        for (int round = 0; round < kRounds; ++round) {
            if (!ask(random_() % 7)) ++wrong;
        }
        if (glGetError() != GL_NO_ERROR) ++wrong;
        return wrong;
    }

  private:
    bool ask(unsigned question) {
        switch (question) {
            case 0:
                return ask_of_a_block();
            case 1:
                return ask_of_a_bounding_block();
            case 2:
                return ask_on_the_exact_path();
            case 3:
                return ask_of_shapes();
            case 4:
                return ask_of_regions();
            case 5:
                return ask_by_shared_list();
            default:
                return ask_by_own_list();
        }
    }

    bool ask_of_a_block() {
        const Block block(random_);
        gl_emu().begin(GL_ALL_REGISTERS_EMU, names_[1]);
        block.draw();
        gl_emu().end();
        return tells(read_record(names_[1]), block);
    }

    bool ask_of_a_bounding_block() {
        glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
        const bool is_right = ask_of_a_block();
        glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
        return is_right;
    }

    // No fragment stage of another's does what the alpha test does.
    bool ask_on_the_exact_path() {
        glEnable(GL_ALPHA_TEST);
        glAlphaFunc(GL_GREATER, 0.5F);
        const bool is_right = ask_of_a_block();
        glDisable(GL_ALPHA_TEST);
        return is_right;
    }

    // Flat boxes parallel to the screen: both of their large sides cover the block.
    bool ask_of_shapes() {
        const std::array blocks = {Block(random_), Block(random_)};
        std::vector<GLfloat> corners;
        for (const Block& block : blocks) {
            const auto at = [](int pixels) { return 2.0F * static_cast<float>(pixels) / kSize - 1.0F; };
            corners.insert(corners.end(),
                           {-1.0F, -1.0F, block.z(), at(block.width), at(block.height), block.z()});
        }
        glViewport(0, 0, kSize, kSize);
        gl_emu().shapes(GL_ALL_REGISTERS_EMU, GL_BOX_EMU, 2, corners.data(), nullptr, names_[2]);
        std::array<GLocclusionrecordEMU, 2> records{};
        gl_emu().get_records(names_[2], 0, 2, records.data());
        for (GLocclusionrecordEMU& record : records) {
            record.projected_hits /= 2;
            record.visible_hits /= 2;
        }
        return tells(records[0], blocks[0]) && tells(records[1], blocks[1]);
    }

    bool ask_of_regions() {
        const std::array<GLint, 4> region = {static_cast<GLint>(random_() % 32), 3, 16, 7};
        GLfloat furthest = -1.0F;
        gl_emu().get_region(GL_FURTHEST_DEPTH_EMU, region[0], region[1], region[2], region[3], &furthest);
        gl_emu().query_regions(GL_REGION_OCCLUDED_EMU, 1, region.data(), &names_[3]);
        GLuint is_occluded = 7;
        glGetQueryObjectuiv(names_[3], GL_QUERY_RESULT, &is_occluded);
        return furthest > 0.4999F && furthest < 0.5001F && is_occluded == 1;
    }

    bool ask_by_shared_list() const {
        glCallList(shared_list_);
        return read_record(kListQuery).visible_hits == 64;
    }

    bool ask_by_own_list() {
        const Block block(random_);
        const GLuint list = glGenLists(1);
        glNewList(list, GL_COMPILE);
        gl_emu().begin(GL_ALL_REGISTERS_EMU, kListQuery);
        block.draw();
        gl_emu().end();
        glEndList();
        glCallList(list);
        const bool is_right = tells(read_record(kListQuery), block);
        glDeleteLists(list, 1);
        return is_right;
    }

    std::mt19937 random_;
    GLuint shared_list_;
    std::array<GLuint, 4> names_{};  // the first is kListQuery
};

// A list that every context of the share group calls: 64 samples by the caller's own query.
GLuint compile_shared_list() {
    const GLuint list = glGenLists(1);
    glNewList(list, GL_COMPILE);
    gl_emu().begin(GL_VISIBLE_HITS_BIT_EMU, kListQuery);
    draw_pixels(8, 8, kInFront);
    gl_emu().end();
    glEndList();
    return list;
}

TEST(unit_in_threads, eight_threads_of_a_share_group_get_their_own_answers) {
    const ThreadContext first;
    first.make_current();
    const GLuint list = compile_shared_list();
    ThreadContext::release();
    const WrongAnswers wrong =
        ask_in_threads(first, [list](unsigned index) { return Inquirer(index, list).count_wrong_answers(); });
    EXPECT_EQ(wrong, WrongAnswers{});
}

}  // namespace
}  // namespace threads
