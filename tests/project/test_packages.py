# SPDX-License-Identifier: MIT
"""packages.txt is whole: Debian has every package, and every program that our scripts call is from one.

The programs are found in shell scripts (command position), in Python (lists given to run, Popen and the like)
and in CMake files (find_program). What is built here is left out, and so is what a script first looks for
with shutil.which: it can do without.
"""
import ast
import re
import subprocess
import unittest

from debian import base, closure, installed, owner
from shell_words import programs
from tree import ROOT, project_files

CALLS = re.compile(r"(run|run_\w+|Popen|call|check_call|check_output)$")


def packages_listed():
    lines = (line.split("#")[0].strip() for line in (ROOT / "packages.txt").read_text().splitlines())
    return [line for line in lines if line]


def python_programs(text):
    """First strings of the lists that go to a starter of programs, literal or by name."""
    found, lists = set(), {}
    nodes = list(ast.walk(ast.parse(text)))
    for node in nodes:
        if isinstance(node, ast.Assign) and isinstance(node.value, ast.List) and node.value.elts:
            lists.update({t.id: node.value.elts[0] for t in node.targets if isinstance(t, ast.Name)})
    for node in nodes:
        if not isinstance(node, ast.Call) or not node.args:
            continue
        name = getattr(node.func, "attr", getattr(node.func, "id", ""))
        first, listed = node.args[0], False
        if isinstance(first, (ast.List, ast.Tuple)) and first.elts:
            first, listed = first.elts[0], True
        first = first.value if isinstance(first, ast.Starred) else first
        if isinstance(first, ast.Name) and first.id in lists:
            first, listed = lists[first.id], True
        if listed and CALLS.match(name) and isinstance(first, ast.Constant) and isinstance(first.value, str):
            found.add(first.value)
    return found


def cmake_programs(text):
    return set(re.findall(r"find_program\(\s*\w+\s+(?:NAMES\s+)?([\w.+-]+)", text))


def called_programs():
    """Program -> the files that call it."""
    called = {}
    for path in project_files():
        try:
            text = (ROOT / path).read_text(encoding="utf-8")
        except UnicodeDecodeError:
            continue
        if re.match(r"#!.*\b(ba|da)?sh\b", text):
            found = programs(text)
        elif path.suffix == ".py" or text.startswith("#!/usr/bin/python3"):
            found = python_programs(text)
        elif path.name == "CMakeLists.txt" or path.suffix == ".cmake":
            found = cmake_programs(text)
        else:
            continue
        for program in found:
            if (
                not program.startswith("./")
                and not (ROOT / program).is_file()
                and not (ROOT / path).with_name(program).is_file()
            ):
                called.setdefault(program, []).append(str(path))
    return called


class Packages(unittest.TestCase):
    def test_debian_has_every_package_of_the_list(self):
        command = ["apt-get", "-s", "--no-install-recommends", "install", *packages_listed()]
        told = subprocess.run(command, capture_output=True, text=True, check=False)
        self.assertEqual(told.returncode, 0, told.stderr)

    def test_no_package_is_listed_twice(self):
        listed = packages_listed()
        self.assertEqual(sorted(listed), sorted(set(listed)))

    def test_every_program_that_is_called_comes_from_a_listed_package(self):
        packages = installed()
        known = closure([*packages_listed(), *base(packages)], packages)
        called = called_programs()
        self.assertIn("cmake", called)
        for program, callers in sorted(called.items()):
            with self.subTest(program=program):
                package = owner(program)
                self.assertIsNotNone(package, f"{callers}: {program} is not installed or from no package")
                self.assertTrue(
                    package in known, f"{callers}: {program} is from {package}, not in packages.txt"
                )


class TheCheckItself(unittest.TestCase):
    def test_a_shell_script_tells_its_programs(self):
        script = """
            # a comment calls nothing; curl
            helper() { sed -n "1p; $(awk 1)" file; }
            x=$(grep -c 'wget' f) || exec timeout 5 env A=1 nm
            case $x in
                a | b) tar xf "$x" ;;
                *) helper ;;
            esac
            cat <<TEXT
            curl is only text here
            TEXT
            if ! cmp a b >/dev/null 2>&1; then xvfb-run -a ctest; fi
        """
        expected = {"awk", "sed", "grep", "timeout", "env", "nm", "tar", "cat", "cmp", "xvfb-run", "ctest"}
        self.assertEqual(programs(script), expected)

    def test_python_tells_its_programs(self):
        text = "subprocess.run(['nm', '-D'])\nshutil.which('optional')\nprint(['no', 'program'])\n"
        text += "git = ['git', '-C']\nother = ['none']\nrun([*git, 'log'])\n"
        self.assertEqual(python_programs(text), {"nm", "git"})

    def test_a_dependency_counts_and_a_stranger_does_not(self):
        blank = {"Provides": "", "Pre-Depends": "", "Depends": ""}
        packages = {
            "a": {**blank, "Depends": "b (>= 1) | x, virtual:any"},
            "b": blank,
            "c": {**blank, "Provides": "virtual (= 2)"},
            "stranger": blank,
        }
        self.assertEqual(closure(["a"], packages), {"a", "b", "c"})


if __name__ == "__main__":
    unittest.main()
