# SPDX-License-Identifier: MIT
"""J. Bittner, M. Wimmer, H. Piringer, W. Purgathofer, "Coherent Hierarchical Culling", Eurographics 2004: Tables 1
and 2, frame times along the walks (Figures 5 to 7), and what CHC++ (Mattausch, Bittner, Wimmer, 2008) makes of them.

In device time of their GeForce FX 5950, and on the driver that runs here.
"""
from dataclasses import dataclass
from html import escape

from ..jobs import Job
from ..tables import DASH, cells, number
from . import plots
from .common import Goal, Section, nothing_visible_is_culled, ratio, speedups

MACHINE = "geforce-fx-5950"
HERE = "mesa"
SCENES = ("chc-teapots", "chc-city", "chc-plant")
CULLERS = ("frustum", "stop-and-wait", "chc", "chc++", "ideal")
SIZE = "1024x768"
# The ideal of the paper draws leaf by leaf; this one makes as few draw commands of the same set as a method may that
# draws visible leaves together, as CHC++ does.
IN_RUNS = (("in_runs", 1),)
# The paper's plant did not fit its graphics card's memory. Our meshes are shared; here each is stored where it stands.
UNSHARED = {"chc-plant": ("--unshared",)}
SWEEP = ((0, 0), (2, 0), (2, 25))  # t_av, n_vp


@dataclass(frozen=True)
class Published:
    """A row of Table 1; `speedup` is the mean of the frames' ratios to frustum culling."""

    triangles: int
    milliseconds: float
    queries: int = None
    wait_ms: float = None
    speedup: float = 1.0


TABLE_1 = {
    "chc-teapots": {
        "frustum": Published(11_139_928, 310.42),
        "stop-and-wait": Published(2_617_801, 154.95, 4704, 83.19, 2.3),
        "chc": Published(2_852_514, 81.18, 2827, 1.31, 4.6),
        "ideal": Published(2_617_801, 72.19, speedup=5.2),
    },
    "chc-city": {
        "frustum": Published(156_521, 19.79),
        "stop-and-wait": Published(30_594, 19.9, 663, 9.49, 1.5),
        "chc": Published(31_034, 8.47, 345, 0.18, 4.0),
        "ideal": Published(30_594, 4.55, speedup=6.6),
    },
    "chc-plant": {
        "frustum": Published(1_556_300, 138.76),
        "stop-and-wait": Published(392_962, 52.29, 485, 16.16, 3.2),
        "chc": Published(397_920, 38.73, 263, 0.70, 4.7),
        "ideal": Published(392_962, 36.34, speedup=5.8),
    },
}
TABLE_2 = {
    "chc-teapots": {(0, 0): (2827, 81.18), (2, 0): (1769, 86.31), (2, 25): (1468, 55.90)},
    "chc-city": {(0, 0): (345, 8.47), (2, 0): (192, 6.70), (2, 25): (181, 6.11)},
    "chc-plant": {(0, 0): (263, 38.73), (2, 0): (126, 31.17), (2, 25): (120, 36.62)},
}
SCALES = {"small": {"chc-teapots": 0.05, "chc-city": 1, "chc-plant": 0.05},
          "full": dict.fromkeys(SCENES, 1)}  # fmt: skip
# Frames of the whole walk, and the part of it that is walked: (sections, frames of each).
WALKS = {
    "small": {"chc-teapots": (140, (3, 20)), "chc-city": (2600, (3, 20)), "chc-plant": (4400, (3, 20))},
    "full": {"chc-teapots": (140, (4, 20)), "chc-city": (2600, (10, 20)), "chc-plant": (4400, (10, 20))},
}


def job(extent, scene, culler, device=MACHINE, knobs=(), repeat=0, extra=()):
    frames, sections = WALKS[extent.name][scene]
    timed = device == HERE
    return Job(
        scene=scene, culler=culler, device=device, clock="none" if timed else "device", frames=frames,
        sections=sections, scale=SCALES[extent.name][scene], size=SIZE, knobs=knobs, repeat=repeat,
        extra=(*UNSHARED.get(scene, ()), *extra),
        judge_every=0 if timed or culler in ("frustum", "ideal") else 20 if extent.is_full else 10,
    )  # fmt: skip


def sweep_job(extent, scene, t_av, n_vp):
    return job(extent, scene, "chc", knobs=(("t_av", t_av), ("n_vp", n_vp)) if t_av or n_vp else ())


def jobs(extent):
    wanted = [job(extent, scene, culler) for scene in SCENES for culler in CULLERS]
    wanted += [job(extent, scene, "ideal", knobs=IN_RUNS) for scene in SCENES]
    wanted += [sweep_job(extent, scene, *knobs) for scene in SCENES for knobs in SWEEP]
    wanted += [job(extent, "chc-city", culler, extra=("--moving", "0.05")) for culler in CULLERS[1:4]]
    wanted += [job(extent, scene, culler, device=HERE) for scene in SCENES for culler in CULLERS]
    wanted += [job(extent, scene, "frustum", device=HERE, repeat=1) for scene in SCENES]
    return wanted


def table_1(results, extent):
    lines = []
    for scene in SCENES:
        base = results.get(job(extent, scene, "frustum"))
        base_here = results.get(job(extent, scene, "frustum", device=HERE))
        if base is None:
            continue
        lines.append(f'<tr class="group"><td colspan="15">{scene}, {base.summary["scene_triangles"]:,} triangles, '
                     f'{base.summary["tree_nodes"]:,} nodes</td></tr>')  # fmt: skip
        for culler, knobs in (*((culler, ()) for culler in CULLERS), ("ideal", IN_RUNS)):
            ours = results.get(job(extent, scene, culler, knobs=knobs))
            here = None if knobs else results.get(job(extent, scene, culler, device=HERE))
            if ours is None:
                continue
            theirs = None if knobs else TABLE_1[scene].get(culler)
            mean, means = speedups(base.column("device_ms"), ours.column("device_ms"))
            of_means = theirs and TABLE_1[scene]["frustum"].milliseconds / theirs.milliseconds
            on_mesa = here and base_here and speedups(base_here.column("frame_ms"), here.column("frame_ms"))[0]
            lines.append(
                "<tr>"
                + cells(escape(culler) + (", fewest draws" if knobs else ""), number(theirs and theirs.queries), number(ours.mean("queries") or None))
                + cells(number(theirs and theirs.wait_ms, 2),
                        number(ours.layer_mean("device_stall_ms") if ours.mean("queries") else None, 2))
                + cells(number(theirs and theirs.triangles), number(ours.mean("drawn_triangles")))
                + cells(number(theirs and theirs.milliseconds, 2), f"<strong>{number(ours.mean('device_ms'), 2)}</strong>")
                + cells(number(theirs and theirs.speedup, 1), number(mean, 1))
                + cells(number(of_means, 2), number(means, 2))
                + cells(number(here and here.mean("frame_ms"), 1), number(here and here.mean("stall_ms") or None, 1),
                        number(on_mesa, 1))
                + "</tr>"
            )  # fmt: skip
    return "\n".join(lines)


def relations(results, extent):
    """CHC by stop-and-wait: queries, triangles; the driver's cost of a query."""
    lines = []
    for scene in SCENES:
        waiting, coherent = results.get(job(extent, scene, "stop-and-wait")), results.get(job(extent, scene, "chc"))
        ideal = results.get(job(extent, scene, "ideal", device=HERE))
        waiting_here = results.get(job(extent, scene, "stop-and-wait", device=HERE))
        if waiting is None or coherent is None:
            continue
        theirs = TABLE_1[scene]
        surplus = coherent.mean("drawn_triangles") / waiting.mean("drawn_triangles") - 1
        their_surplus = theirs["chc"].triangles / theirs["stop-and-wait"].triangles - 1
        query_us = None
        if ideal and waiting_here and waiting_here.mean("queries"):
            query_us = 1000 * (waiting_here.mean("frame_ms") - ideal.mean("frame_ms")) / waiting_here.mean("queries")
        shares = (("frustum_triangles", waiting.mean("frustum_triangles") / waiting.summary["scene_triangles"]),
                  ("drawn", waiting.mean("drawn_triangles") / waiting.mean("frustum_triangles")))  # fmt: skip
        lines.append(
            f"<tr>{cells(scene)}"
            + cells(ratio(theirs["chc"].queries, theirs["stop-and-wait"].queries),
                    ratio(coherent.mean("queries"), waiting.mean("queries")))
            + cells(f"{their_surplus:+.1%}", f"{surplus:+.1%}")
            + cells(f"{theirs['frustum'].triangles / TOTALS[scene]:.1%}", f"{shares[0][1]:.1%}")
            + cells(f"{theirs['ideal'].triangles / theirs['frustum'].triangles:.1%}", f"{shares[1][1]:.1%}")
            + cells(number(query_us, 1)) + "</tr>"
        )  # fmt: skip
    return "\n".join(lines)


TOTALS = {"chc-teapots": 11_520_000, "chc-city": 1_036_146, "chc-plant": 12_748_510}


def table_2(results, extent):
    lines = []
    for scene in SCENES:
        for knobs in SWEEP:
            ours = results.get(sweep_job(extent, scene, *knobs))
            if ours is None:
                continue
            queries, milliseconds = TABLE_2[scene][knobs]
            judged = [frame for frame in ours.frames if "wrong_pixels" in frame]
            wrong = sum(frame["wrong_pixels"] for frame in judged) / len(judged) if judged else None
            lines.append(
                f"<tr>{cells(scene, *knobs, number(queries), number(ours.mean('queries')))}"
                f"{cells(number(milliseconds, 2), number(ours.mean('device_ms'), 2))}"
                f"{cells(number(ours.mean('drawn_triangles')), number(wrong, 1), number(ours.mean('false_culls'), 1))}</tr>"
            )
    return "\n".join(lines)


def worst_window(results, extent, scene, length=20):
    """The largest ratio of CHC++'s time to frustum culling's over `length` frames in a row of one section."""
    base, ours = results.get(job(extent, scene, "frustum")), results.get(job(extent, scene, "chc++"))
    if base is None or ours is None:
        return None
    worst = 0
    for first in range(len(ours.frames) - length + 1):
        if ours.frames[first + length - 1]["frame"] - ours.frames[first]["frame"] != length - 1:
            continue
        window = slice(first, first + length)
        worst = max(worst, sum(ours.column("device_ms")[window]) / sum(base.column("device_ms")[window]))
    return worst


def goals(results, extent):
    found = []
    for scene in SCENES:
        runs = {culler: results.get(job(extent, scene, culler)) for culler in CULLERS}
        if None in runs.values():
            continue
        times = {culler: run.mean("device_ms") for culler, run in runs.items()}
        faster, _ = speedups(runs["frustum"].column("device_ms"), runs["chc"].column("device_ms"))
        bound, _ = speedups(runs["frustum"].column("device_ms"), runs["ideal"].column("device_ms"))
        found.append(Goal(f"{scene}: CHC is four times as fast as frustum culling (mean of ratios; ideal: {bound:.1f})",
                          "4", f"{faster:.1f}", faster >= 4))  # fmt: skip
        if scene != "chc-city":
            slower = times["chc"] / times["ideal"]
            found.append(Goal(f"{scene}: CHC takes at most 1.15 times the ideal", "1.15", f"{slower:.3f}", slower <= 1.15))
        slower = times["chc++"] / times["ideal"]
        found.append(Goal(f"{scene}: CHC++ takes at most 1.05 times the ideal", "1.05", f"{slower:.3f}", slower <= 1.05))
        in_runs = results.get(job(extent, scene, "ideal", knobs=IN_RUNS))
        if in_runs:
            slower = times["chc++"] / in_runs.mean("device_ms")
            found.append(Goal(f"{scene}: CHC++ takes at most 1.05 times the ideal in as few draws as can be", "1.05",
                              f"{slower:.3f}", slower <= 1.05))  # fmt: skip
        worst = worst_window(results, extent, scene)
        found.append(Goal(f"{scene}: CHC++ is over no 20 frames slower than frustum culling", "1", f"{worst:.3f}",
                          worst <= 1))  # fmt: skip
    return found


INTRODUCTION = """<p>J. Bittner, M. Wimmer, H. Piringer, W. Purgathofer, <em>Coherent Hierarchical Culling: Hardware
Occlusion Queries Made Useful</em>, 2004. <em>CHC</em> asks only where the last frame's tree ended, draws what was visible
without waiting, and fetches answers when they are there. <em>CHC++</em> (Mattausch, Bittner, Wimmer, 2008) asks in
batches, about many nodes at once, and seldom about what stays visible. Left of each pair the paper's figure, right ours in device time of
a GeForce FX 5950; last, this computer's own. The power plant is a proxy: the model cannot be had. {scale}</p>"""
HEAD_1 = """<div class="scroll"><table class="wide"><thead><tr><th>method</th><th>queries:<br>paper</th><th>here</th>
<th>waiting, ms:<br>paper</th><th>here</th><th>triangles:<br>paper</th><th>here</th><th>frame, ms:<br>paper</th><th>device<br>time</th>
<th>mean of<br>ratios: paper</th><th>here</th><th>ratio of<br>means: paper</th><th>here</th><th>this computer,<br>ms</th><th>waiting,<br>ms</th>
<th>mean of<br>ratios</th></tr></thead><tbody>"""
HEAD_R = """<div class="scroll"><table><thead><tr><th>scene</th><th>CHC's queries by<br>stop-and-wait's: paper</th><th>here</th>
<th>CHC's surplus of<br>triangles: paper</th><th>here</th><th>in the frustum,<br>of all: paper</th><th>here</th>
<th>drawn, of<br>those: paper</th><th>here</th><th>a query costs this<br>computer, µs</th></tr></thead><tbody>"""
HEAD_2 = """<div class="scroll"><table><thead><tr><th>scene</th><th>t<sub>av</sub></th><th>n<sub>vp</sub></th><th>queries:<br>paper</th>
<th>here</th><th>frame, ms:<br>paper</th><th>device<br>time</th><th>triangles</th><th>wrong pixels<br>a frame</th>
<th>visible objects<br>left out, a frame</th></tr></thead><tbody>"""


def rows(results):
    keys = ("queries", "query_boxes", "polls", "results_waited", "drawn_triangles", "frustum_triangles", "device_ms",
            "frame_ms", "stall_ms")  # fmt: skip
    return [
        {"scene": one.scene, "scale": one.scale, "culler": one.culler, "device": one.device, "clock": one.clock,
         "repeat": one.repeat, "knobs": " ".join(f"{n}={v:g}" for n, v in one.knobs), "moving": "--moving" in one.extra,
         **{key: result.mean(key) for key in keys},
         "device_stall_ms": result.layer_mean("device_stall_ms") if one.clock == "device" else None,
         "false_culls_total": result.total("false_culls"), "wrong_pixels_total": result.total("wrong_pixels")}
        for one, result in results.items()
    ]  # fmt: skip


def noise(results, extent):
    """The A/A rows: the same walk timed twice on this computer."""
    parts = []
    for scene in SCENES:
        pair = [results.get(job(extent, scene, "frustum", device=HERE, repeat=repeat)) for repeat in (0, 1)]
        if None not in pair:
            parts.append(f"{scene} {pair[1].mean('frame_ms') / pair[0].mean('frame_ms') - 1:+.1%}")
    return ", ".join(parts) or DASH


def panels(results, extent):
    """For the plot: the frames' times by method."""
    found = []
    for scene in SCENES:
        runs = {culler: results.get(job(extent, scene, culler)) for culler in CULLERS}
        times = {culler: run.column("device_ms") for culler, run in runs.items() if run}
        numbers = next((run.column("frame") for run in runs.values() if run), [])
        found.append((scene, numbers, times))
    return found


def section(results, extent):
    results = {one: results[one] for one in jobs(extent) if one in results}
    note = (
        "The scenes have the paper's totals."
        if extent.is_full
        else "The scenes are small here ("
        + ", ".join(f"{scene} at {scale:g}" for scene, scale in SCALES[extent.name].items())
        + "): <code>./evaluate --paper chc</code> takes the paper's."
    )
    html = (
        INTRODUCTION.format(scale=note) + HEAD_1 + table_1(results, extent) + "</tbody></table></div>"
        + f"<p>Frustum culling timed once more on this computer: {noise(results, extent)}.</p>"
        + HEAD_R + relations(results, extent) + "</tbody></table></div>"
        + f"<figure>{plots.along_the_walks(panels(results, extent))}<figcaption>Frame times in device time along sections of the "
        "walks, logarithmic, as the paper's Figures 5 to 7.</figcaption></figure>"
        "<h3>Asking less often, and leaving out what shows little</h3>"
        "<p>Table 2. A visible leaf is assumed to stay visible for t<sub>av</sub> frames; a node of which at most n<sub>vp</sub> "
        "samples show is left out. The first costs no pixel, the second does.</p>"
        + HEAD_2 + table_2(results, extent) + "</tbody></table></div>"
    )  # fmt: skip
    checks = [nothing_visible_is_culled(results, lambda one: dict(one.knobs).get("n_vp", 0) > 0)]
    return Section("Coherent Hierarchical Culling", html, checks, goals(results, extent) if extent.is_full else [], rows(results))
