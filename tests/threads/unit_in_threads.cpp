// SPDX-License-Identifier: MIT
// The proposed hardware in eight threads at once, whose contexts share their objects: queries of the
// Occlusion Unit over fixed function, over fragments that only the exact path can follow and out of display
// lists, shapes, and region queries, in an order of each thread's own. Every answer is known from what was
// drawn.
#include <gtest/gtest.h>

#include <array>
#include <random>
#include <thread>
#include <vector>

#include "thread_context.h"

// After glext.h with its prototypes, which it includes without.
#include <GL/glext_emu.h>

namespace threads {
namespace {

constexpr int kThreads = 8;
constexpr int kRounds = 150;  // of each thread
constexpr float kInFront = -0.5F, kBehind = 0.5F;

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

struct Block {
    int width, height;
    bool in_front;

    explicit Block(std::mt19937& random)
        : width(1 + static_cast<int>(random() % 16)),
          height(1 + static_cast<int>(random() % 16)),
          in_front((random() & 1U) != 0) {}
    void draw() const { draw_pixels(width, height, in_front ? kInFront : kBehind); }

    // What the unit has to tell of it; all of its coordinates are exact in every format.
    bool is(const GLocclusionrecordEMU& record) const {
        const auto all = static_cast<GLuint64>(width * height);
        const std::array box = {record.box[0], record.box[1], record.box[2], record.box[3]};
        const std::array seen =
            in_front ? std::array<GLint, 4>{0, 0, width - 1, height - 1} : std::array<GLint, 4>{0, 0, -1, -1};
        return record.registers == GL_ALL_REGISTERS_EMU && record.projected_hits == all &&
               record.visible_hits == (in_front ? all : 0) && record.visible == (in_front ? 1U : 0U) &&
               record.nearest_depth >= (in_front ? 0.2499F : 1.0F) &&
               record.nearest_depth <= (in_front ? 0.2501F : 1.0F) && box == seen;
    }
};

void draw_occluder() {
    glEnable(GL_DEPTH_TEST);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    draw_pixels(kSize, kSize, 0.0F);
    glDepthMask(GL_FALSE);
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
        return block.is(read_record(names_[1]));
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
            const float z = block.in_front ? kInFront : kBehind;
            const auto at = [](int pixels) { return 2.0F * static_cast<float>(pixels) / kSize - 1.0F; };
            corners.insert(corners.end(), {-1.0F, -1.0F, z, at(block.width), at(block.height), z});
        }
        glViewport(0, 0, kSize, kSize);
        gl_emu().shapes(GL_ALL_REGISTERS_EMU, GL_BOX_EMU, 2, corners.data(), nullptr, names_[2]);
        std::array<GLocclusionrecordEMU, 2> records{};
        gl_emu().get_records(names_[2], 0, 2, records.data());
        for (GLocclusionrecordEMU& record : records) {
            record.projected_hits /= 2;
            record.visible_hits /= 2;
        }
        return blocks[0].is(records[0]) && blocks[1].is(records[1]);
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
        const bool is_right = block.is(read_record(kListQuery));
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
    std::array<int, kThreads> wrong;
    wrong.fill(-1);
    std::vector<std::thread> threads;
    for (unsigned index = 0; index < kThreads; ++index) {
        threads.emplace_back([&, index] {
            const ThreadContext context(&first);
            context.make_current();
            wrong[index] = Inquirer(index, list).count_wrong_answers();
            ThreadContext::release();
        });
    }
    for (std::thread& thread : threads) thread.join();
    std::array<int, kThreads> none{};
    EXPECT_EQ(wrong, none);
}

}  // namespace
}  // namespace threads
