# SPDX-License-Identifier: MIT
"""A frame of a timeline as a picture, after Figure 1 of Bittner et al., "Coherent Hierarchical Culling" (2004).

usage: python3 -m apps.evaluation.timeline_picture TIMELINE.json OUT.{png,svg}
           [--frame N] [--from US] [--to US] [--context N]

What CPU and GPU do, with the FIFO between them: R draws, Q queries, C is the program's own work. Numbers count
from the frame's first. Times are microseconds of the device, from the beginning of the frame.
"""
import argparse
import bisect
import json
import sys
from dataclasses import dataclass, field

from .plots import FAINT, INK, STYLE, pyplot, svg_of

# The lanes, from below.
GPU_Y, FIFO_Y, CPU_Y = 0.0, 1.15, 2.3
LANE_HEIGHT, FIFO_HEIGHT = 0.8, 0.8
# More arrows than this hide what they are to show.
MOST_ARROWS = 40
# A slice narrower than this has no outline.
OUTLINE_PT = 3.0
FONT_PT = 8.0
WIDTH_IN = 11.0


@dataclass(frozen=True)
class Look:
    """Kinds differ by lightness or hatching, so that they stay apart without colour."""

    letter: str
    legend: str
    face: str
    edge: str = INK
    hatch: str = ""
    text: str = INK
    thin: str = ""  # the face where there is no room for hatching


LOOKS = {
    "draw": Look("R", "render", "#2f5d8c", text="#ffffff"),
    "query": Look("Q", "query", "#f7dfa6"),
    "region": Look("Q", "depth region query", "#f7dfa6"),
    "program": Look("C", "the program's own work", "#d5d9de"),
    "poll": Look("P", "poll", "#e9ecef"),
    "clear": Look("clear", "clear", "#8fa9bf"),
    "read": Look("read", "read back", "#b7a3c9"),
    "swap": Look("swap", "swap", "#6b7a90", text="#ffffff"),
    "stall": Look("stall", "CPU stall", "#ffffff", edge="#c8102e", hatch="////", text="#c8102e", thin="#e56a7e"),
    "back-pressure": Look("full", "FIFO full", "#ffffff", edge="#a35200", hatch="----", thin="#d9a066"),
    "drain": Look("drain", "CPU waits for the GPU at the end", "#ffffff", edge="#555555", hatch="||||", thin="#cfcfcf"),
    "starvation": Look("starved", "GPU starvation", "#ffffff", edge="#8a94a3", hatch="\\\\\\\\", thin="#dfe3e8"),
    "condition": Look("cond.", "GPU waits for a condition", "#ffffff", edge="#8a94a3", hatch="xxxx", thin="#dfe3e8"),
}  # fmt: skip
NUMBERED = {"draw": "draw", "query": "query", "region": "query"}


@dataclass
class Slice:
    name: str
    begin: float  # microseconds of the frame
    end: float
    arguments: dict


@dataclass
class Frame:
    """A frame, with times from its beginning."""

    device: str
    program: str
    context: int
    number: int
    arguments: dict
    begin: float
    end: float
    cpu: list = field(default_factory=list)
    gpu: list = field(default_factory=list)
    levels: list = field(default_factory=list)  # (time, microseconds of work in the FIFO)
    flows: list = field(default_factory=list)  # of a query: [(phase, time), ...]

    @property
    def length(self):
        return self.end - self.begin

    def share(self, lane, names):
        return sum(s.end - s.begin for s in lane if s.name in names) / self.length if self.length else 0.0


def contexts_of(events):
    """(pid, context) -> {"CPU": tid, ...}."""
    contexts = {}
    for event in events:
        if event["ph"] == "M" and event["name"] == "thread_name":
            context, _, lane = event["args"]["name"].partition(": ")
            number = int(context.removeprefix("context "))
            contexts.setdefault((event["pid"], number), {})[lane] = event["tid"]
    return contexts


def metadata(events, name, key, pid):
    return next(
        (e["args"][key] for e in events if e["name"] == name and e["ph"] == "M" and e["pid"] == pid), ""
    )


def choose_frame(events, contexts, number, context):
    """The frame's slice: of the number and the context, if they are given; of whole ones, if there are any."""
    found = []
    for event in events:
        is_frame = event["ph"] == "X" and event["cat"] == "frame"
        if not is_frame or (event["pid"], event["args"]["context"]) not in contexts:
            continue
        if number in (None, event["args"]["frame"]) and context in (None, event["args"]["context"]):
            found.append(event)
    if not found:
        held = sorted({e["args"]["frame"] for e in events if e["ph"] == "X" and e["cat"] == "frame"})
        which = f"frames {held[0]} to {held[-1]}" if held else "no frame"
        raise ValueError(f"the file holds no such frame, but {which}.")
    return next((event for event in found if event["args"]["is_whole"]), found[0])


def read_frame(trace, number=None, context=None):
    """A frame of a timeline: `trace` is its path, or its JSON. ValueError where there is none."""
    if not isinstance(trace, dict):
        with open(trace, encoding="utf-8") as stream:
            trace = json.load(stream)
    events = trace["traceEvents"]
    contexts = contexts_of(events)
    chosen = choose_frame(events, contexts, number, context)
    pid, context = chosen["pid"], chosen["args"]["context"]
    lanes = contexts[pid, context]
    frame = Frame(
        metadata(events, "process_labels", "labels", pid),
        metadata(events, "process_name", "name", pid),
        context,
        chosen["args"]["frame"],
        chosen["args"],
        chosen["ts"],
        chosen["ts"] + chosen["dur"],
    )
    flows = {}
    for event in events:
        if event["pid"] != pid or event["ph"] == "M" or not frame.begin <= event["ts"] <= frame.end:
            continue
        at, lane = event["ts"] - frame.begin, event["tid"]
        if event["ph"] == "X" and lane in (lanes["CPU"], lanes["GPU"]) and event["ts"] < frame.end:
            name = event["name"].split(" ")[0]
            slices = frame.cpu if lane == lanes["CPU"] else frame.gpu
            slices.append(Slice(name, at, at + event["dur"], event["args"]))
        elif event["ph"] == "C" and lane == lanes["FIFO"]:
            frame.levels.append((at, event["args"]["us"]))
        elif event["ph"] in "stf" and lane in (lanes["CPU"], lanes["GPU"]):
            flows.setdefault(event["id"], []).append((event["ph"], at))
    for lane in (frame.cpu, frame.gpu):
        lane.sort(key=lambda each: each.begin)
    frame.flows = [flow for flow in flows.values() if flow[0][0] == "s"]
    return frame


def label_of(each, first_query):
    look = LOOKS[each.name]
    if each.name not in NUMBERED:
        return look.letter
    number = each.arguments.get(NUMBERED[each.name], 0)
    return f"{look.letter}{number - first_query + 1 if NUMBERED[each.name] == 'query' else number}"


def draw_lane(axes, slices, y, window, first_query):
    """The slices of a lane that lie in the window, with labels where there is room."""
    begin, end = window
    points_per_us = WIDTH_IN * 0.9 * 72 / (end - begin)
    for name, look in LOOKS.items():
        bars = [
            (s.begin, s.end - s.begin) for s in slices if s.name == name and s.end > begin and s.begin < end
        ]
        wide = [bar for bar in bars if bar[1] * points_per_us > OUTLINE_PT]
        thin = [bar for bar in bars if bar[1] * points_per_us <= OUTLINE_PT]
        place = (y, LANE_HEIGHT)
        axes.broken_barh(wide, place, fc=look.face, ec=look.edge, hatch=look.hatch, lw=0.6, zorder=2)
        axes.broken_barh(thin, place, fc=look.thin or look.face, lw=0, zorder=2)
    for each in slices:
        left, right = max(each.begin, begin), min(each.end, end)
        label = label_of(each, first_query)
        if (
            right <= left
            or len(label) * FONT_PT * 0.62 + (5 if LOOKS[each.name].hatch else 2)
            > (right - left) * points_per_us
        ):
            continue
        look = LOOKS[each.name]
        box = {"facecolor": "#ffffff", "edgecolor": "none", "pad": 0.8} if look.hatch else None
        axes.text(
            (left + right) / 2, y + LANE_HEIGHT / 2, label, ha="center", va="center", fontsize=FONT_PT,
            color=look.text, bbox=box, zorder=4,
        )  # fmt: skip


def draw_fifo(axes, frame, window):
    """The work before the GPU: it jumps where a command comes in, and falls as the GPU works it off."""
    times, levels = [0.0], [0.0]
    for at, level in [*frame.levels, (frame.length, 0.0)]:
        left = max(0.0, levels[-1] - (at - times[-1]))
        # It is empty before the next command comes.
        times += [min(at, times[-1] + levels[-1]), at, at]
        levels += [left, left, level]
    first = max(0, bisect.bisect_left(times, window[0]) - 1)
    last = bisect.bisect_right(times, window[1]) + 1
    times, levels = times[first:last], levels[first:last]
    most = max(levels) or 1.0
    heights = [FIFO_Y + FIFO_HEIGHT * level / most for level in levels]
    axes.fill_between(times, FIFO_Y, heights, color="#b9c3cf", linewidth=0, zorder=1)
    axes.plot(window, (FIFO_Y, FIFO_Y), color=FAINT, linewidth=0.8, zorder=1)
    return most


def draw_arrows(axes, frame, window):
    """Thin arrows from a query's command to its work, and from its work's end to who fetched the result."""
    seen = [flow for flow in frame.flows if window[0] <= flow[0][1] < window[1]]
    if len(seen) > MOST_ARROWS:
        return False
    begins = [each.begin for each in frame.gpu]
    starts = [each.begin for each in frame.cpu]
    arrow = {
        "arrowstyle": "-|>,head_width=0.13,head_length=0.3",
        "color": INK,
        "lw": 0.6,
        "shrinkA": 0,
        "shrinkB": 0,
    }
    for flow in seen:
        times = dict(reversed(flow))
        if "t" not in times:
            continue
        command = frame.cpu[bisect.bisect_right(starts, times["s"]) - 1]
        work = frame.gpu[bisect.bisect_right(begins, times["t"]) - 1]
        down = (command.end, CPU_Y), (times["t"], GPU_Y + LANE_HEIGHT)
        ends = [down]
        if "f" in times:
            ends.append(((work.end, GPU_Y + LANE_HEIGHT), (times["f"], CPU_Y)))
        for tail, head in ends:
            axes.annotate("", xy=head, xytext=tail, arrowprops=arrow, annotation_clip=True, zorder=3)
    return True


def draw_figure(frame, window):
    with pyplot.rc_context({**STYLE, "hatch.linewidth": 0.7}):
        figure, axes = pyplot.subplots(figsize=(WIDTH_IN, 3.1))
        first_query = min(
            (s.arguments["query"] for s in frame.cpu if s.name in ("query", "region")), default=1
        )
        most = draw_fifo(axes, frame, window)
        draw_lane(axes, frame.cpu, CPU_Y, window, first_query)
        draw_lane(axes, frame.gpu, GPU_Y, window, first_query)
        has_arrows = draw_arrows(axes, frame, window)
        axes.set_xlim(window)
        axes.set_ylim(-0.15, CPU_Y + LANE_HEIGHT + 0.15)
        axes.set_yticks(
            [GPU_Y + LANE_HEIGHT / 2, FIFO_Y + FIFO_HEIGHT / 2, CPU_Y + LANE_HEIGHT / 2],
            ["GPU", f"FIFO\nup to {most:.3g} µs", "CPU"],
        )
        axes.tick_params(axis="y", length=0)
        axes.grid(False)
        axes.spines["left"].set_visible(False)
        axes.set_xlabel("µs of the device, from the beginning of the frame")
        stall, starvation = frame.share(frame.cpu, {"stall"}), frame.share(
            frame.gpu, {"starvation", "condition"}
        )
        axes.set_title(
            f"{frame.program} on {frame.device}, frame {frame.number}: {frame.length / 1000:.3f} ms; "
            f"CPU stalled {stall:.1%}, GPU starved {starvation:.1%}"
        )
        shown = {s.name for s in frame.cpu + frame.gpu if s.end > window[0] and s.begin < window[1]}
        handles = []
        for look in (look for name, look in LOOKS.items() if name in shown):
            legend = f"{look.letter}  {look.legend}" if len(look.letter) == 1 else look.legend
            style = {"fc": look.face, "ec": look.edge, "hatch": look.hatch, "lw": 0.6}
            handles.append(pyplot.Rectangle((0, 0), 1, 1, label=legend, **style))
        if not has_arrows:
            handles.append(pyplot.Line2D([], [], linestyle="none", label="(too many queries for arrows)"))
        axes.legend(
            handles=handles, loc="upper center", bbox_to_anchor=(0.5, -0.22), ncols=min(5, len(handles)),
            fontsize=FONT_PT, handlelength=2.2,
        )  # fmt: skip
        return figure


def draw(trace, out=None, frame=None, window_us=None, context=None):
    """A frame of `trace`, a timeline's path or JSON, as a picture.

    Into the file `out`, a .png or .svg; or, where that is None, returned as the text of an <svg> element.
    `window_us` are the first and last microsecond of the frame that are seen, either of them None for its end.
    ValueError, with a sentence, where there is no such frame or window.
    """
    chosen = read_frame(trace, frame, context)
    begin, end = window_us or (None, None)
    window = (max(0.0, begin or 0.0), min(chosen.length, chosen.length if end is None else end))
    if window[0] >= window[1]:
        raise ValueError(f"the frame is {chosen.length:.3f} µs long, and nothing of it lies in that window.")
    figure = draw_figure(chosen, window)
    # With the ids of the style, and nothing else that differs from run to run.
    with pyplot.rc_context(STYLE):
        if out is None:
            return svg_of(figure)
        metadata = {"Date": None} if str(out).endswith(".svg") else None
        figure.savefig(out, dpi=150, bbox_inches="tight", facecolor="white", metadata=metadata)
    pyplot.close(figure)
    return None


def main():
    parser = argparse.ArgumentParser(prog="timeline_picture", description=__doc__.splitlines()[0])
    parser.add_argument("timeline", help="a file written by glext-emu run --timeline")
    parser.add_argument("out", help="a .png or .svg")
    parser.add_argument("--frame", type=int, help="its number; by default the first whole one in the file")
    parser.add_argument("--context", type=int, help="its number; by default the first that has the frame")
    parser.add_argument(
        "--from", dest="begin", type=float, metavar="US", help="first microsecond of the frame"
    )
    parser.add_argument("--to", dest="end", type=float, metavar="US", help="last microsecond of the frame")
    options = parser.parse_args()
    if not options.out.endswith((".png", ".svg")):
        parser.error(f"{options.out} is neither a .png nor a .svg.")
    try:
        draw(options.timeline, options.out, options.frame, (options.begin, options.end), options.context)
    except (OSError, ValueError) as error:
        print(f"timeline_picture: {options.timeline}: {error}", file=sys.stderr)
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main())
