#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""The report is one JSON object whatever happens to the program, and counts what the program did."""
import json
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time
import unittest

LAUNCHER, EXAMPLE = sys.argv[1], sys.argv[2]
del sys.argv[1:]
if "DISPLAY" not in os.environ:
    sys.exit(77)


class Report(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = pathlib.Path(folder.name) / "report.json"

    def command(self, *program, device="visualize-fx"):
        return [LAUNCHER, "run", "--device", device, "--report", str(self.path), "--", *program]

    def records(self, kind):
        return [record for record in json.loads(self.path.read_text())["records"] if record["kind"] == kind]

    def test_it_counts_tests_reads_and_draws(self):
        subprocess.run(self.command(EXAMPLE), check=True, stdout=subprocess.DEVNULL)
        # SDL tries a context out before it makes the program's.
        context = self.records("context")[-1]
        self.assertEqual((context["platform"], context["device"], context["clock"]), ("glx", "visualize-fx", "none"))
        self.assertEqual(context["program"], pathlib.Path(EXAMPLE).name)
        self.assertTrue(context["version"].startswith("1.1 "))
        (frame,) = self.records("frame")
        # The wall and two boxes, of which each box is a test of its own.
        self.assertEqual((frame["draws"], frame["triangles"]), (3, 6))
        self.assertEqual((frame["queries_begun"], frame["waits"], frame["results"], frame["polls"]), (2, 2, 2, 0))
        self.assertGreater(frame["stall_ms"], 0)

    def test_a_wall_clock_shows_as_stalled_time(self):
        command = self.command(EXAMPLE)
        command[2:2] = ["--clock", "wall=20000"]
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
        (frame,) = self.records("frame")
        self.assertGreaterEqual(frame["stall_ms"], 2 * 20)

    def test_it_is_whole_after_the_program_was_killed(self):
        process = subprocess.Popen(self.command("glxgears", device="mesa"), stdout=subprocess.DEVNULL)
        deadline = time.monotonic() + 30
        while time.monotonic() < deadline and not (self.path.exists() and len(self.records("frame")) > 10):
            time.sleep(0.1)
        process.send_signal(signal.SIGKILL)
        process.wait()
        frames = self.records("frame")
        self.assertGreater(len(frames), 10)
        self.assertEqual([frame["frame"] for frame in frames], list(range(len(frames))))

    def test_processes_share_one_report(self):
        script = f'"{EXAMPLE}" & "{EXAMPLE}" & "{EXAMPLE}" & wait'
        subprocess.run(self.command("sh", "-c", script), check=True, stdout=subprocess.DEVNULL)
        contexts, frames = self.records("context"), self.records("frame")
        self.assertEqual(len({record["pid"] for record in contexts}), 3)
        self.assertEqual({record["pid"] for record in contexts}, {record["pid"] for record in frames})

    def test_a_file_that_is_no_report_is_left_alone(self):
        self.path.write_text("precious\n")
        library = pathlib.Path(LAUNCHER).parent.parent / "lib" / "libglext_emu.so"
        result = subprocess.run([EXAMPLE], capture_output=True, text=True,
                                env={**os.environ, "LD_PRELOAD": str(library),
                                     "GLEXT_EMU": f"device=mesa,report={self.path}"})
        self.assertEqual(self.path.read_text(), "precious\n")
        self.assertIn("is not a report, so nothing is written to it", result.stderr)

    def test_a_file_that_may_not_grow_stays_whole_and_the_program_goes_on(self):
        # 200 blocks of 512 bytes: some hundred frames.
        command = self.command("timeout", "3", "glxgears", device="mesa")
        result = subprocess.run(["sh", "-c", 'ulimit -f 200; exec "$@"', "sh", *command], capture_output=True, text=True)
        self.assertEqual(result.returncode, 124, "timeout ended it, not a signal")
        self.assertIn("cannot be written", result.stderr)
        self.assertGreater(len(self.records("frame")), 10)
        self.assertLessEqual(self.path.stat().st_size, 200 * 512)

    def test_an_earlier_report_is_replaced_by_the_launcher(self):
        for _ in range(2):
            subprocess.run(self.command(EXAMPLE), check=True, stdout=subprocess.DEVNULL)
            self.assertEqual(len({record["pid"] for record in self.records("context")}), 1)

    def test_a_program_without_gl_leaves_an_empty_report(self):
        subprocess.run(self.command("true"), check=True)
        self.assertEqual(json.loads(self.path.read_text()), {"glext_emu_report": 1, "records": []})


if __name__ == "__main__":
    unittest.main()
