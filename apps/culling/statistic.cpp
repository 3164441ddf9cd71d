// SPDX-License-Identifier: MIT
// The register of statistics: each enters itself before main.
#include "apps/culling/statistic.h"

namespace apps {
namespace {

std::vector<const Statistic*>& entered() {
    static std::vector<const Statistic*> list;
    return list;
}

}  // namespace

Statistic::Statistic(std::string_view name, std::string_view meaning)
    : name_(name), meaning_(meaning), index_(entered().size()) {
    entered().push_back(this);
}

std::span<const Statistic* const> Statistic::all() {
    return entered();
}

Tally::Tally() : counts_(Statistic::all().size()), is_counted_(Statistic::all().size()) {
}

}  // namespace apps
