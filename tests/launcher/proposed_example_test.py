#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""The examples of the proposed extensions say what they should on machines that have them, and only there.

The numbers are those of 64 x 64 pixels: the wall is the left half at depth 0.5. A rectangle of 32 x 32 pixels in the
middle is half behind it; of 16 x 16 pixels, the two faces of a box that are seen head on are 512 samples.
"""
import subprocess
import sys
import unittest

LAUNCHER, UNIT, REGION = sys.argv[1:4]
del sys.argv[1:]
CLOCKS = ("none", "wall=100", "calls=50", "frames=3")
UNIT_SAYS = """\
a rectangle behind the wall's edge: 512 of 1024 samples visible, nearest at 0.750, within (32, 16) to (47, 47)
a box: 0 of 512 samples visible
a box: 256 of 512 samples visible, nearest at 0.625, within (32, 24) to (39, 39)
a box: 512 of 512 samples visible, nearest at 0.125, within (40, 24) to (55, 39)
"""
REGION_SAYS = """\
left tile: occluded, furthest depth 0.500
right tile: open, furthest depth 1.000
"""


class ProposedExamples(unittest.TestCase):
    def output_on(self, device, clock, example):
        return subprocess.check_output(
            [LAUNCHER, "run", "--device", device, "--clock", clock, "--", example], text=True)

    def test_the_unit_tells_of_a_rectangle_and_of_three_boxes(self):
        for clock in CLOCKS:
            with self.subTest(clock=clock):
                self.assertEqual(self.output_on("proposed-occlusion-unit", clock, UNIT), UNIT_SAYS)

    def test_a_region_query_tells_a_full_tile_from_an_open_one(self):
        for device in ("proposed-zfar", "proposed-zfar-parallel"):
            for clock in CLOCKS:
                with self.subTest(device=device, clock=clock):
                    self.assertEqual(self.output_on(device, clock, REGION), REGION_SAYS)

    def test_other_machines_have_neither(self):
        for prefix in ([], [LAUNCHER, "run", "--device", "visualize-fx", "--"]):
            with self.subTest(prefix=prefix):
                done = subprocess.run([*prefix, UNIT], capture_output=True, text=True, check=False)
                self.assertEqual((done.returncode, done.stdout), (1, "this GL has no occlusion unit\n"))
                done = subprocess.run([*prefix, REGION], capture_output=True, text=True, check=False)
                self.assertEqual((done.returncode, done.stdout), (1, "this GL has no depth region queries\n"))


if __name__ == "__main__":
    unittest.main()
