#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""A machine that passes through is the driver, and one that adds or hides extensions changes the list by no more.

    compare_with_driver.py same PRELOAD SETTING -- print_state...
    compare_with_driver.py extensions PRELOAD SETTING [+ADDED ...] [-HIDDEN ...] -- print_state...

Runs the program without the layer and under LD_PRELOAD=PRELOAD GLEXT_EMU=SETTING. `same` wants every line of its output
equal; `extensions` wants the driver's list, in its order, less the hidden names, with the added ones behind it.
"""
import difflib
import os
import subprocess
import sys


def run(program, **variables):
    environment = {k: v for k, v in os.environ.items() if k not in ("LD_PRELOAD", "GLEXT_EMU")} | variables
    done = subprocess.run(program, env=environment, stdout=subprocess.PIPE, text=True, timeout=120, check=True)
    return done.stdout.splitlines()


def extensions(lines):
    return [line.split()[1] for line in lines if line.startswith("extension ")]


def main():
    arguments, program = sys.argv[1 : sys.argv.index("--")], sys.argv[sys.argv.index("--") + 1 :]
    mode, preload, setting, *edits = arguments
    bare = run(program)
    layered = run(program, LD_PRELOAD=preload, GLEXT_EMU=setting)
    # Too short an output would be equal to itself whatever the layer did.
    if len(bare) < 1000 or len(extensions(bare)) < 100:
        sys.exit(f"print_state printed {len(bare)} lines and {len(extensions(bare))} extensions only")
    if mode == "extensions":
        added = [edit[1:] for edit in edits if edit.startswith("+")]
        hidden = {edit[1:] for edit in edits if edit.startswith("-")}
        missing = hidden - set(extensions(bare))
        if missing:
            sys.exit(f"the driver itself does not have {sorted(missing)}")
        bare = [name for name in extensions(bare) if name not in hidden] + added
        layered = extensions(layered)
    difference = list(difflib.unified_diff(bare, layered, "driver", setting, lineterm="", n=0))
    print("\n".join(difference) or f"equal in {len(bare)} lines")
    sys.exit(1 if difference else 0)


main()
