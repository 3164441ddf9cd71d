// SPDX-License-Identifier: MIT
// Each call of GL_NV_occlusion_query changes what its text says and no other gettable state, with and without
// the HP test beside it.
#include "harness/draw.h"
#include "harness/query.h"
#include "query_rows.h"
#include "state_test.h"

namespace tests {
namespace {

using conformance::draw_rect;
using conformance::kNear;
using conformance::kUntouched;
using conformance::kWhole;

class NvCalls : public StateTest {
  protected:
    void SetUp() override {
        ASSERT_NO_FATAL_FAILURE(StateTest::SetUp());
        if (const auto why = conformance::lacks("GL_NV_occlusion_query")) GTEST_SKIP() << *why;
        glGenOcclusionQueriesNV(2, names_);
    }

    GLuint name() const { return names_[0]; }
    GLuint other() const { return names_[1]; }
    void begin() const { glBeginOcclusionQueryNV(name()); }
    static void end() { glEndOcclusionQueryNV(); }
    GLuint get(GLenum parameter) const {
        GLuint value = kUntouched;
        glGetOcclusionQueryuivNV(name(), parameter, &value);
        return value;
    }

  private:
    GLuint names_[2] = {};
};

const char* const kTarget = "GL_SAMPLES_PASSED";  // what an NV query is to the later texts

TEST_F(NvCalls, names_change_nothing_until_they_are_begun) {
    GLuint fresh = 0;
    expect_nothing([&] { glGenOcclusionQueriesNV(1, &fresh); });
    expect_nothing([&] { glIsOcclusionQueryNV(fresh); });
    expect_nothing([&] { glDeleteOcclusionQueriesNV(1, &fresh); });
}

TEST_F(NvCalls, begin_and_end_change_the_active_query) {
    expect_changes(objects() + active(kTarget), [this] { begin(); });
    expect_nothing([] { draw_rect(kWhole, kNear); });
    expect_changes(active(kTarget), end);
    expect_changes_with_error_pending(active(kTarget), [this] { begin(); });
    expect_changes_with_error_pending(active(kTarget), end);
    EXPECT_EQ(get(GL_PIXEL_COUNT_NV), 0u);
}

TEST_F(NvCalls, polling_and_reading_change_nothing) {
    begin();
    draw_rect(kWhole, kNear);
    end();
    expect_nothing([this] { get(GL_PIXEL_COUNT_AVAILABLE_NV); });
    expect_nothing([this] { get(GL_PIXEL_COUNT_NV); });
    expect_nothing([this] {
        GLint value = 0;
        glGetOcclusionQueryivNV(name(), GL_PIXEL_COUNT_NV, &value);
    });
    expect_nothing([this] {
        begin();
        draw_rect(kWhole, kNear);
        end();
        while (get(GL_PIXEL_COUNT_AVAILABLE_NV) == GL_FALSE) {
        }
        get(GL_PIXEL_COUNT_NV);
    });
}

TEST_F(NvCalls, deleting_changes_the_name_alone) {
    begin();
    draw_rect(kWhole, kNear);
    end();
    expect_changes(objects(), [this] {
        const GLuint gone = name();
        glDeleteOcclusionQueriesNV(1, &gone);
    });
}

TEST_F(NvCalls, refused_calls_change_nothing) {
    expect_refusal(GL_INVALID_OPERATION, end);
    expect_refusal(GL_INVALID_OPERATION, [] { glBeginOcclusionQueryNV(0); });
    expect_refusal(GL_INVALID_OPERATION, [this] { get(GL_PIXEL_COUNT_NV); });  // no object yet
    begin();
    GLuint unused = kUntouched;
    expect_refusal(GL_INVALID_OPERATION, [this] { glBeginOcclusionQueryNV(other()); });
    expect_refusal(GL_INVALID_OPERATION, [&] { glGenOcclusionQueriesNV(1, &unused); });
    expect_refusal(GL_INVALID_OPERATION, [this] {
        const GLuint gone = other();
        glDeleteOcclusionQueriesNV(1, &gone);
    });
    expect_refusal(GL_INVALID_OPERATION, [this] { get(GL_PIXEL_COUNT_NV); });
    end();
    EXPECT_EQ(unused, kUntouched);
    expect_refusal(GL_INVALID_ENUM, [this] { get(GL_TEXTURE_2D); });
}

TEST_F(NvCalls, compiled_queries_change_nothing_until_they_are_called) {
    const GLuint list = glGenLists(1);
    glNewList(list, GL_COMPILE);
    glEndList();
    expect_nothing([&] {
        glNewList(list, GL_COMPILE);
        begin();
        draw_rect(kWhole, kNear);
        end();
        glEndList();
    });
    expect_changes(objects(), [&] { glCallList(list); });
    expect_nothing([&] { glCallList(list); });
}

TEST_F(NvCalls, the_active_query_is_in_no_attribute_group) {
    const Rows depth = number("GL_ATTRIB_STACK_DEPTH");
    begin();
    end();
    expect_changes(depth, [] { glPushAttrib(GL_ALL_ATTRIB_BITS); });
    begin();
    expect_changes(depth, [] { glPopAttrib(); });
    draw_rect(kWhole, kNear);
    expect_changes(active(kTarget), end);
    EXPECT_EQ(get(GL_PIXEL_COUNT_NV), kPixelsOfWhole);
}

TEST_F(NvCalls, the_hp_test_and_a_query_leave_each_others_state) {
    if (const auto why = conformance::lacks("GL_HP_occlusion_test")) GTEST_SKIP() << *why;
    const Rows enable = enable_of("GL_OCCLUSION_TEST_HP");
    begin();
    end();
    expect_changes(enable, [] { glEnable(GL_OCCLUSION_TEST_HP); });
    draw_rect(kWhole, kNear);
    expect_changes(active(kTarget), [this] { begin(); });
    expect_nothing([] { draw_rect(kWhole, kNear); });
    expect_nothing([] { conformance::get_integer(GL_OCCLUSION_TEST_RESULT_HP); });
    expect_changes(enable, [] { glDisable(GL_OCCLUSION_TEST_HP); });
    expect_changes(active(kTarget), end);
}

}  // namespace
}  // namespace tests
