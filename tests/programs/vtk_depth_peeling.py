# SPDX-License-Identifier: MIT
"""VTK's depth peeling waits for every query: latency has to show as stalled time, and never in the
picture."""
import pathlib
import sys
import tempfile
import unittest

import under_layer

FRAMES = 10
SCENE = pathlib.Path(__file__).with_name("vtk_scene.py")
LATENCY_US = 3000


class VtkDepthPeeling(unittest.TestCase):
    def peel(self, **how):
        """Run the scene; the run and the bytes of the picture it wrote."""
        with tempfile.TemporaryDirectory() as folder:
            image = pathlib.Path(folder, "scene.png")
            run = under_layer.run([sys.executable, str(SCENE), str(image), str(FRAMES)], **how)
            return run, image.read_bytes() if image.exists() else None

    @classmethod
    def setUpClass(cls):
        cls.bare, cls.bare_picture = cls().peel(layer=False)

    def test_without_the_layer_vtk_peels_and_no_report_is_written(self):
        self.assertEqual((self.bare.status, self.bare.report), (0, None), self.bare.errors)
        self.assertIn("peeled vtkXOpenGLRenderWindow", self.bare.output)
        self.assertNotIn("not peeled", self.bare.output)

    def test_the_picture_and_the_queries_are_the_same_with_every_latency(self):
        queries = set()
        for clock in (None, f"wall={LATENCY_US}", "calls=50", "frames=2"):
            with self.subTest(clock=clock):
                run, picture = self.peel(device="mesa", clock=clock)
                self.assertEqual((run.output, run.errors, run.status),
                                 (self.bare.output, self.bare.errors, self.bare.status))
                self.assertEqual(picture, self.bare_picture)
                queries.add(run.layers_report().total("queries_begun"))
                self.assertGreaterEqual(len(run.layers_report().frames()), FRAMES)
                self.assertGreater(run.layers_report().total("waits"), 0)
        self.assertEqual(len(queries), 1, queries)
        self.assertGreaterEqual(queries.pop(), 2 * FRAMES)  # five balls: ten surfaces behind each other

    def test_latency_shows_as_stalled_time_at_every_wait(self):
        run, _ = self.peel(device="mesa", clock=f"wall={LATENCY_US}")
        waits, stall_ms = run.layers_report().total("waits"), run.layers_report().total("stall_ms")
        self.assertEqual(waits, run.layers_report().total("queries_begun"))
        # VTK reads a result at once after the query's end; what it does between is far less than half of that.
        self.assertGreater(stall_ms, 0.5 * waits * LATENCY_US / 1000)
        self.assertGreater(run.seconds, stall_ms / 1000)

    def test_vtk_refuses_a_device_of_gl_1_5_as_it_refuses_a_mesa_of_gl_1_5(self):
        # VTK wants 3.2, says so, and then stumbles over what it did not get.
        mesa, _ = self.peel(layer=False, environment={"MESA_GL_VERSION_OVERRIDE": "1.5"})
        device, _ = self.peel(device="geforce-fx-5950")
        for run in (mesa, device):
            self.assertIn("Unable to find a valid OpenGL 3.2 or later implementation", run.errors)
        self.assertEqual(device.status, mesa.status)
        self.assertTrue(device.layers_report().contexts()[0]["version"].startswith("1.5"))


if __name__ == "__main__":
    under_layer.main()
