#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""The documents' example says what it should on an HP machine, and only there."""
import os
import subprocess
import sys
import unittest

LAUNCHER, EXAMPLE = sys.argv[1], sys.argv[2]
del sys.argv[1:]
if "DISPLAY" not in os.environ:
    sys.exit(77)


class Example(unittest.TestCase):
    def test_on_visualize_fx_it_sees_what_is_visible(self):
        for clock in ("none", "wall=100", "calls=50", "frames=3"):
            output = subprocess.check_output(
                [LAUNCHER, "run", "--device", "visualize-fx", "--clock", clock, "--", EXAMPLE], text=True)
            self.assertEqual(output, "behind the wall: occluded\nbefore the wall: visible\n", clock)

    def test_without_the_layer_there_is_no_such_test(self):
        # The driver does not know the names: the variable is never written.
        output = subprocess.check_output([EXAMPLE], text=True)
        self.assertNotEqual(output, "behind the wall: occluded\nbefore the wall: visible\n")


if __name__ == "__main__":
    unittest.main()
