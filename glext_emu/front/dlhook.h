// SPDX-License-Identifier: MIT
// dlsym and dlopen, put in front of libc's by dlhook_x86_64.S, for the front ends that are preloaded.
//
// What runs inside every dlsym and dlopen of the process, some of them before libc or a sanitizer is ready,
// is FREESTANDING: no libc calls but dlvsym, no instrumentation, no static that needs a guard.
#pragma once

#define FREESTANDING __attribute__((visibility("hidden"), no_sanitize("address", "thread", "undefined")))

extern "C" {

// The next in the chain of those that put themselves in front of libc's; null before find_next.
extern void* (*next_dlsym)(void* library, const char* name);
extern void* (*next_dlopen)(const char* file, int flags);

// The front end's answer to dlsym(<library>, <name>) as called from the code at <caller>; null: the next one
// answers.
FREESTANDING void* dlhook_symbol(void* library, const char* name, const void* caller);
FREESTANDING void dlhook_before_dlopen(const char* file, int flags);
}

namespace glext_emu {

FREESTANDING void find_next();

FREESTANDING bool equals(const char* a, const char* b);

// libc's own dlsym, whoever stands before it. Its null tells as libc's does, by dlerror.
extern void* (*libc_dlsym)(void* library, const char* name);

}  // namespace glext_emu
