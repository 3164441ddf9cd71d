# SPDX-License-Identifier: MIT
"""opencsgexample draws solids by boolean operations and asks by occlusion queries when it is done: by those of ARB
where they are advertised, else by those of NV. On geforce3 it has to take the NV path, with ARB's picture and numbers.

apitrace stands above the layer and tells what the program itself called. Time stands still (libfaketime): the solid
turns with the clock. It needs the pointer of its display, hence a display of its own.
"""
import dataclasses
import itertools
import pathlib
import time
import unittest

import traced
import under_layer
import x_window

FROZEN = {"FAKETIME": "2020-01-01 00:00:00"}
FAKETIME = "/usr/lib/x86_64-linux-gnu/faketime/libfaketime.so.1"
SIZE = (512, 512)
# The menu "CSG Algorithms": the second of three entries, and in it the entries of 25 pixels that ask.
RIGHT_BUTTON, LEFT_BUTTON, ENTRY_PX = 3, 1, 25
MENU, SUBMENU = (151, 79), (330, 179)  # their sizes
GOLDFEATHER, SCS = 3, 6
BOOLEAN, COUNT = "GL_ANY_SAMPLES_PASSED", "GL_SAMPLES_PASSED"


def choose(window, algorithm):
    """Open the menu at (100, 100), its submenu right of it, and click the entry."""
    window.point(100, 100, RIGHT_BUTTON)
    with x_window.Window(MENU):
        window.point(120, 100 + ENTRY_PX + ENTRY_PX // 2)
    with x_window.Window(SUBMENU):
        window.point(300, 100 + ENTRY_PX + algorithm * ENTRY_PX + ENTRY_PX // 2, LEFT_BUTTON)
    window.point(SIZE[0] + 100, SIZE[1] + 100)
    time.sleep(1)  # some frames are drawn that way, on a busy machine too: they look like those before


@dataclasses.dataclass
class Session:
    run: under_layer.Run
    pictures: list  # without queries, by Goldfeather, by SCS
    commands: set  # names of the query commands that the program called
    targets: set
    answers: list  # each frame's results, by Goldfeather and by SCS; equal frames stand here once


def draw(**how):
    """Draw the first solid by each algorithm."""
    with under_layer.Program(["opencsgexample", "-geometry", "+0+0"], preload=(traced.WRAPPER, FAKETIME),
                             environment=dict(FROZEN, TRACE_FILE="calls.trace"), **how) as program:
        with x_window.Window(SIZE) as window:
            pictures = [window.picture_at_rest()]
            for algorithm in (GOLDFEATHER, SCS):
                choose(window, algorithm)
                pictures.append(window.picture_at_rest())
            window.close()
        run = program.finish()
        calls = traced.calls(pathlib.Path(program.folder.name, "calls.trace"), "Query|SwapBuffers")
    asked, frames, results = set(), [], []
    targets = set()
    for call in calls:
        if "Query" in call.name:
            asked.add(call.name)
            targets.update(target for target in (BOOLEAN, COUNT) if f"target = {target}," in call.text)
            results += [call.value()] if call.value() is not None and "AVAILABLE" not in call.text else []
        elif results:  # a menu is a window too, and swaps between the frames
            frames.append(tuple(results))
            results = []
    return Session(run, pictures, asked, targets, [answers for answers, _ in itertools.groupby(frames)])


class Opencsg(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.bare = draw(layer=False)
        cls.geforce3 = draw(device="geforce3")
        cls.late = draw(device="geforce3", clock="calls=50")  # `wall` would wait for ever: time stands still
        cls.mesa = draw(device="mesa", clock="calls=7")

    def test_bare_it_asks_by_arb_and_each_algorithm_draws_the_solid_by_its_own_queries(self):
        self.assertEqual((self.bare.run.status, self.bare.run.report), (0, None), self.bare.run.errors)
        self.assertEqual({name for name in self.bare.commands if "NV" in name}, set())
        self.assertEqual(self.bare.targets, {BOOLEAN, COUNT})
        pixels = self.bare.pictures[0]
        self.assertGreater(len(set(zip(pixels[0::4], pixels[1::4], pixels[2::4]))), 20)  # a shaded solid
        goldfeather, scs = self.bare.answers
        self.assertEqual(set(goldfeather), {0, 1})
        self.assertGreater(len(set(scs)), 2)  # counts, not booleans
        self.assertGreater(max(scs), 1000)

    def test_on_a_geforce3_it_takes_the_nv_path_and_calls_no_arb_query(self):
        for session in (self.geforce3, self.late):
            self.assertEqual(session.run.status, 0, session.run.errors)
            self.assertEqual({name for name in session.commands if not name.endswith("NV")}, set())
            self.assertLessEqual({"glBeginOcclusionQueryNV", "glEndOcclusionQueryNV", "glGetOcclusionQueryuivNV"},
                                 session.commands)
            self.assertGreater(session.run.layers_report().total("queries_begun"), 0)

    def test_a_pass_through_device_keeps_the_arb_path(self):
        self.assertEqual((self.mesa.run.status, self.mesa.commands, self.mesa.targets),
                         (0, self.bare.commands, self.bare.targets))
        self.assertGreater(self.mesa.run.layers_report().total("queries_begun"), 0)

    def test_the_pictures_are_mesas_whichever_way_it_asks(self):
        for session in (self.geforce3, self.late, self.mesa):
            for algorithm, picture, bare in zip(("none", "Goldfeather", "SCS"), session.pictures, self.bare.pictures):
                with self.subTest(device=session.run.layers_report().contexts()[0]["device"], algorithm=algorithm):
                    self.assertTrue(picture == bare)  # by ==: assertEqual would print both pictures

    def test_the_numbers_are_arbs_whichever_way_it_asks(self):
        goldfeather, scs = self.bare.answers
        self.assertEqual(self.mesa.answers, self.bare.answers)
        for session in (self.geforce3, self.late):
            nv_goldfeather, nv_scs = session.answers
            self.assertEqual(nv_scs, scs)
            self.assertEqual(tuple(int(count > 0) for count in nv_goldfeather), goldfeather)


if __name__ == "__main__":
    under_layer.main()
