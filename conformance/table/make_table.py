# SPDX-License-Identifier: MIT
"""The table of all numbered statements: what a run of the tests showed of each.

usage: make_table.py BUILD_FOLDER [RESULTS.xml]

Reads statements.tsv and the PLAN.md files of this tree, BUILD_FOLDER/conformance/runs.tsv with the results it
names, and ctest's JUnit file (BUILD_FOLDER/results.xml); writes conformance.md and conformance.html into
BUILD_FOLDER/conformance. Prints what is wrong, then a summary line, then where the pages are.

Exit status: 0; 1 when a statement stands in no plan or in two, a plan names a test that was not run, every
machine skipped a statement, or anything failed; 2 when there are no results to read.
"""
import sys
import xml.etree.ElementTree as xml
from pathlib import Path

from judge import judge
from pages import html, markdown, summary
from plans import read_plans, read_statements
from runs import read_results

MOST_FAULTS = 40  # on the terminal; the pages hold all


def make(tree, build, junit):
    """Writes the pages; gives the judged statements and the faults."""
    statements = read_statements(tree / "statements.tsv")
    rows, faults = read_plans(tree)
    results = read_results(build / "conformance" / "runs.tsv", junit)
    judged, more = judge(statements, rows, results)
    faults += more
    for name, page in (("conformance.md", markdown), ("conformance.html", html)):
        (build / "conformance" / name).write_text(page(judged, faults), encoding="utf-8")
    return judged, faults


def main(arguments):
    if len(arguments) not in (1, 2) or arguments[0].startswith("-"):
        print(__doc__)
        return 0 if arguments == ["--help"] else 2
    tree = Path(__file__).resolve().parents[1]
    build = Path(arguments[0])
    junit = Path(arguments[1]) if arguments[1:] else build / "results.xml"
    try:
        judged, faults = make(tree, build, junit)
    except (OSError, xml.ParseError) as error:
        print(f"no results to make a table of: {error}", file=sys.stderr)
        return 2
    for fault in faults[:MOST_FAULTS]:
        print(f"conformance: {fault}")
    if len(faults) > MOST_FAULTS:
        print(f"conformance: and {len(faults) - MOST_FAULTS} more")
    print(f"conformance: {summary(judged)}")
    print(f"conformance: {build / 'conformance' / 'conformance.html'}")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
