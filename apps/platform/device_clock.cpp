// SPDX-License-Identifier: MIT
// TIMESTAMP, read by GetInteger64v, is the time of the device's CPU.
#include "apps/platform/device_clock.h"

#include <GL/gl.h>
#include <GL/glext.h>

#include <utility>

namespace apps {

DeviceClock::DeviceClock(Platform& platform) {
    if (!platform.has_extension("GL_EMU_device_time")) return;
    get_integer64_ = reinterpret_cast<GetInteger64>(platform.function("glGetInteger64v"));
    device_work_ = reinterpret_cast<DeviceWork>(platform.function("glDeviceWorkEMU"));
}

std::optional<double> DeviceClock::lap_ms() {
    if (!get_integer64_) return std::nullopt;
    std::int64_t now_ns = last_ns_;
    get_integer64_(GL_TIMESTAMP, &now_ns);
    constexpr double kNanosecondsPerMillisecond = 1e6;
    return static_cast<double>(now_ns - std::exchange(last_ns_, now_ns)) / kNanosecondsPerMillisecond;
}

void DeviceClock::work(std::chrono::nanoseconds time) const {
    if (device_work_ && time.count() > 0) device_work_(static_cast<std::uint64_t>(time.count()));
}

}  // namespace apps
