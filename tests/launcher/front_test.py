#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""The ways in which glext-emu gets the layer under a program: --front seam, vendor or export."""
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

LAUNCHER, EXAMPLE = sys.argv[1], sys.argv[2]
del sys.argv[1:]
LIBRARIES = pathlib.Path(LAUNCHER).parent.parent / "lib"
VARIABLES = ("LD_PRELOAD", "LD_LIBRARY_PATH", "GLEXT_EMU", "__GLX_VENDOR_LIBRARY_NAME",
             "__EGL_VENDOR_LIBRARY_FILENAMES")
VENDOR = {"__GLX_VENDOR_LIBRARY_NAME": "glextemu", "LD_LIBRARY_PATH": str(LIBRARIES),
          "__EGL_VENDOR_LIBRARY_FILENAMES": str(LIBRARIES / "50_glextemu.json")}
OSMESA_PROGRAM = """
extern void *OSMesaCreateContext(unsigned, void *);
extern unsigned char OSMesaMakeCurrent(void *, void *, unsigned, int, int);
extern void glFinish(void);
static unsigned char pixels[16 * 16 * 4];
int main(void) {
    if (!OSMesaMakeCurrent(OSMesaCreateContext(0x1908, 0), pixels, 0x1401, 16, 16)) return 1;
    glFinish();
    glFinish();
    return 0;
}
"""


def launch(*arguments, **environment):
    return subprocess.run([LAUNCHER, *arguments], capture_output=True, text=True, timeout=60,
                          env={**os.environ, **environment})


def compile_osmesa_program(folder):
    """The compiled program; skips the test where there is no OSMesa to link."""
    source, program = pathlib.Path(folder) / "program.c", pathlib.Path(folder) / "program"
    source.write_text(OSMESA_PROGRAM)
    for library in ("-lOSMesa", "-l:libOSMesa.so.8"):
        if subprocess.run(["cc", str(source), "-o", str(program), library], capture_output=True).returncode == 0:
            return str(program)
    raise unittest.SkipTest("needs libOSMesa")


def environment_of_a_child(*arguments, **environment):
    """What `glext-emu run ARGUMENTS` sets for its program."""
    result = launch("run", "--device", "mesa", *arguments, "--", "env", **environment)
    assert result.returncode == 0, result.stderr
    pairs = (line.split("=", 1) for line in result.stdout.splitlines() if "=" in line)
    return {name: value for name, value in pairs if name in VARIABLES}


class Environment(unittest.TestCase):
    def setUp(self):
        for name in VARIABLES:
            os.environ.pop(name, None)

    def test_the_seam_and_the_exports_are_preloaded(self):
        for arguments, library in (([], "libglext_emu.so"), (["--front", "seam"], "libglext_emu.so"),
                                   (["--front", "export"], "libglext_emu_exports.so")):
            with self.subTest(arguments):
                self.assertEqual(environment_of_a_child(*arguments),
                                 {"LD_PRELOAD": str(LIBRARIES / library), "GLEXT_EMU": "device=mesa,clock=none"})

    def test_the_vendor_library_needs_no_preload(self):
        self.assertEqual(environment_of_a_child("--front", "vendor"),
                         {**VENDOR, "GLEXT_EMU": "device=mesa,clock=none"})

    def test_the_driver_that_was_chosen_before_is_the_one_beneath(self):
        found = environment_of_a_child("--front", "vendor", __GLX_VENDOR_LIBRARY_NAME="other", LD_LIBRARY_PATH="/else")
        self.assertEqual(found["GLEXT_EMU"], "device=mesa,clock=none,driver=other")
        self.assertEqual(found["LD_LIBRARY_PATH"], f"{LIBRARIES}:/else")

    def test_the_inner_of_two_launchers_decides(self):
        def inner(first, second, **environment):
            return environment_of_a_child("--front", first, "--", LAUNCHER, "run", "--device", "mesa", "--front",
                                          second, **environment)
        seam = inner("vendor", "seam")
        self.assertEqual(seam.get("LD_PRELOAD"), str(LIBRARIES / "libglext_emu.so"))
        self.assertNotIn("__GLX_VENDOR_LIBRARY_NAME", seam)
        self.assertNotIn("__EGL_VENDOR_LIBRARY_FILENAMES", seam)
        self.assertEqual(inner("vendor", "seam", __GLX_VENDOR_LIBRARY_NAME="other")["__GLX_VENDOR_LIBRARY_NAME"], "other")
        vendor = inner("export", "vendor")
        self.assertNotIn("LD_PRELOAD", vendor)
        again = inner("vendor", "vendor", __GLX_VENDOR_LIBRARY_NAME="other")
        self.assertEqual(again["GLEXT_EMU"], "device=mesa,clock=none,driver=other")

    def test_zero_in_the_environment_switches_every_front_end_off(self):
        for front in ("seam", "vendor", "export"):
            self.assertEqual(environment_of_a_child("--front", front, GLEXT_EMU="0"), {"GLEXT_EMU": "0"})

    def test_a_front_end_that_is_none_is_told(self):
        result = launch("run", "--front", "back", "--", "true")
        self.assertEqual(result.returncode, 2)
        self.assertEqual(result.stderr, "glext-emu: `back` is not a front end, expected seam, vendor or export.\n")

    def test_an_installed_launcher_finds_its_libraries(self):
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run(["cmake", "--install", str(pathlib.Path(LAUNCHER).parent.parent), "--prefix", folder,
                            "--component", "layer"], check=True, capture_output=True)
            launcher = pathlib.Path(folder) / "bin" / "glext-emu"
            for front in ("seam", "vendor", "export"):
                result = subprocess.run([launcher, "run", "--device", "mesa", "--front", front, "-v", "--", "true"],
                                        capture_output=True, text=True)
                self.assertEqual(result.returncode, 0, result.stderr)
                self.assertIn(f"{folder}/lib", result.stderr)
            self.assertTrue((pathlib.Path(folder) / "lib" / "libEGL_glextemu.so.0").is_file())


class Settings(unittest.TestCase):
    def run_example(self, **environment):
        if "DISPLAY" not in os.environ:
            self.skipTest("needs DISPLAY")
        return subprocess.run([EXAMPLE], capture_output=True, text=True, timeout=60,
                              env={**os.environ, **environment})

    def test_a_wrong_setting_is_told_and_ends_the_program(self):
        exports = {"LD_PRELOAD": str(LIBRARIES / "libglext_emu_exports.so")}
        for front in (VENDOR, exports):
            result = self.run_example(**front, GLEXT_EMU="device=voodoo")
            self.assertEqual(result.returncode, 2)
            self.assertEqual(result.stderr.count("glext_emu: there is no device `voodoo`"), 1, result.stderr)

    def test_a_driver_that_is_not_there_is_told_and_ends_the_program(self):
        result = self.run_example(**VENDOR, GLEXT_EMU="device=mesa,driver=nowhere")
        self.assertEqual(result.returncode, 2)
        self.assertIn("glext_emu: the driver `nowhere` cannot be loaded", result.stderr)

    def test_the_layer_is_no_driver_of_its_own(self):
        result = self.run_example(**VENDOR, GLEXT_EMU="device=mesa,driver=glextemu")
        self.assertEqual(result.returncode, 2)
        self.assertIn("`glextemu` is not a driver", result.stderr)


class Doctor(unittest.TestCase):
    def test_it_says_which_front_end_it_was(self):
        if "DISPLAY" not in os.environ:
            self.skipTest("needs DISPLAY")
        for front, word in (("seam", "seam"), ("vendor", "vendor library"), ("export", "exports")):
            result = launch("doctor", "--front", front, "--", EXAMPLE)
            self.assertEqual(result.returncode, 0, result.stdout)
            self.assertIn(f"hooked GLX, by the {word}\n", result.stdout)

    def test_a_program_that_needs_osmesa_gets_the_exports_by_itself(self):
        with tempfile.TemporaryDirectory() as folder:
            program = compile_osmesa_program(folder)
            result = launch("doctor", "--", program)
            seam = launch("doctor", "--front", "seam", "--", program)
        self.assertEqual(result.returncode, 0, result.stdout)
        self.assertIn("hooked OSMesa, by the exports\n", result.stdout)
        self.assertIn("context: osmesa, OpenGL", result.stdout)
        self.assertEqual(seam.returncode, 1)
        self.assertIn("for such a program there is --front export", seam.stdout)


class Frames(unittest.TestCase):
    def test_a_frame_of_osmesa_ends_where_the_program_finishes(self):
        with tempfile.TemporaryDirectory() as folder:
            report = pathlib.Path(folder) / "report.json"
            result = launch("run", "--report", str(report), "--", compile_osmesa_program(folder))
            records = json.loads(report.read_text())["records"]
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual([record["kind"] for record in records], ["context", "frame", "frame"])
        self.assertEqual(records[0]["platform"], "osmesa")


if __name__ == "__main__":
    unittest.main()
