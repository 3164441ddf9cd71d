// SPDX-License-Identifier: MIT
// Whether the count is there: by waiting, by polling, after a flush and after a finish (NV-30, NV-34 to
// NV-37).
#include <chrono>

#include "nv_occlusion_query/nv_test.h"

namespace conformance {
namespace {

class NvAvailability : public NvTest {};

// Polls until the count is there, or until no sane machine would still be working.
bool becomes_available(GLuint name) {
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    while (std::chrono::steady_clock::now() < deadline) {
        const GLuint available = get_nv(name, GL_PIXEL_COUNT_AVAILABLE_NV);
        EXPECT_TRUE(available == GL_TRUE || available == GL_FALSE) << available;
        if (available == GL_TRUE) return true;
    }
    return false;
}

// NV-34. NV 6.1.13: PIXEL_COUNT_AVAILABLE_NV "indicates whether or not such a wait would occur": once read,
// there is nothing left to wait for until the object is begun again.
TEST_F(NvAvailability, availability_comes_with_the_count_and_stays) {
    const NvQuery query;
    EXPECT_EQ(query.count([] { draw_samples(5); }), 5u);
    for (int i = 0; i < 100; ++i) {
        ASSERT_EQ(get_nv(query.name(), GL_PIXEL_COUNT_AVAILABLE_NV), GLuint{GL_TRUE}) << i;
        GLint integer = -1;
        glGetOcclusionQueryivNV(query.name(), GL_PIXEL_COUNT_AVAILABLE_NV, &integer);
        ASSERT_EQ(integer, GL_TRUE) << i;
        draw_samples(1);
        if (i % 10 == 0) surface().swap();
    }
}

// NV-34, of availability that polling found.
TEST_F(NvAvailability, availability_found_by_polling_stays) {
    const NvQuery query;
    query.begin();
    draw_samples(5);
    glEndOcclusionQueryNV();
    ASSERT_TRUE(becomes_available(query.name()));
    for (int i = 0; i < 100; ++i) {
        ASSERT_EQ(get_nv(query.name(), GL_PIXEL_COUNT_AVAILABLE_NV), GLuint{GL_TRUE}) << i;
        draw_samples(1);
    }
    EXPECT_EQ(query.result(), 5u);
}

// NV-35. GL 4.5, 2.3.2: Finish "does not return until all effects from all previously issued commands [...]
// are fully realized"; then no wait would occur.
TEST_F(NvAvailability, after_a_finish_the_count_is_available) {
    const NvQuery query;
    for (const int samples : {0, 5, 4096}) {
        query.begin();
        draw_samples(samples);
        glEndOcclusionQueryNV();
        glFinish();
        EXPECT_EQ(get_nv(query.name(), GL_PIXEL_COUNT_AVAILABLE_NV), GLuint{GL_TRUE}) << samples;
        EXPECT_EQ(query.result(), static_cast<GLuint>(samples));
    }
}

// NV-36. NV, issues: "if you use GL_PIXEL_COUNT_AVAILABLE_NV, you _must_ use glFlush, or your app may hang."
TEST_F(NvAvailability, after_a_flush_polling_brings_the_count) {
    const NvQuery query;
    for (const int samples : {5, 0, 4096}) {
        query.begin();
        draw_samples(samples);
        glEndOcclusionQueryNV();
        glFlush();
        EXPECT_TRUE(becomes_available(query.name()));
        EXPECT_EQ(query.result(), static_cast<GLuint>(samples));
    }
}

// NV-36. The text allows to wait for a flush for ever; decided: as ARB_occlusion_query 6.1.13, polling
// "forces that occlusion query to complete within a finite amount of time."
TEST_F(NvAvailability, polling_alone_brings_the_count) {
    const NvQuery query;
    for (const int samples : {5, 0, 4096}) {
        query.begin();
        draw_samples(samples);
        glEndOcclusionQueryNV();
        EXPECT_TRUE(becomes_available(query.name()));
        EXPECT_EQ(query.result(), static_cast<GLuint>(samples));
    }
}

// NV-37. NV, issues: "If you ask for the result, however, any flush required will be done automatically."
TEST_F(NvAvailability, reading_waits_and_needs_no_flush) {
    clear();
    glEnable(GL_DEPTH_TEST);
    const NvQuery query;
    const GLuint count = query.count([] {
        for (int i = 0; i < 200; ++i) draw_rect(kWhole, 0.9f - 0.004f * static_cast<float>(i));
    });
    EXPECT_EQ(count, 200u * 4096u);
}

// NV-30. A query around nothing has nothing to wait for in the end.
TEST_F(NvAvailability, a_query_around_nothing_becomes_available) {
    draw_samples(500);
    const NvQuery query;
    query.begin();
    glEndOcclusionQueryNV();
    EXPECT_TRUE(becomes_available(query.name()));
    EXPECT_EQ(query.result(), 0u);
}

}  // namespace
}  // namespace conformance
