#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""glext-emu as a user meets it: statuses, sentences, help, devices, doctor."""
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

LAUNCHER, EXAMPLE = sys.argv[1], sys.argv[2]
del sys.argv[1:]


def launch(*arguments, **environment):
    return subprocess.run([LAUNCHER, *arguments], capture_output=True, text=True, timeout=60,
                          env={**os.environ, **environment})


class Run(unittest.TestCase):
    def test_the_exit_status_passes_through(self):
        for status in (0, 1, 7, 255):
            self.assertEqual(launch("run", "--", "sh", "-c", f"exit {status}").returncode, status)

    def test_the_programs_arguments_are_untouched(self):
        words = ["--device", "-v", "--", "a b", "", "--help"]
        result = launch("run", "--device", "mesa", "--", "printf", "%s|", *words)
        self.assertEqual(result.stdout, "|".join(words) + "|")

    def test_the_dashes_may_be_left_out(self):
        self.assertEqual(launch("run", "--device", "mesa", "printf", "-x").stdout, "-x")

    def test_a_program_that_is_not_there_gives_127(self):
        result = launch("run", "--", "no-such-program")
        self.assertEqual(result.returncode, 127)
        self.assertIn("no-such-program cannot be run", result.stderr)

    def test_bad_use_is_one_sentence_and_status_2(self):
        for arguments, words in (
                (["run"], "there is no program to run"),
                (["run", "--device", "voodoo", "--", "true"], "there is no device `voodoo`"),
                (["run", "--clock", "5us", "--", "true"], "expected none, wall=MICROSECONDS"),
                (["run", "--speed", "5", "--", "true"], "--speed"),
                (["run", "--device", "/no/such.toml", "--", "true"], "cannot be opened"),
                (["run", "--report", "/no/such/report.json", "--", "true"], "cannot be written"),
                (["run", "--report", "/etc/passwd", "--", "true"], "is not a report"),
                (["run", "--probe", "unit", "--", "true"], "wants --report FILE"),
                (["run", "--probe", "hp", "--report", "/tmp/r", "--", "true"], "expected unit"),
                (["run", "--report", "/tmp/a,b", "--", "true"], "must not hold a comma"),
                (["doctor"], "there is no program to look at"),
                ([], "subcommand")):
            with self.subTest(arguments):
                result = launch(*arguments)
                self.assertEqual((result.returncode, result.stdout), (2, ""))
                self.assertIn(words, result.stderr)
                self.assertEqual(result.stderr.count("\n"), 1, result.stderr)

    def test_a_wrong_device_file_is_told_with_its_line(self):
        with tempfile.NamedTemporaryFile("w", suffix=".toml") as file:
            file.write('name = "x"\ndescription = "d"\nsource = "s"\nspeed = 3\n')
            file.flush()
            result = launch("run", "--device", file.name, "--", "true")
        self.assertEqual(result.returncode, 2)
        self.assertIn(f"{file.name}:4: unknown key `speed`", result.stderr)

    def test_ours_comes_first_once_and_others_stay(self):
        show = ["run", "--device", "mesa", "--", "sh", "-c", "echo $LD_PRELOAD"]
        with tempfile.TemporaryDirectory() as folder:
            # LD_PRELOAD is set by a shell, so that the launcher itself does not load these.
            script = f'LD_PRELOAD="{folder}/libglext_emu.so:libm.so.6" exec "$@"'
            result = subprocess.run(["sh", "-c", script, "sh", LAUNCHER, *show], capture_output=True, text=True)
        items = result.stdout.strip().split(":")
        self.assertEqual([pathlib.Path(item).name for item in items], ["libglext_emu.so", "libm.so.6"])
        self.assertNotIn(folder, items[0])

    def test_zero_in_the_environment_switches_the_layer_off(self):
        result = launch("run", "--device", "mesa", "--", "sh", "-c", "echo [$LD_PRELOAD]", GLEXT_EMU="0")
        self.assertEqual(result.stdout, "[]\n")

    def test_help_teaches_with_examples(self):
        result = launch("--help")
        self.assertEqual(result.returncode, 0)
        self.assertIn("glext-emu run --device visualize-fx", result.stdout)
        self.assertEqual(launch("run", "--help").returncode, 0)


class Preload(unittest.TestCase):
    def test_a_wrong_setting_without_the_launcher_is_told_and_ends_the_program(self):
        if "DISPLAY" not in os.environ:
            self.skipTest("needs DISPLAY")
        library = pathlib.Path(LAUNCHER).parent.parent / "lib" / "libglext_emu.so"
        result = subprocess.run([EXAMPLE], capture_output=True, text=True, timeout=60,
                                env={**os.environ, "LD_PRELOAD": str(library), "GLEXT_EMU": "device=voodoo"})
        self.assertEqual(result.returncode, 2)
        self.assertIn("glext_emu: there is no device `voodoo`", result.stderr)


class Devices(unittest.TestCase):
    def test_the_list_and_its_json_agree(self):
        devices = json.loads(launch("devices", "--json").stdout)
        by_name = {device["name"]: device for device in devices}
        self.assertEqual(by_name["visualize-fx"]["emulate"], ["GL_HP_occlusion_test"])
        self.assertEqual(by_name["visualize-fx"]["gl_version"], "1.1")
        self.assertEqual(by_name["geforce-fx-5950"]["year"], 2003)
        self.assertTrue(all(device["source"] for device in devices))
        lines = launch("devices").stdout.splitlines()[1:]
        self.assertEqual([line.split()[0] for line in lines], [device["name"] for device in devices])


class Doctor(unittest.TestCase):
    def test_a_gl_program_is_told_to_be_reached(self):
        if "DISPLAY" not in os.environ:
            self.skipTest("needs DISPLAY")
        result = launch("doctor", "--", EXAMPLE)
        self.assertEqual(result.returncode, 0)
        self.assertIn("hooked GLX", result.stdout)
        self.assertIn("The layer is under this program.", result.stdout)

    def test_a_program_without_gl_is_told_not_to_be(self):
        result = launch("doctor", "--", "true")
        self.assertEqual(result.returncode, 1)
        self.assertIn("no GLVND driver was loaded", result.stdout)

    def test_a_program_that_runs_on_is_ended(self):
        result = launch("doctor", "--seconds", "1", "--", "sleep", "60")
        self.assertIn("ended after 1 s", result.stdout)

    def compile(self, folder, *options):
        source = pathlib.Path(folder) / "program.c"
        source.write_text("int main(void) { return 0; }\n")
        program = pathlib.Path(folder) / "program"
        subprocess.run(["cc", str(source), "-o", str(program), *options], check=True)
        return str(program)

    def test_a_static_program_is_told_why(self):
        with tempfile.TemporaryDirectory() as folder:
            result = launch("doctor", "--", self.compile(folder, "-static"))
        self.assertEqual(result.returncode, 1)
        self.assertIn("statically linked", result.stdout)

    def test_a_set_uid_program_is_told_why(self):
        with tempfile.TemporaryDirectory() as folder:
            program = self.compile(folder)
            os.chmod(program, 0o4755)
            result = launch("doctor", "--", program)
        self.assertIn("set-uid", result.stdout)

    def test_damaged_programs_do_not_crash_it(self):
        with tempfile.TemporaryDirectory() as folder:
            whole = pathlib.Path(shutil.which("true")).read_bytes()
            program = pathlib.Path(folder) / "damaged"
            for size in (1, 4, 16, 63, 64, 100, 500, 1000, 5000):
                program.write_bytes(whole[:size])
                program.chmod(0o755)
                # What the kernel refuses, execvp gives to a shell: let it do so in a folder of its own.
                result = subprocess.run([LAUNCHER, "doctor", "--", str(program)], cwd=folder, capture_output=True)
                self.assertEqual(result.returncode, 1, f"{size} bytes: {result}")


if __name__ == "__main__":
    unittest.main()
