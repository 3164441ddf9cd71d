// SPDX-License-Identifier: MIT
// GL_ARB_occlusion_query when several threads and contexts use it. Runs on the bare driver too, which shows
// that the tests ask for no more than GL says. The environment says what the layer has to add: VERSION, how
// GL_VERSION starts; POLLS, the poll that each result comes with; LATENCY_US, how old it is at least.
#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <functional>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include "thread_context.h"

namespace threads {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kPollLimit = 1'000'000;  // a result that is not there by then never comes

struct Answer {
    GLuint samples;
    int polls;                      // until QUERY_RESULT_AVAILABLE was TRUE, that poll included
    std::chrono::microseconds age;  // at that poll, since just before EndQuery
};

Answer wait_for(GLuint query) {
    Answer answer{};
    GLuint available = GL_FALSE;
    while (!available && answer.polls < kPollLimit) {
        glGetQueryObjectuiv(query, GL_QUERY_RESULT_AVAILABLE, &available);
        ++answer.polls;
    }
    glGetQueryObjectuiv(query, GL_QUERY_RESULT, &answer.samples);
    return answer;
}

Answer query_pixels(GLuint query, int width, int height) {
    glBeginQuery(GL_SAMPLES_PASSED, query);
    draw_pixels(width, height, 0.0F);
    const auto end = Clock::now();
    glEndQuery(GL_SAMPLES_PASSED);
    Answer answer = wait_for(query);
    answer.age = std::chrono::duration_cast<std::chrono::microseconds>(Clock::now() - end);
    return answer;
}

GLuint current_query() {
    GLint query = -1;
    glGetQueryiv(GL_SAMPLES_PASSED, GL_CURRENT_QUERY, &query);
    return static_cast<GLuint>(query);
}

GLuint new_query() {
    GLuint query = 0;
    glGenQueries(1, &query);
    return query;
}

// 0 where the environment asks for nothing.
int wanted(const char* variable) {
    const char* text = std::getenv(variable);
    return text ? std::atoi(text) : 0;
}

void in_another_thread(const std::function<void()>& work) {
    std::thread(work).join();
}

struct Mistakes {
    int wrong_counts = -1;
    int wrong_times = -1;
};

// <queries> queries of random size, waited for one by one; counts are width times height.
Mistakes run_queries(int queries, unsigned seed) {
    std::mt19937 random(seed);
    const int polls = wanted("POLLS");
    const std::chrono::microseconds latency(wanted("LATENCY_US"));
    Mistakes mistakes{0, 0};
    const GLuint query = new_query();
    for (int i = 0; i < queries; ++i) {
        const int width = 1 + static_cast<int>(random() % kSize);
        const int height = 1 + static_cast<int>(random() % kSize);
        const Answer answer = query_pixels(query, width, height);
        if (answer.samples != static_cast<GLuint>(width * height)) ++mistakes.wrong_counts;
        if (polls != 0 && answer.polls != polls) ++mistakes.wrong_times;
        if (answer.age < latency) ++mistakes.wrong_times;
    }
    return mistakes;
}

TEST(queries_in_threads, two_threads_with_a_context_each_get_their_own_1000_counts_in_time) {
    std::array<Mistakes, 2> of_thread;
    const auto work = [&of_thread](unsigned index) {
        const ThreadContext context;
        context.make_current();
        of_thread[index] = run_queries(1000, index);
        ThreadContext::release();
    };
    std::thread first(work, 0);
    std::thread second(work, 1);
    first.join();
    second.join();
    for (const Mistakes& mistakes : of_thread) {
        EXPECT_EQ(mistakes.wrong_counts, 0);
        EXPECT_EQ(mistakes.wrong_times, 0);
    }
}

TEST(queries_in_threads, the_machine_is_the_one_that_was_asked_for) {
    const char* version = std::getenv("VERSION");
    if (!version) GTEST_SKIP() << "no layer";
    const ThreadContext context;
    context.make_current();
    EXPECT_EQ(std::string(reinterpret_cast<const char*>(glGetString(GL_VERSION))).find(version), 0U);
    ThreadContext::release();
}

// ARB_occlusion_query, Issues: "Are query objects shareable between multiple contexts? RESOLVED: No."
TEST(queries_in_threads, a_share_group_does_not_share_query_names) {
    const ThreadContext first;
    const ThreadContext second(&first);
    first.make_current();
    const GLuint name = new_query();
    EXPECT_EQ(query_pixels(name, 8, 8).samples, 64U);
    EXPECT_TRUE(glIsQuery(name));
    in_another_thread([&] {
        second.make_current();
        EXPECT_FALSE(glIsQuery(name));
        EXPECT_EQ(current_query(), 0U);
        const GLuint own_name = new_query();
        EXPECT_EQ(query_pixels(own_name, 4, 4).samples, 16U);
        ThreadContext::release();
    });
    GLuint samples = 0;
    glGetQueryObjectuiv(name, GL_QUERY_RESULT, &samples);
    EXPECT_EQ(samples, 64U);
    ThreadContext::release();
}

TEST(queries_in_threads, a_context_handed_to_another_thread_keeps_its_active_query) {
    const ThreadContext context;
    context.make_current();
    const GLuint query = new_query();
    glBeginQuery(GL_SAMPLES_PASSED, query);
    draw_pixels(10, 10, 0.0F);
    ThreadContext::release();
    in_another_thread([&] {
        context.make_current();
        EXPECT_EQ(current_query(), query);
        draw_pixels(5, 10, 0.0F);
        glEndQuery(GL_SAMPLES_PASSED);
        EXPECT_EQ(wait_for(query).samples, 150U);
        ThreadContext::release();
    });
}

TEST(queries_in_threads, a_result_in_flight_survives_having_no_current_context) {
    const ThreadContext context;
    context.make_current();
    const GLuint query = new_query();
    glBeginQuery(GL_SAMPLES_PASSED, query);
    draw_pixels(10, 10, 0.0F);
    glEndQuery(GL_SAMPLES_PASSED);
    ThreadContext::release();
    context.make_current();
    EXPECT_EQ(wait_for(query).samples, 100U);
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
    ThreadContext::release();
}

TEST(queries_in_threads, after_a_context_that_ended_inside_a_query_the_next_one_starts_clean) {
    for (int round = 0; round < 20; ++round) {
        ThreadContext context;
        context.make_current();
        EXPECT_EQ(current_query(), 0U) << "round " << round;
        EXPECT_FALSE(glIsQuery(1)) << "round " << round;
        EXPECT_EQ(query_pixels(new_query(), 6, 7).samples, 42U) << "round " << round;
        EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR)) << "round " << round;
        glBeginQuery(GL_SAMPLES_PASSED, new_query());
        draw_pixels(8, 8, 0.0F);
        // Mesa 22.3.6's llvmpipe frees an active query with its context while its threads still count for it.
        glFinish();
        if (round % 2 == 0) context.destroy();  // while it is current
        ThreadContext::release();
    }
}

void compile_query(GLuint list, GLuint query, int side) {
    glNewList(list, GL_COMPILE);
    glBeginQuery(GL_SAMPLES_PASSED, query);
    draw_pixels(side, side, 0.0F);
    glEndQuery(GL_SAMPLES_PASSED);
    glEndList();
}

// A list is the old one until EndList, then the new one: never part of either.
TEST(queries_in_threads, a_list_replaced_while_others_call_it_is_the_old_or_the_new_one) {
    constexpr GLuint kQuery = 1;  // the first name of every context
    const ThreadContext first;
    first.make_current();
    const GLuint list = glGenLists(1);
    compile_query(list, kQuery, 8);
    std::atomic<bool> is_over = false;
    std::array<int, 3> wrong;
    wrong.fill(-1);
    std::vector<std::thread> threads;
    for (std::size_t index = 0; index < wrong.size(); ++index) {
        threads.emplace_back([&, index] {
            const ThreadContext context(&first);
            context.make_current();
            wrong[index] = new_query() == kQuery ? 0 : 1;
            while (!is_over) {
                glCallList(list);
                const GLuint samples = wait_for(kQuery).samples;
                if (samples != 8 * 8 && samples != 3 * 3) ++wrong[index];
            }
            ThreadContext::release();
        });
    }
    for (int round = 0; round < 1000; ++round) compile_query(list, kQuery, round % 2 == 0 ? 3 : 8);
    is_over = true;
    for (std::thread& thread : threads) thread.join();
    ThreadContext::release();
    EXPECT_EQ(wrong, (std::array<int, 3>{}));
}

}  // namespace
}  // namespace threads
