#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""The timeline of a real program: whole, as the report says, the same each time, and of the frames asked for.

usage: timeline_test.py GLEXT_EMU WALKTHROUGH
"""
import fcntl
import json
import pathlib
import re
import signal
import subprocess
import sys
import tempfile
import time
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent.parent / "project"))

from timeline_trace import check_timeline, load  # noqa: E402

LAUNCHER, WALKTHROUGH = sys.argv[1], sys.argv[2]
del sys.argv[1:]
DEVICE = "geforce-fx-5950"
WALK = (WALKTHROUGH, "--scene", "chc-city", "--culler", "stop-and-wait", "--scale", "0.02", "--frames")


class Timeline(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = pathlib.Path(folder.name) / "timeline.json"
        self.report = self.path.with_name("report.json")

    def command(self, *program, options=()):
        files = ("--timeline", str(self.path), "--report", str(self.report))
        return [LAUNCHER, "run", "--device", DEVICE, "--clock", "device", *files, *options, "--", *program]

    def run_program(self, *program, options=()):
        command = self.command(*program, options=options)
        return subprocess.run(command, check=True, stdout=subprocess.DEVNULL, timeout=60)

    def frames(self):
        with open(self.path, encoding="utf-8") as stream:
            fcntl.flock(stream, fcntl.LOCK_SH)  # not in the midst of a write
            events = json.load(stream)["traceEvents"]
        return [e["args"] for e in events if e["ph"] == "X" and e["cat"] == "frame"]

    def test_it_says_what_the_report_says(self):
        self.run_program(*WALK, "3")
        self.assertGreaterEqual(check_timeline(load(self.path), load(self.report)), 3)
        self.assertGreater(sum(frame["stall_ms"] for frame in self.frames()), 0)

    def test_effects_that_are_switched_off_leave_it_whole(self):
        options = ("--without", "starvation,latency,back-pressure")
        self.run_program(*WALK, "2", options=options)
        self.assertGreaterEqual(check_timeline(load(self.path), load(self.report)), 2)

    def test_it_holds_the_frames_that_were_asked_for(self):
        self.run_program(*WALK, "4", options=("--frames", "1..2"))
        self.assertEqual([frame["frame"] for frame in self.frames()], [1, 2])
        self.assertEqual(check_timeline(load(self.path), load(self.report)), 2)

    def test_two_runs_are_the_same_but_for_the_process(self):
        texts = []
        for _ in range(2):
            self.run_program(*WALK, "2")
            texts.append(re.sub(r'"pid":\d+|"id":"[0-9a-f]{8}', "", self.path.read_text()))
        self.assertEqual(*texts)

    def test_processes_share_one(self):
        walk = " ".join((*WALK, "2"))
        self.run_program("sh", "-c", f"{walk} & {walk} & wait")
        trace = load(self.path)
        self.assertGreaterEqual(check_timeline(trace, load(self.report)), 4)
        self.assertEqual(len({event["pid"] for event in trace["traceEvents"]}), 2)

    def test_it_is_whole_after_the_program_was_killed(self):
        process = subprocess.Popen(self.command(*WALK, "1000"), stdout=subprocess.DEVNULL)
        deadline = time.monotonic() + 30
        while time.monotonic() < deadline and not (self.path.exists() and len(self.frames()) > 2):
            time.sleep(0.05)
        process.send_signal(signal.SIGKILL)
        process.wait()
        self.assertGreater(check_timeline(load(self.path), load(self.report)), 2)

    def test_what_is_no_timeline_is_not_overwritten(self):
        self.path.write_text('{"traceEvents":[\n]}\n')
        done = subprocess.run(self.command("true"), capture_output=True, text=True, check=False)
        self.assertEqual((done.returncode, self.path.read_text()), (2, '{"traceEvents":[\n]}\n'))
        self.assertIn("exists and is not a timeline", done.stderr)


if __name__ == "__main__":
    unittest.main()
