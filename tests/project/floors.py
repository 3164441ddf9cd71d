# SPDX-License-Identifier: MIT
"""The floors of the house: which folder may include which, and which outside headers.

A file belongs to the longest folder of FLOORS that holds it. It may include its own folder, the folders
named there, and outside headers of the kinds named there. An include that names a file of the tree is found
as the compiler finds it: beside the including file, or from a folder above it. A quoted include of a file
that the build generates has its floor in GENERATED.
"""
import re
from pathlib import PurePosixPath

LANGUAGES = {".h", ".hpp", ".c", ".cc", ".cpp", ".inl", ".inc"}

# Outside headers by kind; the first pattern that matches decides.
KINDS = (
    ("khronos", r"(GL|GLES|GLES2|GLES3|EGL|KHR|glvnd)/"),
    ("x11", r"X11/"),
    ("glm", r"glm/"),
    ("toml", r"toml\+\+/"),
    ("cli", r"(CLI|fmt|nlohmann)/"),
    ("image", r"png\.h"),
    ("model", r"(assimp/|meshoptimizer\.h)"),
    ("threads", r"tbb/"),
    ("test", r"(gtest|gmock|benchmark|rapidcheck)/|rapidcheck\.h"),
    ("window", r"(SDL2|GLFW)/"),
    ("std", r"[a-z_0-9]+$"),
    ("std", r"(assert|ctype|errno|float|inttypes|limits|locale|math|setjmp|signal|stdarg|stdbool|stddef)\.h$"),
    ("std", r"(stdint|stdio|stdlib|string|time|wchar)\.h$"),
    ("system", r"(sys|linux|bits|asm|net|arpa|netinet)/"),
    ("system", r"(dlfcn|elf|fcntl|link|poll|pthread|sched|semaphore|spawn|strings|unistd|alloca|malloc)\.h$"),
)  # fmt: skip

LAYER = {"std", "system", "khronos", "x11"}
CLIENT = {"std", "system", "glm", "cli", "image", "model", "threads"}

# folder -> (folders that it may include beside itself, kinds of outside headers)
FLOORS = {
    "occlusion_unit": (set(), {"std"}),
    "glext_emu/real_gl": (set(), LAYER),
    "glext_emu/context": ({"glext_emu/real_gl", "occlusion_unit"}, LAYER | {"toml"}),
    "glext_emu/features": ({"glext_emu/context", "glext_emu/real_gl", "occlusion_unit"}, LAYER),
    "glext_emu/entry": (
        {"glext_emu/features", "glext_emu/context", "glext_emu/real_gl", "occlusion_unit"},
        LAYER,
    ),
    "glext_emu/front": (
        {"glext_emu/entry", "glext_emu/features", "glext_emu/context", "glext_emu/real_gl", "occlusion_unit"},
        LAYER,
    ),
    "glext_emu/launcher": (
        {"glext_emu/context", "glext_emu/real_gl", "occlusion_unit"},
        LAYER | {"toml", "cli"},
    ),
    "apps": ({"apps"}, CLIENT),
    "apps/scene": (set(), CLIENT),
    "apps/hierarchy": ({"apps/scene"}, CLIENT),
    "apps/calibrate": ({"apps"}, CLIENT | {"khronos"}),
    "apps/oracle": ({"apps"}, CLIENT | {"khronos"}),
    "apps/platform": ({"apps"}, CLIENT | {"khronos", "x11"}),
    "apps/query": ({"apps"}, CLIENT | {"khronos"}),
    "apps/render": ({"apps"}, CLIENT | {"khronos"}),
    "conformance": (set(), {"std", "system", "khronos", "x11", "test"}),
    "docs/examples": (set(), {"std", "system", "khronos", "x11", "window"}),
}
# Tests look at everything.
EVERYWHERE = ("tests",)

# What the build generates from gl.xml and the device files, and the floor that it stands on. The header of the proposed
# extensions, GL/glext_emu.h, is everybody's, as an installed one.
GENERATED = {
    "real_gl.h": "glext_emu/real_gl",
    "real_gl_names.inc": "glext_emu/real_gl",
    "hot_bits.h": "glext_emu/real_gl",
    "builtin_devices.inc": "glext_emu/context",
}

INCLUDE = re.compile(r'^\s*#\s*include(?:_next)?\s*(?:<([^>]+)>|"([^"]+)")', re.MULTILINE)


def folder_in(path, folders):
    """The longest of `folders` that holds `path`, or None."""
    return max((f for f in folders if path.is_relative_to(f)), key=len, default=None)


def resolve(name, includer, files):
    """The file of the tree that an include names, or None."""
    for folder in includer.parents:
        parts = []
        for part in (folder / name).parts:
            parts = parts[:-1] if part == ".." else [*parts, part]
        if PurePosixPath(*parts) in files:
            return PurePosixPath(*parts)
    return None


def kind_of(name):
    return next((kind for kind, pattern in KINDS if re.match(pattern, name)), "unknown")


def fault_of(includer, name, quoted, files):
    """What is wrong with one include, as half a sentence, or None."""
    floor = folder_in(includer, FLOORS)
    if floor is None:
        return "lies in a folder that has no floor yet: give it one in tests/project/floors.py"
    below, kinds = FLOORS[floor]
    target = resolve(name, includer, files)
    if target is None and name in GENERATED:
        target = PurePosixPath(GENERATED[name]) / name
    if target is not None:
        owner = folder_in(target, FLOORS)
        allowed = owner == floor or (owner is not None and folder_in(target, below) is not None)
        return (
            None if allowed else f"may not include {target}: {floor} stands on {sorted(below) or 'nothing'}"
        )
    if quoted:
        return f'includes "{name}", which is no file of the tree and none that the build is known to generate'
    kind = kind_of(name)
    return None if kind in kinds else f"may not include <{name}>, a header of the kind {kind}"


def violations(texts):
    """Sentences, one per include that breaks the floors. `texts`: relative path -> content."""
    files = {PurePosixPath(path): text for path, text in texts.items()}
    found = []
    for path, text in sorted(files.items()):
        if path.suffix not in LANGUAGES or path.parts[0] in EVERYWHERE:
            continue
        for match in INCLUDE.finditer(text):
            name, quoted = match.group(1) or match.group(2), match.group(2) is not None
            fault = fault_of(path, name, quoted, files)
            if fault:
                line = text.count("\n", 0, match.start(1 if not quoted else 2)) + 1
                found.append(f"{path}:{line} {fault}")
    return found
