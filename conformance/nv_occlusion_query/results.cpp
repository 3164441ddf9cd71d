// SPDX-License-Identifier: MIT
// Reading the count: its value and its errors (NV-28 to NV-33, NV-40 to NV-42); availability.cpp has whether
// it is there.
#include "nv_occlusion_query/nv_test.h"

namespace conformance {
namespace {

class NvResults : public NvTest {};

// NV-28. NV 6.1.13: "If <pname> is PIXEL_COUNT_NV, then the occlusion query's pixel count result is placed in
// params." Each of the two waits by itself.
TEST_F(NvResults, both_gets_wait_for_the_number_of_fragments) {
    const NvQuery query;
    for (const int samples : {1, 63, 64, 1234, 4096}) {
        query.begin();
        draw_samples(samples);
        glEndOcclusionQueryNV();
        GLint integer = -1;
        glGetOcclusionQueryivNV(query.name(), GL_PIXEL_COUNT_NV, &integer);
        EXPECT_EQ(integer, samples);
        EXPECT_EQ(query.count([samples] { draw_samples(samples); }), static_cast<GLuint>(samples));
    }
}

// NV-29. NV 4.1.6A: "Whenever a fragment reaches this stage [...] the pixel counter is incremented."
TEST_F(NvResults, the_count_is_the_sum_over_all_draws) {
    clear();
    glEnable(GL_DEPTH_TEST);
    const NvQuery query;
    EXPECT_EQ(query.count([] {}), 0u);
    EXPECT_EQ(query.count([] {
        draw_rect({0, 0, 8, 8}, kMiddle);
        draw_rect({16, 16, 4, 4}, kMiddle);
    }),
              64u + 16u);
    EXPECT_EQ(query.count([] {
        draw_rect(kWhole, kFar);
        draw_rect(kWhole, kNear);  // over the first
        draw_rect(kWhole, kMiddle);
    }),
              2u * 4096u - 64u - 16u)
        << "passes twice but where the first query's rectangles stand before kFar";
}

// NV-30. NV 4.1.6A: "This pixel count result is initialized to zero when the object is created."
TEST_F(NvResults, a_new_object_has_counted_nothing) {
    draw_samples(500);
    const NvQuery query;
    query.begin();
    glEndOcclusionQueryNV();
    EXPECT_EQ(query.result(), 0u);
}

// NV-31. NV, Errors: INVALID_OPERATION "where id is the name of the currently active occlusion query."
TEST_F(NvResults, the_active_query_is_not_read) {
    const NvQuery query;
    EXPECT_EQ(query.count([&] {
        draw_samples(5);
        for (const GLenum parameter : {GL_PIXEL_COUNT_NV, GL_PIXEL_COUNT_AVAILABLE_NV}) {
            GLint integer = -1;
            EXPECT_EQ(get_nv(query.name(), parameter), kUntouched);
            EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
            glGetOcclusionQueryivNV(query.name(), parameter, &integer);
            EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
            EXPECT_EQ(integer, -1);
        }
    }),
              5u);
}

// NV-32. NV, Errors: INVALID_OPERATION "where id is not the name of an occlusion query." Deleted names:
// NvNames.a_deleted_name_is_unused.
TEST_F(NvResults, what_is_no_query_is_not_read) {
    const NvQuery generated;
    for (const GLuint name : {0u, kUnknownName, generated.name()}) {
        for (const GLenum parameter : {GL_PIXEL_COUNT_NV, GL_PIXEL_COUNT_AVAILABLE_NV}) {
            GLint integer = -1;
            EXPECT_EQ(get_nv(name, parameter), kUntouched);
            EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
            glGetOcclusionQueryivNV(name, parameter, &integer);
            EXPECT_TRUE(error_is(GL_INVALID_OPERATION));
            EXPECT_EQ(integer, -1);
        }
    }
}

// NV-33. NV, Errors: "INVALID_ENUM [...] where pname is not either PIXEL_COUNT_NV or
// PIXEL_COUNT_AVAILABLE_NV." What GetQueryObject takes beside the two is not taken.
TEST_F(NvResults, an_unknown_parameter_is_refused) {
    constexpr GLenum kResultNoWait = 0x9194;
    constexpr GLenum kQueryTarget = 0x82EA;
    const NvQuery query;
    EXPECT_EQ(query.count([] { draw_samples(5); }), 5u);
    for (const GLenum parameter : {GLenum{GL_PIXEL_COUNTER_BITS_NV}, GLenum{GL_CURRENT_OCCLUSION_QUERY_ID_NV},
                                   kResultNoWait, kQueryTarget, GLenum{0}}) {
        GLint integer = -1;
        EXPECT_EQ(get_nv(query.name(), parameter), kUntouched);
        EXPECT_TRUE(error_is(GL_INVALID_ENUM)) << parameter;
        glGetOcclusionQueryivNV(query.name(), parameter, &integer);
        EXPECT_TRUE(error_is(GL_INVALID_ENUM)) << parameter;
        EXPECT_EQ(integer, -1);
    }
    EXPECT_EQ(get_nv(kUnknownName, 0), kUntouched);
    const GLenum error = glGetError();
    EXPECT_TRUE(error == GL_INVALID_ENUM || error == GL_INVALID_OPERATION) << error_name(error);
    EXPECT_EQ(query.result(), 5u);
}

// NV-40. The count is state of the object: reading does not change it.
TEST_F(NvResults, reading_again_gives_the_same) {
    const NvQuery query;
    EXPECT_EQ(query.count([] { draw_samples(321); }), 321u);
    for (int i = 0; i < 10; ++i) EXPECT_EQ(query.result(), 321u);
}

// NV-41. NV 4.1.6A: End copies the counter "into the active occlusion query object's pixel count result":
// over what stood there.
TEST_F(NvResults, of_queries_on_one_object_the_last_one_counts) {
    const NvQuery query;
    for (const int samples : {500, 50, 5}) {
        query.begin();
        draw_samples(samples);
        glEndOcclusionQueryNV();
    }
    EXPECT_EQ(query.result(), 5u);
}

// NV-42. As above: what comes after the End is not in the copy.
TEST_F(NvResults, nothing_after_the_end_alters_the_count) {
    const NvQuery query;
    query.begin();
    draw_samples(55);
    glEndOcclusionQueryNV();
    draw_samples(99);
    clear();
    surface().swap();
    draw_samples(11);
    EXPECT_EQ(query.result(), 55u);
    draw_samples(22);
    EXPECT_EQ(query.result(), 55u);
}

}  // namespace
}  // namespace conformance
