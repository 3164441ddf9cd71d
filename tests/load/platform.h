// SPDX-License-Identifier: MIT
// The window system that a program is compiled for: LOAD_GLX, LOAD_OSMESA, else EGL. A program is compiled
// once for each, because a load path must not see the libraries of another.
#pragma once

#if defined(LOAD_GLX)
#include "glx_session.h"
#define WINSYS_LIBRARY "libGL.so.1"  // GLX stands in libGL too, and old programs open only that
#define GL_LIBRARY "libGL.so.1"
#define WINSYS_GET_PROC_ADDRESS "glXGetProcAddressARB"
#define GET_PROC_ADDRESS(name) glXGetProcAddressARB((const GLubyte*)(name))
#elif defined(LOAD_OSMESA)
#include "osmesa_session.h"
#define WINSYS_LIBRARY "libOSMesa.so.8"
#define GL_LIBRARY "libOSMesa.so.8"
#define WINSYS_GET_PROC_ADDRESS "OSMesaGetProcAddress"
#define GET_PROC_ADDRESS(name) OSMesaGetProcAddress(name)
#else
#include "egl_session.h"
#define WINSYS_LIBRARY "libEGL.so.1"
#define GL_LIBRARY "libGL.so.1"
#define WINSYS_GET_PROC_ADDRESS "eglGetProcAddress"
#define GET_PROC_ADDRESS(name) eglGetProcAddress(name)
#endif
