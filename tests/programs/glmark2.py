# SPDX-License-Identifier: MIT
"""glmark2 in its four forms: compatibility context and ES, in a window and off screen, one scene of a fixed
number of frames.

Its own validation compares drawn pixels with known ones. It wants GL 2.0: on a machine of GL 1.5 it has to
refuse, in its own words, while its ES form, whose contexts no device changes, runs on.
"""
import re
import unittest

import under_layer

FRAMES = 40
SCENE = ["-b", f"build:nframes={FRAMES}", "-s", "200x150"]
FORMS = [("glmark2", []), ("glmark2", ["--off-screen"]), ("glmark2-es2", []), ("glmark2-es2", ["--off-screen"])]


def what_it_says(run):
    """The output without its measurements."""
    return re.sub(r"FPS: \d+ FrameTime: [\d.]+ ms|Score: \d+", "", run.output)


class Glmark2(unittest.TestCase):
    def test_a_scene_says_the_same_with_the_layer_with_latency_and_without(self):
        for program, options in FORMS:
            bare = under_layer.run([program, *SCENE, *options], layer=False)
            self.assertEqual(bare.status, 0, bare.output)
            self.assertIsNone(bare.report)
            for clock in (None, "wall=5000", "frames=2"):
                with self.subTest(program=program, options=options, clock=clock):
                    run = under_layer.run([program, *SCENE, *options], device="mesa", clock=clock)
                    self.assertEqual((what_it_says(run), run.errors, run.status),
                                     (what_it_says(bare), bare.errors, bare.status))
                    self.reports_the_scene(run.layers_report(), program, on_screen=not options)

    def reports_the_scene(self, report, program, on_screen):
        self.assertTrue(report.contexts(program))
        self.assertGreaterEqual(report.total("draws"), FRAMES)
        if on_screen:  # off screen nothing is swapped, hence no frame ends
            self.assertGreaterEqual(len(report.frames()), FRAMES)
        self.assertEqual(report.total("queries_begun"), 0)

    def test_its_own_validation_finds_the_right_pixels(self):
        for program in ("glmark2", "glmark2-es2"):
            for layer in (False, True):
                with self.subTest(program=program, layer=layer):
                    run = under_layer.run([program, "--validate", "-b", "build", "-b", "shading"], layer=layer,
                                          device="mesa", clock="frames=2")
                    self.assertEqual(run.status, 0)
                    self.assertEqual(run.output.count("Validation: Success"), 2)
                    self.assertEqual(run.report is not None, layer)

    def test_it_refuses_a_machine_of_gl_1_5_but_its_es_form_runs_there(self):
        desktop = under_layer.run(["glmark2", *SCENE], device="geforce-fx-5950")
        self.assertEqual(desktop.status, 1)
        self.assertRegex(desktop.output + desktop.errors, r"needs OpenGL\(ES\) version >= 2\.0 .* is: '1\.5")
        es = under_layer.run(["glmark2-es2", *SCENE], device="geforce-fx-5950")
        self.assertEqual(es.status, 0, es.output)
        self.reports_the_scene(es.layers_report(), "glmark2-es2", on_screen=True)


if __name__ == "__main__":
    under_layer.main()
