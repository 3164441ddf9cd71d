// SPDX-License-Identifier: MIT
// Conditional rendering changes no gettable state, whether it draws or discards, in every mode, delayed or
// not, and refused or not.
#include <vector>

#include "harness/query.h"
#include "state_test.h"

namespace tests {
namespace {

using conformance::draw_rect;
using conformance::kNear;
using conformance::kWhole;
using conformance::Query;

class ConditionalCalls : public StateTest {
  protected:
    void SetUp() override {
        ASSERT_NO_FATAL_FAILURE(StateTest::SetUp());
        if (const auto why = conformance::lacks(30)) GTEST_SKIP() << *why;
        if (conformance::gl_version() >= 44) glBindBuffer(GL_QUERY_BUFFER, 0);  // it would take the results
        passed_.count([] { draw_rect(kWhole, kNear); });
        failed_.count([] {});
    }
    void TearDown() override {
        glDeleteQueries(1, &generated_);
        StateTest::TearDown();
    }

    static std::vector<GLenum> modes() {
        std::vector<GLenum> all = {GL_QUERY_WAIT, GL_QUERY_NO_WAIT, GL_QUERY_BY_REGION_WAIT,
                                   GL_QUERY_BY_REGION_NO_WAIT};
        if (!conformance::lacks(45, "GL_ARB_conditional_render_inverted")) {
            all.insert(all.end(), {GL_QUERY_WAIT_INVERTED, GL_QUERY_NO_WAIT_INVERTED,
                                   GL_QUERY_BY_REGION_WAIT_INVERTED, GL_QUERY_BY_REGION_NO_WAIT_INVERTED});
        }
        return all;
    }

    GLuint passed() const { return passed_.name(); }
    GLuint failed() const { return failed_.name(); }
    GLuint generated() {
        if (generated_ == 0) glGenQueries(1, &generated_);
        return generated_;
    }

  private:
    struct Kept {  // made in SetUp, where there is a context
        GLuint made = 0;
        GLuint name() const { return made; }
        template <typename Draw>
        void count(Draw draw) {
            glGenQueries(1, &made);
            glBeginQuery(GL_SAMPLES_PASSED, made);
            draw();
            glEndQuery(GL_SAMPLES_PASSED);
        }
    };

    Kept passed_, failed_;
    GLuint generated_ = 0;
};

TEST_F(ConditionalCalls, a_block_changes_nothing_in_any_mode_whether_it_draws_or_not) {
    for (const GLenum mode : modes()) {
        for (const GLuint name : {passed(), failed()}) {
            SCOPED_TRACE(testing::Message() << "mode " << mode << ", object " << name);
            expect_nothing([=] {
                glBeginConditionalRender(name, mode);
                draw_rect(kWhole, kNear);
                glEndConditionalRender();
            });
        }
    }
}

TEST_F(ConditionalCalls, each_call_of_a_block_changes_nothing) {
    expect_changes({}, [this] { glBeginConditionalRender(failed(), GL_QUERY_WAIT); });
    expect_nothing([] { draw_rect(kWhole, kNear); });
    expect_nothing([] { glClear(GL_COLOR_BUFFER_BIT); });
    expect_changes_with_error_pending({}, [] { glEndConditionalRender(); });
}

TEST_F(ConditionalCalls, refused_calls_change_nothing) {
    expect_refusal(GL_INVALID_OPERATION, [] { glEndConditionalRender(); });
    expect_refusal(GL_INVALID_ENUM, [this] { glBeginConditionalRender(passed(), GL_TEXTURE_2D); });
    expect_refusal(GL_INVALID_VALUE, [] { glBeginConditionalRender(0x7000, GL_QUERY_WAIT); });
    glBeginConditionalRender(passed(), GL_QUERY_WAIT);
    expect_refusal(GL_INVALID_OPERATION, [this] { glBeginConditionalRender(failed(), GL_QUERY_WAIT); });
    glEndConditionalRender();
    const Query active;
    active.begin();
    expect_refusal(GL_INVALID_OPERATION, [&] { glBeginConditionalRender(active.name(), GL_QUERY_WAIT); });
    active.end();
}

TEST_F(ConditionalCalls, a_block_inside_a_query_and_a_query_inside_a_block_keep_the_rest) {
    const Query outer;
    outer.begin();
    expect_nothing([this] {
        glBeginConditionalRender(passed(), GL_QUERY_WAIT);
        draw_rect(kWhole, kNear);
        glEndConditionalRender();
    });
    outer.end();
    expect_nothing([&] {
        glBeginConditionalRender(failed(), GL_QUERY_WAIT);
        outer.count([] { draw_rect(kWhole, kNear); });
        glEndConditionalRender();
    });
    EXPECT_EQ(outer.result(), 0u);
}

TEST_F(ConditionalCalls, a_block_under_the_hp_test_keeps_its_state) {
    if (const auto why = conformance::lacks("GL_HP_occlusion_test")) GTEST_SKIP() << *why;
    glEnable(GL_OCCLUSION_TEST_HP);
    expect_nothing([this] {
        glBeginConditionalRender(failed(), GL_QUERY_WAIT);
        draw_rect(kWhole, kNear);
        glEndConditionalRender();
        conformance::get_integer(GL_OCCLUSION_TEST_RESULT_HP);
    });
    glDisable(GL_OCCLUSION_TEST_HP);
}

TEST_F(ConditionalCalls, the_forerunners_block_changes_nothing) {
    if (const auto why = conformance::lacks("GL_NVX_conditional_render")) GTEST_SKIP() << *why;
    for (const GLuint name : {passed(), failed()}) {
        expect_nothing([=] {
            glBeginConditionalRenderNVX(name);
            draw_rect(kWhole, kNear);
            glEndConditionalRenderNVX();
        });
    }
    expect_refusal(GL_INVALID_OPERATION, [] { glEndConditionalRenderNVX(); });
}

}  // namespace
}  // namespace tests
