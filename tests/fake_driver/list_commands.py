#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Lists every command of the registries for the fake driver, as C++: COMMAND(glName, class, has_driver).

  list_commands.py --registry gl.xml [--registry proposed.xml ...] --hooks hooks.list --out commands.inc

<class> is the class of hooks.list that wires the command, by its own name or as an alias, or "". <has_driver> is false
for commands of further registries, which no driver has. Reads hooks.list by its documented form alone, not by the
layer's generator, which is under test.
"""
import argparse
import pathlib
import re
import xml.etree.ElementTree as ET


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--registry", type=pathlib.Path, action="append", required=True)
    parser.add_argument("--hooks", type=pathlib.Path, required=True)
    parser.add_argument("--out", type=pathlib.Path, required=True)
    args = parser.parse_args()

    alias_of, drivers = {}, set()
    for registry in args.registry:
        for command in ET.parse(registry).getroot().find("commands"):
            name, alias = command.find("proto/name").text, command.find("alias")
            alias_of[name] = alias.get("name") if alias is not None else None
            if registry == args.registry[0]:
                drivers.add(name)

    class_of, section = {}, None
    for line in args.hooks.read_text().splitlines():
        if match := re.match(r"\[(\w+)\]", line):
            section = match[1]
        elif section not in (None, "real", "leave") and (match := re.match(r"gl\w+", line)):
            class_of[match[0]] = section

    def wired(name):
        seen = set()
        while name and name not in seen:
            if name in class_of:
                return class_of[name]
            seen.add(name)
            name = alias_of.get(name)
        return ""

    args.out.write_text("".join(
        f'COMMAND({name}, "{wired(name)}", {"true" if name in drivers else "false"})\n' for name in sorted(alias_of)))


if __name__ == "__main__":
    main()
