# SPDX-License-Identifier: MIT
"""Promise: an effect is simulated only where a scene calls for it. Each effect is switched off where the report says that
it was not called for, which changes nothing, and in scenes made for it, which changes what it should, by as much as it
should.
"""
import json
import os
import subprocess
import tempfile
import unittest

import under_device
from scenes import CALLED, FRAMES, P, UNCALLED
from under_device import EFFECTS, run

WORTH = 0.01  # of the frames' time: less is no difference
ROUNDING_MS = 1e-6  # the machine adds whole picoseconds
DEPTH_ROUNDING = 2**-24  # a result is a float of 32 bits


def differ(with_it, without_it):
    """Whether the time differs, or any result."""
    ratio = without_it.total_ms() / with_it.total_ms()
    return abs(ratio - 1) >= WORTH or with_it.results != without_it.results


def disagreement(effect, with_it, without_it):
    """A sentence where the predicate of <effect> and the ablation contradict each other."""
    is_called_for, differs = with_it.effects[effect]["called_for"], differ(with_it, without_it)
    if with_it.picture != without_it.picture:
        return f"{effect} changes the picture"
    if is_called_for == differs:
        return None
    return f"{effect} is {'' if is_called_for else 'not '}called for, and without it time and results are " + (
        "others" if differs else "the same")


class AnEffect(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.runs = {}

    def run_of(self, words, without=()):
        if (words, without) not in self.runs:
            self.runs[words, without] = run(words, without=without)
        return self.runs[words, without]

    def judge(self, effect, scene, is_called_for):
        with_it, without_it = self.run_of(scene.words), self.run_of(scene.words, (effect,))
        tally = with_it.effects[effect]
        self.assertIsNone(disagreement(effect, with_it, without_it))
        self.assertIs(tally["called_for"], is_called_for)
        self.assertTrue(tally["reason"].startswith(scene.reason), tally["reason"])
        self.assertEqual([tally["on"], without_it.effects[effect]["on"]], [True, False])
        if scene.own_us is None:
            self.assertIsNone(tally["ms"])
        else:
            self.assertAlmostEqual(tally["ms"], FRAMES * scene.own_us / 1e3, delta=ROUNDING_MS)
        saved_ms = with_it.total_ms() - without_it.total_ms()
        self.assertAlmostEqual(saved_ms, FRAMES * scene.saved_us / 1e3, delta=ROUNDING_MS)
        if scene.results is None:
            self.assertEqual(with_it.results, without_it.results)
        else:
            self.assert_results(with_it, scene.results[0])
            self.assert_results(without_it, scene.results[1])

    def assert_results(self, made, expected):
        self.assertEqual(len(made.results), len(expected))
        for result, value in zip(made.results, expected):
            self.assertAlmostEqual(result, value, delta=0 if value == int(value) else DEPTH_ROUNDING)

    def test_that_is_not_called_for_changes_nothing(self):
        for effect, scenes in UNCALLED.items():
            for scene in scenes:
                with self.subTest(effect=effect, words=scene.words):
                    self.judge(effect, scene, False)

    def test_that_is_called_for_takes_as_long_as_the_machine_says(self):
        for effect, scenes in CALLED.items():
            for scene in scenes:
                with self.subTest(effect=effect, words=scene.words):
                    self.judge(effect, scene, True)

    def test_has_a_scene_that_calls_for_it_and_one_that_does_not(self):
        self.assertEqual([tuple(UNCALLED), tuple(CALLED)], [EFFECTS, EFFECTS])

    def test_is_judged_the_same_in_the_same_run_twice(self):
        for effect in ("fill", "latency", "saturation"):
            for scene in CALLED[effect]:
                again = run(scene.words)
                told = self.run_of(scene.words)
                for one in (again, told):
                    for record in one.effects.values():
                        record.pop("pid", None)
                self.assertEqual(again.effects, told.effects)
                self.assertEqual(again.total_ms(), told.total_ms())

    def test_whose_predicate_is_wrong_is_found_out(self):
        for is_called_for, scenes in ((False, UNCALLED), (True, CALLED)):
            for effect in ("latency", "fill", "saturation"):
                scene = scenes[effect][0]
                with_it, without_it = self.run_of(scene.words), self.run_of(scene.words, (effect,))
                tally = with_it.effects[effect]
                tally["called_for"] = not is_called_for
                self.assertIsNotNone(disagreement(effect, with_it, without_it))
                tally["called_for"] = is_called_for
                self.assertIsNone(disagreement(effect, with_it, without_it))


class AllEffects(unittest.TestCase):
    WORDS = "clear mesh=10,10 fill=64,64,10 arrays=100,5 ask=16,16,4 read=16,16,2 region=16,16,2 work=200".split()
    # The CPU's part: what a GPU without any of them waits for.
    FRAME_MS = (25 * P["batch_us"] + (4 + 2) * P["query_us"] + 2 * P["read_us"] + 200 + P["swap_us"]) / 1e3

    def test_switched_off_leave_a_machine_without_ends(self):
        bare = run(self.WORDS, without=EFFECTS)
        unlimited = run(self.WORDS, machine="unlimited", without=("starvation",))
        self.assertEqual([frame["device_ms"] for frame in bare.frames], FRAMES * [self.FRAME_MS])
        self.assertEqual([frame["device_ms"] for frame in unlimited.frames], FRAMES * [self.FRAME_MS])
        self.assertEqual((bare.results, bare.picture), (unlimited.results, unlimited.picture))
        full = run(self.WORDS)
        self.assertEqual(full.picture, bare.picture)
        self.assertGreater(full.total_ms(), 1.5 * bare.total_ms())
        self.assertNotEqual(full.results, bare.results)


class AnUnknownEffect(unittest.TestCase):
    def assert_refused(self, done):
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertEqual(done.stdout, "")
        self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
        self.assertIn("colour", done.stderr)
        self.assertIn("depth-quantisation", done.stderr)

    def test_is_one_sentence_from_the_layer(self):
        with tempfile.TemporaryDirectory() as folder:
            self.assert_refused(under_device.start(["clear"], without=("fill", "colour"), folder=folder)[0])

    def test_is_one_sentence_from_the_launcher(self):
        command = [under_device.LAUNCHER, "run", "--device", str(under_device.FOLDER / "machine.toml"), "--clock", "device"]
        client = ["--", under_device.CLIENT, "clear"]
        self.assert_refused(subprocess.run([*command, "--without", "fill,colour", *client], capture_output=True, text=True,
                                           check=False))
        # A list of known ones is none.
        with tempfile.TemporaryDirectory() as folder:
            report = os.path.join(folder, "report.json")
            subprocess.run([*command, "--without", "fill,read-cost", "--report", report, *client], check=True,
                           capture_output=True, timeout=120)
            with open(report, encoding="utf-8") as file:
                records = json.load(file)["records"]
        off = {record["effect"] for record in records if record["kind"] == "effect" and not record["on"]}
        self.assertEqual(off, {"fill", "read-cost"})


if __name__ == "__main__":
    unittest.main(verbosity=2)
