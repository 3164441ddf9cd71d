// SPDX-License-Identifier: MIT
// GL_HP_occlusion_test when several threads and contexts use it: its enable and its result are state of a
// context (HP_occlusion_test, New State), whichever thread the context is current in.
#include <gtest/gtest.h>

#include <barrier>
#include <functional>
#include <random>
#include <thread>
#include <vector>

#include "thread_context.h"

namespace threads {
namespace {

constexpr GLenum kOcclusionTest = 0x8165;        // gl.xml: GL_OCCLUSION_TEST_HP
constexpr GLenum kOcclusionTestResult = 0x8166;  // gl.xml: GL_OCCLUSION_TEST_RESULT_HP

bool read_result() {
    GLboolean result = GL_FALSE;
    glGetBooleanv(kOcclusionTestResult, &result);
    return result == GL_TRUE;
}

bool state_is_initial() {
    return !glIsEnabled(kOcclusionTest) && !read_result() && glGetError() == GL_NO_ERROR;
}

// Draws an occluder at window depth 0.5 over everything.
void draw_occluder() {
    glEnable(GL_DEPTH_TEST);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    draw_pixels(kSize, kSize, 0.0F);
    glDepthMask(GL_FALSE);
}

bool one_test_is_visible(bool in_front) {
    glEnable(kOcclusionTest);
    draw_pixels(8, 8, in_front ? -0.5F : 0.5F);
    glDisable(kOcclusionTest);
    return read_result();
}

// Counts the wrong answers of <tests> tests, hidden or visible in the order of <seed>.
int count_wrong_answers(int tests, unsigned seed) {
    std::mt19937 random(seed);
    int wrong = 0;
    for (int i = 0; i < tests; ++i) {
        const bool in_front = (random() & 1U) != 0;
        if (one_test_is_visible(in_front) != in_front) ++wrong;
    }
    return wrong;
}

void in_another_thread(const std::function<void()>& work) {
    std::thread(work).join();
}

TEST(hp_test_in_threads, two_threads_with_a_context_each_get_their_own_1000_answers) {
    int wrong[2] = {-1, -1};
    const auto work = [&wrong](unsigned index) {
        const ThreadContext context;
        context.make_current();
        draw_occluder();
        wrong[index] = count_wrong_answers(1000, index);
        ThreadContext::release();
    };
    std::thread first(work, 0);
    std::thread second(work, 1);
    first.join();
    second.join();
    EXPECT_EQ(wrong[0], 0);
    EXPECT_EQ(wrong[1], 0);
}

TEST(hp_test_in_threads, contexts_of_a_share_group_do_not_see_each_others_test) {
    const ThreadContext testing;
    const ThreadContext idle(&testing);
    std::barrier step(2);
    bool testing_saw_its_quad = false;
    bool idle_stayed_initial = false;
    std::thread first([&] {
        testing.make_current();
        draw_occluder();
        glEnable(kOcclusionTest);
        draw_pixels(8, 8, -0.5F);
        step.arrive_and_wait();
        step.arrive_and_wait();
        testing_saw_its_quad = read_result();
        ThreadContext::release();
    });
    std::thread second([&] {
        idle.make_current();
        step.arrive_and_wait();
        draw_pixels(8, 8, -0.5F);
        idle_stayed_initial = state_is_initial();
        step.arrive_and_wait();
        ThreadContext::release();
    });
    first.join();
    second.join();
    EXPECT_TRUE(testing_saw_its_quad);
    EXPECT_TRUE(idle_stayed_initial);
}

TEST(hp_test_in_threads, a_context_handed_from_thread_to_thread_keeps_its_test_and_its_result) {
    const ThreadContext context;
    context.make_current();
    draw_occluder();
    glEnable(kOcclusionTest);
    ThreadContext::release();
    for (int turn = 0; turn < 20; ++turn) {
        const bool in_front = turn % 3 == 0;
        in_another_thread([&] {
            context.make_current();
            EXPECT_TRUE(glIsEnabled(kOcclusionTest));
            draw_pixels(8, 8, in_front ? -0.5F : 0.5F);
            ThreadContext::release();
        });
        in_another_thread([&] {
            context.make_current();
            EXPECT_EQ(read_result(), in_front) << "turn " << turn;
            ThreadContext::release();
        });
    }
}

TEST(hp_test_in_threads, a_context_is_whole_after_its_thread_ended) {
    const ThreadContext context;
    in_another_thread([&] {
        context.make_current();
        draw_occluder();
        glEnable(kOcclusionTest);
        draw_pixels(8, 8, -0.5F);
        ThreadContext::release_thread();
        EXPECT_EQ(glGetString(GL_VERSION), nullptr) << "without a context there is no GL";
    });
    context.make_current();
    EXPECT_TRUE(read_result());
    EXPECT_TRUE(glIsEnabled(kOcclusionTest));
    ThreadContext::release();
}

// The driver gives the address of a context that one thread destroys to a context that another thread
// creates.
TEST(hp_test_in_threads, a_context_has_its_own_state_while_other_threads_create_and_destroy_contexts) {
    std::vector<int> unclean(2, 0);
    std::vector<int> forgotten(2, 0);
    const auto work = [&](std::size_t index) {
        for (int round = 0; round < 40; ++round) {
            ThreadContext context;
            context.make_current();
            if (!state_is_initial()) ++unclean[index];
            glEnable(kOcclusionTest);
            ThreadContext::release();
            context.make_current();
            if (!glIsEnabled(kOcclusionTest)) ++forgotten[index];
            draw_pixels(8, 8, 0.0F);
            if (round % 2 == 0) context.destroy();  // while it is current
            ThreadContext::release();
        }
    };
    std::thread first(work, 0);
    std::thread second(work, 1);
    first.join();
    second.join();
    EXPECT_EQ(unclean, std::vector<int>(2, 0));
    EXPECT_EQ(forgotten, std::vector<int>(2, 0));
}

}  // namespace
}  // namespace threads
