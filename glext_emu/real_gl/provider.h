// SPDX-License-Identifier: MIT
// A driver below the layer: its own GL functions, fetched once through its getProcAddress.
#pragma once

#include "real_gl.h"

namespace glext_emu {

using GetProcAddress = void* (*)(const char* name);

// Fills <real> with the driver's functions; null where the driver has none.
void load_real_gl(RealGl& real, GetProcAddress get_proc_address);

}  // namespace glext_emu
