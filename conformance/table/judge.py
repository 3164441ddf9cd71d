# SPDX-License-Identifier: MIT
"""From plans and results to one verdict per statement, and the list of what is wrong."""
from collections import Counter
from dataclasses import dataclass, field
from fnmatch import fnmatchcase

from plans import DECIDED, NOT_APPLICABLE
from runs import DEPARTS, FAILED, PASSED, SEAM, SKIPPED, WORST_FIRST

# The verdicts, as the summary counts them.
MISSING, NA, DECISION = "missing", "not applicable", "decided"
VERDICTS = (PASSED, DECISION, DEPARTS, NA, FAILED, MISSING)


@dataclass
class Judged:
    """A statement, and what became of it."""

    statement: object
    verdict: str = MISSING
    remark: str = ""
    tests: list = field(default_factory=list)  # names, as the plan has them
    cells: dict = field(default_factory=dict)  # column -> the worst outcome there
    departures: list = field(default_factory=list)  # observations


def worst(outcomes):
    return min(outcomes, key=WORST_FIRST.index)


def judge(statements, rows, results):
    """The judged statements in order, and the faults: sentences, each reason enough to fail."""
    faults = list(results.faults)
    stands = Counter()
    judged = {number: Judged(statement) for number, statement in statements.items()}
    for row in rows:
        observed = observations_of(row, results, faults)
        for number in row.numbers:
            stands[number] += 1
            if number not in statements:
                faults.append(f"{row.folder}/PLAN.md: there is no statement {number}")
            elif stands[number] == 1:
                fill(judged[number], row, observed, faults)
            elif stands[number] == 2:
                faults.append(f"{number} stands in more than one row of the plans (again in {row.folder})")
    for number in statements:
        if not stands[number]:
            faults.append(f"{number} stands in no plan")
    for (folder, name), observations in sorted(results.tests.items()):
        for one in observations:
            if one.outcome == FAILED:
                faults.append(f"{folder}: {name} failed in {one.run}: {first_line(one.said)}")
    return list(judged.values()), faults


def observations_of(row, results, faults):
    """What each test of a row did: name -> observations."""
    observed = {}
    for name in row.tests:
        keys = find(row.folder, name, results)
        if not keys:
            faults.append(f"{row.folder}/PLAN.md: no run has a test {name}")
        observed[name] = [one for key in keys for one in results.tests[key]]
    for name in row.ctests:
        if name not in results.ctests:
            faults.append(f"{row.folder}/PLAN.md: there is no ctest {name}, or it was not run")
        observed[f"ctest:{name}"] = [results.ctests[name]] if name in results.ctests else []
    return observed


def find(folder, name, results):
    """The tests that a name in a plan means: of the plan's own program, else of whichever has it."""
    hits = [key for key in results.tests
            if key[1] == name or key[1].startswith(name + "/") or fnmatchcase(key[1], name)]  # fmt: skip
    own = [key for key in hits if key[0] == folder]
    return own or hits


def fill(judged, row, observed, faults):
    judged.remark = row.remark
    judged.tests = list(observed)
    by_column = {}
    for observations in observed.values():
        for one in observations:
            by_column.setdefault(one.column, []).append(one.outcome)
            if one.outcome == DEPARTS:
                judged.departures.append(one)
    judged.cells = {column: worst(outcomes) for column, outcomes in by_column.items()}
    judged.verdict = verdict_of(observed)
    nothing_ran = judged.verdict == SKIPPED or not observed
    if row.remark.startswith(NOT_APPLICABLE) and nothing_ran:
        judged.verdict = NA
    elif row.remark.startswith(DECIDED) and judged.verdict == PASSED:
        judged.verdict = DECISION
    elif judged.verdict == SKIPPED:
        judged.verdict = MISSING
        faults.append(f"{judged.statement.number}: every machine skipped it ({reason_of(observed)})")


def verdict_of(observed):
    """A test is shown by one machine, an emulated one where there is any that does not skip: a driver that follows the
    text does not excuse a device that departs. A statement is worth as much as the worst of its tests."""
    verdicts = []
    for observations in observed.values():
        if not observations:
            return MISSING
        emulated = [one for one in observations if one.column == SEAM and one.outcome != SKIPPED]
        failed = [one for one in observations if one.outcome == FAILED]
        outcomes = {one.outcome for one in failed or emulated or observations}
        verdicts.append(next(one for one in (FAILED, PASSED, DEPARTS, SKIPPED) if one in outcomes))
    return worst(verdicts) if verdicts else MISSING


def reason_of(observed):
    said = {one.said for observations in observed.values() for one in observations if one.said}
    return "; ".join(sorted(said)) or "no reason given"


def first_line(text):
    """Of a failure: GoogleTest begins with the place, which says less than what follows."""
    lines = [line.strip() for line in text.splitlines() if line.strip()]
    return " ".join(lines[:3])[:200]
