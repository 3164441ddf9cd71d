# SPDX-License-Identifier: MIT
"""A culling client on the clock of a GeForce FX 5950: what it measures of itself by GL_EMU_device_time is the same in
every run, whatever rasterises, and nothing but time differs from a run without that clock.

  device_time.py WALKTHROUGH
"""
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import traced

LAUNCHER = os.environ["GLEXT_EMU_LAUNCHER"]
DEVICE = "geforce-fx-5950"
FRAMES = 4
WARM_UP = 1  # frames that the layer sees before the client's first
SCENE = ("--scene", "chc-city", "--scale", "0.05", "--frames", str(FRAMES))
CULLERS = ("stop-and-wait", "frustum")
TIMES = ("device_ms", "gpu_busy_ms", "device_stall_ms", "back_pressure_ms", "starvation_ms", "drain_ms")
# The client reads whole nanoseconds, rounded down, before and after a frame; the report has picoseconds.
ROUNDING_MS = 1.001e-6
EGL_WRAPPER = traced.WRAPPER.replace("glxtrace", "egltrace")


class Walk:
    """One run of the client under the layer, and what both wrote down; deleted when `folder` is."""

    def __init__(self, folder, culler, clock="device", platform="egl", threads="0", layer_options=(), options=(),
                 environment=None):
        folder = pathlib.Path(tempfile.mkdtemp(dir=folder))
        report, lines = folder / "report.json", folder / "frames.jsonl"
        front = ("--front", "export") if platform == "osmesa" else ()
        child = {**os.environ, "LP_NUM_THREADS": threads, "TRACE_FILE": str(folder / "calls.trace"),
                 **(environment or {})}
        done = subprocess.run(
            [LAUNCHER, "run", "--device", DEVICE, "--clock", clock, "--report", str(report), *front, *layer_options,
             "--", WALKTHROUGH, *SCENE, "--culler", culler, "--platform", platform, "--json", str(lines), *options],
            env=child, cwd=folder, capture_output=True, text=True, timeout=120, check=False)
        if done.returncode != 0:
            raise AssertionError(f"{culler} on {platform}: status {done.returncode}\n{done.stdout}{done.stderr}")
        self.folder = folder
        read = [json.loads(line) for line in lines.read_text().splitlines()]
        self.frames = [line for line in read if "frame" in line]
        self.summary = read[-1]["summary"]
        records = json.loads(report.read_text())["records"]
        self.layer_frames = [record for record in records if record["kind"] == "frame"][:FRAMES + WARM_UP]

    def times(self):
        """Everything that is measured in device time, by the client and by the layer, frame by frame."""
        return ([frame["device_ms"] for frame in self.frames],
                [[frame[name] for name in TIMES] for frame in self.layer_frames])

    def total(self, name):
        return sum(frame[name] for frame in self.layer_frames[WARM_UP:])

    def drawn(self):
        return [[frame[name] for name in ("drawn_triangles", "drawn_objects", "queries")] for frame in self.frames]

    def results(self):
        """What the client was told of its queries, in the order of its asking."""
        found = traced.calls(self.folder / "calls.trace", "glGetQueryObject")
        return [call.value() for call in found if "GL_QUERY_RESULT," in call.text]

    def picture(self):
        return (self.folder / "view.png").read_bytes()


class DeviceTime(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory(prefix="glext_emu_device_time_")
        cls.addClassCleanup(folder.cleanup)
        cls.folder = folder.name
        cls.first = {culler: Walk(cls.folder, culler) for culler in CULLERS}

    def walk(self, culler, **how):
        return Walk(self.folder, culler, **how)

    def test_device_time_is_bit_identical_whatever_rasterises(self):
        for culler in CULLERS:
            for how in ({}, {"threads": "1"}, {"threads": "2"}, {"platform": "osmesa"},
                        {"platform": "osmesa", "threads": "2"}):
                with self.subTest(culler=culler, **how):
                    again = self.walk(culler, **how)
                    self.assertEqual(len(again.frames), FRAMES)
                    self.assertEqual(again.times(), self.first[culler].times())
                    self.assertEqual(again.drawn(), self.first[culler].drawn())

    def test_the_client_measures_what_the_layer_reports(self):
        for culler, walk in self.first.items():
            for frame, reported in zip(walk.frames, walk.layer_frames[WARM_UP:], strict=True):
                with self.subTest(culler=culler, frame=frame["frame"]):
                    self.assertGreater(frame["device_ms"], 0)
                    self.assertLess(abs(frame["device_ms"] - reported["device_ms"]), ROUNDING_MS)
            mean = sum(frame["device_ms"] for frame in walk.frames) / FRAMES
            self.assertAlmostEqual(walk.summary["device_ms"], mean)

    def test_stop_and_wait_waits_and_frustum_does_not(self):
        asking, silent = self.first["stop-and-wait"], self.first["frustum"]
        for frame, reported in zip(asking.frames, asking.layer_frames[WARM_UP:], strict=True):
            self.assertEqual(reported["device_stall_ms"] > 0, frame["queries"] > 0, frame)
        self.assertGreater(asking.total("device_stall_ms"), 0)
        # A GPU that is waited for has nothing to do until it is asked again.
        self.assertGreater(asking.total("starvation_ms"), 0)
        self.assertEqual(silent.total("device_stall_ms"), 0)

    def test_without_latency_waiting_takes_less(self):
        quick = self.walk("stop-and-wait", layer_options=("--without", "latency"))
        saved_ms = self.first["stop-and-wait"].total("device_stall_ms") - quick.total("device_stall_ms")
        self.assertGreater(saved_ms, 0)
        self.assertEqual(quick.drawn(), self.first["stop-and-wait"].drawn())
        silent = self.walk("frustum", layer_options=("--without", "latency"))
        self.assertEqual(silent.times(), self.first["frustum"].times())

    def test_the_clients_own_work_is_part_of_its_frames(self):
        # Stop-and-wait has the GPU idle at its frames' beginning, so nothing can go on beside the work.
        busy = self.walk("stop-and-wait", options=("--work-us", "1500"))
        for frame, before in zip(busy.frames, self.first["stop-and-wait"].frames, strict=True):
            self.assertAlmostEqual(frame["device_ms"] - before["device_ms"], 1.5, delta=2 * ROUNDING_MS)

    def test_results_and_pictures_are_those_without_the_clock(self):
        picture = ("--images", ".", "--image-frame", "2")
        for culler in CULLERS:
            with self.subTest(culler=culler):
                # Traced and painted apart: a painted frame asks once more.
                traces = [self.walk(culler, clock=clock, environment={"LD_PRELOAD": EGL_WRAPPER})
                          for clock in ("none", "device")]
                self.assertEqual(traces[0].results(), traces[1].results())
                self.assertEqual(len(set(traces[0].results())) > 1, culler == "stop-and-wait")
                self.assertEqual(traces[0].drawn(), traces[1].drawn())
                painted = [self.walk(culler, clock=clock, options=picture) for clock in ("none", "device")]
                self.assertTrue(painted[0].picture() == painted[1].picture())
                self.assertTrue(all(frame["device_ms"] is None for frame in painted[0].frames))


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    WALKTHROUGH = sys.argv.pop(1)
    unittest.main(verbosity=2)
