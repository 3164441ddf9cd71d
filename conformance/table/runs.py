# SPDX-License-Identifier: MIT
"""What was run, and what became of it: the list of runs, GoogleTest's JSON of each, ctest's JUnit file."""
import csv
import json
import xml.etree.ElementTree as xml
from collections import defaultdict
from dataclasses import dataclass
from pathlib import Path

# What a test does on a machine; the worst comes first. A departure failed as it has to: the machine is known
# not to follow the text there.
FAILED, DEPARTS, PASSED, SKIPPED = "failed", "departs", "passed", "skipped"
WORST_FIRST = (FAILED, DEPARTS, PASSED, SKIPPED)

# Groups of machines: the columns of the table. The last holds what other tests of the tree prove.
BARE, SEAM, FRONTS, SOFTPIPE, ELSEWHERE = "bare", "seam", "fronts", "softpipe", "elsewhere"
COLUMNS = {
    BARE: "bare driver",
    SEAM: "emulated, seam",
    FRONTS: "emulated, other fronts",
    SOFTPIPE: "softpipe",
    ELSEWHERE: "other tests",
}


@dataclass(frozen=True)
class Observation:
    """What one test did in one run."""

    column: str
    run: str
    outcome: str
    said: str = ""  # why it was skipped, or the first failure


class Results:
    """Everything that a run of ctest left."""

    def __init__(self):
        self.tests = defaultdict(list)  # (folder, "Suite.test") -> observations
        self.ctests = {}  # name -> observation
        self.faults = []  # runs that failed without a test that did

    def folders_of(self, name):
        return {folder for folder, test in self.tests if test == name}


def column_of(run):
    if run["driver"] == "softpipe":
        return SOFTPIPE
    if run["kind"] == "native":
        return BARE
    return SEAM if run["front"] == "seam" else FRONTS


def read_junit(path):
    """Outcome of each ctest, by name. A test that did not run for another reason than its own word failed."""
    outcomes = {}
    for case in xml.parse(path).getroot().iter("testcase"):
        skipped = case.find("skipped")
        message = skipped.get("message", "") if skipped is not None else ""
        if case.get("status") == "run":
            outcomes[case.get("name")] = (PASSED, "")
        elif case.get("status") == "disabled" or message.startswith("SKIP_"):
            said = (case.findtext("system-out") or "").strip().splitlines()
            outcomes[case.get("name")] = (SKIPPED, said[-1].strip() if said else "")
        else:
            outcomes[case.get("name")] = (FAILED, message)
    return outcomes


def read_google_test(path):
    """Yields name, outcome and a word on it, of every test that the file tells of."""
    for suite in json.loads(Path(path).read_text(encoding="utf-8"))["testsuites"]:
        for test in suite["testsuite"]:
            name = f"{suite['name']}.{test['name']}"
            if test.get("failures"):
                yield name, FAILED, test["failures"][0]["failure"]
            elif test["result"] == "SKIPPED":
                yield name, SKIPPED, test.get("skipped", "")
            elif test["result"] == "COMPLETED":
                yield name, PASSED, ""


def read_results(runs_path, junit_path):
    results = Results()
    outcomes = read_junit(junit_path)
    with open(runs_path, encoding="utf-8", newline="") as lines:
        runs = list(csv.DictReader(lines, delimiter="\t", quoting=csv.QUOTE_NONE))
    for name in outcomes.keys() - {run["run"] for run in runs}:
        results.ctests[name] = Observation(ELSEWHERE, name, *outcomes[name])
    for run in runs:
        outcome, said = outcomes.get(run["run"], (FAILED, ""))
        if run["run"] not in outcomes:
            results.faults.append(f"{run['run']} was not run")
        elif outcome != SKIPPED:
            add_run(results, run, outcome, said)
    return results


def add_run(results, run, outcome, said):
    try:
        told = list(read_google_test(run["results"]))
    except (OSError, ValueError, KeyError) as error:
        results.faults.append(f"{run['run']}: {said or outcome}, and left no results: {error}")
        return
    failures = 0
    for name, became, word in told:
        if run["departure"]:
            # The one test that has to fail; ctest knows whether it did so without crashing.
            became = DEPARTS if became == FAILED and outcome == PASSED else FAILED
            word = word if became == DEPARTS else "is expected to depart from the text, and does not"
        failures += became == FAILED
        results.tests[run["folder"], name].append(Observation(column_of(run), run["run"], became, word))
    if outcome == FAILED and not failures:
        results.faults.append(f"{run['run']}: {said or outcome}, though none of its tests failed")
    if not told:
        results.faults.append(f"{run['run']}: no test ran in it")
