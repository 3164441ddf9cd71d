# SPDX-License-Identifier: MIT
"""Draws docs/pictures/registers.png: three boxes about a wall, and what the Occlusion Unit tells of each.

usage, from the root of the tree, the numbers being those that the unit returns:

  build/release/bin/glext-emu run --device proposed-occlusion-unit -- /usr/bin/python3 docs/pictures/registers.py OUT.png
"""
import ctypes
import os
import sys

os.environ["PYOPENGL_PLATFORM"] = "egl"

import matplotlib  # noqa: E402  (after the platform is chosen)

matplotlib.use("Agg")

import matplotlib.pyplot as plt  # noqa: E402
import numpy  # noqa: E402
from OpenGL import EGL, GL  # noqa: E402

EGL_PLATFORM_SURFACELESS_MESA = 0x31DD  # EGL/eglext.h
ALL_REGISTERS = 0x1F  # GL/glext_emu.h
WIDTH, HEIGHT = 840, 300
NAMES = ("behind the wall", "half behind it", "beside the wall")
CENTERS = (-3.6, 0.0, 3.4)
FACES = ((0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5))  # from outside: counter-clockwise
SHADES = (0.75, 0.95, 0.6, 1.0, 0.7, 0.85)
ORANGE, WALL, GROUND = (0.95, 0.55, 0.15), (0.42, 0.47, 0.55), (0.93, 0.94, 0.96)


class Record(ctypes.Structure):
    """GLocclusionrecordEMU"""

    _fields_ = [("projected_hits", ctypes.c_uint64), ("visible_hits", ctypes.c_uint64), ("visible", ctypes.c_uint32),
                ("nearest_depth", ctypes.c_float), ("box", ctypes.c_int32 * 4), ("registers", ctypes.c_uint32),
                ("reserved", ctypes.c_uint32)]


def make_context():
    display = EGL.eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, None, None)
    EGL.eglInitialize(display, None, None)
    EGL.eglBindAPI(EGL.EGL_OPENGL_API)
    wanted = [EGL.EGL_SURFACE_TYPE, EGL.EGL_PBUFFER_BIT, EGL.EGL_RED_SIZE, 8, EGL.EGL_DEPTH_SIZE, 24, EGL.EGL_NONE]
    configs, count = (EGL.EGLConfig * 1)(), EGL.EGLint()
    EGL.eglChooseConfig(display, (EGL.EGLint * len(wanted))(*wanted), configs, 1, count)
    size = [EGL.EGL_WIDTH, WIDTH, EGL.EGL_HEIGHT, HEIGHT, EGL.EGL_NONE]
    surface = EGL.eglCreatePbufferSurface(display, configs[0], (EGL.EGLint * len(size))(*size))
    context = EGL.eglCreateContext(display, configs[0], EGL.EGL_NO_CONTEXT, None)
    EGL.eglMakeCurrent(display, surface, surface, context)


def command(name, *parameters):
    """A command of the extension, which no library exports."""
    extensions = GL.glGetString(GL.GL_EXTENSIONS).decode().split()
    if "GL_EMU_occlusion_unit" not in extensions:
        sys.exit(f"no GL_EMU_occlusion_unit here.\n{__doc__}")
    address = ctypes.cast(EGL.eglGetProcAddress(name), ctypes.c_void_p).value
    return ctypes.CFUNCTYPE(None, *parameters)(address)


def set_up():
    GL.glViewport(0, 0, WIDTH, HEIGHT)
    GL.glMatrixMode(GL.GL_PROJECTION)
    half = 0.5 * WIDTH / HEIGHT
    GL.glFrustum(-half, half, -0.5, 0.5, 2.5, 40)
    GL.glMatrixMode(GL.GL_MODELVIEW)
    GL.glRotatef(12, 1, 0, 0)
    GL.glTranslatef(0, -2.9, -12)
    GL.glEnable(GL.GL_DEPTH_TEST)
    GL.glClearColor(*GROUND, 1)
    GL.glClear(GL.GL_COLOR_BUFFER_BIT | GL.GL_DEPTH_BUFFER_BIT)


def draw_wall():
    GL.glColor3f(*WALL)
    GL.glBegin(GL.GL_QUADS)
    for x, y in ((-5.6, -1.6), (0, -1.6), (0, 1.9), (-5.6, 1.9)):
        GL.glVertex3f(x, y, 0)
    GL.glEnd()


def draw_box(center, mode):
    GL.glPolygonMode(GL.GL_FRONT_AND_BACK, mode)
    GL.glPushMatrix()
    GL.glTranslatef(center, 0, -3.2)
    GL.glRotatef(32, 0, 1, 0)
    GL.glBegin(GL.GL_QUADS)
    for face, shade in zip(FACES, SHADES):
        if mode == GL.GL_FILL:
            GL.glColor3f(*(shade * part for part in ORANGE))
        for corner in face:
            GL.glVertex3f(*(1.1 if corner >> bit & 1 else -1.1 for bit in range(3)))
    GL.glEnd()
    GL.glPopMatrix()
    GL.glPolygonMode(GL.GL_FRONT_AND_BACK, GL.GL_FILL)


def ask():
    """The record of each box. Back faces are culled, so a covered pixel counts once."""
    begin = command("glBeginOcclusionUnitEMU", ctypes.c_uint32, ctypes.c_uint32)
    end = command("glEndOcclusionUnitEMU")
    get = command("glGetOcclusionRecordsEMU", ctypes.c_uint32, ctypes.c_int32, ctypes.c_int32, ctypes.POINTER(Record))
    GL.glColorMask(False, False, False, False)
    GL.glDepthMask(False)
    GL.glEnable(GL.GL_CULL_FACE)
    records = []
    for center in CENTERS:
        name = int(numpy.ravel(GL.glGenQueries(1))[0])
        begin(ALL_REGISTERS, name)
        draw_box(center, GL.GL_FILL)
        end()
        record = Record()
        get(name, 0, 1, record)
        assert GL.glGetError() == GL.GL_NO_ERROR and record.registers == ALL_REGISTERS
        records.append(record)
    GL.glColorMask(True, True, True, True)
    GL.glDepthMask(True)
    GL.glDisable(GL.GL_CULL_FACE)
    return records


def draw_boxes():
    """What is visible of them is filled; all of their edges are drawn."""
    for center in CENTERS:
        draw_box(center, GL.GL_FILL)
    GL.glDisable(GL.GL_DEPTH_TEST)
    GL.glColor3f(0.2, 0.2, 0.2)
    for center in CENTERS:
        draw_box(center, GL.GL_LINE)
    pixels = GL.glReadPixels(0, 0, WIDTH, HEIGHT, GL.GL_RGB, GL.GL_UNSIGNED_BYTE)
    return numpy.frombuffer(pixels, numpy.uint8).reshape(HEIGHT, WIDTH, 3)


def told(record):
    box = "empty" if record.box[2] < record.box[0] else "{},{} to {},{}".format(*record.box)
    return (f"projected hits  {record.projected_hits:,}\nvisible hits    {record.visible_hits:,}\n"
            f"nearest depth   {record.nearest_depth:.6f}\nscreen box      {box}")


def main(out):
    make_context()
    set_up()
    draw_wall()
    records = ask()
    image = draw_boxes()
    figure, axes = plt.subplots(figsize=(WIDTH / 100, HEIGHT / 100 + 1.15), dpi=100)
    figure.subplots_adjust(left=0, right=1, top=1, bottom=1.15 / (HEIGHT / 100 + 1.15))
    axes.imshow(image, origin="lower", interpolation="nearest", aspect="auto")
    axes.axis("off")
    for at, (name, record) in enumerate(zip(NAMES, records)):
        left, bottom, right, top = record.box
        if record.visible:
            axes.add_patch(plt.Rectangle((left - 0.5, bottom - 0.5), right - left + 1, top - bottom + 1, fill=False,
                                         edgecolor="crimson", linewidth=2))
        figure.text(0.02 + at / 3, 0.235, name, fontsize=11, weight="bold", color="black")
        figure.text(0.02 + at / 3, 0.03, told(record), fontsize=9, family="monospace", linespacing=1.4)
    figure.savefig(out)
    print(*(f"{name}: {record.visible_hits:,} of {record.projected_hits:,}" for name, record in zip(NAMES, records)),
          sep="\n")


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(sys.argv[1])
