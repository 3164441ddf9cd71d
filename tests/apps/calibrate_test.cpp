// SPDX-License-Identifier: MIT
// What calibrate computes, away from any clock: lines through points that are known, terms from them, the
// model on mixes that can be reckoned by hand.
#include <gtest/gtest.h>

#include <cmath>

#include "apps/calibrate/findings.h"
#include "apps/calibrate/fit.h"
#include "apps/calibrate/model.h"

namespace {

using namespace apps;

std::vector<Point> line_points(double intercept, double slope) {
    std::vector<Point> points;
    for (const double x : {1, 2, 4, 8, 16, 32, 64, 128, 256}) points.push_back({x, intercept + slope * x});
    return points;
}

TEST(Fit, finds_an_exact_line_exactly) {
    const Line line = fit_line(line_points(7.5, 0.25));
    EXPECT_NEAR(line.intercept, 7.5, 1e-9);
    EXPECT_NEAR(line.slope, 0.25, 1e-11);
    EXPECT_NEAR(line.r2, 1, 1e-9);
    EXPECT_NEAR(line.rms_percent, 0, 1e-6);
    EXPECT_EQ(line.used, 9U);
}

TEST(Fit, is_not_moved_by_a_quarter_of_wild_points_and_says_that_they_do_not_fit) {
    for (const std::size_t wild : {std::size_t{0}, std::size_t{4}, std::size_t{7}}) {
        std::vector<Point> points = line_points(7.5, 0.25);
        points[wild].y *= 40;
        points[(wild + 3) % 9].y *= 3;
        const Line line = fit_line(points);
        EXPECT_NEAR(line.intercept, 7.5, 1e-6) << wild;
        EXPECT_NEAR(line.slope, 0.25, 1e-8) << wild;
        EXPECT_EQ(line.used, 7U);
        EXPECT_GT(line.rms_percent, 20);
    }
}

TEST(Fit, weighs_errors_by_the_size_of_what_is_measured) {
    // A tenth too much and too little at the far end, where a tenth is a hundred times the intercept.
    std::vector<Point> points = line_points(1, 4);
    points[7].y *= 1.02;
    points[8].y *= 0.98;
    const Line line = fit_line(points);
    EXPECT_NEAR(line.intercept, 1, 0.1);
    EXPECT_NEAR(line.slope, 4, 0.04);
}

TEST(Fit, finds_no_slope_in_what_does_not_grow) {
    std::vector<Point> points = line_points(10, 0);
    for (std::size_t i = 0; i < points.size(); ++i) points[i].y += i % 2 == 0 ? 0.5 : -0.5;
    EXPECT_LT(fit_line(points).r2, kLeastR2);
}

TEST(Fit, has_no_line_for_too_little) {
    EXPECT_EQ(fit_line({}).used, 0U);
    EXPECT_EQ(fit_line(std::vector<Point>{{1, 1}, {2, 2}}).used, 0U);
    EXPECT_EQ(fit_line(std::vector<Point>{{3, 1}, {3, 2}, {3, 4}, {3, 5}}).used, 0U);
    EXPECT_EQ(fit_line(std::vector<Point>{{1, -1}, {2, -2}, {3, 0}, {4, 5}}).used, 0U);
}

TEST(Fit, takes_quartiles_between_values) {
    const Quartiles five = quartiles({5, 1, 4, 2, 3});
    EXPECT_EQ(five.low, 2);
    EXPECT_EQ(five.middle, 3);
    EXPECT_EQ(five.high, 4);
    EXPECT_EQ(median({1, 2}), 1.5);
    EXPECT_EQ(median({}), 0);
}

// A sweep of <rounds> alike rounds on a line.
std::vector<Series> sweep_of(const std::vector<Point>& points, int rounds = 3) {
    std::vector<Series> sweep;
    for (const Point& point : points)
        sweep.push_back({point.x, std::vector<Times>(static_cast<std::size_t>(rounds), {point.y, point.y})});
    return sweep;
}

TEST(Terms, turn_slopes_into_rates_and_intercepts_into_microseconds) {
    const SweepFit fit = fit_sweep(sweep_of(line_points(7.5, 0.25)), &Times::total);
    const Term rate = rate_term("triangles_per_second", fit, "");
    EXPECT_EQ(rate.lack, "");
    EXPECT_NEAR(rate.value, 4e6, 1);
    EXPECT_NEAR(rate.low, 4e6, 1);
    EXPECT_NEAR(slope_term("copied_triangle_ns", fit, "", 1000).value, 250, 1e-6);
    EXPECT_NEAR(intercept_term("result_latency_us", fit, 2.5, "", "none").value, 5, 1e-6);
}

TEST(Terms, are_not_shown_where_nothing_is_left_or_nothing_grows) {
    const SweepFit fit = fit_sweep(sweep_of(line_points(7.5, 0.25)), &Times::total);
    EXPECT_EQ(intercept_term("result_latency_us", fit, 8, "", "nothing").lack, "nothing");
    std::vector<Point> restless = line_points(10, 0);
    for (std::size_t i = 0; i < restless.size(); ++i) restless[i].y += i % 2 == 0 ? 3 : 0;
    Findings findings;
    findings.add(rate_term("fragments_per_second", fit_sweep(sweep_of(restless), &Times::total), ""));
    EXPECT_EQ(findings.shown("fragments_per_second"), nullptr);
    EXPECT_EQ(findings.costs.fragment, 0);
    // Measured again, and found.
    findings.add(rate_term("fragments_per_second", fit, ""));
    ASSERT_NE(findings.shown("fragments_per_second"), nullptr);
    EXPECT_NEAR(findings.costs.fragment, 0.25, 1e-9);
    EXPECT_EQ(findings.terms.size(), 1U);
}

TEST(Terms, are_fitted_only_where_the_gpu_is_the_slower) {
    // max(CPU, GPU): flat until the GPU's line takes over.
    std::vector<Point> points = line_points(3, 0.25);
    for (Point& point : points) point.y = std::max(point.y, 10.0);
    const SweepFit fit = fit_sweep(sweep_of(points), &Times::total, 10.5);
    EXPECT_NEAR(fit.line.intercept, 3, 1e-6);
    EXPECT_NEAR(fit.line.slope, 0.25, 1e-8);
}

struct Reckoned : testing::Test {
    Costs costs = {.batch = 10,
                   .query = 5,
                   .read = 2,
                   .gpu_batch = 1,
                   .triangle = 0.01,
                   .fragment = 0.001,
                   .depth_fragment = 0.0005,
                   .cleared_pixel = 0.0001,
                   .gpu_query = 3,
                   .latency = 20,
                   .fifo = 0,
                   .read_pixel = 0.1};
    static constexpr double kPixels = 64000;
};

TEST_F(Reckoned, a_query_that_is_waited_for_takes_its_parts_in_turn) {
    Model model(costs, kPixels);
    model.query(10);  // 200 fragments
    model.wait(0);
    EXPECT_DOUBLE_EQ(model.microseconds(), 5 + 3 + 0.1 + 20);
}

TEST_F(Reckoned, draws_overlap_with_their_making_until_the_fifo_is_full) {
    const auto time_of = [&](double fifo, int draws) {
        costs.fifo = fifo;
        Model model(costs, kPixels);
        for (int i = 0; i < draws; ++i) model.mesh(10000, MeshSize::kSubPixel);  // 101 on the GPU
        const double given = model.microseconds();
        model.finish();
        return std::pair(given, model.microseconds());
    };
    EXPECT_EQ(time_of(0, 5), std::pair(50.0, 515.0));
    // The fifth draw comes when 150 of the four before are left.
    EXPECT_EQ(time_of(150, 5), std::pair(414.0 - 150 + 10, 515.0));
}

TEST_F(Reckoned, fragments_count_where_they_take_longer_than_vertices) {
    Model model(costs, kPixels);
    model.quad(8);
    model.finish();
    EXPECT_DOUBLE_EQ(model.microseconds(), 10 + 1 + 64);
    model.clear();
    model.read(10);
    EXPECT_DOUBLE_EQ(model.microseconds(), 75 + 6.4 + 2 + 10);
}

}  // namespace
