// SPDX-License-Identifier: MIT
// CHC, chc.cpp, on a machine with written answers: what it asks, when, and what it makes of the answers.
#include "apps/culling/chc_patience.h"
#include "chc_script.h"

namespace {

using apps_test::Play;
using Event = apps_test::ScriptedCanvas::Event;
using Set = std::set<apps::ObjectId>;
using Ids = std::vector<apps::ObjectId>;

TEST(Chc, asks_about_visible_leaves_and_the_highest_hidden_nodes_only) {
    Play play(8, "chc");
    play.canvas.visible = {0, 1};
    EXPECT_EQ(play.frame(), (Set{0, 1}));
    EXPECT_EQ(play.queries(), 7U)
        << "the first frame is stop-and-wait's: the root, and both children of what is visible";
    EXPECT_EQ(play.frame(), (Set{0, 1}));
    EXPECT_EQ(play.canvas.asked(), (std::vector<Ids>{{2, 3}, {1}, {0}, {4, 5, 6, 7}}));
}

TEST(Chc, pulls_down_within_the_frame_and_pulls_up_for_the_next) {
    Play play(8, "chc");
    play.canvas.visible = {0, 1};
    play.frames(2);

    play.canvas.visible = {0, 5};  // 4..7 is opened, and 4..5 of it; 1 is drawn once more
    EXPECT_EQ(play.frame(), (Set{0, 1, 5}));
    EXPECT_EQ(play.queries(), 4U + 2 + 2);
    EXPECT_EQ(play.count_of("pull_downs"), 2U);

    EXPECT_EQ(play.frame(), (Set{0, 5}));
    EXPECT_EQ(play.queries(), 6U);

    play.canvas.visible = {5};  // 0..3 is hidden in all its parts
    EXPECT_EQ(play.frame(), (Set{0, 5}));
    EXPECT_EQ(play.queries(), 6U);
    EXPECT_EQ(play.frame(), (Set{5}));
    EXPECT_EQ(play.canvas.asked(), (std::vector<Ids>{{0, 1, 2, 3}, {4}, {5}, {6, 7}}));
    EXPECT_EQ(play.count_of("pull_ups"), 3U) << "4..5, 4..7 and the root, by way of 5";
}

TEST(Chc, pulls_up_to_the_root_and_no_further) {
    Play play(4, "chc");
    play.canvas.visible = {2};
    play.frames(2);
    play.canvas.visible = {};
    EXPECT_EQ(play.frame(), (Set{2}));
    EXPECT_EQ(play.frame(), Set{});
    EXPECT_EQ(play.queries(), 1U) << "the root";
    play.canvas.visible = {0, 1, 2, 3};
    EXPECT_EQ(play.frame(), (Set{0, 1, 2, 3}));
    EXPECT_EQ(play.queries(), 7U);

    Play single(1, "chc");
    single.canvas.visible = {0};
    EXPECT_EQ(single.frames(3), Set{0});
}

TEST(Chc, asks_before_it_draws_and_draws_without_waiting) {
    Play play(2, "chc");
    play.canvas.visible = {0, 1};
    play.canvas.latency_calls = apps_test::kNeverUnlessWaitedFor;
    play.frames(2);
    std::vector<Event::Kind> kinds;
    for (const Event& event : play.canvas.events) kinds.push_back(event.kind);
    EXPECT_EQ(kinds, (std::vector{Event::kAsk, Event::kDraw, Event::kAsk, Event::kDraw, Event::kTake,
                                  Event::kTake}));
}

TEST(Chc, draws_what_stop_and_wait_draws_and_nothing_twice_whatever_the_latency) {
    for (const double traversal : {0, 1})
        for (const std::uint64_t latency : {0ULL, 1ULL, 5ULL, 100ULL, ~0ULL}) {
            Play waiting(64, "stop-and-wait");
            Play play(64, "chc", {{"traversal", traversal}});
            play.canvas.latency_calls = latency;
            for (const apps::ObjectId from : {0U, 7U, 40U}) {
                waiting.canvas.visible = play.canvas.visible = {from, from + 1, from + 20};
                const Set truth = waiting.frame();
                EXPECT_EQ(truth, play.canvas.visible);
                for (int frame = 0; frame < 3; ++frame) {
                    const Set drawn = play.frame();
                    EXPECT_EQ(play.canvas.drawn().size(), drawn.size());
                    EXPECT_LE(play.canvas.polls, 4 * 127U) << "no spinning";
                    if (frame > 0) {
                        EXPECT_EQ(drawn, truth) << latency << " calls, frame " << frame;
                    }
                    EXPECT_TRUE(std::includes(drawn.begin(), drawn.end(), truth.begin(), truth.end()));
                }
            }
        }
}

TEST(Chc, asks_about_a_visible_leaf_every_third_frame_where_t_av_is_two) {
    Play play(4, "chc", {{"t_av", 2}});
    play.canvas.visible = {0, 1, 2, 3};
    play.frame();
    for (const std::size_t queries : {0U, 0U, 4U, 0U, 0U, 4U, 0U}) {
        EXPECT_EQ(play.frame().size(), 4U);
        EXPECT_EQ(play.queries(), queries);
    }
    EXPECT_EQ(play.count_of("assumed_visible"), 4U);
    play.canvas.visible = {};
    EXPECT_EQ(play.frames(2).size(), 4U) << "asked in the second of these frames, and drawn";
    EXPECT_EQ(play.frame(), Set{});
}

TEST(Chc, visits_by_distance_with_a_priority_queue_and_the_near_child_first_without) {
    // Far to near in the order of the tree; as a bounding volume hierarchy, for which distance decides.
    const apps::Scene scene = apps_test::row_of_boxes(8, -1);
    for (const double traversal : {0, 1}) {
        Play play(scene, apps_test::complete_tree(scene), "chc", {{"traversal", traversal}});
        play.canvas.visible = {0, 1, 2, 3, 4, 5, 6, 7};
        play.frames(2);
        EXPECT_EQ(play.canvas.drawn(), (Ids{7, 6, 5, 4, 3, 2, 1, 0}));
    }
    // A split between eye and boxes: the far child, by the plane, is pushed first whatever the distance.
    apps::Tree tree = apps_test::complete_tree(scene);
    tree.nodes[0].axis = 0;
    tree.nodes[0].split = 1;
    Play play(scene, tree, "chc");
    play.canvas.visible = {0, 7};
    play.frames(2);
    EXPECT_EQ(play.canvas.drawn(), (Ids{0, 7}));
}

TEST(Chc, takes_what_is_too_near_for_a_test_as_visible_and_keeps_what_is_above_it_open) {
    Play play(8, "chc");
    play.eye = {80, -3.5F, 0};  // in the first box
    play.canvas.visible = {};
    EXPECT_TRUE(play.frame().contains(0));
    const std::size_t queries = play.queries();
    for (int frame = 0; frame < 3; ++frame) {
        EXPECT_TRUE(play.frame().contains(0));
        EXPECT_EQ(play.queries(), queries) << "nothing above it collapses";
        for (const Ids& asked : play.canvas.asked()) EXPECT_FALSE(std::count(asked.begin(), asked.end(), 0U));
    }
}

TEST(Chc, begins_anew_after_a_restart_and_where_it_did_not_look_for_a_frame) {
    Play play(8, "chc");
    play.canvas.visible = {0, 1};
    play.frames(3);
    EXPECT_EQ(play.queries(), 4U);
    play.culler->restart();
    play.frame();
    EXPECT_EQ(play.queries(), 7U);
    play.frame();
    play.eye = {1000, 0, 0};  // everything is behind
    EXPECT_EQ(play.frame(), Set{});
    play.eye = {0, 0, 0};
    EXPECT_EQ(play.frame(), (Set{0, 1}));
    EXPECT_EQ(play.queries(), 7U);
}

TEST(Chc, draws_the_cheapest_open_question_rather_than_wait_below_its_price) {
    for (const double price : {1, 2, 100}) {
        Play play(4, "chc", {{"speculate", price}});
        play.canvas.latency_calls = apps_test::kNeverUnlessWaitedFor;
        play.canvas.visible = {0};
        play.frames(2);
        play.canvas.visible = {0, 1};  // leaf 1 is asked about alone, 2 and 3 together
        const Set drawn = play.frame();
        EXPECT_EQ(play.count_of("speculated_nodes"), price < 2 ? 0U : price < 100 ? 1U : 2U);
        EXPECT_EQ(drawn, price < 100 ? (Set{0, 1}) : (Set{0, 1, 2, 3}));
        const auto first_take = std::find_if(play.canvas.events.begin(), play.canvas.events.end(),
                                             [](const Event& e) { return e.kind == Event::kTake; });
        const auto draw_of_1 =
            std::find_if(play.canvas.events.begin(), play.canvas.events.end(),
                         [](const Event& e) { return e.kind == Event::kDraw && e.objects == Ids{1}; });
        EXPECT_EQ(draw_of_1 < first_take, price >= 2);
        play.canvas.latency_calls = 0;
        EXPECT_EQ(play.frame(), (Set{0, 1})) << "what was drawn in vain is not thereby visible";
    }
}

TEST(Chc, leaves_out_nodes_of_no_more_than_n_vp_pixels) {
    Play play(4, "chc", {{"n_vp", 1}});
    play.canvas.visible = {0, 2, 3};  // a sample each: 2..3 has two, each of its leaves one
    EXPECT_EQ(play.frames(3), Set{});
    play.canvas.visible = {0, 1, 2, 3};
    EXPECT_EQ(play.frame(), Set{}) << "more than so many";
}

TEST(Chc, asks_about_what_hangs_in_an_interior_node_by_itself) {
    // Object 0 hangs in the root; the leaves hold 1 and 2.
    const apps::Scene scene = apps_test::row_of_boxes(3);
    apps::Tree tree = apps_test::two_leaves_and_a_root(scene);
    Play play(scene, tree, "chc");
    play.canvas.visible = {0};
    EXPECT_EQ(play.frames(2), Set{0});
    EXPECT_EQ(play.canvas.asked(), (std::vector<Ids>{{0}, {1}, {2}}));
    play.canvas.visible = {2};
    EXPECT_EQ(play.frames(2), Set{2});
    play.canvas.visible = {};
    EXPECT_EQ(play.frames(2), Set{});
    EXPECT_EQ(play.queries(), 1U);
}

}  // namespace
