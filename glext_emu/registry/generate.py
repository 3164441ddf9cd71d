#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Generates the layer's boring half from gl.xml, proposed.xml and hooks.list.

  generate.py --registry gl.xml [--registry proposed.xml ...] --hooks hooks.list --out DIR

writes real_gl.h, real_gl_names.inc, hot_bits.h and entry.cpp. Exit status 1, with one sentence on stderr,
where hooks.list and gl.xml disagree or a draw, query or conditional-render command is not classified.
"""
import argparse
import pathlib
import re
import sys
import xml.etree.ElementTree as ET

# A command with one of these shapes draws, queries or renders conditionally, and has to be classified.
LOOKS_LIKE_DRAW_OR_QUERY = re.compile(
    r"^gl(Multi(Mode)?)?Draw|^glRect|^glEvalMesh|^glCallList|^gl(Bitmap|Begin$|End$|CopyPixels)|Quer(y|ies)|Conditional"
    r"|^gl(Named)?FramebufferDrawBuffer")

# Classes of commands that a driver may lack: where a device emulates something, they have a wrapper even so.
SUPPLIED = {"nvquery", "nvxrender", "instrument", "visibility", "fardepth", "region", "unit", "work"}

# Classes whose commands may stand between Begin and End, or look for themselves whether they do.
UNGUARDED = {"immediate", "call", "enable", "get", "region"}

BANNER = "// Generated from the registries and hooks.list. Do not edit.\n"


class Command:
    """One command of gl.xml: name, C return type, parameters as (declaration, name), the root of its alias family."""

    def __init__(self, element):
        proto = element.find("proto")
        self.name = proto.find("name").text
        self.returns = "".join(proto.itertext())[: -len(self.name)].strip()
        self.params = [(" ".join("".join(p.itertext()).split()), p.find("name").text) for p in element.findall("param")]
        alias = element.find("alias")
        self.alias = alias.get("name") if alias is not None else None

    def declaration(self, name):
        return f"{self.returns} {name}({self.parameters()})"

    def parameters(self):
        return ", ".join(declaration for declaration, _ in self.params)

    def arguments(self):
        return ", ".join(name for _, name in self.params)


def fail(sentence):
    sys.exit(f"generate.py: {sentence}")


def read_registry(paths):
    """The commands of gl.xml and of further registries in its form, by name."""
    commands = {}
    for path in paths:
        for element in ET.parse(path).getroot().find("commands"):
            command = Command(element)
            if command.name in commands:
                fail(f"{path}: {command.name} stands in an earlier registry")
            commands[command.name] = command
    for command in commands.values():  # walk each alias to its root
        seen = {command.name}
        while command.alias and commands[command.alias].alias and command.alias not in seen:
            seen.add(command.alias)
            command.alias = commands[command.alias].alias
    return commands


def snake_case(name):
    """glGetQueryObjectui64v -> get_query_objectui64v"""
    return re.sub(r"(?<=[a-z0-9])(?=[A-Z])", "_", name.removeprefix("gl")).lower()


def read_hooks(path, commands):
    """Returns hooks {name: (class, how)}, the names in [real] and the expressions in [leave]."""
    hooks, real, leave, section = {}, [], [], None
    for number, raw in enumerate(path.read_text().splitlines(), 1):
        line = raw if section == "leave" else raw.split("#")[0]
        line = line.strip()
        if not line or line.startswith("#"):
            continue
        if match := re.fullmatch(r"\[(\w+)\]", line):
            section = match[1]
            continue
        if section is None:
            fail(f"{path}:{number}: a command before the first [class]")
        if section == "leave":
            parts = line.split(None, 1)
            if len(parts) != 2:
                fail(f"{path}:{number}: an expression without the reason why it is left alone")
            leave.append(re.compile(parts[0]))
            continue
        match = re.fullmatch(r"(gl\w+)\s*(?:=\s*(\w+)|:\s*(.+))?", line)
        if not match:
            fail(f"{path}:{number}: expected `glName`, `glName = function` or `glName : triangles`, found `{line}`")
        name, function, triangles = match.groups()
        if name not in commands:
            fail(f"{path}:{number}: no registry has a command {name}")
        if name in hooks or name in real:
            fail(f"{path}:{number}: {name} stands twice")
        if section == "real":
            real.append(name)
            continue
        if (section == "draw") != (triangles is not None):
            fail(f"{path}:{number}: in [draw], and only there, a command says how many triangles it draws")
        hooks[name] = (section, triangles or function or snake_case(name))
    for command in commands.values():
        root = command.alias
        if root in hooks and command.name not in hooks:
            if len(command.params) != len(commands[root].params):
                fail(f"{command.name} is called an alias of {root} but has other parameters")
            section, how = hooks[root]
            if section == "draw":  # the expression names the root's parameters
                renamed = dict(zip((n for _, n in commands[root].params), (n for _, n in command.params)))
                how = re.sub(r"\w+", lambda m: renamed.get(m[0], m[0]), how)
            hooks[command.name] = (section, how)
    return hooks, real, leave


def check_every_draw_and_query_is_classified(commands, hooks, leave):
    for name in sorted(commands):
        if not LOOKS_LIKE_DRAW_OR_QUERY.search(name):
            continue
        left = [expression for expression in leave if expression.fullmatch(name)]
        if name in hooks and left:
            fail(f"{name} is both hooked and matched by `{left[0].pattern}` in [leave]")
        if name not in hooks and not left:
            fail(f"{name} looks like a draw, query or conditional-render command and hooks.list does not classify it")


def real_gl_header(commands, names):
    fields = "\n".join(f"    {commands[n].returns} (*{n})({commands[n].parameters()});" for n in names)
    return (f"{BANNER}#pragma once\n#include <GL/gl.h>\n#include <GL/glext.h>\n#include <GL/glext_emu.h>\n\n"
            "namespace glext_emu {\n\n"
            "// The driver's own functions, in the order of real_gl_names.inc; null where the driver has none.\n"
            f"struct RealGl {{\n{fields}\n}};\n\n}}  // namespace glext_emu\n")


def hot_bits_header(hooks):
    classes = list(dict.fromkeys(section for section, _ in hooks.values()))
    bits = "\n".join(f"inline constexpr std::uint32_t kHot{c.capitalize()} = 1u << {i};" for i, c in enumerate(classes))
    return (f"{BANNER}#pragma once\n#include <cstdint>\n\nnamespace glext_emu {{\n\n"
            "// A bit of the hot word for each class of hooks.list.\n"
            f"{bits}\n"
            f"inline constexpr std::uint32_t kHotAll = {hex((1 << len(classes)) - 1)};\n\n}}  // namespace glext_emu\n")


def wrapper(command, section, how):
    """The fast path holds nothing but the test and a jump, so the slow one is a function of its own."""
    call = f"current.real->{command.name}({command.arguments()})"
    forward = f"return {call};"
    if section in SUPPLIED:
        forward = f"return current.real->{command.name} == nullptr ? {command.returns}() : {call};"
    if section == "draw":
        body = f"    features::draw(ctx, features::{how}, [&] {{ {call}; }});"
    else:
        arguments = ", ".join(["ctx"] + [name for _, name in command.params])
        body = f"    return features::{how}({arguments});"
    guard = ""
    if section not in UNGUARDED:
        guard = f"    if (ctx.is_between_begin_and_end()) [[unlikely]] {forward}\n"
    return (f"[[gnu::noinline, gnu::cold]] static {command.declaration('slow_' + command.name)} {{\n"
            f"    Context& ctx = enter();\n{guard}{body}\n}}\n"
            f"{command.declaration(command.name)} {{\n"
            f"    if (!(current.hot & kHot{section.capitalize()})) [[likely]] {forward}\n"
            f"    return slow_{command.name}({command.arguments()});\n}}")


def entry_source(commands, hooks):
    names = sorted(hooks)
    wrappers = "\n\n".join(wrapper(commands[n], *hooks[n]) for n in names)
    table = "\n".join(f'    {{"{n}", reinterpret_cast<void*>(wrappers::{n}), '
                      f'{"true" if hooks[n][0] in SUPPLIED else "false"}}},' for n in names)
    return (f'{BANNER}#include "entry/entry.h"\n\n#include "features/features.h"\n\n'
            "namespace glext_emu {\nnamespace wrappers {\n\n"
            f"{wrappers}\n\n}}  // namespace wrappers\n\n"
            "// Sorted by name.\n"
            f"const Hook kHooks[] = {{\n{table}\n}};\n"
            f"const std::size_t kHookCount = {len(names)};\n\n}}  // namespace glext_emu\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--registry", type=pathlib.Path, action="append", required=True)
    parser.add_argument("--hooks", type=pathlib.Path, required=True)
    parser.add_argument("--out", type=pathlib.Path, required=True)
    args = parser.parse_args()

    commands = read_registry(args.registry)
    hooks, real, leave = read_hooks(args.hooks, commands)
    check_every_draw_and_query_is_classified(commands, hooks, leave)

    names = sorted(set(hooks) | set(real))
    args.out.mkdir(parents=True, exist_ok=True)
    (args.out / "real_gl.h").write_text(real_gl_header(commands, names))
    (args.out / "real_gl_names.inc").write_text("".join(f'"{n}",\n' for n in names))
    (args.out / "hot_bits.h").write_text(hot_bits_header(hooks))
    (args.out / "entry.cpp").write_text(entry_source(commands, hooks))


if __name__ == "__main__":
    main()
