// SPDX-License-Identifier: MIT
// Many queries in flight: in order, without a limit, and without a mix-up of counts (NV-38, NV-39).
#include <array>
#include <vector>

#include "nv_occlusion_query/nv_test.h"

namespace conformance {
namespace {

class NvOrder : public NvTest {
  protected:
    static void begin_draw_end(GLuint name, int samples) {
        glBeginOcclusionQueryNV(name);
        draw_samples(samples);
        glEndOcclusionQueryNV();
    }
};

// Asks the last first, then down: once one says TRUE, no earlier one may say FALSE.
template <typename Available>
void expect_in_order(std::size_t queries, Available available) {
    bool later_is_available = false;
    for (int round = 0; round < 1000000 && !later_is_available; ++round) {
        for (std::size_t i = queries; i-- > 0;) {
            const bool here = available(i);
            ASSERT_TRUE(here || !later_is_available) << "query " << i;
            later_is_available = here;
        }
    }
    EXPECT_TRUE(later_is_available) << "the first query never became available";
}

// NV-38. NV 6.1.13: "It must always be true that if the result for one occlusion query is available, the
// result for all previous occlusion queries must also be available at that point in time."
TEST_F(NvOrder, when_a_query_is_available_all_earlier_ones_are) {
    std::array<GLuint, 100> names{};
    glGenOcclusionQueriesNV(names.size(), names.data());
    for (std::size_t i = 0; i < names.size(); ++i) begin_draw_end(names[i], static_cast<int>(i));
    expect_in_order(names.size(),
                    [&](std::size_t i) { return get_nv(names[i], GL_PIXEL_COUNT_AVAILABLE_NV) == GL_TRUE; });
    for (std::size_t i = 0; i < names.size(); ++i) EXPECT_EQ(get_nv(names[i], GL_PIXEL_COUNT_NV), i);
    glDeleteOcclusionQueriesNV(names.size(), names.data());
}

// NV-38. A wait for one count brings all earlier ones.
TEST_F(NvOrder, waiting_for_a_count_brings_all_earlier_ones) {
    std::array<GLuint, 10> names{};
    glGenOcclusionQueriesNV(names.size(), names.data());
    for (const GLuint name : names) begin_draw_end(name, 64);
    EXPECT_EQ(get_nv(names[7], GL_PIXEL_COUNT_NV), 64u);
    for (std::size_t i = 0; i < 8; ++i) {
        EXPECT_EQ(get_nv(names[i], GL_PIXEL_COUNT_AVAILABLE_NV), GLuint{GL_TRUE}) << i;
    }
    glDeleteOcclusionQueriesNV(names.size(), names.data());
}

// NV-38. ARB 6.1.13 has the same sentence of "all previous queries": the two kinds come in one order.
TEST_F(NvOrder, queries_of_both_extensions_come_in_one_order) {
    if (const auto why = lacks(15, "GL_ARB_occlusion_query")) GTEST_SKIP() << *why;
    std::array<GLuint, 100> names{};
    glGenQueries(names.size(), names.data());
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (i % 3 != 0) {
            begin_draw_end(names[i], static_cast<int>(i));
            continue;
        }
        glBeginQuery(GL_SAMPLES_PASSED, names[i]);
        draw_samples(static_cast<int>(i));
        glEndQuery(GL_SAMPLES_PASSED);
    }
    expect_in_order(names.size(), [&](std::size_t i) {
        if (i % 3 != 0) return get_nv(names[i], GL_PIXEL_COUNT_AVAILABLE_NV) == GL_TRUE;
        GLint available = -1;
        glGetQueryObjectiv(names[i], GL_QUERY_RESULT_AVAILABLE, &available);
        return available == GL_TRUE;
    });
    EXPECT_TRUE(no_error());
    glDeleteQueries(names.size(), names.data());
}

// NV-39. NV, issues: "Should there be a limit on how many queries can be outstanding? RESOLVED: No."
TEST_F(NvOrder, ten_thousand_queries_in_flight_are_each_right_in_any_order) {
    constexpr std::size_t kQueries = 10000;
    std::vector<GLuint> names(kQueries);
    glGenOcclusionQueriesNV(kQueries, names.data());
    for (std::size_t i = 0; i < kQueries; ++i) begin_draw_end(names[i], static_cast<int>(i % 67));
    // 6199 is prime to 10000: a fixed permutation that visits each once.
    for (std::size_t step = 0, i = 0; step < kQueries; ++step, i = (i + 6199) % kQueries) {
        ASSERT_EQ(get_nv(names[i], GL_PIXEL_COUNT_NV), i % 67) << "query " << i;
    }
    glDeleteOcclusionQueriesNV(kQueries, names.data());
}

// NV-39, NV-41. An object that is begun again in flight, among others.
TEST_F(NvOrder, re_using_an_object_in_flight_mixes_no_counts) {
    const NvQuery reused;
    const NvQuery before;
    const NvQuery between;
    begin_draw_end(before.name(), 1);
    begin_draw_end(reused.name(), 20);
    begin_draw_end(between.name(), 300);
    begin_draw_end(reused.name(), 4000);
    EXPECT_TRUE(no_error());
    EXPECT_EQ(between.result(), 300u);
    EXPECT_EQ(reused.result(), 4000u);
    EXPECT_EQ(before.result(), 1u);
}

// NV-39. Names deleted while their counts are pending disturb no other.
TEST_F(NvOrder, deleting_objects_in_flight_disturbs_no_other) {
    const NvQuery kept;
    for (int i = 0; i < 20; ++i) {
        begin_draw_end(kUnknownName, 7);
        if (i == 10) begin_draw_end(kept.name(), 33);
        glDeleteOcclusionQueriesNV(1, &kUnknownName);
    }
    EXPECT_EQ(kept.result(), 33u);
    EXPECT_FALSE(glIsOcclusionQueryNV(kUnknownName));
}

}  // namespace
}  // namespace conformance
