// SPDX-License-Identifier: MIT
// The libraries below the layer: GLVND's drivers, whose entry point is called as if nothing were there and
// whose getProcAddress is then replaced by one that knows the wrappers; and, for the exports, libraries that
// bring a GL of their own.
#pragma once

#include <glvnd/libeglabi.h>

#include <cstdint>

#include "real_gl.h"
#include "real_gl/provider.h"

namespace glext_emu {

// How the layer got under this process: each front end, a library of its own, has its word for it.
extern const char* const front_name;

// The front end that stands above GLVND: where it is loaded too, the others leave everything to it.
inline constexpr const char* kExportsLibrary = "libglext_emu_exports.so";

using EglMain = EGLBoolean (*)(std::uint32_t, const __EGLapiExports*, __EGLvendorInfo*, __EGLapiImports*);

// <real> is a driver's __glx_Main or __egl_Main. Returns what GLVND shall call instead: a wrapper, or <real>
// itself where the layer steps aside.
void* wrap_glx_main(void* real);
void* wrap_egl_main(void* real);

// A library was opened with RTLD_DEEPBIND, so the GL libraries were loaded before it.
extern bool gl_was_loaded_ahead;

enum class Platform { kGlx, kEgl, kOsmesa };

// A process has a GLX and an EGL vendor, rarely two of each; more than this at once are left alone.
inline constexpr int kMostDrivers = 8;

// The place of a driver, below kMostDrivers: where it is known already, else a free one, or one whose driver
// is gone; -1 if there is none. <key> is a function of the driver's that its dynamic symbols name.
int driver_place(void* key, Platform platform);
// False until take_driver.
bool is_driver_taken(int driver);
// From now on the driver's own functions are what <own> gives.
void take_driver(int driver, GetProcAddress own);

// What the program gets for <name>: a wrapper stands in for what the driver has, or what a device supplies.
void* layered_function(int driver, const char* name);

// Replaces a driver's window-system function <real> by the layer's; returns <real> for other names.
void* winsys_hook(int driver, const char* name, void* real);
void* glx_hook(int driver, const char* name, void* real);
void* egl_hook(int driver, const char* name, void* real);
void* osmesa_hook(int driver, const char* name, void* real);
// OSMesa has no swap: frames end with glFinish. Returns what does that after <finish>, the driver's.
using Finish = decltype(RealGl::glFinish);
Finish end_osmesa_frames(int driver, Finish finish);

// What a driver's own getProcAddress gives for <name>.
void* driver_function(int driver, const char* name);

// The GL functions of a driver; and the driver of such functions, -1 if they are no driver's.
const RealGl& real_gl_of(int driver);
int driver_of(const RealGl* real);

}  // namespace glext_emu
