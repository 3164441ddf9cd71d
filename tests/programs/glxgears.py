# SPDX-License-Identifier: MIT
"""glxgears draws display lists and asks nothing: it must not notice any device, nor any latency."""
import re
import time
import unittest

import under_layer
import x_window

SIZE = (301, 203)  # odd, so that no other program's window is taken for it
COMMAND = ["glxgears", "-info", "-geometry", "{}x{}+0+0".format(*SIZE)]
FRAMES = 30


def turn(layer=True, device=None, clock=None):
    """Let the gears turn, then press Escape: the run, and two pictures taken while they turned."""
    with under_layer.Program(COMMAND, layer, device, clock) as program, x_window.Window(SIZE) as window:
        pictures = []
        for _ in range(2):
            time.sleep(0.3)
            pictures.append(window.picture())
        window.press("Escape")
        return program.finish(), pictures


def what_it_says(run):
    """The output without its measurements: `5584 frames in 5.0 seconds = 1116.676 FPS`."""
    return re.sub(r"^\d+ frames in .*\n", "", run.output, flags=re.MULTILINE)


class Glxgears(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.bare, cls.bare_pictures = turn(layer=False)

    def test_without_the_layer_the_gears_turn_and_no_report_is_written(self):
        self.assertEqual(self.bare.status, 0)
        self.assertIsNone(self.bare.report)
        self.assertNotEqual(*self.bare_pictures)

    def test_the_gears_turn_on_every_device_with_latency_and_without(self):
        for device in ("mesa", "visualize-fx", "geforce-fx-5950"):
            for clock in (None, "wall=5000", "calls=10", "frames=2"):
                with self.subTest(device=device, clock=clock):
                    run, pictures = turn(True, device, clock)
                    self.assertEqual((run.status, run.errors), (self.bare.status, self.bare.errors))
                    self.assertNotEqual(*pictures)
                    self.reports_frames_but_no_query(run.layers_report())

    def reports_frames_but_no_query(self, report):
        self.assertEqual(len(report.contexts("glxgears")), 1)
        self.assertGreaterEqual(len(report.frames()), FRAMES)
        # Each gear is a display list.
        self.assertGreaterEqual(min(frame["draws"] for frame in report.frames()[:FRAMES]), 3)
        for field in ("queries_begun", "polls", "waits", "results", "stall_ms"):
            self.assertEqual(report.total(field), 0, field)

    def test_a_pass_through_device_says_what_mesa_says(self):
        for device in (None, "mesa"):
            with self.subTest(device=device):
                run, _ = turn(device=device)
                self.assertTrue(run.layers_report().contexts("glxgears"))
                self.assertEqual(what_it_says(run), what_it_says(self.bare))

    def test_the_report_is_valid_while_the_program_runs(self):
        with under_layer.Program(COMMAND, device="mesa") as program, x_window.Window(SIZE) as window:
            seen = []
            for _ in range(20):
                time.sleep(0.1)
                report = program.report_now()
                seen.append(len(report.frames()) if report else 0)
            window.press("Escape")
            self.assertEqual(program.finish().status, 0)
        self.assertEqual(seen, sorted(seen))
        self.assertGreater(seen[-1], seen[0])


if __name__ == "__main__":
    under_layer.main()
