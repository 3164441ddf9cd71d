// SPDX-License-Identifier: MIT
#include <algorithm>
#include <span>

#include "entry/entry.h"

namespace glext_emu {

const Hook* find_hook(std::string_view name) {
    const std::span hooks(kHooks, kHookCount);
    const auto found = std::ranges::lower_bound(hooks, name, {}, &Hook::name);
    return found != hooks.end() && found->name == name ? &*found : nullptr;
}

}  // namespace glext_emu
