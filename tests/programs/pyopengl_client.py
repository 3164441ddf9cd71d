# SPDX-License-Identifier: MIT
"""A PyOpenGL program that uses the occlusion test of HP and the occlusion query of NV where PyOpenGL finds them, and
prints what it found as JSON. It knows nothing of the layer. usage: pyopengl_client.py

The window has 64 x 64 pixels; a wall at depth 0.5 covers its left half. A box of 10 x 10 pixels is asked about
thrice: behind the wall, before it, and behind it but for 4 columns.
"""
import json

from OpenGL import GL
from OpenGL import EGL
from OpenGL.GL.HP import occlusion_test as hp
from OpenGL.GL.NV import occlusion_query as nv

EGL_PLATFORM_SURFACELESS_MESA = 0x31DD  # EGL/eglext.h; PyOpenGL 3.1.6 has no module for it
SIZE, BOX = 64, 10
# Left edge of the box in pixels, its depth.
BOXES = {"behind": (5, 0.75), "before": (5, 0.25), "in part": (SIZE // 2 - 6, 0.75)}


def make_context():
    display = EGL.eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, None, None)
    EGL.eglInitialize(display, None, None)
    EGL.eglBindAPI(EGL.EGL_OPENGL_API)
    wanted = [EGL.EGL_SURFACE_TYPE, EGL.EGL_PBUFFER_BIT, EGL.EGL_DEPTH_SIZE, 24, EGL.EGL_NONE]
    configs, count = (EGL.EGLConfig * 1)(), EGL.EGLint()
    EGL.eglChooseConfig(display, (EGL.EGLint * len(wanted))(*wanted), configs, 1, count)
    size = [EGL.EGL_WIDTH, SIZE, EGL.EGL_HEIGHT, SIZE, EGL.EGL_NONE]
    surface = EGL.eglCreatePbufferSurface(display, configs[0], (EGL.EGLint * len(size))(*size))
    context = EGL.eglCreateContext(display, configs[0], EGL.EGL_NO_CONTEXT, None)
    EGL.eglMakeCurrent(display, surface, surface, context)


def draw(left, right, bottom, top, depth):
    GL.glBegin(GL.GL_QUADS)
    for x, y in ((left, bottom), (right, bottom), (right, top), (left, top)):
        GL.glVertex3f(x, y, -depth)
    GL.glEnd()


def draw_box(name):
    left, depth = BOXES[name]
    draw(left, left + BOX, 20, 20 + BOX, depth)


def draw_wall():
    GL.glViewport(0, 0, SIZE, SIZE)
    GL.glMatrixMode(GL.GL_PROJECTION)
    GL.glLoadIdentity()
    GL.glOrtho(0, SIZE, 0, SIZE, 0, 1)
    GL.glEnable(GL.GL_DEPTH_TEST)
    GL.glClear(GL.GL_COLOR_BUFFER_BIT | GL.GL_DEPTH_BUFFER_BIT)
    draw(0, SIZE // 2, 0, SIZE, 0.5)
    GL.glDepthMask(GL.GL_FALSE)


def test_by_hp(box):
    GL.glEnable(hp.GL_OCCLUSION_TEST_HP)
    draw_box(box)
    GL.glDisable(hp.GL_OCCLUSION_TEST_HP)
    first = GL.glGetBooleanv(hp.GL_OCCLUSION_TEST_RESULT_HP)
    return [bool(first), bool(GL.glGetBooleanv(hp.GL_OCCLUSION_TEST_RESULT_HP))]  # the second is always false


def count_by_nv(box, name):
    nv.glBeginOcclusionQueryNV(name)
    draw_box(box)
    nv.glEndOcclusionQueryNV()
    return int(nv.glGetOcclusionQueryuivNV(name, nv.GL_PIXEL_COUNT_NV))


def main():
    make_context()
    draw_wall()
    found = {"version": GL.glGetString(GL.GL_VERSION).decode(), "hp": bool(hp.glInitOcclusionTestHP()),
             "nv": bool(nv.glInitOcclusionQueryNV()), "nv_function": bool(nv.glBeginOcclusionQueryNV)}
    if found["hp"]:
        found["hp_results"] = {box: test_by_hp(box) for box in BOXES}
    if found["nv"]:
        name = int(nv.glGenOcclusionQueriesNV(1))
        found["nv_counts"] = {box: count_by_nv(box, name) for box in BOXES}
        found["nv_is_query"] = bool(nv.glIsOcclusionQueryNV(name))
        nv.glDeleteOcclusionQueriesNV(1, [name])
        found["nv_is_query_after_delete"] = bool(nv.glIsOcclusionQueryNV(name))
    print(json.dumps(found))


main()
