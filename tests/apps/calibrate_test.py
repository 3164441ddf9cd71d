#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""calibrate as a user meets it: the device file that it writes, the files that it spares, its one sentence on
bad use. Nothing here asserts a time: the machine may be busy."""
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import tomllib
import unittest

CALIBRATE, LAUNCHER = sys.argv[1], sys.argv[2]
del sys.argv[1:]

NEEDED = ("batch_us", "triangles_per_second", "fragments_per_second", "depth_fragments_per_second", "query_us",
          "gpu_query_us", "poll_us", "read_pixels_per_second")
OTHERS = ("swap_us", "read_us", "copied_triangle_ns", "gpu_batch_us", "cleared_pixels_per_second",
          "swapped_pixels_per_second", "result_latency_us", "fifo_us")


def run(program, *arguments, **environment):
    return subprocess.run([program, *map(str, arguments)], capture_output=True, text=True, timeout=240,
                          env={**os.environ, **environment})


class Measured(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.scratch.name)
        cls.device = cls.folder / "mine.toml"
        cls.raw = cls.folder / "raw.json"
        cls.result = run(CALIBRATE, "--quick", "--size", "512x384", "--output", cls.device, "--json", cls.raw)
        if cls.result.returncode == 2 and "EGL" in cls.result.stderr:
            raise unittest.SkipTest("no EGL here: " + cls.result.stderr)

    @classmethod
    def tearDownClass(cls):
        cls.scratch.cleanup()

    def setUp(self):
        self.assertEqual(self.result.returncode, 0, self.result.stderr)

    def test_every_needed_number_is_there_and_positive(self):
        device = tomllib.loads(self.device.read_text())
        self.assertEqual((device["name"], device["extensions"]), ("mine", {}))
        time = device["time"]
        self.assertEqual(time["quality"], "fitted")
        self.assertIn("measured by calibrate", time["source"])
        for key in NEEDED:
            self.assertGreater(time[key], 0, key)
        self.assertLessEqual(set(time), {"source", "quality", *NEEDED, *OTHERS})

    def test_a_number_that_is_left_out_has_a_reason(self):
        text = self.device.read_text()
        time = tomllib.loads(text)["time"]
        for key in OTHERS:
            if key not in time:
                self.assertRegex(text, rf"# {key} is left out: \w")

    def test_the_emulator_takes_the_file(self):
        for clock in ("none", "device"):
            told = run(LAUNCHER, "run", "--device", self.device, "--clock", clock, "--", "true")
            self.assertEqual((told.returncode, told.stderr), (0, ""))

    def test_the_raw_report_holds_every_sample_and_the_checks(self):
        report = json.loads(self.raw.read_text())
        time = tomllib.loads(self.device.read_text())["time"]
        for key, term in report["terms"].items():
            self.assertEqual(term["value"] is None, key not in time, key)
            self.assertEqual(term["value"] is None, "left_out" in term, key)
        for name, sweep in report["sweeps"].items():
            for point in sweep:
                self.assertEqual(len(point["total_us"]), report["rounds"], name)
        self.assertGreaterEqual(len(report["checks"]), 6)
        for check in report["checks"]:
            self.assertGreater(check["measured_us"], 0)
            wrong = 100 * (check["predicted_us"] / check["measured_us"] - 1)
            self.assertAlmostEqual(check["error_percent"], wrong, places=6)

    def test_llvmpipes_threads_are_told(self):
        report = json.loads(self.raw.read_text())
        if "llvmpipe" not in report["renderer"]:
            self.skipTest("another renderer")
        threads = os.environ.get("LP_NUM_THREADS", "0")
        self.assertEqual(report["lp_num_threads"], threads)
        self.assertIn(f"LP_NUM_THREADS={threads}", self.device.read_text())

    def test_nothing_half_written_stays(self):
        self.assertEqual(sorted(p.name for p in self.folder.iterdir()), ["mine.toml", "raw.json"])


# A machine with an end to everything that the model knows. What is measured as a difference errs by a share of what
# it is taken from, so a query's work and its latency are large here.
EMULATED = {"batch_us": 17.0, "query_us": 10.1, "poll_us": 0.1, "read_us": 3.0, "copied_triangle_ns": 79.0,
            "triangles_per_second": 36.3e6, "fragments_per_second": 1.9e9, "depth_fragments_per_second": 3.8e9,
            "cleared_pixels_per_second": 3.8e9, "gpu_query_us": 30.0, "result_latency_us": 53.0, "fifo_us": 1300.0,
            "read_pixels_per_second": 50e6}


class Emulated(unittest.TestCase):
    """Under the device clock, GL's own time is the emulated machine's: what is put in has to come out. No wall clock is
    involved, so the bounds are narrow: they are the fragments of whole blocks that a driver counts at edges."""

    def test_what_a_device_is_told_to_cost_is_what_is_measured(self):
        with tempfile.TemporaryDirectory() as folder:
            device, found = pathlib.Path(folder, "told.toml"), pathlib.Path(folder, "found.toml")
            numbers = "".join(f"{key} = {value}\n" for key, value in EMULATED.items())
            device.write_text('name = "told"\ndescription = "a test"\nsource = "a test"\n[time]\n'
                              'source = "a test"\nquality = "assumed"\n' + numbers)
            told = run(LAUNCHER, "run", "--device", device, "--clock", "device", "--all-fragments", "--", CALIBRATE, "--quick", "--time", "gl",
                       "--output", found)
            self.assertEqual(told.returncode, 0, told.stderr)
            time = tomllib.loads(found.read_text())["time"]
            for key, value in EMULATED.items():
                with self.subTest(key=key):
                    self.assertAlmostEqual(time[key] / value, 1, delta=0.02)
            self.assertNotIn("gpu_batch_us", time)


class Refused(unittest.TestCase):
    def refuses(self, culprit, *arguments):
        told = run(CALIBRATE, *arguments)
        self.assertEqual(told.returncode, 2, told.stderr)
        self.assertTrue(told.stderr.startswith("calibrate: ") and told.stderr.count("\n") == 1, told.stderr)
        self.assertIn(culprit, told.stderr)
        self.assertEqual(told.stdout, "")

    def test_bad_use_is_one_sentence(self):
        for culprit, *arguments in (
            ("web", "--platform", "web"), ("640", "--size", "640"), ("100x100", "--size", "100x100"),
            ("--nonsense", "--nonsense"), ("sun", "--time", "sun"), ("--output", "--force"),
            ("stdout", "--json", "-"), ("no folder", "--output", "/nowhere/mine.toml")):
            with self.subTest(arguments=arguments):
                self.refuses(culprit, *arguments)

    def test_a_file_of_somebody_elses_is_spared_unless_forced(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "precious.toml")
            path.write_text('name = "precious"\n')
            self.refuses("--force", "--output", path)
            self.assertEqual(path.read_text(), 'name = "precious"\n')
            # Forced, or once it is calibrate's own, it comes as far as the platform, which is not there.
            self.refuses("DISPLAY", "--output", path, "--force", "--platform", "glx")

    def test_help_teaches(self):
        told = run(CALIBRATE, "--help")
        self.assertEqual(told.returncode, 0)
        for word in ("--output", "--quick", "glext-emu run --device", "docs/calibrate.md"):
            self.assertIn(word, told.stdout)


if __name__ == "__main__":
    os.environ.pop("DISPLAY", None)
    unittest.main()
