# SPDX-License-Identifier: MIT
"""apitrace's player. `--ppd` puts a SAMPLES_PASSED query around every draw call and prints the pixels that it drew: they
have to be Mesa's on every machine that has such queries. A machine without them it refuses in its own words, but plays
the trace there with the right pictures. A trace recorded above the layer holds the HP test as the program saw it.

usage: glretrace.py HP_EXAMPLE    the built docs/examples/hp_occlusion_test.c
"""
import pathlib
import re
import subprocess
import sys
import tempfile
import time
import unittest

import traced
import under_layer
import x_window

HP_EXAMPLE = sys.argv.pop()
FRAMES = 20
GEARS = 3  # display lists, each drawn once a frame
SIZE = (307, 205)  # odd, so that no other program's window is taken for it
WITH_QUERIES = [("mesa", None), ("mesa", "calls=20"), ("geforce-fx-5950", None), ("geforce-fx-5950", "wall=50"),
                ("radeon-hd5770", None), ("radeon-hd5770", "calls=20")]
WITHOUT_QUERIES = ["visualize-fx", "geforce3"]


def checksums(run):
    """Of each frame's picture but the first: nothing has been drawn yet where that one is taken."""
    return re.findall(r"^[0-9A-F]{32}$", run.output, re.MULTILINE)[1:]


def pixels_of_draws(run):
    """(number of the call, its name, its pixels) of each profiled draw call; state changes have -1 pixels."""
    rows = re.findall(r"^call (\d+) (?:\S+ ){8}(-?\d+) \S+ (\w+)$", run.output, re.MULTILINE)
    return [(int(number), name, int(pixels)) for number, pixels, name in rows if int(pixels) >= 0]


class Glretrace(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        whole, cls.trace = str(pathlib.Path(folder.name, "whole")), str(pathlib.Path(folder.name, "gears"))
        with under_layer.Program(["glxgears", "-geometry", "{}x{}+0+0".format(*SIZE)], layer=False,
                                 preload=[traced.WRAPPER], environment={"TRACE_FILE": whole}) as program:
            with x_window.Window(SIZE) as window:
                time.sleep(0.5)
                window.press("Escape")
            program.finish()
        subprocess.run(["apitrace", "trim", f"--frames=0-{FRAMES - 1}", "-o", cls.trace, whole], check=True,
                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        cls.hp_trace = str(pathlib.Path(folder.name, "hp"))
        cls.hp_run = under_layer.run([HP_EXAMPLE], device="visualize-fx", preload=[traced.WRAPPER],
                                     environment={"TRACE_FILE": cls.hp_trace})

    def test_it_counts_mesas_pixels_for_every_draw_call_on_machines_with_queries(self):
        bare = under_layer.run(["glretrace", "--ppd", self.trace], layer=False)
        self.assertEqual((bare.status, bare.report), (0, None), bare.errors)
        draws = pixels_of_draws(bare)
        self.assertGreaterEqual([name for _, name, _ in draws].count("glCallList"), GEARS * FRAMES)
        self.assertGreater(sum(pixels for _, _, pixels in draws), 1000 * FRAMES)
        for device, clock in WITH_QUERIES:
            with self.subTest(device=device, clock=clock):
                run = under_layer.run(["glretrace", "--ppd", self.trace], device=device, clock=clock)
                self.assertEqual((run.status, run.errors), (bare.status, bare.errors))
                self.assertEqual(pixels_of_draws(run), draws)
                self.assertEqual(run.layers_report().total("queries_begun"), len(draws))

    def test_it_refuses_to_count_on_machines_that_have_no_arb_query(self):
        for device in WITHOUT_QUERIES:
            with self.subTest(device=device):
                run = under_layer.run(["glretrace", "--ppd", self.trace], device=device)
                self.assertRegex(run.output + run.errors, "GL_ARB_occlusion_query extension is not supported "
                                 r"\(OpenGL 1\.[13]\)")
                self.assertNotEqual(run.status, 0)
                self.assertEqual(run.layers_report().total("queries_begun"), 0)

    def test_the_played_frames_are_mesas_on_every_machine(self):
        play = ["glretrace", "-s", "-", "--snapshot-format=MD5", self.trace]
        bare = under_layer.run(play, layer=False)
        sums = checksums(bare)
        self.assertEqual(len(sums), FRAMES - 1)
        self.assertGreater(len(set(sums)), FRAMES // 2)  # the gears turn
        for device in (*WITHOUT_QUERIES, *dict(WITH_QUERIES)):
            with self.subTest(device=device):
                run = under_layer.run(play, device=device)
                self.assertEqual(checksums(run), sums)
                self.assertTrue(run.layers_report().contexts())

    def test_a_trace_made_above_the_layer_holds_the_hp_test_as_the_program_saw_it(self):
        self.assertEqual(self.hp_run.output, "behind the wall: occluded\nbefore the wall: visible\n")
        reads = [call.text for call in traced.calls(self.hp_trace, "glGetBooleanv") if "OCCLUSION_TEST" in call.text]
        self.assertEqual([re.search(r"GL_(TRUE|FALSE)", text)[0] for text in reads], ["GL_FALSE", "GL_TRUE"])

    def test_it_plays_the_hp_test_without_an_error_only_where_the_machine_has_it(self):
        for how in (dict(layer=False), dict(device="mesa"), dict(device="geforce-fx-5950")):
            run = under_layer.run(["glretrace", self.hp_trace], **how)
            self.assertIn("glGetError(glEnable) = GL_INVALID_ENUM", run.output + run.errors, how)
        for device in ("visualize-fx", "geforce3"):
            run = under_layer.run(["glretrace", self.hp_trace], device=device)
            self.assertEqual(run.status, 0)
            self.assertNotIn("GL_INVALID", run.output + run.errors, device)


if __name__ == "__main__":
    under_layer.main()
