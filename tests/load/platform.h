// SPDX-License-Identifier: MIT
// The window system that a program is compiled for: GLX where LOAD_GLX is defined, else EGL. A program is
// compiled once for each, because a load path must not see the libraries of another.
#pragma once

#ifdef LOAD_GLX
#include "glx_session.h"
#define WINSYS_LIBRARY "libGL.so.1"  // GLX stands in libGL too, and old programs open only that
#define WINSYS_GET_PROC_ADDRESS "glXGetProcAddressARB"
#else
#include "egl_session.h"
#define WINSYS_LIBRARY "libEGL.so.1"
#define WINSYS_GET_PROC_ADDRESS "eglGetProcAddress"
#endif
