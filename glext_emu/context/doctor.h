// SPDX-License-Identifier: MIT
// What the layer saw in a process, for `glext-emu doctor`: a line for each fact in the file that it names.
#pragma once

namespace glext_emu {

// Does nothing where no doctor listens.
void doctor_note(const char* fact);

}  // namespace glext_emu
