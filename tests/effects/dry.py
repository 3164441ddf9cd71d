# SPDX-License-Identifier: MIT
"""--dry: draws are counted and take their time on the machine, and nothing is rasterised.

  dry.py WALKTHROUGH
"""
import collections
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import under_device

CLEAR_COLOR = bytes(round(255 * value) for value in (0.2, 0.4, 0.6, 1))
DRAWN = ("draws", "triangles", "device_ms", "gpu_busy_ms", "device_stall_ms", "back_pressure_ms", "starvation_ms",
         "drain_ms")
WALK = ("--scene", "chc-city", "--scale", "0.1", "--culler", "frustum", "--frames", "4")


def drawn(frames):
    return [[frame[name] for name in DRAWN] for frame in frames]


def colors(picture):
    return collections.Counter(picture[at:at + 4] for at in range(0, len(picture), 4))


class ADryRun(unittest.TestCase):
    def walk(self, *layer_options):
        with tempfile.TemporaryDirectory(prefix="glext_emu_dry_") as folder:
            report, lines = pathlib.Path(folder) / "report.json", pathlib.Path(folder) / "frames.jsonl"
            done = subprocess.run(
                [under_device.LAUNCHER, "run", "--device", "geforce-fx-5950", "--clock", "device", "--report", report,
                 *layer_options, "--", WALKTHROUGH, *WALK, "--json", lines],
                env={**os.environ, "LP_NUM_THREADS": "0"}, capture_output=True, text=True, timeout=120, check=False)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            told = [json.loads(line) for line in lines.read_text().splitlines()]
            records = json.loads(report.read_text())["records"]
        return ([frame for frame in told if "frame" in frame],
                [record for record in records if record["kind"] == "frame"])

    def test_of_a_walk_draws_as_much_in_the_same_time(self):
        wet, wet_frames = self.walk("--without", "fill")
        dry, dry_frames = self.walk("--without", "fill", "--dry")
        self.assertEqual(drawn(dry_frames), drawn(wet_frames))
        for name in ("device_ms", "drawn_triangles", "drawn_objects"):
            self.assertEqual([frame[name] for frame in dry], [frame[name] for frame in wet])
        self.assertGreater(sum(frame["drawn_triangles"] for frame in dry), 1000)
        self.assertGreater(min(frame["device_ms"] for frame in dry), 0)

    def test_counts_triangles_of_lists_and_of_begin_and_end(self):
        for words in ("clear mesh=50,3", "clear arrays=50,3", "clear immediate=50,3", "clear list=50,3"):
            wet = under_device.run(words.split(), without=("fill",))
            dry = under_device.run(words.split(), without=("fill",), more=("dry=1",))
            with self.subTest(words=words):
                self.assertEqual(drawn(dry.frames), drawn(wet.frames))
                # Three draws of 50 triangles, of which the machine does ten in a microsecond.
                self.assertEqual([frame["gpu_busy_ms"] for frame in dry.frames], [0.015, 0.015])

    def test_rasterises_nothing(self):
        for words in ("clear fill=32,32,1", "clear paint=32,32,2", "clear stamp=32,32,3"):
            with self.subTest(words=words):
                wet = colors(under_device.run(words.split()).picture)
                self.assertEqual(wet[CLEAR_COLOR], 64 * 64 - 32 * 32)
                dry = colors(under_device.run(words.split(), more=("dry=1",)).picture)
                self.assertEqual(dry, {CLEAR_COLOR: 64 * 64})

    def test_ends_where_the_program_asks_for_what_was_drawn(self):
        for words, command in (("clear read=8,8,1", "glReadPixels"), ("clear ask=8,8,1", "occlusion query"),
                               ("clear region=8,8,1", "region query"), ("clear unit=8,8,1", "Occlusion Unit")):
            with self.subTest(words=words), tempfile.TemporaryDirectory() as folder:
                self.assertEqual(under_device.start(words.split(), folder=folder)[0].returncode, 0)
                done, _, picture = under_device.start(words.split(), more=("dry=1",), folder=folder)
                self.assertEqual((done.returncode, done.stdout), (2, ""))
                self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
                self.assertIn("--dry rasterises nothing", done.stderr)
                self.assertIn(command, done.stderr)

    def test_is_refused_on_another_clock(self):
        done = subprocess.run([under_device.LAUNCHER, "run", "--dry", "--", under_device.CLIENT, "clear"],
                              capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 2)
        self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
        self.assertIn("dry", done.stderr)


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    WALKTHROUGH = sys.argv.pop(1)
    unittest.main(verbosity=2)
