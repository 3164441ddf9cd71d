// SPDX-License-Identifier: MIT
// The time of an emulated device, by GL_EMU_device_time: what a frame would have taken on that machine. Where
// the extension is not there, there is no such time, and nothing here does anything.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>

#include "apps/platform/platform.h"

namespace apps {

class DeviceClock {
  public:
    explicit DeviceClock(Platform& platform);

    /// Milliseconds of the device's CPU clock since the last call, or since the context was made; none
    /// without a device's time. Two calls around a frame and its swap tell what the frame took.
    std::optional<double> lap_ms();

    /// Tells the device that the program itself computed for so long.
    void work(std::chrono::nanoseconds time) const;

  private:
    using GetInteger64 = void (*)(unsigned name, std::int64_t* value);
    using DeviceWork = void (*)(std::uint64_t nanoseconds);

    GetInteger64 get_integer64_ = nullptr;  // null where there is no device's time
    DeviceWork device_work_ = nullptr;
    std::int64_t last_ns_ = 0;
};

}  // namespace apps
