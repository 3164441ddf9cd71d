#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Load path: Python's ctypes, `ctypes_path.py glx|egl|osmesa`. The check is load_check.h's, in Python."""
import ctypes
import os
import sys

GL_EXTENSIONS, GL_QUADS, GL_NO_ERROR, GL_INVALID_ENUM = 0x1F03, 7, 0, 0x0500
GL_COLOR_AND_DEPTH, GL_DEPTH_TEST = 0x4100, 0x0B71
OCCLUSION_TEST_HP, OCCLUSION_TEST_RESULT_HP = 0x8165, 0x8166
EGL_PLATFORM_SURFACELESS_MESA, EGL_OPENGL_API = 0x31DD, 0x30A2


def require(condition, sentence):
    if not condition:
        sys.exit(f"failed: expected that {sentence}")


def open_egl():
    egl = ctypes.CDLL("libEGL.so.1")
    egl.eglGetPlatformDisplay.restype = ctypes.c_void_p
    egl.eglCreatePbufferSurface.restype = ctypes.c_void_p
    egl.eglCreateContext.restype = ctypes.c_void_p
    display = ctypes.c_void_p(egl.eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, None, None))
    require(egl.eglInitialize(display, None, None), "eglInitialize succeeds")
    egl.eglBindAPI(EGL_OPENGL_API)
    # SURFACE_TYPE = PBUFFER, RENDERABLE_TYPE = OPENGL, DEPTH_SIZE = 16, NONE
    wanted = (ctypes.c_int * 7)(0x3033, 1, 0x3040, 8, 0x3025, 16, 0x3038)
    config, count = ctypes.c_void_p(), ctypes.c_int()
    egl.eglChooseConfig(display, wanted, ctypes.byref(config), 1, ctypes.byref(count))
    require(count.value, "an EGL config has a pbuffer, OpenGL and depth")
    size = (ctypes.c_int * 5)(0x3057, 64, 0x3056, 64, 0x3038)  # WIDTH, HEIGHT, NONE
    surface = ctypes.c_void_p(egl.eglCreatePbufferSurface(display, config, size))
    context = ctypes.c_void_p(egl.eglCreateContext(display, config, None, None))
    require(egl.eglMakeCurrent(display, surface, surface, context), "eglMakeCurrent succeeds")
    return ctypes.CDLL("libOpenGL.so.0")


def open_glx():
    if "DISPLAY" not in os.environ:
        sys.exit(77)
    x11, gl = ctypes.CDLL("libX11.so.6"), ctypes.CDLL("libGL.so.1")
    x11.XOpenDisplay.restype = ctypes.c_void_p
    x11.XDefaultRootWindow.restype = ctypes.c_ulong
    gl.glXChooseFBConfig.restype = ctypes.POINTER(ctypes.c_void_p)
    gl.glXCreatePbuffer.restype = ctypes.c_ulong
    gl.glXCreateNewContext.restype = ctypes.c_void_p
    display = ctypes.c_void_p(x11.XOpenDisplay(None))
    require(display.value, "DISPLAY can be opened")
    # DRAWABLE_TYPE = PBUFFER, DEPTH_SIZE = 16, None
    wanted, count = (ctypes.c_int * 5)(0x8010, 4, 12, 16, 0), ctypes.c_int()
    configs = gl.glXChooseFBConfig(display, x11.XDefaultScreen(display), wanted, ctypes.byref(count))
    require(count.value, "a GLX config has a pbuffer and depth")
    config = ctypes.c_void_p(configs[0])
    size = (ctypes.c_int * 5)(0x8041, 64, 0x8040, 64, 0)  # PBUFFER_WIDTH, PBUFFER_HEIGHT, None
    pbuffer = ctypes.c_ulong(gl.glXCreatePbuffer(display, config, size))
    context = ctypes.c_void_p(gl.glXCreateNewContext(display, config, 0x8014, None, 1))  # RGBA_TYPE, direct
    require(gl.glXMakeContextCurrent(display, pbuffer, pbuffer, context), "glXMakeContextCurrent succeeds")
    return gl


def open_osmesa():
    gl = ctypes.CDLL("libOSMesa.so.8")
    gl.OSMesaCreateContextExt.restype = ctypes.c_void_p
    context = ctypes.c_void_p(gl.OSMesaCreateContextExt(0x1908, 16, 0, 0, None))  # RGBA
    require(context.value, "OSMesaCreateContextExt succeeds")
    open_osmesa.pixels = (ctypes.c_ubyte * (64 * 64 * 4))()  # as long as the context draws into them
    require(gl.OSMesaMakeCurrent(context, open_osmesa.pixels, 0x1401, 64, 64), "OSMesaMakeCurrent succeeds")
    return gl


def draw_quad(gl, z):
    gl.glBegin(GL_QUADS)
    for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
        gl.glVertex3f(ctypes.c_float(x), ctypes.c_float(y), ctypes.c_float(z))
    gl.glEnd()


def read_result(gl):
    result = ctypes.c_ubyte(0)
    gl.glGetBooleanv(OCCLUSION_TEST_RESULT_HP, ctypes.byref(result))
    return result.value


def check(gl, layer):
    gl.glGetString.restype = ctypes.c_char_p
    words = gl.glGetString(GL_EXTENSIONS).split()
    require(words.count(b"GL_HP_occlusion_test") == layer, "GL_HP_occlusion_test is listed once, or never")
    require(gl.glGetError() == GL_NO_ERROR, "no error is pending before the test")
    gl.glEnable(OCCLUSION_TEST_HP)
    error = gl.glGetError()
    require(error == (GL_NO_ERROR if layer else GL_INVALID_ENUM), "GL knows OCCLUSION_TEST_HP, or does not")
    if not layer:
        return
    gl.glClear(GL_COLOR_AND_DEPTH)
    gl.glEnable(GL_DEPTH_TEST)
    draw_quad(gl, -0.5)
    require(read_result(gl) == 1, "a visible quad is visible")
    require(read_result(gl) == 0, "reading the result clears it")
    draw_quad(gl, 0.5)
    require(read_result(gl) == 0, "a hidden quad is hidden")
    require(gl.glGetError() == GL_NO_ERROR, "no error is pending after the test")


if __name__ == "__main__":
    require(os.environ.get("EXPECT") in ("layer", "nothing"), "EXPECT is `layer` or `nothing`")
    openers = {"glx": open_glx, "egl": open_egl, "osmesa": open_osmesa}
    check(openers[sys.argv[1]](), os.environ["EXPECT"] == "layer")
