# SPDX-License-Identifier: MIT
"""Sections as HTML, alone on a page or as a part of the evaluation's; and their rows as CSV."""
import csv
from html import escape
from pathlib import Path

from ..tables import check_list, definitions

STYLE = Path(__file__).parents[1] / "page.css"

PAGE = """<!doctype html>
<!-- SPDX-License-Identifier: MIT -->
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1">
<title>{title}</title><style>{style}</style></head><body><main>
<h1>{title}</h1>
<p class="lead">The paper's tables at the paper's scale, measured under the emulator and set beside the paper's.</p>
{warnings}{sections}
<h2>This run</h2><dl>{machine}</dl>
<p>Once more: <code>{command}</code>. Walks that are done are kept in <code>jobs</code> and not walked again, until the
programs change; the figures of all of them are in {files}.</p>
</main></body></html>
"""


def goal_table(goals):
    if not goals:
        return ""
    lines = "".join(
        f'<tr class="{"" if goal.is_met else "missed"}"><td>{escape(goal.sentence)}</td><td>{goal.wanted}</td>'
        f"<td>{goal.measured}</td><td>{'yes' if goal.is_met else 'no'}</td></tr>"
        for goal in goals
    )
    return (
        '<div class="scroll"><table class="goals"><thead><tr><th>goal</th><th>wanted</th><th>measured</th><th>reached</th></tr></thead>'
        f"<tbody>{lines}</tbody></table></div>"
    )


def html_of(section):
    """One section, with its goals and what was checked."""
    return (
        f"<h2>{escape(section.title)}</h2>\n{section.html}\n{goal_table(section.goals)}"
        f'<ul class="checks">{check_list(section.checks)}</ul>'
    )


def warnings(failures):
    if not failures:
        return ""
    items = "".join(f"<li>{escape(failure)}</li>" for failure in failures)
    return f'<div class="warning"><h2>Not everything ran</h2><ul>{items}</ul></div>'


def write_paper_page(path, title, sections, failures, machine, command, files):
    text = PAGE.format(
        title=escape(title), style=STYLE.read_text(encoding="utf-8"),
        warnings=warnings(failures), sections="\n".join(html_of(section) for section in sections),
        machine=definitions(machine), command=escape(command),
        files=", ".join(f'<a href="{name}">{name}</a>' for name in files),
    )  # fmt: skip
    path.write_text(text, encoding="utf-8")


def write_rows(path, rows):
    """The section's rows; an empty cell is a thing that does not apply."""
    if not rows:
        return
    with open(path, "w", newline="", encoding="utf-8") as stream:
        writer = csv.DictWriter(stream, list(rows[0]))
        writer.writeheader()
        for row in rows:
            writer.writerow({k: f"{v:.6g}" if isinstance(v, float) else v for k, v in row.items()})
