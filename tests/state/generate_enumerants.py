#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Writes every enumerant of desktop GL, from Khronos' gl.xml, as rows {"GL_NAME", 0xVALUE}, one per value.

    generate_enumerants.py gl.xml > enumerants.inc

Bit masks are left out: they are no name of a state. Where several names have one value, the shortest is taken, so that
a core name stands before its suffixed aliases.
"""
import sys
import xml.etree.ElementTree as ElementTree


def enumerants(registry):
    names = {}
    for block in registry.findall("enums"):
        if block.get("type") == "bitmask":
            continue
        for enumerant in block.findall("enum"):
            value = int(enumerant.get("value"), 0)
            if enumerant.get("api") in (None, "gl") and 0x100 <= value <= 0xFFFF:
                names.setdefault(value, []).append(enumerant.get("name"))
    return {value: min(candidates, key=lambda name: (len(name), name)) for value, candidates in names.items()}


def main():
    if len(sys.argv) != 2:
        sys.exit("generate_enumerants.py: expected the path of gl.xml")
    for value, name in sorted(enumerants(ElementTree.parse(sys.argv[1]).getroot()).items()):
        print(f'{{"{name}", 0x{value:04X}}},')


main()
