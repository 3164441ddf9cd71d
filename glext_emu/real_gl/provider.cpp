// SPDX-License-Identifier: MIT
#include "real_gl/provider.h"

#include <cstddef>
#include <cstring>
#include <iterator>

namespace glext_emu {
namespace {

constexpr const char* kNames[] = {
#include "real_gl_names.inc"
};
static_assert(sizeof(RealGl) == std::size(kNames) * sizeof(void*), "one name for each function");

}  // namespace

void load_real_gl(RealGl& real, GetProcAddress get_proc_address) {
    auto* slot = reinterpret_cast<std::byte*>(&real);
    for (const char* name : kNames) {
        void* function = get_proc_address(name);
        std::memcpy(slot, &function, sizeof function);
        slot += sizeof function;
    }
}

}  // namespace glext_emu
