// SPDX-License-Identifier: MIT
// The wrappers, generated from hooks.list: a program's call arrives here and goes on to features/, or
// straight to the driver where the context's hot word says that nobody is interested.
#pragma once

#include <cstddef>
#include <string_view>

#include "context/current.h"

namespace glext_emu {

struct Hook {
    std::string_view name;
    void* wrapper;
    bool is_supplied;  // stands in even where the driver has no such command
};

extern const Hook kHooks[];
extern const std::size_t kHookCount;

// The hook of <name>, or null where the command is not hooked.
const Hook* find_hook(std::string_view name);

}  // namespace glext_emu
