# SPDX-License-Identifier: MIT
"""Counts what ctest wrote (JUnit) and ends with the line `N passed, N failed, N skipped`.

ctest itself calls a test "not run" both when the test said so (exit status 77) and when its program is
missing or its fixture failed. Only the first is a skip; the others are failures. No test at all is one too.

usage: count_results.py RESULTS.xml        exit status: 0 if some test ran and none failed, else 1
"""
import sys
import xml.etree.ElementTree as xml
from pathlib import Path


def outcome_of(case):
    """The outcome of one <testcase>: `passed`, `failed` or `skipped`, and a reason for the last two."""
    status = case.get("status")
    skipped = case.find("skipped")
    message = skipped.get("message", "") if skipped is not None else ""
    if status == "run":
        return "passed", ""
    if status == "notrun" and message.startswith("SKIP_"):
        said = (case.findtext("system-out") or "").strip().splitlines()
        return "skipped", said[-1].strip() if said else ""
    if status == "disabled":
        return "skipped", "disabled in its CMakeLists.txt"
    return "failed", message


def count(results):
    """The three lists of (name, reason) that the results file holds."""
    lists = {"passed": [], "failed": [], "skipped": []}
    for case in xml.parse(results).getroot().iter("testcase"):
        outcome, reason = outcome_of(case)
        lists[outcome].append((case.get("name"), reason))
    return lists


def main(path):
    try:
        lists = count(path)
    except (OSError, xml.ParseError) as error:
        print(f"ctest left no results: {error}")
        lists = {"passed": [], "failed": [], "skipped": []}
    for outcome in ("skipped", "failed"):
        for name, reason in sorted(lists[outcome]):
            print(f"{outcome}: {name}" + (f" ({reason})" if reason else ""))
    if not lists["passed"] and not lists["failed"]:
        print("no test ran: that is a failure")
    print(", ".join(f"{len(lists[outcome])} {outcome}" for outcome in ("passed", "failed", "skipped")))
    return 0 if lists["passed"] and not lists["failed"] else 1


if __name__ == "__main__":
    if len(sys.argv) != 2 or sys.argv[1].startswith("-"):
        sys.exit(__doc__)
    sys.exit(main(Path(sys.argv[1])))
