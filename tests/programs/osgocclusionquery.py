# SPDX-License-Identifier: MIT
"""osgocclusionquery culls a scene of ours by core SAMPLES_PASSED queries, which it polls and never waits for.

The scene: two balls, one of them wholly behind a wall. A ball has over 5,000 vertices, so the program puts it
under an occlusion query; the wall has four, so it is drawn first. Every fifth frame asks for both balls, and a
question is polled in the frame that asks it and in each following frame until it is answered; until then the
program draws its ball. Hence, under `frames=N`, where an answer needs N swaps:
  - a question takes exactly N + 1 polls;
  - in five frames the wall and the shown ball are drawn five times, the boxes of the two questions once, and
    the hidden ball N times: 12 + N draws.
"""
import math
import pathlib
import tempfile
import unittest

import under_layer
import x_window

BALLS = 2
PERIOD = 5  # frames from one question to the next
PERIODS = 10
FRAMES = PERIOD * (PERIODS + 2)
SIZE = (403, 305)  # odd, so that no other program's window is taken for it
SINGLE_THREAD = {"OSG_WINDOW": "0 0 {} {}".format(*SIZE), "OSG_THREADING": "SingleThreaded"}


def ball(x, away, radius=1.0, rings=80):
    """A ball as OBJ text, in the loader's axes: x right, y up, z towards the viewer."""
    lines = []
    for ring in range(rings + 1):
        for step in range(rings):
            polar, turn = math.pi * ring / rings, 2 * math.pi * step / rings
            nx, ny, nz = math.sin(polar) * math.cos(turn), math.cos(polar), math.sin(polar) * math.sin(turn)
            lines += [f"v {x + radius * nx} {radius * ny} {radius * nz - away}", f"vn {nx} {ny} {nz}"]
    for ring in range(rings):
        for step in range(rings):
            first, second = ring * rings + step + 1, ring * rings + (step + 1) % rings + 1
            corners = (first, second, second + rings, first + rings)
            lines.append("f " + " ".join(f"{corner}//{corner}" for corner in corners))
    return "\n".join(lines) + "\n"


WALL = "v -5 -2 1\nv -0.5 -2 1\nv -0.5 2 1\nv -5 2 1\nvn 0 0 1\nf 1//1 2//1 3//1 4//1\n"


class Osgocclusionquery(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.command = ["osgocclusionquery"]
        for name, text in (("hidden", ball(-3, 3)), ("wall", WALL), ("shown", ball(3, 3))):
            path = pathlib.Path(folder.name, f"{name}.obj")
            path.write_text(text)
            cls.command.append(str(path))

    def frames(self, **how):
        """Run FRAMES frames; the program counts them itself."""
        environment = dict(SINGLE_THREAD, OSG_RUN_FRAME_COUNT=str(FRAMES))
        return under_layer.run(self.command, environment=environment, **how)

    def picture(self, **how):
        """The picture at rest, and the run that Escape then ended."""
        with under_layer.Program(self.command, environment=SINGLE_THREAD, **how) as program:
            with x_window.Window(SIZE) as window:
                picture = window.picture_at_rest()
                window.press("Escape")
            return picture, program.finish()

    def test_it_asks_the_same_with_and_without_latency_and_never_waits(self):
        bare = self.frames(layer=False)
        self.assertEqual(bare.status, 0, bare.errors)
        self.assertIsNone(bare.report)
        queries = set()
        for device in ("mesa", "geforce-fx-5950"):
            for clock in (None, "frames=1", "frames=3", "wall=50"):
                with self.subTest(device=device, clock=clock):
                    run = self.frames(device=device, clock=clock)
                    self.assertEqual((run.output, run.errors, run.status),
                                     (bare.output, bare.errors, bare.status))
                    self.assertGreaterEqual(len(run.layers_report().frames()), FRAMES)
                    self.assertEqual(run.layers_report().total("waits"), 0)
                    queries.add(run.layers_report().total("queries_begun"))
        self.assertEqual(len(queries), 1, queries)
        self.assertGreaterEqual(queries.pop(), BALLS * PERIODS)

    def test_a_question_takes_one_poll_more_than_the_clock_has_frames(self):
        for latency in (1, 2, 3):
            with self.subTest(latency=latency):
                report = self.frames(device="mesa", clock=f"frames={latency}").layers_report()
                polls_each = latency + 1
                missing = report.total("queries_begun") * polls_each - report.total("polls")
                self.assertGreaterEqual(missing, 0)
                # The last question of each ball may stay unanswered.
                self.assertLess(missing, BALLS * polls_each)

    def test_each_frame_of_latency_draws_the_hidden_ball_once_more_in_five_frames(self):
        for latency in (1, 2, 3):
            with self.subTest(latency=latency):
                frames = self.frames(device="mesa", clock=f"frames={latency}").layers_report().frames()
                # The first answers come with the first question, in the first five frames.
                settled = frames[PERIOD:PERIOD + PERIOD * PERIODS]
                self.assertEqual(sum(frame["draws"] for frame in settled), PERIODS * (12 + latency))

    def test_on_a_machine_without_query_objects_it_asks_nothing_and_draws_everything(self):
        report = self.frames(device="visualize-fx").layers_report()
        self.assertEqual(report.total("queries_begun"), 0)
        self.assertEqual({frame["draws"] for frame in report.frames()}, {BALLS + 1})

    def test_the_picture_is_mesas_on_every_device_with_every_latency(self):
        bare, run = self.picture(layer=False)
        self.assertEqual((run.status, run.report), (0, None))
        colors = set(zip(bare[0::4], bare[1::4], bare[2::4]))
        self.assertGreater(len(colors), 20)  # a shaded ball, not a blank window
        for device, clock in (("mesa", None), ("mesa", "frames=2"), ("mesa", "wall=20000"),
                              ("geforce-fx-5950", "calls=100"), ("visualize-fx", None)):
            with self.subTest(device=device, clock=clock):
                picture, run = self.picture(device=device, clock=clock)
                self.assertEqual(run.status, 0)
                self.assertTrue(run.layers_report().frames())
                self.assertTrue(picture == bare)  # by ==: assertEqual would print both pictures


if __name__ == "__main__":
    under_layer.main()
