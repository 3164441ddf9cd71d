# SPDX-License-Identifier: MIT
"""The files that make up the project: what is in git, and what would be if it were added now."""
import os
import subprocess
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


def git(root, *arguments):
    """The lines that git prints; `safe.directory` because a checkout may belong to another user."""
    command = ["git", "-c", f"safe.directory={root}", "-C", str(root), *arguments]
    told = subprocess.run(command, capture_output=True, check=True).stdout
    return os.fsdecode(told).split("\0")[:-1]


def project_files(root=ROOT):
    """Paths relative to `root`, of files that exist; ignored files (build/, report/) are none of them."""
    names = git(root, "ls-files", "-z", "--cached", "--others", "--exclude-standard")
    return sorted({Path(name) for name in names if (root / name).is_file()})


def tracked_files(root=ROOT):
    return sorted(Path(name) for name in git(root, "ls-files", "-z", "--cached"))
