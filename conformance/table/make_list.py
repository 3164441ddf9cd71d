# SPDX-License-Identifier: MIT
"""What the program `conformance` lists: folder, statements and test of every row of the plans, tab-separated.

usage: make_list.py OUTPUT.tsv
"""
import sys
from pathlib import Path

from plans import read_plans


def main(output):
    rows, faults = read_plans(Path(__file__).resolve().parents[1])
    for fault in faults:
        print(f"{fault}", file=sys.stderr)
    lines = [f"{row.folder}\t{', '.join(row.numbers)}\t{test}\n" for row in rows for test in row.tests]
    Path(output).write_text("folder\tstatements\ttest\n" + "".join(lines), encoding="utf-8")


if __name__ == "__main__":
    if len(sys.argv) != 2 or sys.argv[1].startswith("-"):
        sys.exit(__doc__)
    main(sys.argv[1])
