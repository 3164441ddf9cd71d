# SPDX-License-Identifier: MIT
"""Small rules of every file: licence line, length, nothing generated in git, every preset a workflow."""
import json
import re
import subprocess
import unittest
from pathlib import Path

from tree import ROOT, project_files, tracked_files

SPDX = "SPDX-License-Identifier: MIT"
MOST_LINES = 500
# Extension texts: one document each in the form of Khronos' registry, whose sections and issues refer to each other.
EXTENSION_TEXTS = Path("docs/extensions")
# Data, prose, and what cannot carry a comment.
WITHOUT_COMMENT = {".json", ".toml", ".md", ".png", ".tsv", ".csv", ".txt", ".obj", ".svg"}
WITHOUT_LICENCE_LINE = {"LICENSE", ".clang-format", ".clang-tidy", ".gitignore"}
GENERATED = re.compile(
    r"^(build|report)/|(^|/)(__pycache__|CMakeFiles|Testing)/|\.(o|a|so|pyc|gch|log)$|(^|/)CMakeCache\.txt$"
)
SAYS_GENERATED = re.compile(r"^\W*(auto-?matically |auto-?)?generated (by|from)\b", re.IGNORECASE)


def needs_licence(path):
    return path.name == "CMakeLists.txt" or (
        path.suffix not in WITHOUT_COMMENT and path.name not in WITHOUT_LICENCE_LINE
    )


def has_licence(text):
    """In the first line, or right after what has to be first: `#!`, the XML or document type declaration."""
    lines = [line for line in text.splitlines()[:3] if not line.startswith(("#!", "<?xml", "<!doctype"))]
    return bool(lines) and SPDX in lines[0]


def says_generated(text):
    return any(SAYS_GENERATED.match(line) for line in text.splitlines()[:5])


def may_not_be_long(path):
    is_extension_text = path.parent == EXTENSION_TEXTS and path.suffix == ".txt"
    return path.suffix not in {".tsv", ".csv"} and not is_extension_text


def text_files():
    """Path and text of every file that is text."""
    for path in project_files():
        data = (ROOT / path).read_bytes()
        if b"\0" not in data:
            yield path, data.decode("utf-8")


class TheTree(unittest.TestCase):
    maxDiff = None

    def test_every_source_file_begins_with_its_licence(self):
        self.assertEqual(
            [str(p) for p, text in text_files() if needs_licence(p) and not has_licence(text)], []
        )

    def test_no_file_is_too_long_to_see(self):
        long = {str(p): text.count("\n") for p, text in text_files() if may_not_be_long(p)}
        self.assertEqual({name: lines for name, lines in long.items() if lines > MOST_LINES}, {})

    def test_no_generated_file_is_in_git(self):
        self.assertEqual([str(path) for path in tracked_files() if GENERATED.search(str(path))], [])
        self.assertEqual([str(path) for path, text in text_files() if says_generated(text)], [])

    def test_no_line_ends_in_white_space_and_every_file_in_a_newline(self):
        for path, text in text_files():
            with self.subTest(file=str(path)):
                self.assertTrue(text == "" or text.endswith("\n"), "the last line is not ended")
                trailing = [n for n, line in enumerate(text.splitlines(), 1) if line != line.rstrip()]
                self.assertEqual(trailing, [])

    def test_no_path_of_one_machine_is_written_down(self):
        places = re.compile(r"/(home|root|work|Users)/\w+")
        found = [str(path) for path, text in text_files() if places.search(text) and path != me()]
        self.assertEqual(found, [])

    def test_every_preset_is_a_workflow(self):
        presets = json.loads((ROOT / "CMakePresets.json").read_text())
        names = [preset["name"] for preset in presets["configurePresets"] if not preset.get("hidden")]
        told = subprocess.run(
            ["cmake", "--list-presets=workflow"], cwd=ROOT, capture_output=True, text=True, check=True
        ).stdout
        self.assertEqual(sorted(re.findall(r'"([\w-]+)"', told)), sorted(names))
        for workflow in presets["workflowPresets"]:
            steps = [(step["type"], step["name"]) for step in workflow["steps"]]
            self.assertEqual(steps, [(kind, workflow["name"]) for kind in ("configure", "build", "test")])


def me():
    return Path(__file__).resolve().relative_to(ROOT)


class TheRulesThemselves(unittest.TestCase):
    def test_a_licence_counts_only_at_the_top(self):
        self.assertTrue(has_licence(f"// {SPDX}\n"))
        self.assertTrue(has_licence(f"#!/bin/sh\n# {SPDX}\n"))
        self.assertFalse(has_licence(f"// something\n// {SPDX}\n"))
        self.assertFalse(has_licence(""))

    def test_only_tables_and_extension_texts_may_be_long(self):
        for name in ("conformance/statements.tsv", "docs/extensions/EMU_occlusion_unit.txt"):
            self.assertFalse(may_not_be_long(Path(name)), name)
        for name in ("docs/extensions/notes.md", "docs/extensions/a/b.txt", "packages.txt", "apps/main.cpp"):
            self.assertTrue(may_not_be_long(Path(name)), name)

    def test_generated_files_are_recognised(self):
        for name in ("build/x", "report/index.html", "a/__pycache__/b", "a/b.o", "lib/x.so"):
            self.assertTrue(GENERATED.search(name), name)
        self.assertFalse(GENERATED.search("apps/report/report.cpp"))
        self.assertTrue(says_generated("// Generated by generate.py\n"))
        self.assertFalse(says_generated("// The names are generated at build time.\n"))


if __name__ == "__main__":
    unittest.main()
