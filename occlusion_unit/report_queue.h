// SPDX-License-Identifier: MIT
// Where records wait between the end of their query and the program's read: bounded, in order, nothing is
// ever dropped.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>

#include "occlusion_unit/record.h"

namespace occlusion_unit {

class ReportQueue {
  public:
    // <capacity> records, at least one.
    explicit ReportQueue(std::size_t capacity) : capacity_(capacity) {}

    std::size_t size() const { return waiting_.size(); }
    bool is_full() const { return waiting_.size() >= capacity_; }

    // Behind all that wait. False, and nothing happens, where the queue is full: whoever pushes has to try
    // again after a pop, and the pipes behind it stand still until then.
    bool push(const Record& record) {
        if (is_full()) {
            ++refusals_;
            return false;
        }
        waiting_.push_back(record);
        return true;
    }

    // The oldest, which leaves the queue; nothing where it is empty.
    std::optional<Record> pop() {
        if (waiting_.empty()) return std::nullopt;
        const Record oldest = waiting_.front();
        waiting_.pop_front();
        return oldest;
    }

    // How often a push found it full.
    std::uint64_t refusals() const { return refusals_; }

  private:
    std::size_t capacity_;
    std::deque<Record> waiting_;
    std::uint64_t refusals_ = 0;
};

}  // namespace occlusion_unit
