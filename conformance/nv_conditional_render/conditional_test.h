// SPDX-License-Identifier: MIT
// What the tests of GL_NV_conditional_render share: the fixture, queries whose answer is known, and blocks.
//
// The core names of GL 3.0 are used; the discovery tests of the queries show that the suffixed ones are the
// same commands.
#pragma once

#include "harness/gl_test.h"
#include "harness/query.h"

namespace conformance {

class ConditionalTest : public GlTest {
  protected:
    void SetUp() override {
        ASSERT_NO_FATAL_FAILURE(GlTest::SetUp());
        if (const auto why = lacks(30, "GL_NV_conditional_render")) GTEST_SKIP() << *why;
    }
};

inline constexpr GLenum kModes[] = {GL_QUERY_WAIT, GL_QUERY_NO_WAIT, GL_QUERY_BY_REGION_WAIT,
                                    GL_QUERY_BY_REGION_NO_WAIT};

// A query whose result is known to the client: of a rectangle that passes, or of the same one failing every
// depth test. Leaves the frame buffer cleared.
class Answered : public Query {
  public:
    enum Outcome { kHidden, kVisible };

    explicit Answered(Outcome outcome, GLenum target = GL_SAMPLES_PASSED) : Query(target) { ask(outcome); }

    void ask(Outcome outcome) const {
        begin();
        draw(outcome);
        end();
        EXPECT_EQ(result() != 0, outcome == kVisible);
        clear();
    }

    static void draw(Outcome outcome) {
        glPushAttrib(GL_DEPTH_BUFFER_BIT);
        glEnable(GL_DEPTH_TEST);
        glDepthFunc(outcome == kVisible ? GL_ALWAYS : GL_NEVER);
        draw_rect({0, 0, 8, 8}, kNear);
        glPopAttrib();
    }
};

// <commands> between Begin and EndConditionalRender.
template <typename Commands>
void under(const Query& query, GLenum mode, Commands commands) {
    glBeginConditionalRender(query.name(), mode);
    commands();
    glEndConditionalRender();
}

// What <look> sees after <commands> under a hidden query has to be <before>, under a visible one <after>: the
// second shows that the first was able to fail. <reset> comes before each, and is drawn before the block
// begins, whatever the driver collects: ConditionalEffect.drawing_right_before_the_block_is_not_conditional
// is about that.
template <typename Reset, typename Commands, typename Look, typename Value>
void expect_discarded(Reset reset, Commands commands, Look look, Value before, Value after) {
    for (const auto outcome : {Answered::kHidden, Answered::kVisible}) {
        const Answered query(outcome);
        reset();
        glFlush();
        under(query, GL_QUERY_WAIT, commands);
        EXPECT_TRUE(no_error());
        if (outcome == Answered::kHidden) {
            EXPECT_EQ(look(), before) << "under a hidden query";
        } else {
            EXPECT_EQ(look(), after) << "under a visible query";
        }
    }
}

// Drawing that is discarded, and else alters so many pixels of a black buffer.
template <typename Commands>
void expect_drawing_discarded(Commands commands, int pixels) {
    expect_discarded([] { clear(); }, commands, [] { return drawn_pixels(); }, 0, pixels);
}

}  // namespace conformance
