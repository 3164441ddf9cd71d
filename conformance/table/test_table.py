# SPDX-License-Identifier: MIT
"""Each kind of failure that the table exists to see, on small made-up trees."""
import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from make_table import make

TABLE = "| statement | test | remark |\n|---|---|---|\n"
STATEMENTS = (
    "statement\tsection\tsource\ttext\n"
    "AB-01\tFirst\tclause\tIt is.\n"
    "AB-02\tFirst\t\tIt | is <not>.\n"
)
GOOD = "| AB-01, 02 | `Suite.one`, `Suite.two` | |\n"
RUNS = "run\tresults\tfolder\tkind\tdriver\tfront\tplatform\tdevice\tclock\tdeparture\n"


def told(name, outcome):
    """One test in GoogleTest's JSON."""
    test = {"name": name, "result": "SKIPPED" if outcome == "skipped" else "COMPLETED"}
    return {**test, "failures": [{"failure": "file:1\nis wrong"}]} if outcome == "failed" else test


class Tree:
    """A folder with everything that the table reads."""

    def __init__(self, folder, plan=GOOD, runs=None, ctests=None):
        self.root = Path(folder)
        self.build = self.root / "build"
        (self.root / "some_extension").mkdir()
        (self.build / "conformance").mkdir(parents=True)
        (self.root / "statements.tsv").write_text(STATEMENTS)
        (self.root / "some_extension" / "PLAN.md").write_text("# Plan\n\n" + TABLE + plan)
        lines, cases = [], dict(ctests or {})
        for run in runs if runs is not None else [{}]:
            self.add(lines, cases, **run)
        (self.build / "conformance" / "runs.tsv").write_text(RUNS + "".join(lines))
        cases = "".join(self.case(name, status) for name, status in cases.items())
        (self.build / "results.xml").write_text(f"<testsuite>{cases}</testsuite>")

    def add(self, lines, cases, name="conformance.native.some", tests=None, status="run", departure="",
            kind="native", driver="llvmpipe", front="none"):  # fmt: skip
        path = self.build / f"{name}.json"
        lines.append(f"{name}\t{path}\tsome_extension\t{kind}\t{driver}\t{front}\tegl\t\t\t{departure}\n")
        tests = tests if tests is not None else {"one": "passed", "two": "passed"}
        suite = {"name": "Suite", "testsuite": [told(*test) for test in tests.items()]}
        path.write_text(json.dumps({"testsuites": [suite] if tests else []}))
        if status:
            cases[name] = status

    @staticmethod
    def case(name, status):
        if status == "skipped":
            return (f"<testcase name='{name}' status='notrun'><skipped message='SKIP_RETURN_CODE=77'/>"
                    "<system-out>no display</system-out></testcase>")  # fmt: skip
        return f"<testcase name='{name}' status='{status}'/>"


class TheTable(unittest.TestCase):
    def judge(self, **tree):
        with tempfile.TemporaryDirectory() as folder:
            made = Tree(folder, **tree)
            judged, faults = make(made.root, made.build, made.build / "results.xml")
            self.pages = {page.suffix: page.read_text() for page in (made.build / "conformance").glob("c*.*")}
        return [one.verdict for one in judged], faults

    def expect_fault(self, part, count=1, **tree):
        verdicts, faults = self.judge(**tree)
        self.assertEqual([part in fault for fault in faults], [True] * count, faults)
        return verdicts

    def test_what_passed_has_no_fault(self):
        self.assertEqual(self.judge(), (["passed", "passed"], []))

    def test_a_statement_in_no_plan_is_a_fault(self):
        self.expect_fault("AB-02 stands in no plan", plan="| AB-01 | `Suite.one` | |\n")

    def test_a_statement_in_two_rows_is_a_fault(self):
        self.expect_fault("AB-01 stands in more than one row", plan=GOOD + "| AB-01 | `Suite.two` | |\n")

    def test_a_number_that_is_no_statement_is_a_fault(self):
        self.expect_fault("there is no statement AB-03", plan=GOOD + "| AB-03 | `Suite.two` | |\n")

    def test_a_test_that_does_not_exist_is_a_fault(self):
        verdicts = self.expect_fault("no run has a test Suite.three", plan=GOOD.replace("two", "three"))
        self.assertEqual(verdicts, ["missing", "missing"])

    def test_a_name_that_is_not_whole_is_a_fault(self):
        for name in ("two", "Suite.tw...", "some words"):
            with self.subTest(name=name):
                self.expect_fault(f"`{name}` is no full test name", plan=GOOD + f"| AB-01 | `{name}` | |\n")

    def test_a_row_without_test_and_reason_is_a_fault(self):
        for remark in ("", "with another extension", "not applicable:"):
            with self.subTest(remark=remark):
                _, faults = self.judge(plan=GOOD + f"| AB-01 | | {remark} |\n")
                self.assertEqual(len(faults), 1)

    def test_a_failed_test_is_a_fault(self):
        runs = [{"tests": {"one": "failed", "two": "passed"}, "status": "fail"}]
        part = "Suite.one failed in conformance.native.some: file:1 is wrong"
        verdicts = self.expect_fault(part, runs=runs)
        self.assertEqual(verdicts, ["failed", "failed"])

    def test_a_failure_on_one_machine_of_many_is_a_fault(self):
        worse = {"name": "conformance.emu.some", "kind": "emu", "front": "seam", "status": "fail"}
        runs = [{}, {**worse, "tests": {"one": "failed", "two": "passed"}}]
        self.assertIn("failed", self.expect_fault("failed in conformance.emu.some", runs=runs))

    def test_a_run_that_failed_or_was_not_run_is_a_fault(self):
        for status, part in (("fail", "none of its tests failed"), ("", "was not run")):
            with self.subTest(status=status):
                runs = [{}, {"name": "conformance.native.other", "status": status}]
                self.expect_fault(part, runs=runs)

    def test_a_run_without_tests_is_a_fault(self):
        self.expect_fault("no test ran in it", runs=[{}, {"name": "conformance.native.other", "tests": {}}])

    def test_a_statement_that_every_machine_skipped_is_a_fault(self):
        runs = [{"tests": {"one": "skipped", "two": "skipped"}}]
        self.assertEqual(self.expect_fault("every machine skipped it", 2, runs=runs), ["missing"] * 2)
        plan = "| AB-01, 02 | `Suite.one` | not applicable: no machine has it |\n"
        self.assertEqual(self.judge(plan=plan, runs=runs), (["not applicable"] * 2, []))

    def test_one_machine_that_did_not_skip_is_enough(self):
        runs = [{"tests": {"one": "skipped", "two": "passed"}}, {"name": "conformance.native.other"}]
        self.assertEqual(self.judge(runs=runs), (["passed"] * 2, []))

    def test_a_departure_is_told_and_is_no_fault(self):
        apart = {"name": "conformance.native.some.departure.Suite.one", "departure": "Suite.one"}
        runs = [{"tests": {"two": "passed"}}, {**apart, "tests": {"one": "failed"}}]
        self.assertEqual(self.judge(runs=runs), (["departs"] * 2, []))
        followed = {"name": "conformance.emu.some", "kind": "emu", "front": "seam"}
        self.assertEqual(self.judge(runs=[*runs, followed]), (["passed"] * 2, []))
        self.assertIn("| AB-01 | departs | passed |", self.pages[".md"])
        departs = [{**followed, "tests": {"two": "passed"}},
                   {**followed, "name": "conformance.emu.some.departure.Suite.one", "departure": "Suite.one",
                    "tests": {"one": "failed"}}]
        self.assertEqual(self.judge(runs=[{}, *departs])[0], ["departs"] * 2)

    def test_a_departure_that_is_mended_is_a_fault(self):
        apart = {"name": "conformance.native.some.departure.Suite.one", "departure": "Suite.one"}
        runs = [{"tests": {"two": "passed"}}, {**apart, "tests": {"one": "passed"}, "status": "fail"}]
        self.expect_fault("is expected to depart from the text, and does not", runs=runs)

    def test_decisions_and_reasons_are_told(self):
        plan = "| AB-01 | `Suite.*` | decided: as it is |\n| AB-02 | | not applicable: no such thing |\n"
        self.assertEqual(self.judge(plan=plan), (["decided", "not applicable"], []))
        for page in self.pages.values():
            self.assertIn("as it is", page)
            self.assertIn("no such thing", page)
            self.assertIn("2 statements: 0 passed, 1 decided, 0 departs, 1 not applicable, 0 failed", page)

    def test_other_tests_of_the_tree_can_prove_a_statement(self):
        plan = "| AB-01, 02 | `ctest:programs.some` | |\n"
        self.assertEqual(self.judge(plan=plan, ctests={"programs.some": "run"}), (["passed"] * 2, []))
        self.expect_fault("there is no ctest programs.some", plan=plan)
        self.assertEqual(self.judge(plan=plan, ctests={"programs.some": "fail"})[0], ["failed"] * 2)
        part = "every machine skipped it (no display)"
        self.expect_fault(part, 2, plan=plan, ctests={"programs.some": "skipped"})

    def test_all_values_of_a_parameterised_test_are_one_name(self):
        runs = [{"tests": {"one/0": "passed", "one/1": "failed", "two": "passed"}, "status": "fail"}]
        self.assertEqual(self.judge(runs=runs)[0], ["failed", "failed"])

    def test_columns_are_the_groups_of_machines(self):
        runs = [
            {},
            {"name": "a", "kind": "emu", "front": "seam", "tests": {"one": "skipped"}},
            {"name": "b", "kind": "emu", "front": "vendor"},
            {"name": "c", "driver": "softpipe"},
        ]
        self.judge(runs=runs)
        self.assertIn("| AB-01 | passed | skipped | passed | passed |  | passed |", self.pages[".md"])
        self.assertIn("It \\| is &lt;not>.", self.pages[".md"])

    def test_the_exit_status_is_the_verdict(self):
        program = [sys.executable, "-B", str(Path(__file__).with_name("make_table.py"))]
        for arguments, status in (([], 2), (["/nonexistent"], 2), (["--help"], 0)):
            with self.subTest(arguments=arguments):
                done = subprocess.run(program + arguments, capture_output=True, text=True, check=False)
                self.assertEqual(done.returncode, status, done.stderr)


if __name__ == "__main__":
    unittest.main()
