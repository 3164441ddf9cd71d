// SPDX-License-Identifier: MIT
// The layer's place between GLVND and a driver: the driver's entry point is called as if nothing were there,
// then its getProcAddress is replaced by one that knows the wrappers.
#pragma once

#include <glvnd/libeglabi.h>

#include <cstdint>

#include "real_gl.h"

namespace glext_emu {

// How the layer got under this process: each front end, a library of its own, has its word for it.
extern const char* const front_name;

using EglMain = EGLBoolean (*)(std::uint32_t, const __EGLapiExports*, __EGLvendorInfo*, __EGLapiImports*);

// <real> is a driver's __glx_Main or __egl_Main. Returns what GLVND shall call instead: a wrapper, or <real>
// itself where the layer steps aside.
void* wrap_glx_main(void* real);
void* wrap_egl_main(void* real);

// A library was opened with RTLD_DEEPBIND, so the GL libraries were loaded before it.
extern bool gl_was_loaded_ahead;

// A process has a GLX and an EGL vendor, rarely two of each; more than this at once are left alone.
inline constexpr int kMostDrivers = 8;

// Replaces what a driver's getProcAddress gives by the layer's window-system functions; returns <real> for
// other names. <driver> is the index of the driver, below kMostDrivers.
void* glx_hook(int driver, const char* name, void* real);
void* egl_hook(int driver, const char* name, void* real);

// What a driver's own getProcAddress gives for <name>.
void* driver_function(int driver, const char* name);

// The GL functions of a driver.
const RealGl& real_gl_of(int driver);

}  // namespace glext_emu
