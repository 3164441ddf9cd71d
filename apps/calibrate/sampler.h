// SPDX-License-Identifier: MIT
// Times short bursts of commands, in turn, round after round: whatever else the machine does meets all of
// them. A burst during which somebody else got the processor is made again, six times
// at most; of these the fastest counts.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "apps/calibrate/fit.h"

namespace apps {

struct Burst {
    double x = 0;      // what its time is fitted over
    double count = 1;  // the times are divided by it
    std::function<void()> run;
    std::function<void()> prepare = [] {};  // before each, not timed
};

/// Microseconds until the commands were given, and until they were done.
struct Times {
    double submit = 0;
    double total = 0;
    bool is_disturbed = false;  // others had a share of the processor
};
using Which = double Times::*;

struct Series {
    double x = 0;
    std::vector<Times> rounds;

    /// Of the undisturbed rounds, or of all if these are fewer than three.
    double median_of(Which which) const;
    bool is_disturbed() const;  // fewer than three rounds are not
};

class Sampler {
  public:
    /// `now` tells microseconds; `finish` returns when all commands are done.
    Sampler(std::function<double()> now, std::function<void()> finish, int rounds)
        : now_(std::move(now)), finish_(std::move(finish)), rounds_(rounds) {}

    /// Each burst is made twice in its turn and timed once: what the driver compiles or uploads for it (35 to
    /// 60 ms for a new state of llvmpipe) is none of its cost.
    std::vector<Series> measure(const std::vector<Burst>& bursts);

    /// The share of samples for which the processor was never ours alone.
    double disturbed_share() const { return samples_ > 0 ? disturbed_ / samples_ : 0; }
    int rounds() const { return rounds_; }

  private:
    Times time(const Burst& burst);

    std::function<double()> now_;
    std::function<void()> finish_;
    int rounds_;
    double samples_ = 0;
    double disturbed_ = 0;
};

/// What one of `count` things costs that `more` has and `less` has not, round by round.
Series difference(const Series& more, const Series& less, double count);

/// A line through the medians of a sweep, and what the lines through its single rounds spread over.
struct SweepFit {
    Line line;
    Quartiles slope;
    Quartiles intercept;
};
/// Of the series whose median is at least `least` microseconds.
SweepFit fit_sweep(const std::vector<Series>& sweep, Which which, double least = 0);

}  // namespace apps
