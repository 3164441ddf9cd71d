# SPDX-License-Identifier: MIT
"""Which programs a shell script calls: the words that stand where a command stands.

Enough of the shell's grammar for our own scripts: comments, quotes, here-documents, substitutions,
assignments, keywords and functions. `bash -n` judges the rest.
"""
import re

KEYWORDS = set(
    "if then elif else fi for in do done while until case esac function select time { } ! [[ ]] ((".split()
)
BUILTINS = set(
    "[ alias bg break builtin cd command continue declare dirs echo eval exec exit export false fg getopts hash"
    " jobs kill let local mapfile popd printf pushd pwd read readonly return set shift shopt source test times"
    " trap true type typeset ulimit umask unset wait . :".split()
)
# Words after which the next word is again a command.
PREFIXES = set("exec command then do else elif if while until ! time { env sudo $sudo timeout xvfb-run".split())
HERE_DOCUMENT = re.compile(r"<<-?\s*(['\"]?)(\w+)\1")
ASSIGNMENT = re.compile(r"\w+\+?=")


def without_documents(text):
    """The script without the bodies of its here-documents."""
    kept, end = [], None
    for line in text.splitlines():
        if end is not None:
            end = None if line.strip() == end else end
            continue
        match = HERE_DOCUMENT.search(line)
        end = match.group(2) if match else None
        kept.append(line)
    return "\n".join(kept)


def fragments(text):
    """The script as simple commands: quotes blanked, comments cut, substitutions taken out as their own."""
    text = without_documents(text).replace("\\\n", " ")
    text = re.sub(r"'[^']*'", "''", text)
    text = re.sub(r"(^|\s)#.*", r"\1", text, flags=re.MULTILINE)
    text = re.sub(r"\$\(\(.*?\)\)", "0", text)
    inner, pattern = [], re.compile(r"\$\(([^()]*)\)")
    while match := pattern.search(text):
        inner.append(match.group(1))
        text = text[: match.start()] + "VALUE" + text[match.end() :]
    text = re.sub(r'"(?:[^"\\]|\\.)*"', '""', text)
    text = re.sub(r"\$\{[^}]*\}", "VALUE", text)
    text = re.sub(r"\[\[.*?\]\]|\(\(.*?\)\)|\w+\+?=\([^)]*\)", ":", text, flags=re.DOTALL)
    text = re.sub(r"\b(for|case)\s+\w+.*?\bin\b[^;\n]*", "", text)
    text = re.sub(r"^\s*[^\s()]*(?:\s*\|\s*[^\s()]+)*\)", "", text, flags=re.MULTILINE)
    text = re.sub(r"\d*>&\d*-?|&>>?|\d*[<>]+\s*\S+", " ", text)
    return [*re.split(r"[;\n|&]+|[()]", text), *(part for piece in inner for part in fragments(piece))]


def programs(text):
    """The words in command position that are neither keywords, builtins nor functions of the script."""
    functions = set(re.findall(r"^\s*(?:function\s+)?(\w+)\s*\(\)", text, flags=re.MULTILINE))
    found = set()
    for fragment in fragments(text):
        expected = True
        for word in fragment.split():
            if not expected:
                break
            if ASSIGNMENT.match(word) or word.startswith("-") or re.fullmatch(r"\d+[smh]?", word):
                continue  # nothing of these is a command: `timeout 5 glxgears` calls two programs
            expected = word in PREFIXES
            if word not in KEYWORDS | BUILTINS | functions and re.fullmatch(r"[\w./+-]+", word):
                found.add(word)
    return found - {"VALUE"}
