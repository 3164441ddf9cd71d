// SPDX-License-Identifier: MIT
// Every call that waits for a result returns when it is due, never before.
#include <functional>
#include <string>
#include <vector>

#include "latency.h"
#include "old_commands.h"

namespace clock_tests {
namespace {

using conformance::has_extension;
using conformance::lacks;
using conformance::Query;

class Waiting : public ClockTest {
  protected:
    void SetUp() override {
        ASSERT_NO_FATAL_FAILURE(ClockTest::SetUp());
        draw_visible();  // compiles
        glFinish();
    }

    static GLuint is_available(GLuint query) {
        GLuint available = GL_FALSE;
        glGetQueryObjectuiv(query, GL_QUERY_RESULT_AVAILABLE, &available);
        return available;
    }
};

TEST_F(Waiting, every_read_of_a_query_object_returns_when_its_result_is_due) {
    struct Read {
        const char* name;
        std::function<GLint64(GLuint)> read;
    };
    const auto reading = [](auto get, auto value) {
        return [get, value](GLuint query) mutable {
            get(query, GL_QUERY_RESULT, &value);
            return static_cast<GLint64>(value);
        };
    };
    std::vector<Read> reads = {{"iv", reading(glGetQueryObjectiv, GLint{})},
                               {"uiv", reading(glGetQueryObjectuiv, GLuint{})}};
    if (!lacks(33, "GL_ARB_timer_query")) {
        reads.push_back({"i64v", reading(glGetQueryObjecti64v, GLint64{})});
        reads.push_back({"ui64v", reading(glGetQueryObjectui64v, GLuint64{})});
    }
    for (const GLenum target :
         {GL_SAMPLES_PASSED, GL_ANY_SAMPLES_PASSED, GL_ANY_SAMPLES_PASSED_CONSERVATIVE}) {
        if (target == GL_ANY_SAMPLES_PASSED && lacks(33, "GL_ARB_occlusion_query2")) continue;
        if (target == GL_ANY_SAMPLES_PASSED_CONSERVATIVE && lacks(43, "GL_ARB_ES3_compatibility")) continue;
        for (const Read& read : reads) {
            const Query query(target);
            query.begin();
            draw_visible();
            const Moment end = now();
            query.end();
            EXPECT_EQ(read.read(query.name()), target == GL_SAMPLES_PASSED ? 64 : 1) << read.name;
            EXPECT_TRUE(is_not_early(end, now())) << read.name;
            EXPECT_EQ(is_available(query.name()), GLuint{GL_TRUE}) << read.name;
        }
    }
}

TEST_F(Waiting, every_read_of_an_nv_query_returns_when_its_count_is_due) {
    if (const auto why = lacks("GL_NV_occlusion_query")) GTEST_SKIP() << *why;
    const NvCommands nv;
    GLuint name = 0;
    nv.generate(1, &name);
    for (const bool is_unsigned : {false, true}) {
        nv.begin(name);
        draw_visible();
        const Moment end = now();
        nv.end();
        GLint count = -1;
        GLuint unsigned_count = conformance::kUntouched;
        if (is_unsigned) {
            nv.get_unsigned(name, GL_PIXEL_COUNT_NV, &unsigned_count);
        } else {
            nv.get(name, GL_PIXEL_COUNT_NV, &count);
        }
        EXPECT_TRUE(is_not_early(end, now()));
        EXPECT_EQ(is_unsigned ? unsigned_count : static_cast<GLuint>(count), 64u);
        GLuint available = GL_FALSE;
        nv.get_unsigned(name, GL_PIXEL_COUNT_AVAILABLE_NV, &available);
        EXPECT_EQ(available, GLuint{GL_TRUE});
    }
    nv.remove(1, &name);
}

TEST_F(Waiting, every_read_of_the_hp_flag_returns_when_it_is_due) {
    if (const auto why = lacks("GL_HP_occlusion_test")) GTEST_SKIP() << *why;
    const auto reading = [](auto get, auto value) {
        return [get, value]() mutable {
            get(kOcclusionTestResult, &value);
            return value != 0;
        };
    };
    std::vector<std::function<bool()>> reads = {
        reading(glGetBooleanv, GLboolean{}), reading(glGetIntegerv, GLint{}), reading(glGetFloatv, GLfloat{}),
        reading(glGetDoublev, GLdouble{})};
    if (!lacks(32)) reads.emplace_back(reading(glGetInteger64v, GLint64{}));
    glEnable(kOcclusionTest);
    for (const auto& read : reads) {
        const Moment drawn = now();
        draw_visible();
        EXPECT_TRUE(read());
        EXPECT_TRUE(is_not_early(drawn, now()));
        EXPECT_FALSE(read()) << "read and cleared";
    }
}

// GL 4.5, 2.3.2: Finish "does not return until all effects from all previously issued commands [...] are
// fully realized".
TEST_F(Waiting, finish_returns_when_everything_is_due) {
    std::vector<std::unique_ptr<Query>> queries;
    for (int i = 0; i < 10; ++i) {
        queries.push_back(std::make_unique<Query>());
        queries.back()->begin();
        draw_visible();
        if (i < 9) queries.back()->end();
    }
    const Moment end = now();
    queries.back()->end();
    glFinish();
    EXPECT_TRUE(is_not_early(end, now()));
    for (const auto& query : queries) EXPECT_EQ(is_available(query->name()), GLuint{GL_TRUE});
}

TEST_F(Waiting, a_late_read_does_not_wait_again) {
    const Query query;
    query.begin();
    draw_visible();
    query.end();
    EXPECT_EQ(query.result(), 64u);
    const Moment before = now();
    for (int i = 0; i < 100; ++i) EXPECT_EQ(query.result(), 64u);
    const auto taken = std::chrono::duration_cast<std::chrono::microseconds>(now() - before).count();
    if (latency().kind == Latency::kWall) {
        EXPECT_LT(taken, 50 * static_cast<std::int64_t>(latency().amount)) << "a hundred reads waited again";
    }
}

}  // namespace
}  // namespace clock_tests
