# SPDX-License-Identifier: MIT
"""Plots of the papers' experiments, as SVG text."""
import matplotlib.pyplot as pyplot

from ..plots import FAINT, INK, STYLE, plain_log_axis, svg_of

COLOURS = {
    "none": "#000000", "frustum": "#636363", "stop-and-wait": "#e6550d", "chc": "#3182bd", "chc++": "#08306b",
    "ideal": "#31a354", "log-state": "#756bb1", "log-zfar": "#9e9ac8", "log-coherent": "#3f007d",
    "bog": "#c994c7", "hzb": "#dd1c77", "pq": "#980043", "conditional": "#fdae6b",
}  # fmt: skip


def add_legend(figure, axis):
    handles, labels = axis.get_legend_handles_labels()
    figure.legend(handles, labels, ncol=5, loc="upper center", bbox_to_anchor=(0.5, 0.01), fontsize=9)


def times_beside_paper(panels):
    """`panels`: of each its title and (culler, label, our ms or None, the paper's ms or None) by method."""
    with pyplot.rc_context(STYLE):
        figure, axes = pyplot.subplots(1, len(panels), figsize=(13, 3.6), sharey=True)
        for axis, (title, methods) in zip(axes, panels):
            for place, (culler, _, ours, theirs) in enumerate(methods):
                if ours is not None:
                    axis.bar(place, ours, color=COLOURS[culler], width=0.7)
                if theirs is not None:
                    axis.plot(place, theirs, "D", color=INK, markersize=5)
            axis.set_xticks(range(len(methods)), [label for _, label, _, _ in methods], fontsize=8)
            axis.set_yscale("log")
            axis.set_title(title, fontsize=9.5)
            axis.grid(axis="x", visible=False)
        plain_log_axis(axes[0].yaxis)
        axes[0].set_ylim(bottom=5)  # bars have no natural foot on a logarithmic axis
        axes[0].set_ylabel("frame time (ms)")
        figure.tight_layout()
        return svg_of(figure)


def along_the_walks(panels):
    """`panels`: of each its title, the numbers of its frames, and the times of a frame by culler."""
    with pyplot.rc_context(STYLE):
        figure, axes = pyplot.subplots(len(panels), 1, figsize=(13, 3 * len(panels)), squeeze=False)
        for axis, (title, numbers, times) in zip(axes[:, 0], panels):
            for culler, values in times.items():
                axis.plot(range(len(values)), values, color=COLOURS[culler], label=culler, linewidth=1.2)
            starts = [i for i in range(len(numbers)) if i == 0 or numbers[i] != numbers[i - 1] + 1]
            axis.set_xticks(starts, [numbers[start] for start in starts])
            for start in starts[1:]:
                axis.axvline(start - 0.5, color=FAINT, linewidth=0.6)
            axis.set_yscale("log")
            plain_log_axis(axis.yaxis)
            axis.set_ylabel("device time (ms)")
            axis.set_title(title)
            axis.grid(axis="x", visible=False)
        axes[-1, 0].set_xlabel("frame of the walk, in sections of consecutive frames")
        add_legend(figure, axes[0, 0])
        figure.tight_layout()
        return svg_of(figure)


def growth(panels):
    """`panels`: of each its title and the points (millions of triangles, value) by culler."""
    with pyplot.rc_context(STYLE):
        figure, axes = pyplot.subplots(1, len(panels), figsize=(13, 4))
        for axis, (title, lines) in zip(axes, panels):
            for culler, points in lines.items():
                axis.plot(*zip(*points), "o-", color=COLOURS[culler], label=culler, markersize=3.5)
            axis.set_xscale("log")
            axis.set_yscale("log")
            plain_log_axis(axis.xaxis)
            plain_log_axis(axis.yaxis)
            axis.set_xlabel("triangles in the city (millions)")
            axis.set_title(title)
        add_legend(figure, axes[-1])
        figure.tight_layout()
        return svg_of(figure)
