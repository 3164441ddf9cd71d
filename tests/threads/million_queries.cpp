// SPDX-License-Identifier: MIT
// A million queries of each kind leave the layer, to some bytes, and the process no larger than the first
// hundred thousand did.
//
// Nothing is drawn, or only what lies outside the window: a query takes the layer's whole way and a driver's
// slot, and no time for pixels.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <cstring>
#include <functional>

#include "layer_memory.h"
#include "thread_context.h"

// After glext.h with its prototypes, which it includes without.
#include <GL/glext_emu.h>

namespace threads {
namespace {

constexpr int kQueries = 1'000'000;
constexpr int kWarmUp = 250'000;  // bare Mesa grows by 16 MiB in the first 200,000 draws
constexpr long long kMostLayerBytes =
    1024;  // containers that have settled; a leak is a million times its size
// What the driver holds for the layer, such as names that nobody deletes, grows by 100 bytes a query or more.
// It also holds the vertices of scenes that are not drawn yet, 512 KiB each: three more than before have been
// seen.
constexpr long kMostGrowthKib = 4096;

long resident_kib() {
    long total = 0;
    long resident = -1;
    if (std::FILE* const file = std::fopen("/proc/self/statm", "r")) {
        if (std::fscanf(file, "%ld %ld", &total, &resident) != 2) resident = -1;
        std::fclose(file);
    }
    return resident * (sysconf(_SC_PAGESIZE) / 1024);
}

void expect_no_growth(const std::function<void()>& query) {
    const bool has_layer = watch_layer_memory();
    for (int i = 0; i < kWarmUp; ++i) query();
    const long before_kib = resident_kib();
    const long long before_bytes = layer_bytes();
    ASSERT_GT(before_kib, 0);
    for (int i = 0; i < kQueries; ++i) query();
    const long growth_kib = resident_kib() - before_kib;
    const long long growth_bytes = layer_bytes() - before_bytes;
    std::printf("%d queries: %ld KiB resident before, %+ld KiB", kQueries, before_kib, growth_kib);
    if (has_layer) std::printf("; the layer %+lld bytes", growth_bytes);
    std::printf("\n");
    EXPECT_LE(growth_kib, kMostGrowthKib);
    EXPECT_LE(growth_bytes, kMostLayerBytes);
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

class MillionQueries : public ::testing::Test {
  protected:
    MillionQueries() { context_.make_current(); }
    ~MillionQueries() override { ThreadContext::release(); }

  private:
    ThreadContext context_;
};

bool has(const char* extension) {
    return std::strstr(reinterpret_cast<const char*>(glGetString(GL_EXTENSIONS)), extension) != nullptr;
}

void expect_zero(GLuint result) {
    if (result != 0) ADD_FAILURE() << "counted " << result << " samples of nothing";
}

TEST_F(MillionQueries, by_arb_on_one_name) {
    GLuint name = 0;
    glGenQueries(1, &name);
    expect_no_growth([name] {
        GLuint result = 1;
        glBeginQuery(GL_SAMPLES_PASSED, name);
        glEndQuery(GL_SAMPLES_PASSED);
        glGetQueryObjectuiv(name, GL_QUERY_RESULT, &result);
        expect_zero(result);
    });
}

// Four in flight at any time, as a culler's: the answers are read in order.
TEST_F(MillionQueries, by_any_samples_with_four_in_flight) {
    GLuint names[4] = {};
    glGenQueries(4, names);
    for (const GLuint name : names) {
        glBeginQuery(GL_ANY_SAMPLES_PASSED, name);
        glEndQuery(GL_ANY_SAMPLES_PASSED);
    }
    unsigned next = 0;
    expect_no_growth([&] {
        const GLuint name = names[next++ % 4];
        GLuint result = 1;
        glGetQueryObjectuiv(name, GL_QUERY_RESULT, &result);
        glBeginQuery(GL_ANY_SAMPLES_PASSED, name);
        glEndQuery(GL_ANY_SAMPLES_PASSED);
        expect_zero(result);
    });
}

TEST_F(MillionQueries, by_nv_on_names_of_their_own) {
    if (!has("GL_NV_occlusion_query")) GTEST_SKIP() << "no GL_NV_occlusion_query";
    expect_no_growth([] {
        GLuint name = 0;
        GLuint result = 1;
        glGenOcclusionQueriesNV(1, &name);
        glBeginOcclusionQueryNV(name);
        glEndOcclusionQueryNV();
        glGetOcclusionQueryuivNV(name, GL_PIXEL_COUNT_NV, &result);
        glDeleteOcclusionQueriesNV(1, &name);
        expect_zero(result);
    });
}

TEST_F(MillionQueries, by_the_hp_test) {
    if (!has("GL_HP_occlusion_test")) GTEST_SKIP() << "no GL_HP_occlusion_test";
    glEnable(GL_OCCLUSION_TEST_HP);
    expect_no_growth([] {
        glBegin(GL_POINTS);
        glVertex2f(9, 9);
        glEnd();
        GLboolean result = GL_TRUE;
        glGetBooleanv(GL_OCCLUSION_TEST_RESULT_HP, &result);
        expect_zero(result);
    });
}

// Of the unit, a query around a point outside the window; its record is read before the next.
TEST_F(MillionQueries, by_the_occlusion_unit) {
    if (!has("GL_EMU_occlusion_unit")) GTEST_SKIP() << "no GL_EMU_occlusion_unit";
    const auto begin =
        reinterpret_cast<PFNGLBEGINOCCLUSIONUNITEMUPROC>(eglGetProcAddress("glBeginOcclusionUnitEMU"));
    const auto end =
        reinterpret_cast<PFNGLENDOCCLUSIONUNITEMUPROC>(eglGetProcAddress("glEndOcclusionUnitEMU"));
    GLuint name = 0;
    glGenQueries(1, &name);
    expect_no_growth([begin, end, name] {
        begin(GL_VISIBLE_HITS_BIT_EMU, name);
        glBegin(GL_POINTS);
        glVertex2f(9, 9);
        glEnd();
        end();
        GLuint result = 1;
        glGetQueryObjectuiv(name, GL_VISIBLE_HITS_EMU, &result);
        expect_zero(result);
    });
}

}  // namespace
}  // namespace threads
