// SPDX-License-Identifier: MIT
// Query objects by direct state access, their labels, and the boolean targets change what their texts say and
// no other gettable state.
#include <string>
#include <vector>

#include "harness/query.h"
#include "query_rows.h"
#include "state_test.h"

namespace tests {
namespace {

using conformance::draw_rect;
using conformance::kNear;
using conformance::kWhole;
using conformance::Query;

class ObjectCalls : public StateTest {
  protected:
    void SetUp() override {
        ASSERT_NO_FATAL_FAILURE(StateTest::SetUp());
        if (const auto why = conformance::lacks(15)) GTEST_SKIP() << *why;
        if (conformance::gl_version() >= 44) glBindBuffer(GL_QUERY_BUFFER, 0);
    }
};

std::string label_of(GLuint name) {
    char text[32] = {};
    glGetObjectLabel(GL_QUERY, name, sizeof text, nullptr, text);
    return text;
}

TEST_F(ObjectCalls, create_queries_makes_objects_and_changes_nothing_else) {
    if (const auto why = conformance::lacks(45, "GL_ARB_direct_state_access")) GTEST_SKIP() << *why;
    std::vector<GLenum> targets = {GL_SAMPLES_PASSED, GL_TIME_ELAPSED, GL_PRIMITIVES_GENERATED};
    if (!conformance::lacks(33, "GL_ARB_occlusion_query2")) targets.push_back(GL_ANY_SAMPLES_PASSED);
    if (!conformance::lacks(43, "GL_ARB_ES3_compatibility"))
        targets.push_back(GL_ANY_SAMPLES_PASSED_CONSERVATIVE);
    for (const GLenum target : targets) {
        SCOPED_TRACE(target);
        GLuint name = 0;
        expect_changes(objects(), [&] { glCreateQueries(target, 1, &name); });
        expect_changes(objects(), [&] { glDeleteQueries(1, &name); });
    }
    GLuint name = conformance::kUntouched;
    expect_refusal(GL_INVALID_ENUM, [&] { glCreateQueries(GL_TEXTURE_2D, 1, &name); });
    expect_refusal(GL_INVALID_VALUE, [&] { glCreateQueries(GL_SAMPLES_PASSED, -1, &name); });
    EXPECT_EQ(name, conformance::kUntouched);
}

TEST_F(ObjectCalls, boolean_queries_change_the_active_query_of_their_target) {
    const auto judge = [this](GLenum target, const char* name_of_target) {
        SCOPED_TRACE(name_of_target);
        const Query query(target);
        query.count([] {});
        const Rows is_active = {std::string("Query ") + name_of_target};
        expect_changes(is_active, [&] { query.begin(); });
        expect_nothing([] { draw_rect(kWhole, kNear); });
        expect_changes(is_active, [&] { query.end(); });
        expect_changes_with_error_pending(is_active, [&] { query.begin(); });
        expect_changes_with_error_pending(is_active, [&] { query.end(); });
        expect_nothing([&] { query.result(); });
    };
    if (const auto why = conformance::lacks(33, "GL_ARB_occlusion_query2")) GTEST_SKIP() << *why;
    judge(GL_ANY_SAMPLES_PASSED, "GL_ANY_SAMPLES_PASSED");
    if (const auto why = conformance::lacks(43, "GL_ARB_ES3_compatibility")) GTEST_SKIP() << *why;
    judge(GL_ANY_SAMPLES_PASSED_CONSERVATIVE, "GL_ANY_SAMPLES_PASSED_CONSERVATIVE");
}

TEST_F(ObjectCalls, labels_change_nothing_else_and_outlive_queries) {
    if (const auto why = conformance::lacks(43, "GL_KHR_debug")) GTEST_SKIP() << *why;
    const Query query;
    query.count([] {});
    expect_nothing([&] { glObjectLabel(GL_QUERY, query.name(), -1, "a wall"); });
    EXPECT_EQ(label_of(query.name()), "a wall");
    query.count([] { draw_rect(kWhole, kNear); });
    EXPECT_EQ(query.result(), kPixelsOfWhole);
    expect_nothing([&] { label_of(query.name()); });
    EXPECT_EQ(label_of(query.name()), "a wall");
    expect_refusal(GL_INVALID_VALUE, [] { glObjectLabel(GL_QUERY, 0x7000, -1, "nobody"); });
    expect_nothing([&] { glObjectLabel(GL_QUERY, query.name(), 0, nullptr); });
    EXPECT_EQ(label_of(query.name()), "");
}

TEST_F(ObjectCalls, labels_stay_where_the_hp_test_draws_and_reads) {
    if (const auto why = conformance::lacks("GL_HP_occlusion_test")) GTEST_SKIP() << *why;
    if (const auto why = conformance::lacks(43, "GL_KHR_debug")) GTEST_SKIP() << *why;
    const Query query;
    query.count([] {});
    glObjectLabel(GL_QUERY, query.name(), -1, "a wall");
    glEnable(GL_OCCLUSION_TEST_HP);
    draw_rect(kWhole, kNear);
    query.begin();
    draw_rect(kWhole, kNear);
    conformance::get_integer(GL_OCCLUSION_TEST_RESULT_HP);  // ends the program's query and begins it again
    query.end();
    glDisable(GL_OCCLUSION_TEST_HP);
    EXPECT_EQ(label_of(query.name()), "a wall");
}

}  // namespace
}  // namespace tests
