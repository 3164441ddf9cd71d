// SPDX-License-Identifier: MIT
// The life of a query beside its use for conditional rendering: other queries inside, deletion, chains, other
// buffers, display lists (COND-10, COND-11, COND-24 to COND-26, COND-28).
#include <array>
#include <optional>

#include "harness/objects.h"
#include "nv_conditional_render/conditional_test.h"

namespace conformance {
namespace {

class QueryInUse : public ConditionalTest {};

// Apart, because what Mesa 22.3 does is beyond a test: it goes on with freed memory, and draws, discards,
// hangs or crashes.
class DeletedQuery : public ConditionalTest {};

// COND-10. 2.X forbids to begin the query in use only.
TEST_F(QueryInUse, another_query_runs_inside_the_block_and_counts_what_is_drawn) {
    const Query inner;
    for (const auto outcome : {Answered::kHidden, Answered::kVisible}) {
        const Answered query(outcome);
        under(query, GL_QUERY_WAIT, [&] {
            inner.begin();
            draw_rect({0, 0, 10, 10}, kNear);
            inner.end();
        });
        EXPECT_TRUE(no_error());
        EXPECT_EQ(inner.result(), outcome == Answered::kVisible ? 100u : 0u);
    }
}

// COND-10, of queries that overlap the block at either end.
TEST_F(QueryInUse, another_query_may_span_either_end_of_the_block) {
    const Answered hidden(Answered::kHidden);
    const Query across;
    EXPECT_EQ(across.count([&] {
        draw_rect({0, 0, 3, 1}, kNear);
        glFlush();
        under(hidden, GL_QUERY_WAIT, [] { draw_rect({0, 1, 5, 1}, kNear); });
        draw_rect({0, 2, 7, 1}, kNear);
    }),
              10u);
    across.begin();
    draw_rect({0, 0, 3, 1}, kNear);
    glFlush();
    glBeginConditionalRender(hidden.name(), GL_QUERY_WAIT);
    draw_rect({0, 1, 5, 1}, kNear);
    across.end();
    glEndConditionalRender();
    EXPECT_EQ(across.result(), 3u);
    glBeginConditionalRender(hidden.name(), GL_QUERY_WAIT);
    across.begin();
    draw_rect({0, 1, 5, 1}, kNear);
    glEndConditionalRender();
    draw_rect({0, 2, 7, 1}, kNear);
    across.end();
    EXPECT_EQ(across.result(), 7u);
    EXPECT_TRUE(no_error());
}

// COND-11. GL 4.5, 5.1.3: of an object in use only the name goes at once; the texts say no more. Decided: the
// result that the block began with goes on to decide.
TEST_F(DeletedQuery, the_block_goes_on_by_the_result_that_it_began_with) {
    for (const auto outcome : {Answered::kHidden, Answered::kVisible}) {
        const bool visible = outcome == Answered::kVisible;
        clear();
        // Many are deleted with it, and many made after it: whatever memory the object had is used again, by
        // queries of nothing.
        std::array<std::optional<Query>, 50> others;
        const auto make_others = [&] {
            for (auto& other : others) other.emplace().count([] {});
        };
        make_others();
        {
            const Query query;
            query.begin();
            Answered::draw(outcome);
            query.end();
            clear();
            glBeginConditionalRender(query.name(), GL_QUERY_WAIT);
            for (auto& other : others) other.reset();
        }
        make_others();
        draw_rect(kWhole, kNear);
        EXPECT_EQ(drawn_pixels(), visible ? kWhole.area() : 0);
        glEndConditionalRender();
        EXPECT_TRUE(no_error());
        clear();
        draw_rect(kWhole, kNear);
        EXPECT_EQ(drawn_pixels(), kWhole.area());
    }
}

// COND-24. Issues: a query inside a discarded block counts nothing, so that whatever depends on it is
// discarded too.
TEST_F(QueryInUse, a_chain_of_queries_vanishes_behind_its_first_link) {
    for (const auto outcome : {Answered::kHidden, Answered::kVisible}) {
        const Query first;
        const Query second;
        const Query third;
        first.begin();
        Answered::draw(outcome);
        first.end();
        under(first, GL_QUERY_WAIT, [&] {
            second.begin();
            draw_rect({0, 0, 16, 16}, kNear);
            second.end();
        });
        under(second, GL_QUERY_WAIT, [&] {
            third.begin();
            draw_rect({16, 16, 16, 16}, kNear);
            third.end();
        });
        clear();
        under(third, GL_QUERY_WAIT, [] { draw_rect(kWhole, kNear); });
        EXPECT_EQ(drawn_pixels(), outcome == Answered::kVisible ? kWhole.area() : 0);
    }
}

// COND-25. GL 4.5, 10.9: a result is a number; only the modes by region look at where it came from.
TEST_F(QueryInUse, the_query_may_have_counted_in_another_framebuffer) {
    for (const auto outcome : {Answered::kHidden, Answered::kVisible}) {
        const Query query;
        {
            const Framebuffer small({.width = 16, .height = 16});
            query.begin();
            Answered::draw(outcome);
            query.end();
        }
        const int all = outcome == Answered::kVisible ? kWhole.area() : 0;
        clear();
        under(query, GL_QUERY_WAIT, [] { draw_rect(kWhole, kNear); });
        EXPECT_EQ(drawn_pixels(), all);

        const Surface other;
        ASSERT_TRUE(other);
        come_back(other);
        clear();
        under(query, GL_QUERY_WAIT, [] { draw_rect(kWhole, kNear); });
        EXPECT_EQ(drawn_pixels(), all) << "on another surface";
        come_back();
    }
}

// COND-25, of a change inside the block.
TEST_F(QueryInUse, the_framebuffer_may_change_inside_the_block) {
    const Answered hidden(Answered::kHidden);
    const Framebuffer other({});
    clear();
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glBeginConditionalRender(hidden.name(), GL_QUERY_WAIT);
    draw_rect(kWhole, kNear);
    other.bind();
    draw_rect(kWhole, kNear);
    EXPECT_EQ(drawn_pixels(), 0);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    EXPECT_EQ(drawn_pixels(), 0);
    glEndConditionalRender();
}

// COND-26. 2.X: the results of the query, as they are when the block begins, decide.
TEST_F(QueryInUse, the_next_block_uses_the_next_result) {
    const Answered query(Answered::kHidden);
    for (int round = 0; round < 6; ++round) {
        const auto outcome = round % 2 == 0 ? Answered::kVisible : Answered::kHidden;
        query.begin();
        Answered::draw(outcome);
        query.end();
        clear();
        under(query, GL_QUERY_WAIT, [] { draw_rect(kWhole, kNear); });
        EXPECT_EQ(drawn_pixels(), outcome == Answered::kVisible ? kWhole.area() : 0) << round;
    }
}

// COND-28. GL 4.5, 21.4: CallList does what the commands of the list do, and both commands are compiled.
TEST_F(QueryInUse, lists_are_discarded_and_may_hold_blocks) {
    const Answered query(Answered::kHidden);
    const GLuint drawing = glGenLists(2);
    const GLuint block = drawing + 1;
    glNewList(drawing, GL_COMPILE);
    draw_rect(kWhole, kNear);
    glEndList();
    glNewList(block, GL_COMPILE);
    glBeginConditionalRender(query.name(), GL_QUERY_WAIT);
    draw_rect({0, 0, 10, 10}, kNear);
    glEndConditionalRender();
    draw_rect({0, 20, 5, 1}, kNear);
    glEndList();
    EXPECT_TRUE(no_error());
    EXPECT_EQ(drawn_pixels(), 0) << "compiled, not executed";

    expect_drawing_discarded([&] { glCallList(drawing); }, kWhole.area());
    expect_drawing_discarded([&] { glCallLists(1, GL_UNSIGNED_INT, &drawing); }, kWhole.area());
    for (const auto outcome : {Answered::kHidden, Answered::kVisible}) {
        query.ask(outcome);
        glCallList(block);
        EXPECT_EQ(drawn_pixels(), outcome == Answered::kVisible ? 105 : 5);
        EXPECT_TRUE(no_error());
    }
    glDeleteLists(drawing, 2);
}

}  // namespace
}  // namespace conformance
