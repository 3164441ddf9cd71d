# SPDX-License-Identifier: MIT
"""A program that uses the proposed extensions is built with nothing but an installed layer, and runs on it.

usage: installed.py BUILD_FOLDER EXAMPLES_FOLDER

The layer is installed into a folder of its own; the examples of the documents are compiled with what pkg-config tells,
and nothing else, and run by the installed launcher.
"""
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

BUILD, EXAMPLES = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
del sys.argv[1:]
# Example -> a device that has its extension.
DEVICES = {"depth_region_query": "proposed-zfar-parallel", "occlusion_unit": "proposed-occlusion-unit"}
EXTENSIONS = {"GL_EMU_depth_region_query", "GL_EMU_device_time", "GL_EMU_occlusion_unit"}


class Installed(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        cls.prefix = pathlib.Path(cls.folder.name) / "usr"
        subprocess.run(["cmake", "--install", BUILD, "--prefix", cls.prefix, "--component", "layer"], check=True,
                       capture_output=True)

    def pkg_config(self, *asked):
        environment = {**os.environ, "PKG_CONFIG_PATH": str(self.prefix / "lib/pkgconfig")}
        return subprocess.run(["pkg-config", *asked], env=environment, check=True, capture_output=True,
                              text=True).stdout.split()

    def compiled(self, example):
        program = pathlib.Path(self.folder.name) / example
        flags = self.pkg_config("--cflags", "--libs", "glext_emu", "egl", "opengl")
        subprocess.run(["cc", "-Wall", "-Werror", EXAMPLES / f"{example}.c", "-o", program, *flags], check=True)
        return program

    def test_pkg_config_names_the_extensions_and_where_the_layer_lies(self):
        self.assertEqual(set(self.pkg_config("--variable=extensions", "glext_emu")), EXTENSIONS)
        for variable in ("layer", "launcher"):
            self.assertTrue(pathlib.Path(self.pkg_config(f"--variable={variable}", "glext_emu")[0]).is_file())

    def test_the_examples_build_and_run_on_an_installed_layer_and_on_no_other_gl(self):
        for example, device in DEVICES.items():
            with self.subTest(example=example):
                program = self.compiled(example)
                run = [self.prefix / "bin/glext-emu", "run", "--device", device, "--", program]
                under = subprocess.run(run, capture_output=True, text=True, timeout=60, check=False)
                self.assertEqual(under.returncode, 0, under.stdout + under.stderr)
                self.assertTrue(under.stdout)
                bare = subprocess.run([program], capture_output=True, text=True, timeout=60, check=False)
                self.assertNotEqual((bare.returncode, bare.stdout), (0, under.stdout))


if __name__ == "__main__":
    unittest.main()
