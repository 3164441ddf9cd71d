// SPDX-License-Identifier: MIT
#include "apps/calibrate/sampler.h"

#include <sys/resource.h>

#include <algorithm>
#include <numeric>
#include <random>

namespace apps {
namespace {

long switches_against_our_will() {
    rusage usage{};
    getrusage(RUSAGE_THREAD, &usage);
    return usage.ru_nivcsw;
}

}  // namespace

double Series::median_of(Which which) const {
    const bool takes_all = is_disturbed();
    std::vector<double> values;
    for (const Times& times : rounds)
        if (takes_all || !times.is_disturbed) values.push_back(times.*which);
    return median(std::move(values));
}

bool Series::is_disturbed() const {
    return std::ranges::count(rounds, false, &Times::is_disturbed) < 3;
}

Times Sampler::time(const Burst& burst) {
    constexpr int kTries = 6;
    ++samples_;
    Times best;
    for (int attempt = 0; attempt < kTries; ++attempt) {
        burst.prepare();
        finish_();
        const long switches = switches_against_our_will();
        const double start = now_();
        burst.run();
        const double given = now_();
        finish_();
        const double done = now_();
        const Times times{(given - start) / burst.count, (done - start) / burst.count};
        if (switches_against_our_will() == switches) return times;
        if (attempt == 0 || times.total < best.total) best = times;
    }
    ++disturbed_;
    best.is_disturbed = true;
    return best;
}

std::vector<Series> Sampler::measure(const std::vector<Burst>& bursts) {
    std::vector<Series> sweep;
    for (const Burst& burst : bursts) sweep.push_back({burst.x, {}});
    std::vector<std::size_t> order(bursts.size());
    std::iota(order.begin(), order.end(), 0);
    std::mt19937 random(1);
    for (int round = 0; round < rounds_; ++round) {
        std::ranges::shuffle(order, random);
        for (const std::size_t at : order) {
            bursts[at].prepare();
            bursts[at].run();
            sweep[at].rounds.push_back(time(bursts[at]));
        }
    }
    return sweep;
}

Series difference(const Series& more, const Series& less, double count) {
    Series each = more;
    for (std::size_t round = 0; round < each.rounds.size(); ++round) {
        Times& times = each.rounds[round];
        times.submit = (times.submit - less.rounds[round].submit) / count;
        times.total = (times.total - less.rounds[round].total) / count;
        times.is_disturbed = times.is_disturbed || less.rounds[round].is_disturbed;
    }
    return each;
}

SweepFit fit_sweep(const std::vector<Series>& sweep, Which which, double least) {
    std::vector<const Series*> kept;
    for (const Series& series : sweep)
        if (series.median_of(which) >= least) kept.push_back(&series);
    SweepFit fit;
    if (kept.empty()) return fit;
    std::vector<Point> points;
    for (const Series* series : kept) points.push_back({series->x, series->median_of(which)});
    fit.line = fit_line(points);
    std::vector<double> slopes, intercepts;
    for (std::size_t round = 0; round < kept[0]->rounds.size(); ++round) {
        for (std::size_t i = 0; i < kept.size(); ++i) points[i].y = kept[i]->rounds[round].*which;
        const Line line = fit_line(points);
        if (line.used == 0) continue;
        slopes.push_back(line.slope);
        intercepts.push_back(line.intercept);
    }
    fit.slope = quartiles(std::move(slopes));
    fit.intercept = quartiles(std::move(intercepts));
    return fit;
}

}  // namespace apps
