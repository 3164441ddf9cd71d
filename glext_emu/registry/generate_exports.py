#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Generates the functions that the export front end has under GL's own names.

  generate_exports.py --registry gl.xml [--registry ...] --hooks hooks.list --exports exports.list --out exported.cpp

The wrappers themselves are generate.py's. Exit status 1, with one sentence on stderr, where a line of exports.list is
no prototype.
"""
import argparse
import pathlib
import re

from generate import BANNER, SUPPLIED, fail, read_hooks, read_registry

PLATFORMS = {"glX": "kGlx", "egl": "kEgl", "OSM": "kOsmesa"}

HEAD = """#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/glx.h>
#include <GL/glxext.h>

#include "context/current.h"
#include "front/exports.h"

#define EXPORT extern "C" __attribute__((visibility("default")))

using namespace glext_emu;

template <class T>
using Value = T;
"""


def gl_function(command, section):
    """A driver may lack what is supplied, and the wrapper knows; anything else that is missing is looked for again."""
    call = f"wrappers::{command.name}({command.arguments()})"
    body = f"    return {call};"
    if section not in SUPPLIED:
        body = (f"    if (current.real->{command.name} == nullptr) [[unlikely]] {{\n"
                f"        const auto next = reinterpret_cast<{command.returns} (*)({command.parameters()})>("
                f'exported_gl("{command.name}"));\n'
                f"        return next == nullptr ? Value<{command.returns}>() : next({command.arguments()});\n"
                f"    }}\n{body}")
    return (f"namespace glext_emu::wrappers {{\n{command.declaration(command.name)};\n}}\n"
            f"EXPORT {command.declaration(command.name)} {{\n{body}\n}}\n")


def winsys_function(prototype):
    match = re.fullmatch(r"(.+?)((?:glX|egl|OSMesa)\w+)\((.*)\)", prototype)
    if match is None:
        fail(f"`{prototype}` is no prototype of GLX, EGL or OSMesa")
    returns, name, parameters = (part.strip() for part in match.groups())
    arguments = ", ".join(re.findall(r"(\w+)(?:,|$)", parameters))
    return (f"EXPORT {returns} {name}({parameters}) {{\n"
            f"    const auto function = reinterpret_cast<{returns} (*)({parameters})>(\n"
            f'        exported_winsys(Platform::{PLATFORMS[name[:3]]}, "{name}", __builtin_return_address(0)));\n'
            f"    return function == nullptr ? Value<{returns}>() : function({arguments});\n}}\n")


def prototypes(path):
    lines = (line.split("#")[0].strip() for line in path.read_text().splitlines())
    return [line for line in lines if line]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--registry", type=pathlib.Path, action="append", required=True)
    for name in ("hooks", "exports", "out"):
        parser.add_argument(f"--{name}", type=pathlib.Path, required=True)
    args = parser.parse_args()

    commands = read_registry(args.registry)
    hooks, _, _ = read_hooks(args.hooks, commands)
    functions = [gl_function(commands[name], hooks[name][0]) for name in sorted(hooks)]
    functions += [winsys_function(prototype) for prototype in prototypes(args.exports)]
    args.out.write_text(BANNER + HEAD + "\n" + "\n".join(functions))


if __name__ == "__main__":
    main()
