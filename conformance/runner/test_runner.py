# SPDX-License-Identifier: MIT
"""The program `conformance` beside made-up programs of extensions: what it prints, and how it ends.

usage: test_runner.py BIN_FOLDER        one test runs the real thing, as it was built there
"""
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SCRIPT = Path(__file__).with_name("conformance.py")
BUILT = None
LIST = "folder\tstatements\ttest\narb_some\tAB-01, AB-02\tSuite.one\nnv_other\tCD-01\tSuite.one\n"

# Writes GoogleTest's JSON where it is told to, and ends as it is told to.
PROGRAM = """#!/bin/sh
echo "[ RUN      ] Suite.one"
for argument; do case $argument in --gtest_output=json:*) file=${argument#--gtest_output=json:} ;; esac; done
cat > "$file" <<'JSON'
{"testsuites": [{"name": "Suite", "testsuite": [{"name": "one", "result": "%s"%s}]}]}
JSON
%s
"""
FAILURES = ', "failures": [{"failure": "file:1\\nis wrong"}]'
PASSES = PROGRAM % ("COMPLETED", "", "exit 0")
FAILS = PROGRAM % ("COMPLETED", FAILURES, "exit 1")
SKIPS = PROGRAM % ("SKIPPED", "", "exit 77")
CRASHES = "#!/bin/sh\necho '[ RUN      ] Suite.one'\nkill -SEGV $$\n"
REFUSES = "#!/bin/sh\necho 'no display for platform glx'\nexit 77\n"


class TheRunner(unittest.TestCase):
    def run_it(self, programs, *arguments):
        """Exit status and output of the runner beside these programs, copied away from the tree."""
        with tempfile.TemporaryDirectory() as folder:
            shutil.copy(SCRIPT, Path(folder, "conformance"))
            Path(folder, "conformance.tsv").write_text(LIST)
            for name, text in programs.items():
                program = Path(folder, f"conformance_{name}")
                program.write_text(text)
                program.chmod(0o755)
            done = subprocess.run(
                [sys.executable, "-B", Path(folder, "conformance"), *arguments],
                capture_output=True, text=True, check=False,
            )  # fmt: skip
        return done.returncode, done.stdout + done.stderr

    def test_all_that_ran_passed(self):
        status, said = self.run_it({"arb_some": PASSES, "nv_other": SKIPS})
        self.assertEqual(status, 0)
        self.assertIn("GL_ARB_some                              1 passed, 0 failed, 0 skipped\n", said)
        self.assertIn("GL_NV_other                              0 passed, 0 failed, 1 skipped\n", said)
        self.assertTrue(said.endswith("\n1 passed, 0 failed, 1 skipped\n"), said)

    def test_a_failure_is_told_with_the_statements_that_it_breaks(self):
        status, said = self.run_it({"arb_some": FAILS, "nv_other": PASSES})
        self.assertEqual(status, 1)
        self.assertIn("  failed: Suite.one [AB-01, AB-02]\n    file:1\n    is wrong\n", said)

    def test_a_crash_is_a_failure(self):
        status, said = self.run_it({"arb_some": CRASHES})
        self.assertEqual(status, 1)
        self.assertIn("ended by SIGSEGV in Suite.one", said)

    def test_nothing_but_skips_is_no_success(self):
        self.assertEqual(self.run_it({"arb_some": SKIPS})[0], 77)
        status, said = self.run_it({"arb_some": REFUSES})
        self.assertEqual(status, 77)
        self.assertIn("not run: no display for platform glx", said)

    def test_one_extension_can_be_chosen_by_each_of_its_names(self):
        for name in ("GL_ARB_some", "ARB_some", "arb_some"):
            with self.subTest(name=name):
                status, said = self.run_it({"arb_some": PASSES, "nv_other": FAILS}, "--extension", name)
                self.assertEqual((status, "NV" in said), (0, False), said)

    def test_extensions_have_their_vendors_prefix_and_other_matters_their_own_name(self):
        status, said = self.run_it({"emu_occlusion_unit": PASSES, "overlap": PASSES})
        self.assertEqual(status, 0)
        self.assertEqual([line.split()[0] for line in said.splitlines()[:2]], ["GL_EMU_occlusion_unit", "overlap"])
        status, said = self.run_it({"emu_occlusion_unit": PASSES}, "--extension", "GL_EMU_occlusion_unit")
        self.assertEqual(status, 0, said)

    def test_the_list_runs_nothing(self):
        programs = {"arb_some": CRASHES, "nv_other": CRASHES}
        self.assertEqual(self.run_it(programs, "--list")[1],
                         "GL_ARB_some\tAB-01, AB-02\tSuite.one\nGL_NV_other\tCD-01\tSuite.one\n")  # fmt: skip
        only = self.run_it(programs, "--list", "--extension", "nv_other", "--filter", "S*")[1]
        self.assertEqual(only, "GL_NV_other\tCD-01\tSuite.one\n")

    def test_bad_use_is_told(self):
        for arguments in (["--platform", "wgl"], ["--extension", "GL_NONE"], ["--nonsense"]):
            with self.subTest(arguments=arguments):
                self.assertEqual(self.run_it({"arb_some": PASSES}, *arguments)[0], 2)
        self.assertEqual(self.run_it({})[0], 2)

    def test_help_teaches(self):
        status, said = self.run_it({}, "--help")
        self.assertEqual(status, 0)
        for word in ("--platform", "--extension", "--filter", "--list", "exit status", "LD_PRELOAD"):
            self.assertIn(word, said)

    def test_the_built_one_judges_this_machine(self):
        if BUILT is None:
            self.skipTest("no folder of built programs was given")
        program = [BUILT / "conformance", "--extension", "GL_ARB_occlusion_query"]
        environment = {key: value for key, value in os.environ.items() if key != "GTEST_OUTPUT"}
        listed = subprocess.run([*program, "--list"], capture_output=True, text=True, check=True).stdout
        self.assertIn("\tNames.generated_names_are_distinct_and_not_zero\n", listed)
        done = subprocess.run(
            [*program, "--filter", "Names.generated_*"],
            env=environment, capture_output=True, text=True, check=False,
        )  # fmt: skip
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn("1 passed, 0 failed, 0 skipped", done.stdout)


if __name__ == "__main__":
    if len(sys.argv) > 1:
        BUILT = Path(sys.argv.pop(1))
    unittest.main()
