// SPDX-License-Identifier: MIT
// A GL driver that draws nothing and counts: every command of gl.xml exists, writes its name into a log and
// does as good as nothing. What a program could ask of it stands to reason: a compatibility context of
// OpenGL 4.5, whose state is what was set, whose shaders compile and whose queries are available at once
// (fake_state.cpp).
//
// The test program holds it and stands in for GLVND above it: it finds the driver's __egl_Main by dlsym,
// which the preloaded layer answers, and calls what it got. So the log has what the layer makes of a call of
// the program's.
#pragma once

#include <GL/gl.h>
#include <GL/glext.h>

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace fake_driver {

using Arguments =
    std::array<std::intptr_t, 6>;  // whole numbers and pointers, in order; narrow ones have no upper half
using Answer = std::intptr_t (*)(const Arguments& arguments);

struct Command {
    const char* name;
    std::string_view hooked_as;  // its class in hooks.list, or empty
    bool has_driver;             // false for a command that only the layer has
};
const std::vector<Command>& commands();

// What <command> does beside being logged; null: nothing, and it returns zero.
Answer answer_of(std::string_view command);

// Names of the commands that the driver was called by since the log was cleared, in order.
const std::vector<std::string>& log();
void clear_log();

// The driver's own function <name>, GL or EGL; null where it has none.
void* own_function(std::string_view name);
// What a program gets for it through the layer, if there is one.
void* function(const char* name);
// The state of a new context; names go on.
void reset_state();
// A context, current in this thread, made through the same door. Null where that failed.
void* make_context();

template <typename Function>
Function find(const char* name) {
    return reinterpret_cast<Function>(function(name));
}

// The names of <log>, each with how often: "glDrawArrays", "glEnable x2".
std::vector<std::string> counted(const std::vector<std::string>& log);

}  // namespace fake_driver
