#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""exports.py LIBRARY seam|vendor|export: the layer's library exports what its front end needs, and nothing else.

An exported gl* symbol crashes programs that have a variable of that name, and puts the layer above other
interposers, so only the last has them; an unversioned dlsym is passed over by those that ask dlvsym.
"""
import re
import subprocess
import sys

VERSION_NODES = {"GLIBC_2.2.5", "GLIBC_2.34"}
DLSYM = {f"{name}@{version}" for name in ("dlsym", "dlopen") for version in VERSION_NODES}
NEEDED = {"seam": DLSYM,
          "vendor": {"__glx_Main", "__egl_Main", "glext_emu_vendor"},
          "export": DLSYM | {"glEnable", "glBeginOcclusionQueryNV", "glXMakeCurrent", "glXGetProcAddressARB",
                             "eglMakeCurrent", "eglGetProcAddress", "OSMesaMakeCurrent", "OSMesaGetProcAddress"}}
GL_NAME = re.compile(r"(gl|egl|OSMesa)[A-Z]\w+")

library, front = sys.argv[1:]
lines = subprocess.run(["nm", "--dynamic", "--defined-only", library], check=True, capture_output=True,
                       text=True).stdout.splitlines()
names = {line.split()[-1].replace("@@", "@") for line in lines}
exported = {name for name in names if name.split("@")[0] not in VERSION_NODES}
surplus = exported - NEEDED[front]
if front == "export":
    surplus = {name for name in surplus if not GL_NAME.fullmatch(name)}
if surplus or NEEDED[front] - exported:
    sys.exit(f"failed: exported and not allowed {sorted(surplus)}, missing {sorted(NEEDED[front] - exported)}")
