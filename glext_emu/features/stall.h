// SPDX-License-Identifier: MIT
// Time that the program spends inside a blocking read.
#pragma once

#include <chrono>

#include "context/context.h"

namespace glext_emu::features {

class StallScope {
  public:
    explicit StallScope(Context& ctx) : ctx_(ctx), start_(std::chrono::steady_clock::now()) {}
    ~StallScope() {
        const std::chrono::nanoseconds spent = std::chrono::steady_clock::now() - start_;
        ctx_.frame.waits++;
        ctx_.frame.stall_ns += static_cast<std::uint64_t>(spent.count());
    }
    StallScope(const StallScope&) = delete;
    StallScope& operator=(const StallScope&) = delete;

  private:
    Context& ctx_;
    std::chrono::steady_clock::time_point start_;
};

// What follows needs a result that the program does not see: on a device the GPU waits for it; where the
// latency is all that is known of a machine, the program does.
inline void wait_in_pipe(Context& ctx, occlusion_unit::Tick due) {
    if (ctx.time != nullptr) return ctx.time->wait_on_gpu(due);
    ctx.clock.wait_until(due);
}

// The same without waiting: what the GPU has waited for is there for what it writes.
inline bool poll_in_pipe(Context& ctx, occlusion_unit::Tick due) {
    return ctx.time != nullptr ? ctx.time->poll_on_gpu(due) : ctx.clock.poll(due);
}

}  // namespace glext_emu::features
