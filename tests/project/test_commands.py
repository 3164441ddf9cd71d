# SPDX-License-Identifier: MIT
"""The two commands at the root explain themselves, refuse what they do not know, and count honestly."""
import subprocess
import tempfile
import unittest
from pathlib import Path

from count_results import count, main
from tree import ROOT


def run(*command):
    return subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)


class Help(unittest.TestCase):
    def test_each_command_explains_itself(self):
        for command in ("./check", "./evaluate"):
            with self.subTest(command=command):
                told = run(command, "--help")
                self.assertEqual(told.returncode, 0)
                self.assertTrue(told.stdout.startswith(f"usage: {command}"))
                self.assertIn("Exit status", told.stdout)

    def test_evaluate_refuses_a_wrong_option_before_it_builds(self):
        for wrong in (
            ("--no-such-option",),
            ("--frames", "0"),
            ("--scale", "2"),
            ("--latencies", "5,x"),
            ("--out",),
        ):
            with self.subTest(options=wrong):
                told = run("./evaluate", *wrong)
                self.assertEqual(told.returncode, 2)
                self.assertIn("./evaluate: error: ", told.stderr)
                self.assertNotIn("configuring", told.stdout)

    def test_the_continuous_integration_calls_check(self):
        self.assertEqual(run(".ci/run", "--help").stdout, run("./check", "--help").stdout)


RESULTS = """<?xml version="1.0"?><testsuite>
<testcase name="good" status="run"><system-out>fine</system-out></testcase>
<testcase name="bad" status="fail"><failure message=""/></testcase>
<testcase name="lacking" status="notrun"><skipped message="SKIP_RETURN_CODE=77"/>
<system-out>no display</system-out></testcase>
<testcase name="gone" status="notrun"><skipped message="Unable to find executable"/></testcase>
<testcase name="off" status="disabled"/>
</testsuite>"""


class Counting(unittest.TestCase):
    def result_of(self, text):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder, "results.xml")
            path.write_text(text, encoding="utf-8")
            return main(path), count(path)

    def test_a_missing_program_is_a_failure_and_77_is_a_skip(self):
        status, lists = self.result_of(RESULTS)
        self.assertEqual(status, 1)
        self.assertEqual([name for name, _ in lists["passed"]], ["good"])
        self.assertEqual([name for name, _ in lists["failed"]], ["bad", "gone"])
        self.assertEqual(
            lists["skipped"], [("lacking", "no display"), ("off", "disabled in its CMakeLists.txt")]
        )

    def test_one_pass_and_no_failure_is_success(self):
        self.assertEqual(self.result_of('<testsuite><testcase name="a" status="run"/></testsuite>')[0], 0)

    def test_no_test_at_all_is_a_failure(self):
        self.assertEqual(self.result_of("<testsuite/>")[0], 1)
        skip = '<testcase name="a" status="notrun"><skipped message="SKIP_RETURN_CODE=77"/></testcase>'
        self.assertEqual(self.result_of(f"<testsuite>{skip}</testsuite>")[0], 1)

    def test_no_results_file_is_a_failure(self):
        self.assertEqual(main(Path("/nonexistent/results.xml")), 1)


if __name__ == "__main__":
    unittest.main()
