// SPDX-License-Identifier: MIT
// The timeline as a file: what CPU, FIFO and GPU of the device did when, in the Trace Event format, which
// ui.perfetto.dev and chrome://tracing open.
#pragma once

#include <memory>

#include "occlusion_unit/timeline.h"

namespace glext_emu {

struct Context;

// Who writes down what happens in <ctx>; null where no timeline is wanted.
std::unique_ptr<occlusion_unit::TimelineListener> open_timeline_file(const Context& ctx);

}  // namespace glext_emu
