#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""The generator refuses what it must: above all a draw or query command that nobody has classified."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

REGISTRY_FOLDER = pathlib.Path(sys.argv.pop(1))
GL_XML = pathlib.Path("/usr/share/khronos-api/gl.xml")


class Generator(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.path = pathlib.Path(self.folder.name)
        self.hooks = (REGISTRY_FOLDER / "hooks.list").read_text()
        self.registry = GL_XML.read_text()

    def generate(self):
        (self.path / "hooks.list").write_text(self.hooks)
        (self.path / "gl.xml").write_text(self.registry)
        return subprocess.run(
            [sys.executable, REGISTRY_FOLDER / "generate.py", "--registry", self.path / "gl.xml",
             "--registry", REGISTRY_FOLDER / "historic.xml", "--registry", REGISTRY_FOLDER / "proposed.xml",
             "--hooks", self.path / "hooks.list", "--out", self.path / "out"], capture_output=True, text=True)

    def refuses(self, sentence):
        result = self.generate()
        self.assertEqual(result.returncode, 1)
        self.assertIn(sentence, result.stderr)
        self.assertEqual(result.stderr.count("\n"), 1)

    def add_command(self, name):
        command = f"<command><proto>void <name>{name}</name></proto></command>"
        self.registry = self.registry.replace('<commands namespace="GL">', f'<commands namespace="GL">{command}', 1)
        self.assertIn(command, self.registry)

    def test_the_lists_as_they_are_agree(self):
        result = self.generate()
        self.assertEqual((result.returncode, result.stderr), (0, ""))

    def test_a_new_command_of_each_shape_has_to_be_classified(self):
        whole = self.registry
        for name in ("glDrawMiracleEXT", "glMultiDrawMiracle", "glBeginQueryMiracleNV", "glGetQueriesKHR",
                     "glBeginConditionalMiracle", "glRectq"):
            self.registry = whole
            self.add_command(name)
            self.refuses(f"{name} looks like a draw, query or conditional-render command")

    def test_a_new_command_of_another_shape_is_left_alone(self):
        self.add_command("glTexMiracle")
        self.assertEqual(self.generate().returncode, 0)

    def test_a_forgotten_draw_is_found(self):
        self.hooks = "\n".join(l for l in self.hooks.splitlines() if not l.startswith("glDrawElementsInstanced "))
        self.refuses("glDrawElementsInstanced looks like a draw")

    def test_an_unknown_command_is_told_with_its_line(self):
        self.hooks = self.hooks.replace("[error]\n", "[error]\nglGetErorr\n")
        line = self.hooks.splitlines().index("glGetErorr") + 1
        self.refuses(f"hooks.list:{line}: no registry has a command glGetErorr")

    def test_a_command_stands_once(self):
        self.hooks = self.hooks.replace("[error]\n", "[error]\nglEnable\n")
        self.refuses("glEnable stands twice")

    def test_leaving_a_command_alone_takes_a_reason(self):
        self.hooks += "glDrawMiracle\n"
        self.refuses("without the reason")

    def test_a_hooked_command_cannot_be_left_alone_too(self):
        self.hooks += "glDrawArrays    no reason at all\n"
        self.refuses("glDrawArrays is both hooked and matched")

    def test_a_draw_says_how_many_triangles_it_draws(self):
        self.hooks = self.hooks.replace("[draw]\n", "[draw]\nglArrayElement\n", 1)
        self.refuses("says how many triangles it draws")

    def test_aliases_are_hooked_with_their_command(self):
        self.generate()
        entry = (self.path / "out" / "entry.cpp").read_text()
        for name in ("glBeginQueryARB", "glDrawArraysInstancedEXT", "glGetQueryObjectui64vEXT"):
            self.assertIn(f'{{"{name}", ', entry)


if __name__ == "__main__":
    unittest.main()
