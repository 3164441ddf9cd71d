// SPDX-License-Identifier: MIT
// When results of queries come, asked by name: whoever keeps a timeline answers. A ticket is handed out at a
// query's end, when its time need not be known yet; tickets never fall.
#pragma once

#include <cstdint>

namespace occlusion_unit {

using Tick = std::uint64_t;

class ResultTimes {
  public:
    virtual ~ResultTimes() = default;
    // A query has ended; the ticket of its result.
    virtual Tick end_query() = 0;
    // The ticket of the last one; 0: none.
    virtual Tick last_ticket() const = 0;
    // The program asks whether the result of <ticket> is there, which takes a little time; and whether it is.
    virtual bool poll(Tick ticket) = 0;
    virtual bool has_come(Tick ticket) = 0;
    // The program needs it.
    virtual void wait_for(Tick ticket) = 0;
    // The same, but no longer than <most_ns>; true where it has come.
    virtual bool wait_for(Tick ticket, std::uint64_t most_ns) = 0;
};

}  // namespace occlusion_unit
