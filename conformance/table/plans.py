# SPDX-License-Identifier: MIT
"""What is to be shown: the numbered statements (statements.tsv) and the plans of the folders (PLAN.md).

A plan has tables `| statement | test | remark |`. The first cell holds numbers (`HP-02, 06, MIX-01`), the
second full test names in backticks, or `ctest:NAME` for what another test of the tree proves. A name stands
for all values of a parameterised test of that name, and `*` in it for anything. A remark that begins with
`decided: ` says how an open text was read, one with `not applicable: ` why there is nothing to run.
"""
import csv
import re
from dataclasses import dataclass, field
from pathlib import Path

DECIDED = "decided: "
NOT_APPLICABLE = "not applicable: "
HEAD = ["statement", "test", "remark"]


@dataclass(frozen=True)
class Statement:
    number: str  # "HP-02"
    section: str
    text: str
    source: str  # the clause; empty where the statement follows from another


@dataclass
class Row:
    """One line of a plan."""

    folder: str
    numbers: list
    tests: list = field(default_factory=list)  # "Suite.test"
    ctests: list = field(default_factory=list)  # names of ctest
    remark: str = ""


def read_statements(path):
    """The statements by number, in the order of the file."""
    with open(path, encoding="utf-8", newline="") as lines:
        rows = list(csv.DictReader(lines, delimiter="\t", quoting=csv.QUOTE_NONE))
    statements = [Statement(row["statement"], row["section"], row["text"], row["source"]) for row in rows]
    return {one.number: one for one in statements}


def read_plans(folder):
    """The rows of every PLAN.md one folder down, and what is wrong with them."""
    rows, faults = [], []
    for plan in sorted(Path(folder).glob("*/PLAN.md")):
        in_table = False
        for number, line in enumerate(plan.read_text(encoding="utf-8").splitlines(), 1):
            cells = cells_of(line)
            if cells == HEAD:
                in_table = True
            elif not cells:
                in_table = False
            elif in_table and not all(set(cell) <= set("-: ") for cell in cells):
                try:
                    rows.append(parse_row(plan.parent.name, cells))
                except ValueError as error:
                    faults.append(f"{plan.parent.name}/PLAN.md:{number}: {error}")
    return rows, faults


def cells_of(line):
    """The cells of a line of a table; none of any other line."""
    if not line.startswith("|"):
        return []
    return [cell.strip() for cell in re.split(r"(?<!\\)\|", line)[1:-1]]


def parse_row(folder, cells):
    if len(cells) != len(HEAD):
        raise ValueError(f"{len(cells)} cells instead of {len(HEAD)}")
    row = Row(folder, parse_numbers(cells[0]), remark=cells[2])
    for name in re.findall(r"`([^`]*)`", cells[1]):
        if name.startswith("ctest:"):
            row.ctests.append(name.removeprefix("ctest:"))
        elif re.fullmatch(r"[^\s.]+\.\S+", name) and "..." not in name:
            row.tests.append(name)
        else:
            raise ValueError(f"`{name}` is no full test name")
    if not row.tests and not row.ctests and not row.remark.startswith(NOT_APPLICABLE):
        raise ValueError("neither a test nor a remark that begins with `not applicable: `")
    for word in (DECIDED, NOT_APPLICABLE):
        if row.remark.startswith(word.strip()) and not row.remark.removeprefix(word.strip()).strip():
            raise ValueError(f"`{word.strip()}` without saying what or why")
    return row


def parse_numbers(cell):
    """`HP-02, 06` -> ["HP-02", "HP-06"]."""
    numbers, prefix = [], None
    for word in cell.split(","):
        match = re.fullmatch(r"(?:([A-Z0-9]+)-)?(\d\d)", word.strip())
        if not match or not (match[1] or prefix):
            raise ValueError(f"`{word.strip()}` is no statement number")
        prefix = match[1] or prefix
        numbers.append(f"{prefix}-{match[2]}")
    return numbers
