# SPDX-License-Identifier: MIT
"""The plots, as SVG text: frame time and drawn triangles along the path, time against latency."""
import io
import re

import matplotlib

matplotlib.use("svg")
import matplotlib.pyplot as pyplot  # noqa: E402  (the backend has to be chosen first)
import numpy  # noqa: E402

from .matrix import BASELINE, BOUND, QUERYING  # noqa: E402
from .rows import break_even_us, frame_times_ms, row_with  # noqa: E402

INK = "#1d2733"
FAINT = "#8a94a3"
FRUSTUM_COLOUR = "#6b7a90"
IDEAL_COLOUR = "#1b9e77"
# Later results are darker; the colours stay apart in greyscale and for colour-blind readers.
LATENCY_COLOURS = ("#fdae6b", "#f16913", "#c43c02", "#7f2704")
STYLE = {
    "font.family": "DejaVu Sans", "font.size": 10, "text.color": INK,
    "axes.edgecolor": FAINT, "axes.labelcolor": INK, "axes.titlesize": 11, "axes.titleweight": "bold",
    "axes.titlelocation": "left", "axes.spines.top": False, "axes.spines.right": False,
    "axes.grid": True, "grid.color": "#e3e7ec", "grid.linewidth": 0.8, "axes.axisbelow": True,
    "xtick.color": INK, "ytick.color": INK, "legend.frameon": False, "lines.linewidth": 1.8,
    "svg.hashsalt": "glext_emu", "figure.facecolor": "none", "axes.facecolor": "none",
}  # fmt: skip


def svg_of(figure):
    """The <svg> element alone, scaled by its frame. Ids are those of this figure, unique on the page."""
    stream = io.StringIO()
    figure.savefig(stream, format="svg", bbox_inches="tight", metadata={"Date": None})
    pyplot.close(figure)
    text = stream.getvalue()
    text = text[text.index("<svg") :]
    text = re.sub(r' width="[^"]*pt"', "", text, count=1)
    return re.sub(r' height="[^"]*pt"', "", text, count=1)


def latencies_of(rows):
    return sorted({row.latency_us for row in rows if row.latency_us is not None})


def colour_of(latency_us, latencies):
    last = max(1, len(latencies) - 1)
    return LATENCY_COLOURS[round(latencies.index(latency_us) * (len(LATENCY_COLOURS) - 1) / last)]


def label_of(latency_us):
    return f"stop-and-wait, results {latency_us:g} µs late" if latency_us else "stop-and-wait, driver's own"


def plain_log_axis(axis):
    """Ticks at 1, 2 and 5, and numbers as people write them instead of powers of ten."""
    axis.set_major_locator(matplotlib.ticker.LogLocator(subs=(1, 2, 5)))
    axis.set_major_formatter(matplotlib.ticker.FuncFormatter(lambda value, _: f"{value:,g}"))
    axis.set_minor_formatter(matplotlib.ticker.NullFormatter())


def along_the_path(measured, rows):
    """Per device a column: frame time above, triangles drawn below. x: frame of the path."""
    devices = list(dict.fromkeys(row.device for row in rows))
    latencies = latencies_of(rows)
    with pyplot.rc_context(STYLE):
        figure, axes = pyplot.subplots(
            2, len(devices), figsize=(11, 6.6), sharex=True, sharey="row", squeeze=False,
            gridspec_kw={"height_ratios": (3, 2)},
        )  # fmt: skip
        for configuration, value in measured.items():
            if configuration.repeat or not value.timed or configuration.device not in devices:
                continue
            time_axis, triangle_axis = axes[:, devices.index(configuration.device)]
            times = frame_times_ms(value)
            drawn = [frame["drawn_triangles"] for frame in value.judged.frames]
            if configuration.culler == BASELINE:
                time_axis.plot(times, color=FRUSTUM_COLOUR, label="frustum culling only")
                triangle_axis.plot(drawn, color=FRUSTUM_COLOUR)
            elif configuration.culler == BOUND:
                time_axis.plot(times, color=IDEAL_COLOUR, label="ideal: knows the answers")
                triangle_axis.plot(drawn, color=IDEAL_COLOUR)
            else:
                colour = colour_of(configuration.latency_us, latencies)
                time_axis.plot(times, color=colour, label=label_of(configuration.latency_us))
        for column, device in enumerate(devices):
            axes[0, column].set_title(device)
            axes[1, column].set_xlabel("frame of the path")
        for axis in axes.flat:
            axis.set_yscale("log")
            plain_log_axis(axis.yaxis)
        axes[0, 0].set_ylabel("frame time (ms)")
        axes[1, 0].set_ylabel("triangles drawn")
        handles, labels = axes[0, 0].get_legend_handles_labels()
        figure.legend(handles, labels, ncol=3, loc="upper center", bbox_to_anchor=(0.5, 0.01))
        figure.tight_layout()
        return svg_of(figure)


def against_latency(rows):
    """Per device: frame time and the waiting in it, mean of the path. x: how late a result is, us."""
    devices = list(dict.fromkeys(row.device for row in rows))
    with pyplot.rc_context(STYLE):
        figure, axes = pyplot.subplots(1, len(devices), figsize=(11, 4.4), sharey=True, squeeze=False)
        for axis, device in zip(axes[0], devices):
            points = [r for r in rows if r.device == device and r.culler in QUERYING and not r.repeat]
            points.sort(key=lambda row: row.latency_us)
            places = numpy.arange(len(points))
            stalled = numpy.array([row.stall_ms for row in points])
            rest = numpy.array([row.frame_ms for row in points]) - stalled
            axis.bar(places, stalled, 0.6, color="#e6550d", label="waiting for results (client)")
            axis.bar(places, rest, 0.6, bottom=stalled, color="#fdd0a2", label="all other work")
            layer = [row.layer_stall_ms for row in points]
            axis.plot(
                places, layer, "k_", markersize=22, markeredgewidth=1.6, label="waiting, seen by the layer"
            )
            for place, row in zip(places, points):
                axis.annotate(f"{row.frame_ms:,.1f} ms", (place, row.frame_ms), (0, 4), ha="center",
                              textcoords="offset points", fontsize=9)  # fmt: skip
            for culler, colour, text in (
                (BASELINE, FRUSTUM_COLOUR, "frustum culling only"),
                (BOUND, IDEAL_COLOUR, "ideal"),
            ):
                row = row_with(rows, device, culler)
                if row is not None:
                    axis.axhline(row.frame_ms, color=colour, linestyle="--", label=f"{text}")
            axis.set_xticks(
                places, ["driver's own" if r.latency_us == 0 else f"{r.latency_us:g}" for r in points]
            )
            axis.set_xlabel("a result is late by (µs)")
            even = break_even_us(rows, device, QUERYING[0])
            axis.set_title(device + (f": pays below {even:,.0f} µs" if even else ""))
            axis.grid(axis="x", visible=False)
        axes[0, 0].set_ylabel("frame time (ms), mean of the path")
        handles, labels = axes[0, 0].get_legend_handles_labels()
        figure.legend(handles, labels, ncol=5, loc="upper center", bbox_to_anchor=(0.5, 0.01), fontsize=9)
        figure.tight_layout()
        return svg_of(figure)
