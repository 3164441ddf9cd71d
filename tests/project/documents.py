# SPDX-License-Identifier: MIT
"""The commands in the documents: every block that is fenced with ```sh in README.md, CONTRIBUTING.md, docs/.

A block is run as it stands unless the line before it is one of

    <!-- run: no, REASON -->           it cannot be run here; its grammar and its programs are still checked
    <!-- run: instead COMMAND -->      COMMAND is run in its place; it has to start a program of the block
"""
import re
from dataclasses import dataclass
from pathlib import Path

from shell_words import programs

FENCE = re.compile(r"^( *)```(.*)$")
MARK = re.compile(r"<!-- run: (no, \S.*|instead \S.*) -->$")
# Languages under which a command could hide from the test.
SHELLS = {"bash", "shell", "console", "zsh", "shell-session"}


@dataclass
class Block:
    line: int
    text: str
    mark: str = ""

    @property
    def script(self):
        """What to run, or None."""
        if self.mark.startswith("no,"):
            return None
        return self.mark.removeprefix("instead ") if self.mark else self.text


class BadDocument(Exception):
    """The document breaks the rule above; the message begins with the line."""


def blocks(text):
    """The sh blocks of a document. An indented fence, as in a list, is one as well."""
    found, mark, start, indent, language, body = [], "", 0, "", None, []
    for number, line in enumerate(text.splitlines(), start=1):
        fence = FENCE.match(line)
        if language is None and fence:
            indent, language, start, body = fence.group(1), fence.group(2).strip(), number, []
            if language in SHELLS:
                raise BadDocument(f"{number}: a block of commands is fenced with ```sh, not ```{language}")
            if mark and language != "sh":
                raise BadDocument(f"{number}: a run mark stands before a block that is not ```sh")
        elif language is not None and fence and not fence.group(2):
            if language == "sh":
                found.append(Block(start, "\n".join(body) + "\n", mark))
            language, mark = None, ""
        elif language is not None:
            body.append(line.removeprefix(indent))
        elif line.strip().startswith("<!-- run:"):
            match = MARK.match(line.strip())
            if not match:
                raise BadDocument(f"{number}: a run mark is `no, REASON` or `instead COMMAND`")
            mark = match.group(1)
        elif mark:
            raise BadDocument(f"{number}: a run mark stands directly before its block")
    if language is not None:
        raise BadDocument(f"{start}: the block is not closed")
    for block in found:
        if block.mark.startswith("instead ") and not programs(block.script) & programs(block.text):
            raise BadDocument(f"{block.line}: the command to run instead starts no program of the block")
    return found


def documents(root):
    """The documents whose commands are kept alive."""
    tops = [root / name for name in ("README.md", "CONTRIBUTING.md") if (root / name).exists()]
    return tops + sorted(Path(root, "docs").rglob("*.md"))
