# SPDX-License-Identifier: MIT
"""What the times depend on: processor, threads, driver, system and the commit of the tree."""
import os
import platform
import subprocess
from pathlib import Path


def cpu_name():
    for line in Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines():
        if line.startswith("model name"):
            return line.split(":", 1)[1].strip()
    return platform.machine()


def system_name():
    for line in Path("/etc/os-release").read_text(encoding="utf-8").splitlines():
        if line.startswith("PRETTY_NAME="):
            return line.split("=", 1)[1].strip('"')
    return platform.system()


def driver_name(summary):
    """Mesa's version and its rasteriser, without the GL version, which is the emulated device's."""
    renderer = str(summary.get("device", "unknown")).split(", GL ")[0]
    return f"Mesa {summary.get('mesa', 'unknown')}, {renderer}"


def commit(root):
    """The short hash, with a word if the tree differs from it; a sentence where there is no repository."""
    try:
        git = ["git", "-c", f"safe.directory={root}", "-C", str(root)]
        name = subprocess.run(
            [*git, "rev-parse", "--short=12", "HEAD"], capture_output=True, text=True, check=True
        )
        changed = subprocess.run(
            [*git, "status", "--porcelain", "--untracked-files=no"],
            capture_output=True,
            text=True,
            check=True,
        )
    except (OSError, subprocess.CalledProcessError):
        return "unknown (not a git checkout)"
    return name.stdout.strip() + (" with local changes" if changed.stdout.strip() else "")


def describe(root, threads, summary, size, load_before):
    """Pairs (what, value) for the page. `summary`: that of any walkthrough run; load: of the last minute."""
    return [
        ("Processor", f"{cpu_name()}, {os.cpu_count()} cores"),
        ("Rasteriser threads", f"LP_NUM_THREADS={threads}"),
        ("Driver", driver_name(summary)),
        ("System", f"{system_name()}, Linux {platform.release()}"),
        ("Picture size", f"{size} pixels"),
        ("Load before the first run", f"{load_before:.2f}"),
        ("Commit", commit(root)),
    ]
