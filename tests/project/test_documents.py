# SPDX-License-Identifier: MIT
"""The keeper of the documents' commands finds what is broken in small documents of its own."""
import tempfile
import unittest
from pathlib import Path

from documents import BadDocument, blocks, documents
from run_document import run
from tree import ROOT


class Blocks(unittest.TestCase):
    def test_only_sh_blocks_are_commands(self):
        found = blocks("```sh\necho 1\n```\n```c\nint i;\n```\n- in a list\n  ```sh\n  echo 2\n  ```\n")
        self.assertEqual([(b.line, b.text) for b in found], [(1, "echo 1\n"), (8, "echo 2\n")])

    def test_a_mark_takes_the_block_that_follows(self):
        text = "<!-- run: no, takes an hour -->\n```sh\nsleep 1h\n```\n```sh\ntrue\n```\n"
        self.assertEqual([block.script for block in blocks(text)], [None, "true\n"])

    def test_a_command_can_stand_in_for_its_block(self):
        text = "<!-- run: instead ls --help -->\n```sh\nls /nowhere\n```\n"
        self.assertEqual([block.script for block in blocks(text)], ["ls --help"])

    def test_what_would_hide_a_command_is_refused(self):
        for text in (
            "```bash\nls\n```\n",  # another name of the shell
            "```sh\nls\n",  # never closed
            "<!-- run: no -->\n```sh\nls\n```\n",  # no reason
            "<!-- run: no, far from its block -->\n\n```sh\nls\n```\n",
            "<!-- run: instead cat /dev/null -->\n```sh\nls\n```\n",  # runs something else
        ):
            with self.subTest(text=text), self.assertRaises(BadDocument):
                blocks(text)


class Running(unittest.TestCase):
    def faults(self, text):
        with tempfile.TemporaryDirectory() as folder:
            document = Path(folder, "A.md")
            document.write_text(text, encoding="utf-8")
            return run(document, Path(folder))[0]

    def test_a_good_block_runs_in_the_root_of_a_copy(self):
        self.assertEqual(self.faults("```sh\ntest -x ./check\ntouch here\n```\n"), [])
        self.assertFalse((ROOT / "here").exists())

    def test_each_broken_block_is_a_fault(self):
        for body in ("false\necho not reached", "if true; then", "no_such_program_here --x", "false | cat"):
            with self.subTest(body=body):
                self.assertEqual(len(self.faults(f"```sh\n{body}\n```\n")), 1)

    def test_a_block_that_is_not_run_still_needs_its_programs(self):
        text = "<!-- run: no, slow -->\n```sh\n{}\n```\n"
        self.assertEqual(len(self.faults(text.format("./no_such_script"))), 1)
        self.assertEqual(self.faults(text.format("./check && false")), [])

    def test_the_tree_has_documents(self):
        self.assertTrue(documents(ROOT))


if __name__ == "__main__":
    unittest.main()
