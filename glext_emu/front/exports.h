// SPDX-License-Identifier: MIT
// The export front end: the layer above libraries that have no seam, OSMesa and a program's own, non-GLVND
// libGL. It is preloaded and has the hooked functions under their own names, so that a linked program's calls
// arrive here; and it answers dlsym. Behind each function stands the library that the program would have got.
#pragma once

#include "front/driver.h"

namespace glext_emu {

// What the exported window-system function <name> does, called from the code at <caller>: the layer's
// function over that of the next library, or the latter alone where <caller> is a GL library itself, whose
// own calls are none of the program's. Null where no library has it.
void* exported_winsys(Platform platform, const char* name, const void* caller);

// What an exported gl function does that the current context's library lacks: null, or without a context the
// next library's function.
void* exported_gl(const char* name);

// The answer to dlsym(<library>, <name>) as called from the code at <caller>, null: as without the layer.
// <library> is no pseudo-handle.
void* exported_symbol(void* library, const char* name, const void* caller);

}  // namespace glext_emu
