// SPDX-License-Identifier: MIT
// What a calibration found: a term of the model each, or why the machine does not show it.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "apps/calibrate/model.h"
#include "apps/calibrate/sampler.h"

namespace apps {

/// A line that explains less of its points says nothing of the machine.
constexpr double kLeastR2 = 0.9;

struct Term {
    std::string key;  // of the table [time], which names the unit
    double value = 0;
    double low = 0;  // the quartiles of single rounds
    double high = 0;
    double r2 = 0;  // of the line that it comes from
    double rms_percent = 0;
    std::string way;   // how it was measured, in few words
    std::string lack;  // why it is not shown; empty: it is
};

/// A mix of commands that nothing was fitted to.
struct Check {
    std::string what;
    double measured_us = 0;
    double predicted_us = 0;
    bool is_disturbed = false;  // hardly ever was the processor ours while it ran

    double error_percent() const { return 100 * (predicted_us / measured_us - 1); }
};

struct Findings {
    std::vector<Term> terms;
    std::vector<Check> checks;
    nlohmann::ordered_json sweeps;  // raw: name, {x, submit, total} each
    Costs costs;                    // of the terms that are shown

    /// Replaces the term of that key, and tells `costs`.
    void add(Term term);
    void keep(const std::string& name, const std::vector<Series>& sweep);
    const Term* shown(std::string_view key) const;
};

/// Whether a term that is a difference stands out: half of all rounds find it, and agree on it to its own
/// size.
bool stands_out(const Term& term);

/// From the slope of a line, microseconds a thing: things a second.
Term rate_term(const std::string& key, const SweepFit& fit, const std::string& way);
/// Microseconds, `times` slope (1,000 for nanoseconds).
Term slope_term(const std::string& key, const SweepFit& fit, const std::string& way, double times = 1);
/// Microseconds, the intercept less `known`; `lack` says what it means if nothing is left.
Term intercept_term(const std::string& key, const SweepFit& fit, double known, const std::string& way,
                    const std::string& lack);

}  // namespace apps
