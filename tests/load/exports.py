#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""exports.py LIBRARY: the layer exports the two functions of its seam, in both versions, and no name of GL.

An exported gl* symbol crashes programs that have a variable of that name, and puts the layer above other
interposers; an unversioned dlsym is passed over by those that ask dlvsym.
"""
import subprocess
import sys

ALLOWED = {f"{name}@{version}" for name in ("dlsym", "dlopen") for version in ("GLIBC_2.2.5", "GLIBC_2.34")}
VERSION_NODES = {"GLIBC_2.2.5", "GLIBC_2.34"}

lines = subprocess.run(["nm", "--dynamic", "--defined-only", sys.argv[1]], check=True, capture_output=True,
                       text=True).stdout.splitlines()
names = {line.split()[-1].replace("@@", "@") for line in lines}
exported = {name for name in names if name.split("@")[0] not in VERSION_NODES}
if exported != ALLOWED:
    sys.exit(f"failed: exported and not allowed {sorted(exported - ALLOWED)}, "
             f"missing {sorted(ALLOWED - exported)}")
