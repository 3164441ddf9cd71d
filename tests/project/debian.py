# SPDX-License-Identifier: MIT
"""Debian's own records: which package a program is from, what a list of packages brings along."""
import re
import shutil
import subprocess
from pathlib import Path

FIELDS = ("Package", "Status", "Essential", "Priority", "Provides", "Pre-Depends", "Depends")


def installed():
    """Name -> fields of each installed package."""
    form = "\x1f".join(f"${{{field}}}" for field in FIELDS) + "\x1e"
    told = subprocess.run(["dpkg-query", "-W", "-f", form], capture_output=True, text=True, check=True).stdout
    records = (dict(zip(FIELDS, record.split("\x1f"))) for record in told.split("\x1e") if record)
    return {record["Package"]: record for record in records if record["Status"].endswith(" installed")}


def names_in(relation):
    """All package names of a Depends-like field: alternatives count as well, versions do not."""
    parts = re.split(r"[,|]", relation)
    return [re.sub(r"[(\[:].*", "", part).strip() for part in parts if part.strip()]


def closure(names, packages):
    """The installed packages among `names` and everything that they depend on."""
    providers = {}
    for name, record in packages.items():
        for virtual in [name, *names_in(record["Provides"])]:
            providers.setdefault(virtual, set()).add(name)
    found, waiting = set(), list(names)
    while waiting:
        for name in providers.get(waiting.pop(), ()):
            if name not in found:
                found.add(name)
                waiting += names_in(packages[name]["Depends"]) + names_in(packages[name]["Pre-Depends"])
    return found


def base(packages):
    """What every Debian has: essential, or of the priority `required` (apt is the latter)."""
    return [name for name, r in packages.items() if r["Essential"] == "yes" or r["Priority"] == "required"]


def owner(program):
    """The package that a program belongs to, or None. Follows alternatives; knows the merged /usr."""
    place = shutil.which(program)
    if place is None:
        return None
    real = str(Path(place).resolve())
    for path in (real, real.removeprefix("/usr"), place, place.removeprefix("/usr")):
        told = subprocess.run(["dpkg-query", "-S", path], capture_output=True, text=True, check=False)
        if told.returncode == 0:
            return told.stdout.split(":")[0].split(",")[0]
    return None
