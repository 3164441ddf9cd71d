// SPDX-License-Identifier: MIT
// The one door to the current context: what a wrapper looks at before it does anything.
#pragma once

#include <cstdint>

#include "hot_bits.h"
#include "real_gl.h"

namespace glext_emu {

struct Context;

struct Current {
    std::uint32_t hot = 0;         // classes of commands that need the slow path
    const RealGl* real = nullptr;  // never null while GL can be called: see default_real
    Context* context = nullptr;    // never null while hot is not zero
};

// Initial-exec: one load relative to the thread pointer, no call.
extern thread_local constinit Current current __attribute__((tls_model("initial-exec")));

// What a thread that never had a context of ours calls: the driver that was loaded last.
extern RealGl default_real;

// Counts the call where the clock runs on calls.
Context& enter();

}  // namespace glext_emu
