# SPDX-License-Identifier: MIT
"""PyOpenGL has wrapped the occlusion tests of HP and NV for twenty years, and no driver had them: its
glInitOcclusionTestHP() tells whether the machine has the test. Where it has, the test has to work through PyOpenGL.

PyOpenGL finds GL by ctypes and eglGetProcAddress.
"""
import json
import pathlib
import sys
import unittest

import under_layer

CLIENT = str(pathlib.Path(__file__).with_name("pyopengl_client.py"))
# From the client's geometry: a box of 10 x 10 pixels, 4 columns of which stand beside the wall in the third case.
VISIBLE_PIXELS = {"behind": 0, "before": 100, "in part": 40}


def ask(**how):
    run = under_layer.run([sys.executable, CLIENT], environment={"PYOPENGL_PLATFORM": "egl"}, **how)
    if run.status != 0:
        raise AssertionError(run.output + run.errors)
    return json.loads(run.output), run.report


class Pyopengl(unittest.TestCase):
    def reads_the_test_once(self, found):
        self.assertEqual(found["hp_results"], {box: [pixels > 0, False] for box, pixels in VISIBLE_PIXELS.items()})

    def test_on_bare_mesa_there_is_neither_test(self):
        found, report = ask(layer=False)
        self.assertIsNone(report)
        self.assertEqual((found["hp"], found["nv"], found["nv_function"]), (False, False, False))

    def test_on_a_visualize_fx_the_hp_test_is_there_and_right(self):
        for clock in (None, "wall=50", "calls=5"):
            with self.subTest(clock=clock):
                found, report = ask(device="visualize-fx", clock=clock)
                self.assertTrue(report.contexts())
                self.assertEqual((found["hp"], found["nv"]), (True, False))
                self.assertTrue(found["version"].startswith("1.1"), found["version"])
                self.reads_the_test_once(found)

    def test_on_a_geforce3_both_tests_are_there_and_right(self):
        for clock in (None, "wall=50", "calls=5"):
            with self.subTest(clock=clock):
                found, report = ask(device="geforce3", clock=clock)
                self.assertTrue(report.contexts())
                self.assertEqual((found["hp"], found["nv"], found["nv_function"]), (True, True, True))
                self.reads_the_test_once(found)
                self.assertEqual(found["nv_counts"], VISIBLE_PIXELS)
                self.assertEqual((found["nv_is_query"], found["nv_is_query_after_delete"]), (True, False))


if __name__ == "__main__":
    under_layer.main()
