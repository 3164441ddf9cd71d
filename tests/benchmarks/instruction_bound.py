#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""What the layer costs in instructions, counted by callgrind on a driver that does nothing.

  instruction_bound.py PROGRAM ICD.json LAYER.so

A command that is not hooked costs exactly nothing: GLVND jumps to the driver's own function. A hooked one
whose class is idle may cost the five instructions of the fast path: load the thread's offset, test the hot
word, branch, load the driver's table, jump. Machine code of another compiler may need one more, for a copy; a
call, a lock or a second test would show as more. The row samples_query (Begin, End, read) has no bound: it is
what is emulated.
"""
import pathlib
import re
import subprocess
import sys
import tempfile

CALLS = 10_000
BOUND = 6
NOT_HOOKED = {"glColor4f", "glVertex3f", "glTexImage2D"}
# Device: commands that it has to leave idle; the others of the program may take their slow path there.
IDLE = {
    "geforce-fx-5950": {"glGetError", "glIsEnabled", "glEnable", "glBegin", "glEnd", "glDrawArrays",
                        "glDrawElements"},
    "visualize-fx": {"glGetError", "glDrawArrays", "glDrawElements"},
}


# Never idle where lists may hold operations of the layer's: another thread of the share group may have made one.
WATCHED, WATCHED_BOUND = {"glCallList"}, 40


def count(program, icd, environment):
    """Instructions of each loop, by its name."""
    with tempfile.TemporaryDirectory() as folder:
        valgrind = ["valgrind", "--tool=callgrind", "--collect-atstart=no",
                    f"--callgrind-out-file={folder}/out"]
        base = {"PATH": "/usr/bin:/bin", "__EGL_VENDOR_LIBRARY_FILENAMES": icd}
        done = subprocess.run([*valgrind, program, str(CALLS)], env=dict(base, **environment), check=False,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        if done.returncode != 0 or done.stdout != "null\n":
            sys.exit(f"callgrind gave status {done.returncode}, renderer {done.stdout!r}\n{done.stderr}")
        counts = {}
        for dump in sorted(pathlib.Path(folder).iterdir(), key=lambda file: int(file.suffix[1:] or 0)):
            text = dump.read_text()
            trigger = re.search(r"^desc: Trigger: Client Request: (\w+)$", text, re.MULTILINE)
            if trigger:
                counts[trigger[1]] = int(re.search(r"^(?:totals|summary): (\d+)", text, re.MULTILINE)[1])
        return counts


def main():
    program, icd, layer = sys.argv[1:]
    bare, again = count(program, icd, {}), count(program, icd, {})
    if not NOT_HOOKED | set().union(*IDLE.values()) <= set(bare):
        sys.exit(f"the program counted only {sorted(bare)}")
    if bare != again:
        sys.exit("two runs without the layer differ: the counts mean nothing here")
    wrong = []
    print(f"instructions for one call, {CALLS} calls counted\n{'command':16}{'bare':>8}" +
          "".join(f"{device:>18}" for device in IDLE))
    under = {device: count(program, icd, {"LD_PRELOAD": layer, "GLEXT_EMU": f"device={device}"})
             for device in IDLE}
    for command in bare:
        row = f"{command:16}{bare[command] / CALLS:8.2f}"
        for device, idle in IDLE.items():
            more = (under[device][command] - bare[command]) / CALLS
            row += f"{more:+18.2f}"
            if command in NOT_HOOKED and more != 0:
                wrong.append(f"{command} is not hooked and costs {more:+.2f} instructions on {device}, not 0")
            if command in idle and not 0 < more <= BOUND:
                wrong.append(f"{command} is idle on {device} and costs {more:+.2f} instructions, not 1 to {BOUND}")
            if command in WATCHED and not 0 < more <= WATCHED_BOUND:
                wrong.append(f"{command} is watched on {device} and costs {more:+.2f} instructions, "
                             f"not 1 to {WATCHED_BOUND}")
        print(row)
    print("\n".join(wrong))
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
