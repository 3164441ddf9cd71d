# SPDX-License-Identifier: MIT
"""Is the C and C++ of the tree as .clang-format wants it? Skips (77) where clang-format is not installed.

usage: format.py [--fix]
"""
import shutil
import subprocess
import sys

from floors import LANGUAGES
from tree import ROOT, project_files


def main(fix):
    program = shutil.which("clang-format")
    if program is None:
        print("clang-format is not installed")
        return 77
    sources = [str(path) for path in project_files() if path.suffix in LANGUAGES]
    if not sources:
        print("no source file was found: the test looked at nothing")
        return 1
    mode = ["-i"] if fix else ["--dry-run", "--Werror"]
    done = subprocess.run([program, *mode, *sources], cwd=ROOT, capture_output=True, text=True, check=False)
    wrong = sorted(
        {line.split(":")[0] for line in done.stderr.splitlines() if "-Wclang-format-violations" in line}
    )
    print(done.stderr[:4000] if done.returncode and not wrong else "\n".join(wrong))
    print(f"{len(sources)} files, {len(wrong)} not as .clang-format wants: tests/project/format.py --fix")
    return 1 if done.returncode else 0


if __name__ == "__main__":
    sys.exit(main("--fix" in sys.argv[1:]))
