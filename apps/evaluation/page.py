# SPDX-License-Identifier: MIT
"""The page: one HTML file that carries its style, plots and pictures in itself."""
import base64
import shlex
from datetime import datetime, timezone
from html import escape
from pathlib import Path
from string import Template

from . import plots, tables, timeline_picture
from .matrix import BASELINE, BOUND, DEVICE_TITLES, QUERYING, TIMED_DEVICE, build_device_matrix
from .papers.page import html_of
from .rows import break_even_us, query_budget_us, row_with
from .runs import PICTURES, WARM_UP_FRAMES, timeline_file

HERE = Path(__file__).parent
CAPTIONS = (
    "What the camera sees, at frame {frame} of the path.",
    "The same moment from above: what stop-and-wait draws stands out; the rest is hidden or out of view.",
    "The boxes of the tree that were asked about, from above: orange ones were answered visible.",
)


def cards(rows, checks):
    """The answer in a few large figures: (figure, sentence)."""
    found = []
    last = rows[-1].device if rows else None
    asked = next((r for r in rows if r.device == last and r.culler in QUERYING), None)
    if asked is not None and asked.frustum_triangles:
        share = asked.drawn_triangles / asked.frustum_triangles
        text = f"of the triangles in view are left to draw after asking {asked.queries:,.0f} queries a frame"
        found.append((f"{share:.0%}", text))
    for device in dict.fromkeys(row.device for row in rows):
        found.append(pays_below(rows, device))
    culled = sum(row.false_culls_total for row in rows)
    found.append((f"{culled:,}", f"visible objects culled by mistake, in {checks[0].looked_at}"))
    return found


def pays_below(rows, device):
    """When asking pays on a device: (figure, sentence)."""
    even, budget = break_even_us(rows, device, QUERYING[0]), query_budget_us(rows, device, QUERYING[0])
    frustum = row_with(rows, device, BASELINE)
    points = sorted(
        (r for r in rows if r.device == device and r.culler in QUERYING and not r.repeat),
        key=lambda row: row.latency_us,
    )
    if frustum is None or not points or budget is None:
        return "?", f"{device}: a run that is needed for the answer failed"
    first, last = points[0], points[-1]
    costs = f"a query may cost {budget:,.0f} µs in all and costs {first.query_cost_us:,.0f} µs "
    costs += "at the driver's own speed" if first.latency_us == 0 else f"when {first.latency_us:g} µs late"
    if even:
        return (
            f"{even:,.0f} µs",
            f"late may a result be on {device} before waiting for it no longer pays: {costs}",
        )
    if first.frame_ms >= frustum.frame_ms:
        part = f"it still pays in {first.frames_faster_total} of the path's frames"
        return "slower", f"on average than asking nothing, waiting for results on {device}: {costs}; {part}"
    if last.frame_ms < frustum.frame_ms:
        return (
            f"> {last.latency_us:g} µs",
            f"late may a result be on {device}, the largest latency measured: {costs}",
        )
    return "?", f"{device}: the latencies measured do not bracket the answer"


def pictures(folder, frame):
    """The three pictures, inlined; one that is missing is left out."""
    figures = []
    for name, caption in zip(PICTURES, CAPTIONS):
        if (folder / name).exists():
            data = base64.b64encode((folder / name).read_bytes()).decode()
            text = caption.format(frame=frame)
            figures.append(
                f'<figure><img alt="{escape(text)}" src="data:image/png;base64,{data}">'
                f"<figcaption>{escape(text)}</figcaption></figure>"
            )
    return "\n".join(figures)


TIMELINE_CAPTION = """A part of frame {frame} of stop-and-wait (to the layer, which has seen one before, frame {number}) in
the time of the {device}, as Figure 1 of the paper draws it. The CPU waits for the result of each query (Q)
before it knows what comes next; while it then prepares the next query or draws (R), the GPU has nothing to do. The
whole frame is in <code>runs/{file}</code>, which ui.perfetto.dev opens."""
# From the middle of the frame, where boxes are small, as much as some ten queries take.
TIMELINE_WINDOW_US = 400


def timeline(settings, image_frame):
    """The timeline of one frame that asks, as a figure."""
    asking = next(configuration for configuration in build_device_matrix() if configuration.queries)
    trace = timeline_file(settings, asking)
    number = image_frame + WARM_UP_FRAMES
    try:
        length_us = timeline_picture.read_frame(trace, number).length
    except (OSError, ValueError):
        return ""  # the run failed, which the page says
    begin_us = max(0, (length_us - TIMELINE_WINDOW_US) / 2)
    window_us = (begin_us, begin_us + TIMELINE_WINDOW_US)
    picture = timeline_picture.draw(trace, frame=number, window_us=window_us)
    caption = TIMELINE_CAPTION.format(
        frame=image_frame, number=number, device=escape(asking.device), file=escape(trace.name)
    )
    return f"<figure>{picture}<figcaption>{caption}</figcaption></figure>"


def banner(failures, quick):
    """What a reader must know before any figure: failed runs, or that this was only a look."""
    parts = []
    if failures:
        items = "".join(f"<li>{escape(failure)}</li>" for failure in failures)
        parts.append(f'<div class="warning"><h2>Not everything ran</h2><ul>{items}</ul></div>')
    if quick:
        parts.append(
            '<div class="warning"><h2>A quick look, not a measurement</h2>'
            "<p>Made with <code>--quick</code>: a small city, few frames, one round. Do not quote the times.</p>"
            "</div>"
        )
    return "\n".join(parts)


PATH_CAPTION = """Above: the time of every frame, on a logarithmic scale. Where the grey line (frustum culling)
lies above an orange one, asking paid. Below: the triangles drawn. The gap between grey and green is what queries
can save at most; the gap between orange and green above is what asking and waiting cost."""
LATENCY_CAPTION = """Each bar is the mean frame of stop-and-wait; the dark part is spent in blocking reads of results,
as the client measures it; the black mark is the same as the layer below it measures it. A bar that reaches above
the grey line is slower than asking nothing. A latency shorter than the driver's own time changes nothing. Late
results change no pixel and no count: only this time."""


def write_page(
    path, *, measured, rows, device_rows, checks, failures, machine, settings, image_frame, scene_triangles,
    quick, command, sections,
):

    devices = list(dict.fromkeys(configuration.device for configuration in measured))
    example = next((v.timed[0] for c, v in measured.items() if v.timed and c.queries and c.latency_us), None)
    facts = dict(machine)
    values = {
        "style": (HERE / "page.css").read_text(encoding="utf-8"),
        "triangles": f"{scene_triangles:,}",
        "device_count": {1: "one", 2: "two", 3: "three"}.get(len(devices), str(len(devices))),
        "banner": banner(failures, quick),
        "cards": "".join(
            f'<div class="card"><strong>{escape(figure)}</strong><span>{escape(text)}</span></div>'
            for figure, text in cards(rows, checks)
        ),
        "devices": tables.definitions((device, DEVICE_TITLES.get(device, "")) for device in devices),
        "pictures": pictures(settings.out / "pictures", image_frame),
        "frames": settings.frames,
        "rounds": f"of each frame the median of {settings.rounds} runs taken in turn"
        if settings.rounds > 1
        else "each frame was timed once",
        "table": tables.main_table(rows),
        "path_plot": plots.along_the_path(measured, rows) if rows else "",
        "path_caption": PATH_CAPTION,
        "latency_plot": plots.against_latency(rows) if rows else "",
        "latency_caption": LATENCY_CAPTION,
        "paper_table": tables.paper_table(rows, devices[-1]),
        "timed_device": escape(DEVICE_TITLES[TIMED_DEVICE].split(":")[0]),
        "device_time_table": tables.device_time_table(rows, device_rows),
        "device_share_table": tables.device_share_table(device_rows),
        "timeline": timeline(settings, image_frame),
        "selectivity_table": tables.selectivity_table(rows, devices[-1], scene_triangles),
        "driver": escape(facts["Driver"]),
        "processor": escape(facts["Processor"]),
        "papers": "\n".join(html_of(section) for section in sections),
        "checks": tables.check_list(checks),
        "noise_table": tables.noise_table(rows),
        "machine": tables.definitions(machine),
        "repeat": escape(command),
        "one_run": escape(shlex.join(example.command)) if example else "no run succeeded",
        "when": datetime.now(timezone.utc).strftime("%d %B %Y, %H:%M UTC"),
    }
    template = Template((HERE / "page.html").read_text(encoding="utf-8"))
    path.write_text(template.substitute(values), encoding="utf-8")
