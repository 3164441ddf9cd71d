// SPDX-License-Identifier: MIT
// What CHC++ adds, on a machine with written answers; the rules of patience; and the GPU's own conditions.
#include "apps/culling/chc_groups.h"
#include "apps/culling/chc_patience.h"
#include "chc_script.h"

namespace {

using apps::PatienceRule;
using apps_test::Play;
using Event = apps_test::ScriptedCanvas::Event;
using Set = std::set<apps::ObjectId>;
using Ids = std::vector<apps::ObjectId>;

TEST(ChcPlus, draws_what_stop_and_wait_draws_and_nothing_twice_whatever_the_latency) {
    for (const std::uint64_t latency : {0ULL, 1ULL, 5ULL, 100ULL, ~0ULL}) {
        Play play(64, "chc++", {{"t_av", 1}});
        play.canvas.latency_calls = latency;
        for (const apps::ObjectId from : {0U, 7U, 40U}) {
            const Set truth = play.canvas.visible = {from, from + 1, from + 20};
            for (int frame = 0; frame < 5; ++frame) {
                const Set drawn = play.frame();
                EXPECT_EQ(play.canvas.drawn().size(), drawn.size());
                EXPECT_LE(play.canvas.polls, 4 * 127U) << "no spinning";
                EXPECT_TRUE(std::includes(drawn.begin(), drawn.end(), truth.begin(), truth.end()));
                // Assumed for a frame, asked in the second, known in the third; an answer may be a frame
                // late.
                if (frame >= 4) {
                    EXPECT_EQ(drawn, truth) << latency << " calls";
                }
            }
        }
    }
}

TEST(ChcPlus, lets_nodes_share_a_query_once_they_have_been_hidden_for_some_frames) {
    // 32 hidden nodes, each beside a visible leaf.
    Play play(64, "chc++", {{"t_av", 60}, {"t_av_mode", 0}, {"tight_depth", 0}});
    for (apps::ObjectId id = 0; id < 64; id += 2) play.canvas.visible.insert(id);
    play.frames(2);
    EXPECT_EQ(play.queries(), 11U) << "after one frame in threes: 3 / (1 + 3 (1 - 0.73^3)) is the best";
    play.frames(8);
    EXPECT_LE(play.queries(), 32U / 8);
    EXPECT_EQ(play.count_of("multi_query_nodes"), 32U);

    play.canvas.visible.insert(33);  // one query fails, and each of its nodes is asked about
    EXPECT_EQ(play.frame(), play.canvas.visible);
    EXPECT_EQ(play.queries(), play.count_of("multi_queries") + play.count_of("multi_query_failed_nodes"));
    EXPECT_EQ(play.count_of("multi_query_nodes"), 32U);
    EXPECT_GE(play.count_of("multi_query_failed_nodes"), 10U);
}

TEST(ChcPlus, draws_neighbours_in_one_call_and_before_each_batch) {
    Play play(64, "chc++", {{"t_av", 60}, {"t_av_mode", 0}, {"batch", 1000}});
    play.canvas.visible = {8, 9, 10, 11, 40};
    play.frames(3);
    const auto& events = play.canvas.events;
    ASSERT_FALSE(events.empty());
    EXPECT_EQ(events.front().kind, Event::kDraw);
    Ids drawn = events.front().objects;
    EXPECT_EQ(drawn.size(), 5U);
    const auto at_8 = std::find(drawn.begin(), drawn.end(), 8U);
    EXPECT_TRUE(std::equal(at_8, at_8 + 4, Ids{8, 9, 10, 11}.begin())) << "a run is not torn";
}

TEST(ChcPlus, asks_about_visible_leaves_after_all_else_and_takes_the_answer_in_the_next_frame) {
    Play play(4, "chc++", {{"t_av", 0}});
    play.canvas.latency_calls = 100;
    play.canvas.visible = {0, 1, 2, 3};
    play.frames(2);
    EXPECT_EQ(play.canvas.count(Event::kTake), 0U) << "nothing is waited for";
    EXPECT_EQ(play.queries(), 4U);
    play.canvas.visible = {3};
    EXPECT_EQ(play.frame().size(), 4U);
    EXPECT_EQ(play.canvas.waits, 4U) << "the answers of the frame before, not those of this one";
    EXPECT_EQ(play.frames(3), Set{3});
}

TEST(ChcPlus, asks_with_the_tight_boxes_of_the_children) {
    apps::Scene scene = apps_test::row_of_boxes(8);
    const apps::Tree tree = apps_test::complete_tree(scene);
    const apps::Parts parts(scene, tree);
    EXPECT_EQ(apps::tight_boxes(parts, 0, 0, 1.4).size(), 1U);
    EXPECT_EQ(apps::tight_boxes(parts, 0, 3, 1.03).size(), 2U) << "a gap of 0.2 m between the halves";
    EXPECT_EQ(apps::tight_boxes(parts, 0, 1, 4).size(), 2U);
    EXPECT_EQ(apps::tight_boxes(parts, 0, 3, 4).size(), 8U);
    for (const int depth : {1, 2, 3})
        for (const apps::Object& object : scene.objects) {
            const auto boxes = apps::tight_boxes(parts, 0, depth, 4);
            EXPECT_TRUE(std::any_of(boxes.begin(), boxes.end(),
                                    [&](const apps::Box& box) { return box.contains(object.box); }));
        }
}

TEST(ChcPlus, groups_by_what_a_query_saves_and_what_it_risks) {
    EXPECT_EQ(apps::best_group(std::vector<double>(50, 1), 1, 0), 50U);
    EXPECT_EQ(apps::best_group(std::vector<double>(50, 0.29), 1, 0), 1U);
    EXPECT_EQ(apps::best_group(std::vector<double>{0.99, 0.99, 0.99, 0.1}, 1, 0), 3U);
    // n / (1 + (1 - 0.99^n) n) has its peak at 11: 5.113 against 5.112 at 10 and 5.077 at 12.
    EXPECT_EQ(apps::best_group(std::vector<double>(50, 0.99), 1, 0), 11U);
    EXPECT_EQ(apps::best_group(std::vector<double>(3, 1), 4, 0), 1U) << "three for the price of four";
    EXPECT_NEAR(apps::probability_to_stay_hidden(0), 0.29, 1e-12);
    EXPECT_NEAR(apps::probability_to_stay_hidden(100), 0.99, 1e-12);
}

TEST(Patience, follows_its_rule) {
    const apps::Box box{{40, 0, 0}, {41, 1, 1}};
    const auto frames = [&](PatienceRule rule, std::uint32_t answers, float step, std::uint32_t frame = 5) {
        apps::Patience patience(8, rule);
        for (const float x : {0.0F, step})
            patience.start_frame(apps::View({{x, 0, 0}, {1, 0, 0}, {}}, 640, 480));
        return patience.frames(3, box, answers, frame);
    };
    EXPECT_EQ(frames(PatienceRule::kConstant, 1, 0), 8U);
    std::set<std::uint32_t> first;
    for (std::uint32_t frame = 0; frame < 200; ++frame)
        first.insert(frames(PatienceRule::kRandom, 1, 0, frame));
    EXPECT_EQ(first.size(), 9U) << "0 to 8";
    EXPECT_EQ(frames(PatienceRule::kRandom, 2, 0), 8U);
    for (const auto& [answers, skipped] :
         {std::pair{1U, 0U}, {2U, 1U}, {3U, 3U}, {4U, 7U}, {5U, 8U}, {99U, 8U}})
        EXPECT_EQ(frames(PatienceRule::kHistory, answers, 0), skipped);
    std::set<std::uint32_t> third;
    for (std::uint32_t frame = 0; frame < 200; ++frame)
        third.insert(frames(PatienceRule::kRandomHistory, 3, 0, frame));
    EXPECT_EQ(third, (std::set<std::uint32_t>{3, 4, 5, 6}));
    EXPECT_EQ(frames(PatienceRule::kRandomHistory, 1, 0), 0U);
    EXPECT_EQ(frames(PatienceRule::kRandomHistory, 99, 0), 8U);
    EXPECT_EQ(frames(PatienceRule::kSpeed, 1, 0), 8U);
    EXPECT_EQ(frames(PatienceRule::kSpeed, 1, 10), 0U);
    // At 39 m, a pixel being 1.73e-3: 16 pixels are 1.08 m, 4 steps of a quarter metre.
    EXPECT_EQ(frames(PatienceRule::kSpeed, 1, 0.25F), 4U);
}

TEST(ChcPlus, asks_the_sooner_about_a_leaf_the_more_it_draws) {
    for (const bool is_dear : {false, true}) {  // a leaf draws as much as a query, or twice that
        Play play(4, "chc++", {{"t_av", 2}, {"t_av_mode", 0}, {"query_triangles", 1}});
        if (is_dear)
            for (apps::Object& object : play.scene.objects) object.index_count *= 2;
        play.canvas.visible = {0, 1, 2, 3};
        play.frames(3);
        EXPECT_EQ(play.queries(), is_dear ? 4U : 0U);
    }
}

TEST(Conditional, sends_hidden_nodes_on_condition_and_visible_leaves_without) {
    Play play(8, "conditional");
    play.canvas.visible = {0, 1};
    EXPECT_EQ(play.frame(), (Set{0, 1}));
    EXPECT_EQ(play.canvas.count(Event::kDrawOnCondition), 8U) << "nothing is known: each leaf";
    for (int frame = 0; frame < 2; ++frame) {
        EXPECT_EQ(play.frame(), (Set{0, 1}));
        EXPECT_EQ(play.canvas.drawn().size(), 2U);
        EXPECT_EQ(play.canvas.asked(), (std::vector<Ids>{{2, 3}, {4, 5, 6, 7}, {1}, {0}}));
    }
    play.canvas.visible = {0, 5};
    EXPECT_EQ(play.frame(), (Set{0, 1, 4, 5, 6, 7})) << "on one condition, which holds";
    EXPECT_EQ(play.frame(), (Set{0, 5}));
    EXPECT_EQ(play.calls_of_frame.size(), 1U + 2 * 6 + 1)
        << "0 drawn; 1, 2..3 and 4 to 7 on condition; 0 asked about";
}

TEST(Conditional, never_takes_an_answer_before_the_frame_is_over) {
    for (const double coherent : {0, 1}) {
        Play play(16, "conditional", {{"coherent", coherent}});
        play.canvas.latency_calls = apps_test::kNeverUnlessWaitedFor;
        for (const Set& visible : {Set{1, 2}, Set{2, 9}, Set{}, Set{15}}) {
            play.canvas.visible = visible;
            for (int frame = 0; frame < 3; ++frame) {
                const Set drawn = play.frame();
                EXPECT_TRUE(std::includes(drawn.begin(), drawn.end(), visible.begin(), visible.end()));
                for (const Event& event : play.calls_of_frame) EXPECT_NE(event.kind, Event::kTake);
                if (frame == 2) {
                    EXPECT_EQ(drawn, visible);
                }
            }
        }
    }
}

}  // namespace
