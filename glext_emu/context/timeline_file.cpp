// SPDX-License-Identifier: MIT
#include "context/timeline_file.h"

namespace glext_emu {

std::unique_ptr<occlusion_unit::TimelineListener> open_timeline_file(const Context&) {
    return nullptr;
}

}  // namespace glext_emu
