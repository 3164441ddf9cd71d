// SPDX-License-Identifier: MIT
// How each counter is asked.
#include "counting/counters.h"

#include <algorithm>
#include <limits>

namespace conformance {

namespace {

std::optional<std::string> lacks_hp() {
    return lacks("GL_HP_occlusion_test");
}

std::optional<std::string> lacks_nv() {
    return lacks("GL_NV_occlusion_query");
}

std::optional<std::string> lacks_samples() {
    return lacks(15, "GL_ARB_occlusion_query");
}

std::optional<std::string> lacks_any() {
    return lacks(33, "GL_ARB_occlusion_query2");
}

std::optional<std::string> lacks_conservative() {
    return lacks(43, "GL_ARB_ES3_compatibility");
}

// The largest number of <bits> bits, as far as a Get of so many bits can return it.
std::uint64_t largest_of(GLint bits, int bits_of_get) {
    const int width = std::min(bits, bits_of_get);
    return width >= 64 ? std::numeric_limits<std::uint64_t>::max() : (std::uint64_t{1} << width) - 1;
}

std::uint64_t largest_boolean() {
    return 1;
}

std::uint64_t largest_nv_count() {
    return largest_of(get_integer(GL_PIXEL_COUNTER_BITS_NV), 32);
}

std::uint64_t largest_samples() {
    GLint bits = 0;
    glGetQueryiv(GL_SAMPLES_PASSED, GL_QUERY_COUNTER_BITS, &bits);
    return largest_of(bits, lacks(33, "GL_ARB_timer_query") ? 32 : 64);
}

std::uint64_t hp_flag(const Draw& draw) {
    GLboolean result = GL_FALSE;
    glGetBooleanv(GL_OCCLUSION_TEST_RESULT_HP, &result);  // clears what earlier draws left
    glEnable(GL_OCCLUSION_TEST_HP);
    draw();
    glDisable(GL_OCCLUSION_TEST_HP);
    result = 0xAA;  // a Get that writes nothing is seen
    glGetBooleanv(GL_OCCLUSION_TEST_RESULT_HP, &result);
    return result;
}

std::uint64_t nv_count(const Draw& draw) {
    const auto gen = function<PFNGLGENOCCLUSIONQUERIESNVPROC>("glGenOcclusionQueriesNV");
    const auto begin = function<PFNGLBEGINOCCLUSIONQUERYNVPROC>("glBeginOcclusionQueryNV");
    const auto end = function<PFNGLENDOCCLUSIONQUERYNVPROC>("glEndOcclusionQueryNV");
    const auto get = function<PFNGLGETOCCLUSIONQUERYUIVNVPROC>("glGetOcclusionQueryuivNV");
    const auto remove = function<PFNGLDELETEOCCLUSIONQUERIESNVPROC>("glDeleteOcclusionQueriesNV");
    GLuint name = 0;
    gen(1, &name);
    begin(name);
    draw();
    end();
    GLuint pixels = kUntouched;
    get(name, GL_PIXEL_COUNT_NV, &pixels);
    remove(1, &name);
    return pixels;
}

template <GLenum target>
std::uint64_t query_object(const Draw& draw) {
    const Query query(target);
    const GLuint narrow = query.count(draw);
    if (lacks(33, "GL_ARB_timer_query")) return narrow;
    GLuint64 wide = kUntouched;
    glGetQueryObjectui64v(query.name(), GL_QUERY_RESULT, &wide);
    return wide;
}

}  // namespace

const std::array<Counter, 5> kCounters = {{
    {"hp_flag", true, false, lacks_hp, largest_boolean, hp_flag},
    {"nv_count", false, false, lacks_nv, largest_nv_count, nv_count},
    {"samples", false, false, lacks_samples, largest_samples, query_object<GL_SAMPLES_PASSED>},
    {"any", true, false, lacks_any, largest_boolean, query_object<GL_ANY_SAMPLES_PASSED>},
    {"any_conservative", true, true, lacks_conservative, largest_boolean,
     query_object<GL_ANY_SAMPLES_PASSED_CONSERVATIVE>},
}};

std::string counter_name(const ::testing::TestParamInfo<Counter>& info) {
    return info.param.name;
}

std::ostream& operator<<(std::ostream& out, const Counter& counter) {
    return out << counter.name;
}

bool agrees(const Counter& counter, std::uint64_t value, std::initializer_list<std::uint64_t> samples) {
    return std::ranges::any_of(samples, [&](std::uint64_t passed) {
        if (!counter.is_boolean) return value == std::min(passed, counter.largest());
        return value == (passed > 0) || (counter.is_conservative && value == 1);
    });
}

void CountingTest::SetUp() {
    ASSERT_NO_FATAL_FAILURE(GlTest::SetUp());
    if (const auto why = GetParam().lack()) GTEST_SKIP() << *why;
}

void CountingTest::expect_one_of(std::initializer_list<std::uint64_t> samples, const Draw& draw) {
    const std::uint64_t value = count(draw);
    EXPECT_TRUE(agrees(GetParam(), value, samples))
        << GetParam() << " says " << value << ", but so many passed: " << ::testing::PrintToString(samples);
    EXPECT_TRUE(no_error());
}

}  // namespace conformance
