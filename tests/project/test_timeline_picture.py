# SPDX-License-Identifier: MIT
"""The picture of a timeline shows what is in it, and the same picture comes of the same file.

usage: test_timeline_picture.py FIGURE_ONE_TRACES
"""
import json
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path
from xml.etree import ElementTree

from tree import ROOT

sys.path.insert(0, str(ROOT / "apps"))

from evaluation.timeline_picture import LOOKS, draw, draw_figure, pyplot, read_frame  # noqa: E402

WRITER = sys.argv.pop(1)
SVG = "{http://www.w3.org/2000/svg}"


class Pictures(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = Path(folder.name)
        cls.stop_and_wait, cls.better = cls.folder / "stop_and_wait.json", cls.folder / "better_order.json"
        subprocess.run([WRITER, cls.stop_and_wait, cls.better], check=True)

    def figure(self, trace, window=None):
        frame = read_frame(trace)
        figure = draw_figure(frame, window or (0, frame.length))
        self.addCleanup(pyplot.close, figure)
        return frame, figure.axes[0]

    def test_a_frame_has_its_commands_and_its_waits(self):
        frame = read_frame(self.stop_and_wait)
        self.assertEqual((frame.device, frame.program, frame.number), ("figure 1", "figure_one_traces", 0))
        names = [each.name for each in frame.cpu]
        self.assertEqual((names.count("query"), names.count("stall"), names.count("draw")), (7, 7, 6))
        self.assertAlmostEqual(sum(each.end - each.begin for each in frame.cpu), frame.length, places=6)
        self.assertGreater(frame.share(frame.cpu, {"stall"}), 2 * read_frame(self.better).share(
            read_frame(self.better).cpu, {"stall"}))  # fmt: skip
        self.assertEqual(len(frame.flows), 7)

    def test_slices_are_labelled_and_the_title_says_what_was_lost(self):
        frame, axes = self.figure(self.stop_and_wait)
        labels = [text.get_text() for text in axes.texts]
        for number in range(1, 8):
            self.assertEqual(labels.count(f"Q{number}"), 2, "on the CPU and on the GPU")
        self.assertIn("stall", labels)
        title = axes.get_title(loc="left")
        self.assertIn(f"{frame.length / 1000:.3f} ms", title)
        stalled = sum(each.arguments["ps"] for each in frame.cpu if each.name == "stall")
        self.assertIn(f"CPU stalled {stalled / frame.arguments['ps']:.1%}", title)

    def test_each_query_that_waits_has_two_arrows(self):
        _, axes = self.figure(self.stop_and_wait)
        heads = [text.xy for text in axes.texts if getattr(text, "arrow_patch", None)]
        self.assertEqual(len(heads), 14)
        downward = [head for head in heads if head[1] < 1]
        self.assertEqual(len(downward), 7)

    def test_a_window_shows_its_part_alone(self):
        _, axes = self.figure(self.stop_and_wait, (0, 30))
        labels = {text.get_text() for text in axes.texts}
        self.assertTrue({"Q1", "stall", "R1"} <= labels)
        self.assertFalse({"Q5", "R5"} & labels)
        self.assertRaises(ValueError, draw, self.stop_and_wait, None, None, (10**6, None))

    def test_it_is_the_same_svg_each_time_in_a_page_and_in_a_file(self):
        text = draw(self.stop_and_wait)
        self.assertTrue(text.startswith("<svg"))
        self.assertEqual(text, draw(json.loads(self.stop_and_wait.read_text())))
        ElementTree.fromstring(text)
        files = [self.folder / "first.svg", self.folder / "second.svg"]
        for path in files:
            draw(self.stop_and_wait, path)
        self.assertEqual(*(path.read_bytes() for path in files))
        self.assertEqual(ElementTree.parse(files[0]).getroot().tag, SVG + "svg")

    def test_kinds_of_waiting_are_hatched_and_work_is_not(self):
        hatched = {name for name, look in LOOKS.items() if look.hatch}
        self.assertEqual(hatched, {"stall", "back-pressure", "drain", "starvation", "condition"})
        self.assertEqual(len({LOOKS[name].hatch for name in hatched}), len(hatched))

    def run_command(self, *arguments):
        command = [sys.executable, "-B", "-m", "apps.evaluation.timeline_picture", *map(str, arguments)]
        return subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)

    def test_the_command_writes_a_png_and_tells_what_is_not_there(self):
        out = self.folder / "picture.png"
        done = self.run_command(self.better, out, "--from", "10", "--to", "60")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual(out.read_bytes()[:4], b"\x89PNG")
        for arguments, told in (
            ((self.better, out, "--frame", "7"), "holds no such frame, but frames 0 to 0"),
            ((self.folder / "nothing.json", out), "No such file"),
            ((self.better, self.folder / "picture.pdf"), "neither a .png nor a .svg"),
        ):
            done = self.run_command(*arguments)
            self.assertEqual(done.returncode, 2)
            self.assertIn(told, done.stderr)
            self.assertNotRegex(done.stderr, re.escape("Traceback"))


if __name__ == "__main__":
    unittest.main()
