// SPDX-License-Identifier: MIT
// How a feature gets an emulated operation into the display list that is being compiled.
#pragma once

#include "context/context.h"
#include "context/list_pause.h"

namespace glext_emu::features {

// Reads the driver's list base for the Begin/End pair that is about to be opened.
void remember_list_base(Context& ctx);

// Compiles <operation> into the list; executes it too under COMPILE_AND_EXECUTE.
void record(Context& ctx, ListOperation operation);

}  // namespace glext_emu::features
