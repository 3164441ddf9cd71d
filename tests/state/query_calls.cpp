// SPDX-License-Identifier: MIT
// Each call on query objects changes what its text says and no other gettable state, delayed or not, with and
// without the HP test beside it.
#include "harness/query.h"
#include "query_rows.h"
#include "state_test.h"

namespace tests {
namespace {

using conformance::draw_rect;
using conformance::kNear;
using conformance::kWhole;
using conformance::Query;

class QueryCalls : public StateTest {
  protected:
    void SetUp() override {
        ASSERT_NO_FATAL_FAILURE(StateTest::SetUp());
        if (const auto why = conformance::lacks(15)) GTEST_SKIP() << *why;
        has_test_ = conformance::has_extension("GL_HP_occlusion_test");
        if (conformance::gl_version() >= 44) glBindBuffer(GL_QUERY_BUFFER, 0);  // it would take the results
    }

    // Runs <judge> with the HP test disabled and, where there is one, enabled with something counted already.
    void with_and_without_test(const std::function<void()>& judge) const {
        judge();
        if (!has_test_) return;
        SCOPED_TRACE("under the HP test");
        glEnable(GL_OCCLUSION_TEST_HP);
        draw_rect(kWhole, kNear);
        judge();
        glDisable(GL_OCCLUSION_TEST_HP);
    }

  private:
    bool has_test_ = false;
};

GLuint get_object(const Query& query, GLenum parameter) {
    GLuint value = conformance::kUntouched;
    glGetQueryObjectuiv(query.name(), parameter, &value);
    return value;
}

TEST_F(QueryCalls, names_change_nothing_until_they_are_begun) {
    GLuint name = 0;
    expect_nothing([&] { glGenQueries(1, &name); });
    expect_nothing([&] { glDeleteQueries(1, &name); });
}

TEST_F(QueryCalls, begin_and_end_change_the_active_query) {
    with_and_without_test([this] {
        const Query query;
        expect_changes(objects() + active("GL_SAMPLES_PASSED"), [&] { query.begin(); });
        expect_nothing([] { draw_rect(kWhole, kNear); });
        expect_changes(active("GL_SAMPLES_PASSED"), [&] { query.end(); });
        expect_changes_with_error_pending(active("GL_SAMPLES_PASSED"), [&] { query.begin(); });
        expect_changes_with_error_pending(active("GL_SAMPLES_PASSED"), [&] { query.end(); });
        EXPECT_EQ(query.result(), 0u);
    });
}

TEST_F(QueryCalls, polling_and_reading_change_nothing) {
    with_and_without_test([this] {
        const Query query;
        query.begin();
        draw_rect({2, 3, 8, 8}, kNear);
        query.end();
        expect_nothing([&] { get_object(query, GL_QUERY_RESULT_AVAILABLE); });
        expect_nothing([&] { get_object(query, GL_QUERY_RESULT); });
        expect_nothing([&] { get_object(query, GL_QUERY_RESULT_AVAILABLE); });
        expect_nothing([&] {
            query.begin();
            draw_rect(kWhole, kNear);
            query.end();
            while (get_object(query, GL_QUERY_RESULT_AVAILABLE) == GL_FALSE) {
            }
            query.result();
        });
    });
}

TEST_F(QueryCalls, deleting_changes_the_name_alone) {
    with_and_without_test([this] {
        GLuint name = 0;
        glGenQueries(1, &name);
        glBeginQuery(GL_SAMPLES_PASSED, name);
        draw_rect(kWhole, kNear);
        glEndQuery(GL_SAMPLES_PASSED);
        expect_changes(objects(), [&] { glDeleteQueries(1, &name); });
    });
}

TEST_F(QueryCalls, refused_calls_change_nothing) {
    with_and_without_test([this] {
        const Query query;
        const Query other;
        query.count([&] {
            expect_refusal(GL_INVALID_OPERATION, [&] { other.begin(); });
            expect_refusal(GL_INVALID_OPERATION, [&] { get_object(query, GL_QUERY_RESULT); });
        });
        expect_refusal(GL_INVALID_OPERATION, [&] { query.end(); });
        expect_refusal(GL_INVALID_OPERATION, [] { glBeginQuery(GL_SAMPLES_PASSED, 0); });
        expect_refusal(GL_INVALID_ENUM, [&] { glBeginQuery(GL_TEXTURE_2D, query.name()); });
        expect_refusal(GL_INVALID_ENUM, [&] { get_object(query, GL_TEXTURE_2D); });
    });
}

TEST_F(QueryCalls, compiled_queries_change_nothing_until_they_are_called) {
    with_and_without_test([this] {
        const Query query;
        const GLuint list = glGenLists(1);
        glNewList(list, GL_COMPILE);
        glEndList();
        const auto compile = [&] {
            glNewList(list, GL_COMPILE);
            query.begin();
            draw_rect(kWhole, kNear);
            query.end();
            glEndList();
        };
        expect_nothing(compile);
        expect_changes(objects(), [&] { glCallList(list); });
        expect_nothing([&] { glCallList(list); });
        query.result();
        glDeleteLists(list, 1);
    });
}

TEST_F(QueryCalls, conditional_rendering_changes_nothing_gettable) {
    if (const auto why = conformance::lacks(30)) GTEST_SKIP() << *why;
    with_and_without_test([this] {
        const Query query;
        query.count([] {});
        expect_nothing([&] {
            glBeginConditionalRender(query.name(), GL_QUERY_WAIT);
            draw_rect(kWhole, kNear);
            glEndConditionalRender();
        });
    });
}

TEST_F(QueryCalls, a_query_across_the_tests_enable_keeps_all_state) {
    if (const auto why = conformance::lacks("GL_HP_occlusion_test")) GTEST_SKIP() << *why;
    const Query query;
    const Rows enable = enable_of("GL_OCCLUSION_TEST_HP");
    query.begin();
    expect_changes(enable, [] { glEnable(GL_OCCLUSION_TEST_HP); });
    expect_nothing([] { draw_rect(kWhole, kNear); });
    expect_nothing([] { conformance::get_integer(GL_OCCLUSION_TEST_RESULT_HP); });
    expect_changes(active("GL_SAMPLES_PASSED"), [&] { query.end(); });
    expect_changes(enable, [] { glDisable(GL_OCCLUSION_TEST_HP); });
}

}  // namespace
}  // namespace tests
