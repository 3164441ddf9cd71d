# SPDX-License-Identifier: MIT
"""The table as pages: one Markdown, one HTML that needs no other file."""
from collections import Counter
from html import escape

from judge import NA, VERDICTS
from plans import DECIDED, NOT_APPLICABLE
from runs import COLUMNS, DEPARTS, FAILED

HEAD = ["statement", *COLUMNS.values(), "in all", "what it says", "remark"]

STYLE = """
body { font: 15px/1.4 sans-serif; margin: 2em auto; max-width: 100em; padding: 0 1em; color: #222 }
table { border-collapse: collapse; margin: 1em 0 }
th, td { border: 1px solid #ccc; padding: 3px 8px; text-align: left; vertical-align: top }
th { background: #f3f3f3; position: sticky; top: 0 }
.passed, .decided { background: #e2f3e2 } .departs { background: #fff1cc }
.failed, .missing { background: #f8d0d0 } .skipped, .applicable { background: #eeeeee; color: #666 }
code { font-size: 90% } small { color: #666 }
"""


def totals(judged):
    count = Counter(one.verdict for one in judged)
    return {verdict: count[verdict] for verdict in VERDICTS}


def summary(judged):
    """One line: `610 statements: 563 passed, ...`; the decided ones passed too."""
    counts = ", ".join(f"{count} {verdict}" for verdict, count in totals(judged).items())
    return f"{len(judged)} statements: {counts}"


def sections(judged):
    groups = {}
    for one in judged:
        groups.setdefault(one.statement.section, []).append(one)
    return groups


def row(one):
    text = one.statement.text + (f" [{one.statement.source}]" if one.statement.source else "")
    cells = [one.cells.get(column, "") for column in COLUMNS]
    return [one.statement.number, *cells, one.verdict, text, one.remark]


def tables(judged, faults):
    """Title, a sentence, head and rows of every table, whatever they are written in."""
    if faults:
        yield "What is wrong", "", ["fault"], [[fault] for fault in faults]
    counts = [
        [name, *map(str, totals(group).values()), str(len(group))] for name, group in sections(judged).items()
    ]
    counts.append(["in all", *map(str, totals(judged).values()), str(len(judged))])
    yield ("Totals", "Every statement once. Decided: passed, where the texts leave a choice that was made.",
           ["section", *VERDICTS, "statements"], counts)  # fmt: skip
    yield ("Decided", "Where the texts are silent or disagree.", ["statement", "decision"],
           [[one.statement.number, one.remark.removeprefix(DECIDED)] for one in judged
            if one.remark.startswith(DECIDED)])  # fmt: skip
    yield ("Departures", "Where a machine is known not to follow the text. Each is run, and has to fail.",
           ["statement", "machines", "what it says"],
           [[one.statement.number, machines(one), one.statement.text]
            for one in judged if one.departures])  # fmt: skip
    yield ("Not applicable", "What is not judged, and why.", ["statement", "why", "what it says"],
           [[one.statement.number, one.remark.removeprefix(NOT_APPLICABLE), one.statement.text]
            for one in judged if one.verdict == NA])  # fmt: skip
    for name, group in sections(judged).items():
        yield name, "", HEAD, [row(one) for one in group]


def machines(one):
    """The runs in which a statement's tests depart."""
    return ", ".join(sorted({told.run.split(".departure.")[0] for told in one.departures}))


INTRODUCTION = (
    "What this run showed of every numbered statement. A cell is the worst that any machine of its column "
    "did: passed, departs (failed, as is known of that machine), skipped (it lacks what the test needs), or "
    "failed. "
    "Which tests prove which statement: the plans (PLAN.md) of the folders."
)


def markdown(judged, faults):
    lines = ["# Conformance", "", summary(judged), "", INTRODUCTION, ""]
    for title, sentence, head, rows in tables(judged, faults):
        lines += [f"## {title}", ""] + ([sentence, ""] if sentence else [])
        if not rows:
            lines += ["none", ""]
            continue
        lines += [line(head), line(["---"] * len(head)), *(line(cells) for cells in rows), ""]
    return "\n".join(lines)


def line(cells):
    """A line of a Markdown table; what would mean something there is escaped."""
    escaped = (cell.replace("|", "\\|").replace("<", "&lt;").replace("\n", " ") for cell in cells)
    return "| " + " | ".join(escaped) + " |"


def html(judged, faults):
    parts = [
        "<!doctype html>\n<html lang='en'><meta charset='utf-8'><title>Conformance</title>",
        f"<style>{STYLE}</style>",
        f"<h1>Conformance</h1><p><b>{escape(summary(judged))}</b></p><p>{escape(INTRODUCTION)}</p>",
    ]
    for title, sentence, head, rows in tables(judged, faults):
        parts.append(f"<h2>{escape(title)}</h2><p>{escape(sentence)}</p>")
        if not rows:
            parts.append("<p>none</p>")
            continue
        parts.append("<table><tr>" + "".join(f"<th>{escape(cell)}</th>" for cell in head) + "</tr>")
        for cells in rows:
            parts.append("<tr>" + "".join(cell_of(cell) for cell in cells) + "</tr>")
        parts.append("</table>")
    return "\n".join(parts) + "</html>\n"


def cell_of(cell):
    """Verdicts are coloured; `code` stays code."""
    known = {*VERDICTS, DEPARTS, FAILED, "skipped"}
    style = f" class='{cell}'" if cell in known else ""
    pieces = escape(cell).split("`")
    text = "".join(f"<code>{piece}</code>" if i % 2 else piece for i, piece in enumerate(pieces))
    return f"<td{style}>{text}</td>"
