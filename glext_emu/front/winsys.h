// SPDX-License-Identifier: MIT
// What the GLX, EGL and OSMesa hooks have in common.
#pragma once

#include <atomic>
#include <cstring>
#include <utility>
#include <vector>

#include "context/settings.h"
#include "front/driver.h"

namespace glext_emu {

// A version that the device is too old for is turned into one that no driver has, so that the refusal is the
// driver's own, X error included. <attributes> are pairs up to <end>, which is neither <major> nor <minor>;
// null is empty.
template <class Int>
std::vector<Int> obey_device(const Int* attributes, Int end, Int major, Int minor) {
    constexpr Int kImpossibleVersion = 9;  // GL 9.9
    std::vector<Int> out;
    GlVersion wanted{1, 0};
    for (const Int* a = attributes; a != nullptr && *a != end; a += 2) {
        if (a[0] == major) wanted.major = a[1];
        if (a[0] == minor) wanted.minor = a[1];
        out.insert(out.end(), a, a + 2);
    }
    const auto& limit = settings().device.gl_version;
    for (std::size_t i = 0; limit && wanted > *limit && i < out.size(); i += 2) {
        if (out[i] == major || out[i] == minor) out[i + 1] = kImpossibleVersion;
    }
    out.push_back(end);
    return out;
}

// Keeps the driver's function in <slot> and gives the hook in its place. Asked again, by whatever thread, the
// driver gives the same function: it is written once.
template <class Function>
void* take(Function& slot, void* driver_function, Function hook) {
    const auto real = reinterpret_cast<Function>(driver_function);
    if (const std::atomic_ref kept(slot); kept != real) kept = real;
    return reinterpret_cast<void*>(hook);
}

// Hooks<driver>::find for a driver that is known at run time only: the window systems' functions have no room
// for a user pointer, so each driver has functions of its own. Static: GCC 12 takes the instances of two
// files for one although their arguments have no linkage.
template <template <int> class Hooks, int... kDrivers>
static void* find_in(int driver, const char* name, void* real, std::integer_sequence<int, kDrivers...>) {
    void* found = real;
    ((driver == kDrivers ? (found = Hooks<kDrivers>::find(name, real), 0) : 0), ...);
    return found;
}

}  // namespace glext_emu
