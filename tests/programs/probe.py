# SPDX-License-Identifier: MIT
"""The probe tells of a real program's own queries what the Occlusion Unit would have told, and the program notices
nothing: its picture, its results and its output are the same.

  probe.py WITNESS.so

Two programs that ask in different ways: osgocclusionquery about boxes in its window, from a compatibility context
and fixed function; VTK about the layers of depth peeling, in framebuffer objects, from a core context and GLSL.
What the unit says of the boxes is held against a witness (query_witness.c) that draws them again and reads back.
"""
import pathlib
import struct
import sys
import tempfile
import unittest

import osgocclusionquery
import traced
import under_layer
import x_window

WITNESS = sys.argv.pop(1)
FRAMES = 41
CLOCK = "frames=1"  # with the driver's own time a program may ask sooner or later
VTK_FRAMES = 4
NOTHING = ([0, 0, -1, -1], 1.0)
REGISTERS = ("visible", "projected_hits", "visible_hits", "nearest_depth", "screen_box")


def float32(number):
    return struct.unpack("f", struct.pack("f", number))[0]


def boxes_of_probe(run):
    return [(probe["screen_box"], float32(probe["nearest_depth"])) for probe in run.layers_report().probes()]


def counts_of_probe(run):
    return [probe["visible_hits"] for probe in run.layers_report().probes()]


def results(trace):
    """What a program was told of its queries, in the order of its asking."""
    return [call.value() for call in traced.calls(trace, "glGetQueryObject")
            if "GL_QUERY_RESULT," in call.text]


def without_times(run):
    """The frames of a report, but for what a clock on the wall says."""
    return [{key: value for key, value in frame.items() if key not in ("pid", "stall_ms", "unprobed")}
            for frame in run.layers_report().frames()]


class Osgocclusionquery(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        osgocclusionquery.Osgocclusionquery.setUpClass.__func__(cls)
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = folder.name
        cls.plain = cls.frames(cls)
        cls.probed = cls.frames(cls, probe="unit")

    def frames(self, **how):
        environment = dict(osgocclusionquery.SINGLE_THREAD, OSG_RUN_FRAME_COUNT=str(FRAMES), **how.pop("more", {}))
        return under_layer.run(self.command, device="mesa", clock=CLOCK, environment=environment, **how)

    def picture(self, **how):
        with under_layer.Program(self.command, device="mesa", environment=osgocclusionquery.SINGLE_THREAD,
                                 **how) as program:
            with x_window.Window(osgocclusionquery.SIZE) as window:
                picture = window.picture_at_rest()
                window.press("Escape")
            return picture, program.finish()

    def test_the_program_runs_as_without_the_probe(self):
        self.assertEqual((self.probed.output, self.probed.errors, self.probed.status),
                         (self.plain.output, self.plain.errors, self.plain.status))
        self.assertEqual(without_times(self.probed), without_times(self.plain))
        self.assertEqual(self.plain.layers_report().probes(), [])

    def test_every_query_is_told_of_with_all_registers(self):
        probes = self.probed.layers_report().probes()
        begun = self.probed.layers_report().total("queries_begun")
        self.assertGreaterEqual(begun, 2 * (FRAMES // osgocclusionquery.PERIOD))
        # The last frame's may be read by nobody any more.
        self.assertGreaterEqual(len(probes), begun - osgocclusionquery.BALLS)
        self.assertEqual(self.probed.layers_report().total("unprobed"), 0)
        for probe in probes:
            self.assertNotIn(None, [probe[register] for register in REGISTERS], probe)
            self.assertLessEqual(probe["visible_hits"], probe["projected_hits"])
            self.assertEqual(probe["visible"], min(probe["visible_hits"], 1))

    def test_box_and_nearest_depth_are_those_that_a_witness_reads_back(self):
        path = pathlib.Path(self.folder, "witness.txt")
        run = self.frames(preload=[WITNESS], more={"QUERY_WITNESS": str(path)})
        self.assertEqual((run.output, run.status), (self.plain.output, 0), run.errors)
        seen = []
        for line in path.read_text().splitlines():
            _, *box, depth = line.split()
            seen.append(([int(corner) for corner in box], float32(float(depth))))
        told = boxes_of_probe(self.probed)
        self.assertEqual(told, seen[:len(told)])
        self.assertEqual({told == NOTHING for told in seen}, {True, False})  # a hidden ball, and a shown one

    def test_the_results_that_the_program_reads_are_the_same_and_those_of_the_register(self):
        traces = [str(pathlib.Path(self.folder, name)) for name in ("plain.trace", "probed.trace")]
        for trace, probe in zip(traces, (None, "unit")):
            run = self.frames(preload=[traced.WRAPPER], probe=probe, more={"TRACE_FILE": trace})
            self.assertEqual(run.status, 0, run.errors)
        plain, probed = (results(trace) for trace in traces)
        self.assertEqual(probed, plain)
        self.assertGreater(len(set(plain)), 1)
        self.assertEqual(probed, counts_of_probe(run)[:len(probed)])

    def test_the_picture_is_the_same_bit_by_bit(self):
        plain, _ = self.picture()
        probed, run = self.picture(probe="unit")
        self.assertGreater(len(run.layers_report().probes()), 0)
        self.assertTrue(probed == plain)  # by ==: assertEqual would print both pictures


class Vtk(unittest.TestCase):
    def peel(self, **how):
        """The run and the bytes of the picture it wrote."""
        scene = pathlib.Path(__file__).with_name("vtk_scene.py")
        with tempfile.TemporaryDirectory() as folder:
            image = pathlib.Path(folder, "scene.png")
            run = under_layer.run([sys.executable, str(scene), str(image), str(VTK_FRAMES)], **how)
            return run, image.read_bytes()

    def test_picture_and_output_are_the_same_and_the_counts_those_of_the_program(self):
        bare, bare_picture = self.peel(layer=False)
        with tempfile.TemporaryDirectory() as folder:
            trace = str(pathlib.Path(folder, "trace"))
            run, picture = self.peel(device="mesa", probe="unit", preload=[traced.WRAPPER],
                                     environment={"TRACE_FILE": trace})
            read = results(trace)
        self.assertTrue(picture == bare_picture)
        self.assertEqual((run.output, run.status), (bare.output, bare.status), run.errors)
        self.assertGreaterEqual(len(read), 2 * VTK_FRAMES)
        self.assertEqual(counts_of_probe(run), read)
        for probe in run.layers_report().probes():
            self.assertEqual(probe["screen_box"] == [0, 0, -1, -1], probe["visible_hits"] == 0, probe)

    def test_no_extension_appears(self):
        run, plain = (under_layer.run(["glxinfo"], device="mesa", probe=probe) for probe in ("unit", None))
        self.assertEqual(run.output, plain.output)
        self.assertNotIn("GL_EMU", run.output)


if __name__ == "__main__":
    under_layer.main()
