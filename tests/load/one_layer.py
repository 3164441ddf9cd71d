#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""one_layer.py LIBRARIES PROGRAM: two front ends at once are one layer, whichever two they are and in any order.

PROGRAM makes one context and checks that the layer is there; each layer that saw the context would report it.
"""
import json
import os
import pathlib
import subprocess
import sys
import tempfile

folder, program = pathlib.Path(sys.argv[1]), sys.argv[2]
SEAM, EXPORTS = str(folder / "libglext_emu.so"), str(folder / "libglext_emu_exports.so")
VENDOR = {"__GLX_VENDOR_LIBRARY_NAME": "glextemu", "LD_LIBRARY_PATH": str(folder),
          "__EGL_VENDOR_LIBRARY_FILENAMES": str(folder / "50_glextemu.json")}

for preloads in ([], [SEAM], [EXPORTS], [SEAM, EXPORTS], [EXPORTS, SEAM]):
    for vendor in ({}, VENDOR):
        if not preloads and not vendor:
            continue
        with tempfile.TemporaryDirectory() as place:
            report = pathlib.Path(place) / "report.json"
            report.touch()
            subprocess.run([program], check=True, env={
                **os.environ, **vendor, "LD_PRELOAD": ":".join(preloads), "EXPECT": "layer",
                "GLEXT_EMU": f"device=visualize-fx,report={report}"})
            kinds = [record["kind"] for record in json.loads(report.read_text())["records"]]
        if kinds.count("context") != 1:
            sys.exit(f"failed: {kinds.count('context')} layers saw the context, with the preloads {preloads} and "
                     f"{'the vendor library' if vendor else 'no vendor library'}")
