#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Generates the header of the proposed extensions, for programs that use them.

  generate_header.py --registry proposed.xml --out glext_emu.h

Like glext.h it has a section per extension: its name as a macro, its tokens, its types, and a pointer type per command.
The commands have no prototypes, since no library exports them: programs ask GetProcAddress.
"""
import argparse
import pathlib
import xml.etree.ElementTree as ET

from generate import Command

HEAD = """/* Generated from proposed.xml. Do not edit. */
#ifndef GLEXT_EMU_H_
#define GLEXT_EMU_H_ 1

#include <GL/gl.h>
#include <GL/glext.h>

/* Extensions that are proposed and emulated, not registered: their tokens are of the registry's experimental range
   and may change. docs/extensions/ has the texts. */

#ifdef __cplusplus
extern "C" {
#endif
"""
TAIL = """
#ifdef __cplusplus
}
#endif

#endif
"""


def section(extension, enums, types, commands, said):
    """A section as glext.h has it; what two extensions share stands in the first of them."""
    name = extension.get("name")
    lines = [f"\n#ifndef {name}", f"#define {name} 1"]
    required = [item for item in extension.find("require") if item.get("name") not in said]
    said.update(item.get("name") for item in required)
    named = {kind: [item.get("name") for item in required if item.tag == kind] for kind in ("enum", "type", "command")}
    lines += [f"#define {enum:<40} {enums[enum]}" for enum in named["enum"]]
    lines += [types[one] for one in named["type"]]
    for one in named["command"]:
        command = commands[one]
        lines.append(f"typedef {command.returns} (APIENTRYP PFN{one.upper()}PROC)({command.parameters() or 'void'});")
    return "\n".join(lines + [f"#endif /* {name} */\n"])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--registry", type=pathlib.Path, required=True)
    parser.add_argument("--out", type=pathlib.Path, required=True)
    args = parser.parse_args()

    root = ET.parse(args.registry).getroot()
    enums = {enum.get("name"): enum.get("value") for enum in root.iterfind("enums/enum")}
    types = {one.find("name").text: "".join(one.itertext()) for one in root.iterfind("types/type")}
    commands = {command.name: command for command in map(Command, root.iterfind("commands/command"))}
    said = set()
    sections = [section(e, enums, types, commands, said) for e in root.iterfind("extensions/extension")]
    args.out.parent.mkdir(parents=True, exist_ok=True)
    args.out.write_text(HEAD + "".join(sections) + TAIL)


if __name__ == "__main__":
    main()
