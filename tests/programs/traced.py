# SPDX-License-Identifier: MIT
"""What a program calls, as apitrace sees it: apitrace stands between the program and libGL, so it records what the
program itself asked for, whatever the layer below makes of it."""
import dataclasses
import re
import subprocess

WRAPPER = "/usr/lib/x86_64-linux-gnu/apitrace/wrappers/glxtrace.so"


@dataclasses.dataclass(frozen=True)
class Call:
    name: str
    text: str  # the whole call as `apitrace dump` prints it, number and name cut off

    def value(self):
        """What the call wrote through its pointer `params = &VALUE`, or None."""
        found = re.search(r"params = &(\d+)", self.text)
        return int(found[1]) if found else None


def calls(trace, grep):
    """The calls of a trace file whose name matches `grep`, in order."""
    dump = subprocess.run(["apitrace", "dump", "--color=never", f"--grep={grep}", str(trace)], check=True, text=True,
                          errors="replace", stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
    found = (re.match(r"\d+ (?:@\d+ )?(\w+)(\(.*)", line) for line in dump.stdout.splitlines())
    return [Call(match[1], match[2]) for match in found if match]
