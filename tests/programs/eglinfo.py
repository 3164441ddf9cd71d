# SPDX-License-Identifier: MIT
"""eglinfo and es2_info: EGL and its ES contexts, which no device changes.

Occlusion tests of HP, NV and ARB are for compatibility contexts only (gl.xml: supported="gl"), so an ES
context is the same on every device. eglinfo makes no context, hence no record: that the layer is under it
shows in the dynamic linker's own log, where libEGL takes dlsym from the layer.
"""
import pathlib
import tempfile
import unittest

import under_layer

DEVICES = [("native", None), ("mesa", None), ("mesa", "wall=50"), ("visualize-fx", None),
           ("visualize-fx", "frames=2"), ("geforce-fx-5950", None), ("geforce-fx-5950", "frames=2")]


class Eglinfo(unittest.TestCase):
    def same_on_every_device(self, command):
        """Compare a command's whole output; gives its runs with the layer."""
        bare = under_layer.run(command, layer=False)
        self.assertIsNone(bare.report)
        runs = []
        for device, clock in DEVICES:
            with self.subTest(command=command, device=device, clock=clock):
                runs.append(under_layer.run(command, device=device, clock=clock))
                self.assertEqual((runs[-1].output, runs[-1].errors, runs[-1].status),
                                 (bare.output, bare.errors, bare.status))
        return bare, runs

    def test_eglinfo_prints_the_same_on_every_device(self):
        bare, _ = self.same_on_every_device(["eglinfo"])
        self.assertIn("EGL_KHR_create_context", bare.output)

    def test_es2_info_prints_the_same_on_every_device_and_is_reported(self):
        bare, runs = self.same_on_every_device(["es2_info"])
        self.assertIn("GL_EXT_occlusion_query_boolean", bare.output)
        for run in runs:
            contexts = run.layers_report().contexts("es2_info")
            self.assertEqual([context["platform"] for context in contexts], ["egl"])

    def test_the_linker_binds_libegl_to_the_layer_only_where_it_is_preloaded(self):
        for layer in (False, True):
            with self.subTest(layer=layer), tempfile.TemporaryDirectory() as folder:
                under_layer.run(["eglinfo"], layer=layer, device="mesa",
                                environment={"LD_DEBUG": "bindings", "LD_DEBUG_OUTPUT": f"{folder}/log"})
                lines = [line for log in pathlib.Path(folder).iterdir() for line in log.read_text().splitlines()]
                bindings = [line for line in lines if "libEGL.so" in line and "`dlsym'" in line]
                self.assertTrue(bindings)
                self.assertEqual(any("libglext_emu.so" in line for line in bindings), layer)


if __name__ == "__main__":
    under_layer.main()
