// SPDX-License-Identifier: MIT
#include "apps/calibrate/findings.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace apps {
namespace {

enum class Unit { kMicroseconds, kPerSecond };
struct CostKey {
    std::string_view key;
    double Costs::*member;
    Unit unit;
};
constexpr std::array kCostKeys = {
    CostKey{"batch_us", &Costs::batch, Unit::kMicroseconds},
    CostKey{"query_us", &Costs::query, Unit::kMicroseconds},
    CostKey{"read_us", &Costs::read, Unit::kMicroseconds},
    CostKey{"gpu_batch_us", &Costs::gpu_batch, Unit::kMicroseconds},
    CostKey{"triangles_per_second", &Costs::triangle, Unit::kPerSecond},
    CostKey{"fragments_per_second", &Costs::fragment, Unit::kPerSecond},
    CostKey{"depth_fragments_per_second", &Costs::depth_fragment, Unit::kPerSecond},
    CostKey{"cleared_pixels_per_second", &Costs::cleared_pixel, Unit::kPerSecond},
    CostKey{"gpu_query_us", &Costs::gpu_query, Unit::kMicroseconds},
    CostKey{"result_latency_us", &Costs::latency, Unit::kMicroseconds},
    CostKey{"fifo_us", &Costs::fifo, Unit::kMicroseconds},
    CostKey{"read_pixels_per_second", &Costs::read_pixel, Unit::kPerSecond},
};

// Why this line gives no slope; empty if it does.
std::string lack_of_slope(const SweepFit& fit) {
    if (fit.line.used == 0) return "too few points to fit a line";
    if (fit.line.r2 < kLeastR2)
        return fmt::format("R^2 {:.2f} is below {}: it does not grow with size", fit.line.r2, kLeastR2);
    return fit.line.slope > 0 ? "" : "it does not grow with size";
}

Term term_of(const std::string& key, const SweepFit& fit, const std::string& way) {
    return {key, 0, 0, 0, fit.line.r2, fit.line.rms_percent, way, lack_of_slope(fit)};
}

}  // namespace

bool stands_out(const Term& term) {
    return term.value > 0 && term.low > 0 && term.high - term.low < term.value;
}

Term rate_term(const std::string& key, const SweepFit& fit, const std::string& way) {
    Term term = term_of(key, fit, way);
    const auto rate = [](double slope) { return slope > 0 ? 1e6 / slope : 0; };
    term.value = rate(fit.line.slope);
    term.low = rate(fit.slope.high);
    term.high = rate(fit.slope.low);
    return term;
}

Term slope_term(const std::string& key, const SweepFit& fit, const std::string& way, double times) {
    Term term = term_of(key, fit, way);
    term.value = times * fit.line.slope;
    term.low = times * fit.slope.low;
    term.high = times * fit.slope.high;
    return term;
}

Term intercept_term(const std::string& key, const SweepFit& fit, double known, const std::string& way,
                    const std::string& lack) {
    Term term = term_of(key, fit, way);
    term.value = fit.line.intercept - known;
    term.low = fit.intercept.low - known;
    term.high = fit.intercept.high - known;
    if (term.lack.empty() && !stands_out(term)) term.lack = lack;
    return term;
}

void Findings::add(Term term) {
    for (const CostKey& cost : kCostKeys)
        if (cost.key == term.key)
            costs.*cost.member =
                !term.lack.empty() ? 0 : (cost.unit == Unit::kPerSecond ? 1e6 / term.value : term.value);
    const auto known = std::ranges::find(terms, term.key, &Term::key);
    if (known == terms.end())
        terms.push_back(std::move(term));
    else
        *known = std::move(term);
}

void Findings::keep(const std::string& name, const std::vector<Series>& sweep) {
    nlohmann::ordered_json points = nlohmann::ordered_json::array();
    for (const Series& series : sweep) {
        nlohmann::ordered_json submit, total;
        for (const Times& times : series.rounds) {
            submit.push_back(times.submit);
            total.push_back(times.total);
        }
        points.push_back({{"x", series.x}, {"submit_us", submit}, {"total_us", total}});
    }
    sweeps[name] = points;
}

const Term* Findings::shown(std::string_view key) const {
    const auto term = std::ranges::find(terms, key, &Term::key);
    return term != terms.end() && term->lack.empty() ? &*term : nullptr;
}

}  // namespace apps
