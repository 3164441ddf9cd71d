# SPDX-License-Identifier: MIT
"""Runs the commands of one document, each block in a copy of the tree whose build/release is the given build.

usage: run_document.py DOCUMENT.md BUILD_FOLDER        exit status: 0 if all went well, else 1

Each block is one `bash -euo pipefail`, from the root of a fresh copy: it has to say all it needs.
"""
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from documents import BadDocument, blocks
from shell_words import programs
from tree import ROOT, project_files

LIMIT_S = 240


def copy_tree(root, build, place):
    """The files of the project in a new folder, with the build where the documents say that it is."""
    for path in project_files(root):
        target = place / path
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy2(root / path, target)
    (place / "build").mkdir(exist_ok=True)
    (place / "build/release").symlink_to(build)


def bash(script, place, *options):
    """Exit status and output of a script."""
    try:
        done = subprocess.run(
            ["bash", *options, "-c", script], cwd=place, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT, text=True, timeout=LIMIT_S, check=False,
        )  # fmt: skip
    except subprocess.TimeoutExpired:
        return 124, f"not done after {LIMIT_S} s"
    return done.returncode, done.stdout


def fault_of(block, place):
    """What is wrong with a block, or None."""
    status, told = bash(block.text, place, "-n")
    if status:
        return f"is not shell: {told}"
    for program in sorted(programs(block.text)):
        if not shutil.which(program) and not (place / program).exists():
            return f"calls {program}, which is neither installed nor in the tree"
    if block.script is None:
        return None
    status, told = bash(block.script, place, "-euo", "pipefail")
    return f"ended with status {status}:\n{block.script}\n{told}" if status else None


def run(document, build, root=ROOT):
    """The faults of a document as sentences, and how many blocks were looked at."""
    try:
        found = blocks(document.read_text(encoding="utf-8"))
    except BadDocument as error:
        return [f"{document.name}:{error}"], 0
    faults = []
    for block in found:
        with tempfile.TemporaryDirectory() as folder:
            copy_tree(root, build, Path(folder))
            fault = fault_of(block, Path(folder))
        if fault:
            faults.append(f"{document.name}:{block.line}: the block {fault}")
    return faults, len(found)


def main(document, build):
    if not os.environ.get("DISPLAY"):  # programs of the documents open windows
        os.execvp(
            "xvfb-run", ["xvfb-run", "--auto-servernum", "--server-args=-noreset", sys.executable, *sys.argv]
        )
    faults, count = run(document.resolve(), build.resolve())
    print("\n".join(faults))
    print(f"{document.name}: {count} blocks, {len(faults)} faults")
    return 1 if faults else 0


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    sys.exit(main(Path(sys.argv[1]), Path(sys.argv[2])))
