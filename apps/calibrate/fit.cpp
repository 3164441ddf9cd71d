// SPDX-License-Identifier: MIT
// Theil and Sen: the median of the slopes between all pairs, which stands as long as fewer than 29 % of the
// points are wrong; it chooses the points, least squares then uses them better.
#include "apps/calibrate/fit.h"

#include <algorithm>
#include <cmath>

namespace apps {
namespace {

double residual(const Point& point, const Line& line) {
    return (point.y - line.intercept - line.slope * point.x) / point.y;
}

Line theil_sen(std::span<const Point> points) {
    std::vector<double> slopes;
    for (std::size_t i = 0; i < points.size(); ++i)
        for (std::size_t j = i + 1; j < points.size(); ++j)
            if (points[i].x != points[j].x)
                slopes.push_back((points[j].y - points[i].y) / (points[j].x - points[i].x));
    Line line;
    if (slopes.empty()) return line;
    line.slope = median(std::move(slopes));
    std::vector<double> intercepts;
    for (const Point& point : points) intercepts.push_back(point.y - line.slope * point.x);
    line.intercept = median(std::move(intercepts));
    return line;
}

Line least_relative_squares(std::span<const Point> points) {
    double w = 0, wx = 0, wy = 0, wxx = 0, wxy = 0;
    for (const Point& point : points) {
        const double weight = 1 / (point.y * point.y);
        w += weight;
        wx += weight * point.x;
        wy += weight * point.y;
        wxx += weight * point.x * point.x;
        wxy += weight * point.x * point.y;
    }
    Line line;
    const double spread = w * wxx - wx * wx;
    if (spread <= 1e-12 * w * wxx) return line;
    line.slope = (w * wxy - wx * wy) / spread;
    line.intercept = (wy - line.slope * wx) / w;
    return line;
}

// The points that a line agrees with: all but those, a quarter at most, whose residual is more than three
// times what most have. Below two percent nothing is far.
std::vector<Point> near(std::span<const Point> points, const Line& line) {
    constexpr double kNormal = 1.4826;  // median of absolute residuals to standard deviation
    constexpr double kNear = 0.02;
    std::vector<double> sizes;
    for (const Point& point : points) sizes.push_back(std::abs(residual(point, line)));
    const double far = std::max(kNear, 3 * kNormal * median(sizes));
    std::vector<Point> sorted(points.begin(), points.end());
    std::ranges::stable_sort(sorted, {}, [&](const Point& point) { return std::abs(residual(point, line)); });
    const std::size_t least = std::max<std::size_t>(3, points.size() - points.size() / 4);
    while (sorted.size() > least && std::abs(residual(sorted.back(), line)) > far) sorted.pop_back();
    return sorted;
}

void judge(std::span<const Point> points, Line& line) {
    double weights = 0, mean = 0;
    for (const Point& point : points) weights += 1 / (point.y * point.y);
    for (const Point& point : points) mean += 1 / point.y / weights;
    double left = 0, all = 0;
    for (const Point& point : points) {
        left += std::pow(residual(point, line), 2);
        all += std::pow((point.y - mean) / point.y, 2);
    }
    line.r2 = all > 0 ? std::max(0.0, 1 - left / all) : 0;
    line.rms_percent = 100 * std::sqrt(left / static_cast<double>(points.size()));
}

}  // namespace

Quartiles quartiles(std::vector<double> values) {
    if (values.empty()) return {};
    std::ranges::sort(values);
    const auto at = [&](double share) {
        const double place = share * static_cast<double>(values.size() - 1);
        const auto below = static_cast<std::size_t>(place);
        const std::size_t above = std::min(below + 1, values.size() - 1);
        return values[below] + (values[above] - values[below]) * (place - static_cast<double>(below));
    };
    return {at(0.25), at(0.5), at(0.75)};
}

double median(std::vector<double> values) {
    return quartiles(std::move(values)).middle;
}

Line fit_line(std::span<const Point> points) {
    std::vector<Point> good;
    std::ranges::copy_if(points, std::back_inserter(good), [](const Point& point) { return point.y > 0; });
    if (good.size() < 3 || std::ranges::all_of(good, [&](const Point& p) { return p.x == good[0].x; }))
        return {};
    Line line = theil_sen(good);
    std::size_t used = 0;
    for (int pass = 0; pass < 3; ++pass) {
        const std::vector<Point> kept = near(good, line);
        line = least_relative_squares(kept);
        used = kept.size();
    }
    judge(good, line);
    line.used = used;
    return line;
}

}  // namespace apps
