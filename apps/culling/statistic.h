// SPDX-License-Identifier: MIT
// What a culler counts beside what every frame reports. A count is declared where it is incremented:
//
//     const Statistic kPullUps{"pull_ups", "nodes found visible by way of a child"};
//     ...
//     frame.tally.add(kPullUps);
//
// and appears under its name in the report of every run that counted it.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace apps {

class Statistic {
  public:
    /// Of static storage, as its words are.
    Statistic(std::string_view name, std::string_view meaning);
    Statistic(const Statistic&) = delete;
    Statistic& operator=(const Statistic&) = delete;

    std::string_view name() const { return name_; }
    std::string_view meaning() const { return meaning_; }
    std::size_t index() const { return index_; }

    /// Every statistic of the program, by index.
    static std::span<const Statistic* const> all();

  private:
    std::string_view name_, meaning_;
    std::size_t index_;
};

/// The counts of one frame.
class Tally {
  public:
    Tally();

    void add(const Statistic& statistic, std::uint64_t count = 1) {
        counts_[statistic.index()] += count;
        is_counted_[statistic.index()] = 1;
    }
    std::uint64_t of(const Statistic& statistic) const { return counts_[statistic.index()]; }

    /// True where add() was called, with 0 too.
    bool has(const Statistic& statistic) const { return is_counted_[statistic.index()] != 0; }

  private:
    std::vector<std::uint64_t> counts_;
    std::vector<std::uint8_t> is_counted_;
};

}  // namespace apps
