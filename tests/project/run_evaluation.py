# SPDX-License-Identifier: MIT
"""Runs the real evaluation, small, on a build; then twice with a walkthrough that goes wrong.

usage: run_evaluation.py BUILD_FOLDER
"""
import csv
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from tree import ROOT

BUILD = None
TINY = ("--no-papers", "--frames", "2", "--scale", "0.02", "--rounds", "1", "--latencies", "0,20")

# In place of the walkthrough, beside the real launcher: breaks one culler, or lies about false culls.
CRASHES = """#!/bin/sh
case "$*" in *"--culler ideal"*) echo "no such luck" >&2; exit 3 ;; esac
exec {walkthrough} "$@"
"""
CULLS = """#!/bin/sh
{walkthrough} "$@" || exit
while [ "$1" != --json ]; do shift; done
sed -i 's/"false_culls": *0/"false_culls": 1/' "$2"
grep -q '"false_culls": 1' "$2" && exit 1 || exit 0
"""


def evaluate(out, *options, programs=None):
    environment = {**os.environ, "PYTHONPATH": str(ROOT / "apps"), "PYTHONDONTWRITEBYTECODE": "1"}
    command = [
        sys.executable,
        "-m",
        "evaluation",
        "--programs",
        str(programs or BUILD / "bin"),
        "--out",
        str(out),
    ]
    return subprocess.run([*command, *options], env=environment, capture_output=True, text=True, check=False)


class Evaluation(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def with_walkthrough(self, script):
        programs = self.folder / "bin"
        programs.mkdir()
        (programs / "glext-emu").symlink_to(BUILD / "bin/glext-emu")
        (programs / "walkthrough").write_text(script.format(walkthrough=BUILD / "bin/walkthrough"))
        (programs / "walkthrough").chmod(0o755)
        return evaluate(self.folder / "report", *TINY, programs=programs)

    def test_a_quick_run_writes_the_page_the_rows_and_the_pictures(self):
        told = evaluate(self.folder / "report", "--quick")
        self.assertEqual(told.returncode, 0, told.stdout + told.stderr)
        page = (self.folder / "report/index.html").read_text()
        self.assertEqual((page.count("<svg"), page.count("data:image/png")), (3, 3))
        self.assertNotIn("Not everything ran", page)
        timed = list(csv.DictReader((self.folder / "report/device_time.csv").read_text().splitlines()))
        self.assertEqual([row["culler"] for row in timed], ["frustum", "stop-and-wait", "ideal"])
        for row in timed:
            self.assertEqual(float(row["stall_ms"]) > 0, row["culler"] == "stop-and-wait")
            self.assertGreaterEqual(float(row["device_ms"]), float(row["gpu_busy_ms"]))
        rows = list(csv.DictReader((self.folder / "report/table.csv").read_text().splitlines()))
        self.assertEqual(len(rows), 10)
        for row in rows:
            self.assertGreater(float(row["frame_ms"]), 0)
            self.assertEqual(float(row["queries"]) > 0, row["culler"] == "stop-and-wait")

    def test_a_run_that_fails_is_said_and_is_status_1(self):
        told = self.with_walkthrough(CRASHES)
        self.assertEqual(told.returncode, 1)
        self.assertIn("FAILED: visualize-fx.ideal.0us, judged: exit status 3: no such luck", told.stdout)
        self.assertIn("FAILED: geforce-fx-5950.ideal.device-time, 1: exit status 3: no such luck", told.stdout)
        self.assertIn("Not everything ran", (self.folder / "report/index.html").read_text())

    def test_a_false_cull_is_said_and_is_status_1(self):
        told = self.with_walkthrough(CULLS)
        self.assertEqual(told.returncode, 1, told.stdout + told.stderr)
        self.assertIn("DOES NOT HOLD: Nothing visible is culled", told.stdout)


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    BUILD = Path(sys.argv.pop(1)).resolve()
    unittest.main()
