// SPDX-License-Identifier: MIT
// Many queries in flight: order, re-use of an object, and no mix-up of counts (ARB-35, ARB-36, ARB-38,
// ARB-39, ARB-41).
#include <algorithm>
#include <array>
#include <vector>

#include "arb_occlusion_query/arb_test.h"

namespace conformance {
namespace {

class Order : public ArbTest {
  protected:
    static void begin_draw_end(GLuint name, int samples) {
        glBeginQuery(GL_SAMPLES_PASSED, name);
        draw_samples(samples);
        glEndQuery(GL_SAMPLES_PASSED);
    }
};

// ARB-35. ARB 6.1.13: "It must always be true that if the result for one query is available, the result for
// all previous queries must also be available at that point in time."
TEST_F(Order, when_a_query_is_available_all_earlier_ones_are) {
    constexpr std::size_t kQueries = 100;
    std::array<GLuint, kQueries> names{};
    glGenQueries(kQueries, names.data());
    for (std::size_t i = 0; i < kQueries; ++i) begin_draw_end(names[i], static_cast<int>(i));
    // Ask the last first, then down: once one says TRUE, no earlier one may say FALSE.
    bool later_is_available = false;
    for (int round = 0; round < 1000000 && !later_is_available; ++round) {
        for (std::size_t i = kQueries; i-- > 0;) {
            const bool available = get_object(names[i], GL_QUERY_RESULT_AVAILABLE) == GL_TRUE;
            ASSERT_TRUE(available || !later_is_available) << "query " << i;
            later_is_available = available;
        }
    }
    EXPECT_TRUE(later_is_available) << "the first query never became available";
    glDeleteQueries(kQueries, names.data());
}

// ARB-35. A wait for one result brings all earlier ones.
TEST_F(Order, waiting_for_a_result_brings_all_earlier_ones) {
    std::array<GLuint, 10> names{};
    glGenQueries(names.size(), names.data());
    for (const GLuint name : names) begin_draw_end(name, 64);
    EXPECT_EQ(get_object(names[7], GL_QUERY_RESULT), 64u);
    for (std::size_t i = 0; i < 8; ++i) {
        EXPECT_EQ(get_object(names[i], GL_QUERY_RESULT_AVAILABLE), GLuint{GL_TRUE}) << i;
    }
    glDeleteQueries(names.size(), names.data());
}

// ARB-36, ARB-49. ARB 4.1.6A: "BeginQueryARB [...] resets the current samples-passed count to zero";
// GL 4.5, 4.2: the object's result becomes 0 and not available.
TEST_F(Order, a_former_count_is_not_carried_over) {
    const Query query;
    for (const int samples : {100, 0, 7, 0}) {
        EXPECT_EQ(query.count([samples] { draw_samples(samples); }), static_cast<GLuint>(samples));
    }
}

// ARB-38. ARB 6.1.13: "the result returned will always be from the last query issued."
TEST_F(Order, of_queries_on_one_object_the_last_one_counts) {
    const Query query;
    begin_draw_end(query.name(), 5);
    begin_draw_end(query.name(), 50);
    begin_draw_end(query.name(), 500);
    EXPECT_EQ(query.result(), 500u);
}

// ARB-39. As above, while other queries are in flight between them.
TEST_F(Order, re_using_an_object_in_flight_mixes_no_counts) {
    const Query reused;
    const Query before;
    const Query between;
    begin_draw_end(before.name(), 1);
    begin_draw_end(reused.name(), 20);
    begin_draw_end(between.name(), 300);
    begin_draw_end(reused.name(), 4000);
    EXPECT_TRUE(no_error());
    EXPECT_EQ(between.result(), 300u);
    EXPECT_EQ(reused.result(), 4000u);
    EXPECT_EQ(before.result(), 1u);
}

// ARB-41. ARB, issues: "Should there be a limit on how many queries can be outstanding? RESOLVED: No."
TEST_F(Order, a_thousand_queries_in_flight_are_each_right_in_any_order) {
    constexpr std::size_t kQueries = 1000;
    std::vector<GLuint> names(kQueries);
    glGenQueries(kQueries, names.data());
    for (std::size_t i = 0; i < kQueries; ++i) begin_draw_end(names[i], static_cast<int>(i % 97));
    // 619 is prime to 1000: a fixed permutation that visits each once.
    for (std::size_t step = 0, i = 0; step < kQueries; ++step, i = (i + 619) % kQueries) {
        ASSERT_EQ(get_object(names[i], GL_QUERY_RESULT), i % 97) << "query " << i;
    }
    glDeleteQueries(kQueries, names.data());
}

// ARB-41. Names deleted while their results are pending disturb no other.
TEST_F(Order, deleting_objects_in_flight_disturbs_no_other) {
    const Query kept;
    GLuint name = 0;
    for (int i = 0; i < 20; ++i) {
        glGenQueries(1, &name);
        begin_draw_end(name, 7);
        if (i == 10) begin_draw_end(kept.name(), 33);
        glDeleteQueries(1, &name);
    }
    EXPECT_EQ(kept.result(), 33u);
    glBeginQuery(GL_SAMPLES_PASSED, name);
    glEndQuery(GL_SAMPLES_PASSED);
    EXPECT_EQ(get_object(name, GL_QUERY_RESULT), 0u) << "a re-created object shows the old count";
}

}  // namespace
}  // namespace conformance
