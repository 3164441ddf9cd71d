// SPDX-License-Identifier: MIT
// Every occlusion query there is, in eight threads at once whose contexts share their objects: the HP test,
// NV and ARB queries, boolean queries, conditional rendering and display lists, in an order of each thread's
// own. Every answer is known from what was drawn.
#include <gtest/gtest.h>

#include <array>
#include <random>

#include "thread_context.h"

namespace threads {
namespace {

constexpr int kRounds = 400;  // of each thread
constexpr float kInFront = -0.5F;

// The name of each context's query that the shared list begins: query names belong to a context.
constexpr GLuint kListQuery = 1;

bool read_hp() {
    GLboolean result = GL_FALSE;
    glGetBooleanv(GL_OCCLUSION_TEST_RESULT_HP, &result);
    return result == GL_TRUE;
}

GLuint read_nv(GLuint name) {
    GLuint result = 0xDEADBEEF;
    glGetOcclusionQueryuivNV(name, GL_PIXEL_COUNT_NV, &result);
    return result;
}

GLuint read_arb(GLuint name) {
    GLuint result = 0xDEADBEEF;
    glGetQueryObjectuiv(name, GL_QUERY_RESULT, &result);
    return result;
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
                return ask_hp();
            case 1:
                return ask_nv();
            case 2:
                return ask_arb(GL_SAMPLES_PASSED, names_[1]);
            case 3:
                return ask_arb(GL_ANY_SAMPLES_PASSED, names_[2]);
            case 4:
                return ask_conditionally();
            case 5:
                return ask_by_shared_list();
            default:
                return ask_by_own_list();
        }
    }

    bool ask_hp() {
        const Block block(random_);
        glEnable(GL_OCCLUSION_TEST_HP);
        read_hp();
        block.draw();
        glDisable(GL_OCCLUSION_TEST_HP);
        return read_hp() == block.in_front;
    }

    bool ask_nv() {
        GLuint name = 0;
        const Block block(random_);
        glGenOcclusionQueriesNV(1, &name);
        glBeginOcclusionQueryNV(name);
        block.draw();
        glEndOcclusionQueryNV();
        const bool is_right = read_nv(name) == block.samples();
        glDeleteOcclusionQueriesNV(1, &name);
        return is_right;
    }

    bool ask_arb(GLenum target, GLuint name) {
        const Block block(random_);
        glBeginQuery(target, name);
        block.draw();
        glEndQuery(target);
        const GLuint result = read_arb(name);
        return result ==
               (target == GL_SAMPLES_PASSED ? block.samples() : static_cast<GLuint>(block.in_front));
    }

    bool ask_conditionally() {
        const Block condition(random_);
        glBeginQuery(GL_ANY_SAMPLES_PASSED, names_[3]);
        condition.draw();
        glEndQuery(GL_ANY_SAMPLES_PASSED);
        glBeginQuery(GL_SAMPLES_PASSED, names_[1]);
        glBeginConditionalRender(names_[3], GL_QUERY_WAIT);
        draw_pixels(5, 5, kInFront);
        glEndConditionalRender();
        glEndQuery(GL_SAMPLES_PASSED);
        return read_arb(names_[1]) == (condition.in_front ? 25U : 0U);
    }

    bool ask_by_shared_list() const {
        glCallList(shared_list_);
        return read_nv(kListQuery) == 64 && read_hp();
    }

    bool ask_by_own_list() {
        const Block block(random_);
        const GLuint list = glGenLists(1);
        glNewList(list, GL_COMPILE);
        glBeginOcclusionQueryNV(kListQuery);
        block.draw();
        glEndOcclusionQueryNV();
        glEndList();
        glCallList(list);
        const bool is_right = read_nv(kListQuery) == block.samples();
        glDeleteLists(list, 1);
        return is_right;
    }

    std::mt19937 random_;
    GLuint shared_list_;
    std::array<GLuint, 4> names_{};  // the first is kListQuery
};

// A list that every context of the share group calls: it counts 64 samples by the caller's own query.
GLuint compile_shared_list() {
    const GLuint list = glGenLists(1);
    glNewList(list, GL_COMPILE);
    glEnable(GL_OCCLUSION_TEST_HP);
    glBeginOcclusionQueryNV(kListQuery);
    draw_pixels(8, 8, kInFront);
    glEndOcclusionQueryNV();
    glDisable(GL_OCCLUSION_TEST_HP);
    glEndList();
    return list;
}

TEST(every_query_in_threads, eight_threads_of_a_share_group_get_their_own_answers) {
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
