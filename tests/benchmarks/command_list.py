#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Lists every command of gl.xml as `hooked NAME` or `left NAME`, as hooks.list has it.

  command_list.py gl.xml hooks.list OUT.txt

Reads hooks.list by its documented form alone, not by the layer's generator, which is under test.
"""
import pathlib
import re
import sys
import xml.etree.ElementTree as ET


def main():
    registry, hooks, out = map(pathlib.Path, sys.argv[1:])
    alias_of = {}
    for command in ET.parse(registry).getroot().find("commands"):
        alias = command.find("alias")
        alias_of[command.find("proto/name").text] = alias.get("name") if alias is not None else None
    section, hooked = None, set()
    for line in hooks.read_text().splitlines():
        if match := re.match(r"\[(\w+)\]", line):
            section = match[1]
        elif section not in (None, "real", "leave") and (match := re.match(r"gl\w+", line)):
            hooked.add(match[0])

    def is_hooked(name):
        seen = set()
        while name and name not in seen:
            if name in hooked:
                return True
            seen.add(name)
            name = alias_of.get(name)
        return False

    out.write_text("".join(f"{'hooked' if is_hooked(name) else 'left'} {name}\n" for name in sorted(alias_of)))


if __name__ == "__main__":
    main()
