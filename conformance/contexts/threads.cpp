// SPDX-License-Identifier: MIT
// Threads: each with its own context, and one context that goes from hand to hand (CTX-03, CTX-04).
#include <array>
#include <atomic>
#include <thread>

#include "contexts/asking.h"

namespace conformance {
namespace {

constexpr int kQueries = 1000;  // of each thread

class Threads : public ContextTest {};

INSTANTIATE_TEST_SUITE_P(Each, Threads, every_way(), way_name);

// CTX-03. GL 4.5, 2.1: each thread has its own current context.
TEST_P(Threads, two_threads_with_a_context_each_mix_nothing_up) {
    const std::array<Context, 2> contexts;
    const std::array<Surface, 2> surfaces;
    std::atomic<int> wrong = 0;
    const auto work = [&](std::size_t me) {
        if (!contexts[me].make_current(surfaces[me])) {
            wrong = kQueries;
            return;
        }
        use_pixel_coordinates();
        for (int i = 0; i < kQueries; ++i) {
            // Never the number that the other thread has at the same time; nothing at all in between.
            const int width = i % 3 == 0 ? 0 : static_cast<int>(me) * 20 + 1 + i % 17;
            const GLuint told = ask([&] { draw_rect({0, 0, width, 1}, kMiddle); });
            if (told != as_told(static_cast<GLuint>(width))) ++wrong;
        }
        if (glGetError() != GL_NO_ERROR) ++wrong;
        Context::release_current();
    };
    Context::release_current();
    std::thread first(work, 0);
    std::thread second(work, 1);
    first.join();
    second.join();
    come_back();
    EXPECT_EQ(wrong, 0) << "of " << 2 * kQueries;
}

// CTX-04. GL 4.5, 2.1: a context may become current to another thread once it is current to none.
TEST_P(Threads, a_context_goes_from_thread_to_thread_with_its_query) {
    Context::release_current();
    const auto elsewhere = [this](auto action) {
        std::thread thread([&] {
            EXPECT_TRUE(context().make_current(surface()));
            action();
            Context::release_current();
        });
        thread.join();
    };
    elsewhere([this] {
        asking().begin();
        draw_rect({0, 0, 7, 1}, kMiddle);
    });
    elsewhere([this] {
        EXPECT_TRUE(asking().active());
        draw_rect({0, 1, 5, 1}, kMiddle);
    });
    elsewhere([this] { asking().end(); });
    GLuint told = 0;
    elsewhere([&] { told = asking().result(); });
    EXPECT_EQ(told, as_told(12));
    come_back();
    EXPECT_FALSE(asking().active());
}

}  // namespace
}  // namespace conformance
