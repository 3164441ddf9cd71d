# SPDX-License-Identifier: MIT
"""H. Hey, R. F. Tobler, W. Purgathofer, "Real-Time Occlusion Culling with a Lazy Occlusion Grid", 2001: Table 1.

Their machine read depths back with glReadPixels; so does ours, a GeForce2 GTS in its own time. What their program
spent beside GL is charged as they spent it: 7.5 ms in a frame that culls, and 31.3 ns for each pixel of HZB's
pyramid, which are the fits of tests/unit/log_paper.h to the table.
"""
from dataclasses import dataclass
from html import escape

from ..checks import Check, differing_frames
from ..jobs import Job
from ..tables import DASH, cells, number
from . import plots
from .common import Goal, Section, nothing_visible_is_culled, ratio

MACHINE = "geforce2-gts"
PROPOSED = "proposed-zfar-parallel-geforce2"
SCENES = ("log-forest", "log-city")
SIZES = ("640x480", "1280x960")
GRID = ("log-state", "bog", "hzb", "pq")  # state versions on one traversal
PROGRAM_MS = 7.5
PYRAMID_NS = 31.3


@dataclass(frozen=True)
class Published:
    """Milliseconds, triangles sent and pixels read, means of a frame."""

    milliseconds: float
    drawn: int
    pixels: int = 0


TABLE = {
    ("log-forest", "640x480"): {
        "log-state": Published(18, 7_009, 198_621), "bog": Published(73, 7_009, 2_288_217),
        "hzb": Published(162, 7_009, 2_682_035), "pq": Published(152, 7_009, 5_880_310),
        "frustum": Published(45, 147_969),
    },
    ("log-forest", "1280x960"): {
        "log-state": Published(31, 7_510, 424_713), "bog": Published(216, 7_510, 6_844_437),
        "hzb": Published(632, 7_510, 10_729_627), "pq": Published(611, 7_510, 23_495_623),
        "frustum": Published(52, 147_969),
    },
    ("log-city", "640x480"): {
        "log-state": Published(21, 11_981, 283_306), "bog": Published(45, 11_981, 1_272_965),
        "hzb": Published(87, 11_981, 1_361_715), "pq": Published(158, 11_981, 6_032_486),
        "frustum": Published(741, 1_964_918),
    },
    ("log-city", "1280x960"): {
        "log-state": Published(33, 11_775, 312_053), "bog": Published(138, 11_775, 4_230_168),
        "hzb": Published(328, 11_775, 5_417_068), "pq": Published(630, 11_775, 24_042_029),
        "frustum": Published(742, 1_964_918),
    },
}  # fmt: skip
TILES_A_BOX = {"log-forest": 14.6, "log-city": 17.7}  # at 640x480
NAMES = {"frustum": "no OC", "log-state": "LOG", "bog": "BOG", "hzb": "HZB", "pq": "PQ",
         "log-zfar": "LOG, zfar", "log-coherent": "LOG, coherent"}  # fmt: skip
SCALES = {"small": {"log-forest": 0.25, "log-city": 0.125}, "full": {"log-forest": 1, "log-city": 1}}


def pixels_of(size):
    width, height = size.split("x")
    return int(width) * int(height)


def job(extent, scene, size, culler, device=MACHINE, extra=(), judge=True):
    work = 0 if culler == "frustum" else PROGRAM_MS * 1000
    full = extent.is_full
    return Job(
        scene=scene, culler=culler, device=device, size=size, scale=SCALES[extent.name][scene], frames=1000,
        sections=(20, 2) if full else (4, 2), judge_every=(8 if full else 2) if judge else 0,
        knobs=(("pyramid_ns", PYRAMID_NS),) if culler == "hzb" else (),
        extra=("--work-us", f"{work:g}", *extra),
    )  # fmt: skip


def jobs(extent):
    wanted = []
    for scene in SCENES:
        for size in SIZES:
            wanted += [job(extent, scene, size, culler, judge=culler != "frustum") for culler in ("frustum", *GRID)]
            wanted += [job(extent, scene, size, culler) for culler in ("log-zfar", "log-coherent")]
        wanted += [
            job(extent, scene, SIZES[0], culler, device=PROPOSED) for culler in ("log-state", "log-coherent")
        ]
        wanted += [job(extent, scene, SIZES[0], culler, extra=("--moving", "0.05")) for culler in GRID]
    return wanted


def table(results, extent):
    lines = []
    for (scene, size), published in TABLE.items():
        lines.append(f'<tr class="group"><td colspan="13">{scene}, {size}</td></tr>')
        reference = results.get(job(extent, scene, size, "log-state"))
        for culler in ("log-state", "log-zfar", "log-coherent", "bog", "hzb", "pq", "frustum"):
            ours = results.get(job(extent, scene, size, culler, judge=culler != "frustum"))
            if ours is None:
                continue
            theirs = published.get(culler)
            screens = ours.mean("pixels_read") / pixels_of(size)
            log = published["log-state"]
            lines.append(
                "<tr>"
                + cells(escape(NAMES[culler]))
                + cells(number(theirs and theirs.drawn), number(ours.mean("drawn_triangles")))
                + cells(number(theirs.pixels / pixels_of(size) if theirs and theirs.pixels else None, 2),
                        number(screens, 2) if culler != "frustum" else DASH)  # fmt: skip
                + cells(ratio(theirs and theirs.pixels or None, log.pixels, 1),
                        ratio(ours.mean("pixels_read") or None,
                              reference and reference.mean("pixels_read"), 1))  # fmt: skip
                + cells(number(ours.mean("region_waits") or None))
                + cells(number(TILES_A_BOX[scene], 1) if culler == "log-state" and size == SIZES[0] else DASH,
                        tiles_a_box(ours))  # fmt: skip
                + cells(number(theirs and theirs.milliseconds), f"<strong>{number(ours.mean('device_ms'), 1)}</strong>")
                + cells(number(ours.layer_mean("device_stall_ms"), 1))
                + "</tr>"
            )
    return "\n".join(lines)


def tiles_a_box(result):
    boxes = result.mean("boxes_tested")
    return number(result.mean("tiles_tested") / boxes, 1) if boxes and result.mean("tiles_tested") else DASH


def growth_table(results, extent):
    """Pixels read at 1280x960 by those at 640x480: theirs, ours."""
    lines = []
    for scene in SCENES:
        for culler in (*GRID, "log-zfar", "log-coherent"):
            small, large = (results.get(job(extent, scene, size, culler)) for size in SIZES)
            if small is None or large is None:
                continue
            theirs = [TABLE[(scene, size)].get(culler) for size in SIZES]
            lines.append(
                f"<tr>{cells(scene, NAMES[culler], ratio(theirs[1] and theirs[1].pixels, theirs[0] and theirs[0].pixels))}"
                f"{cells(ratio(large.mean('pixels_read'), small.mean('pixels_read')))}</tr>"
            )
    return "\n".join(lines)


def all_draw_the_same(results, extent):
    faults, count = [], 0
    for scene in SCENES:
        for extra in ((), ("--moving", "0.05")):
            for size in SIZES if not extra else SIZES[:1]:
                drawn = {
                    culler: results[one].column("drawn_triangles")
                    for culler in GRID
                    if (one := job(extent, scene, size, culler, extra=extra)) in results
                }
                for culler in GRID[1:]:
                    if culler not in drawn or GRID[0] not in drawn:
                        continue
                    count += len(drawn[culler])
                    wrong = differing_frames(drawn[GRID[0]], drawn[culler])
                    faults += [f"{scene}, {size} {' '.join(extra)}: {culler} in frames {wrong}"] if wrong else []
    return Check("LOG, BOG, HZB and PQ draw the same number of triangles in every frame", faults, count, "frames")


def order_goals(results, extent):
    """The paper's orderings by time, on the paper's machine."""
    goals = []
    for (scene, size), published in TABLE.items():
        ours = {
            culler: results[one].mean("device_ms")
            for culler in published
            if (one := job(extent, scene, size, culler, judge=culler != "frustum")) in results
        }
        if len(ours) < len(published):
            continue
        wanted = sorted(published, key=lambda culler: published[culler].milliseconds)
        found = sorted(ours, key=ours.get)
        text = " &lt; ".join(f"{NAMES[culler]} {number(ours[culler], 0)}" for culler in found)
        goals.append(
            Goal(f"{scene}, {size}: the paper's order of times on its machine",
                 " &lt; ".join(NAMES[culler] for culler in wanted), text + " ms", wanted == found)  # fmt: skip
        )
    return goals


def read_goals(results, extent):
    goals = []
    for (scene, size), published in TABLE.items():
        one = results.get(job(extent, scene, size, "log-state"))
        if one is None:
            continue
        most = published["log-state"].pixels / pixels_of(size)
        screens = one.mean("pixels_read") / pixels_of(size)
        goals.append(
            Goal(f"{scene}, {size}: LOG reads at most the paper's screenfuls", f"{most:.2f}", f"{screens:.2f}",
                 round(screens, 2) <= round(most, 2))  # fmt: skip
        )
    for scene in SCENES:
        plain, coherent = (results.get(job(extent, scene, SIZES[0], c, device=PROPOSED))
                           for c in ("log-state", "log-coherent"))  # fmt: skip
        if plain is None or coherent is None:
            continue
        reads = plain.mean("pixels_read") / max(1, coherent.mean("pixels_read"))
        waits = plain.mean("region_waits") / max(1, coherent.mean("region_waits"))
        goals.append(
            Goal(f"{scene}: coherent LOG by parallel region queries waits or reads half as much as LOG",
                 "2 times less", f"{waits:.1f} times fewer waits, {reads:.1f} times fewer pixels",
                 max(reads, waits) >= 2)  # fmt: skip
        )
    return goals


INTRODUCTION = """<p>H. Hey, R. F. Tobler, W. Purgathofer, <em>Real-Time Occlusion Culling with a Lazy Occlusion Grid</em>,
2001, Table 1. A grid of 32 x 32 pixel tiles lies over the depth buffer. A box is hidden if all its tiles are full; a
tile is looked at (its depths are read) only when somebody asks. <em>BOG</em> looks after every draw, <em>HZB</em> keeps
a pyramid of depths, <em>PQ</em> reads the rectangle of every box. Left of each pair the paper's figure, right
ours; times in device time of a GeForce2 GTS with depths read back, of which the program's own share is charged as the
paper's fits say: 7.5 ms in a frame that culls, 31.3 ns a pixel of HZB's pyramid. {scale}</p>"""
HEAD = """<div class="scroll"><table class="wide"><thead><tr><th>method</th><th>triangles<br>drawn: paper</th><th>here</th>
<th>screenfuls<br>read: paper</th><th>here</th><th>ratio to<br>LOG: paper</th><th>here</th><th>waits for<br>depths</th>
<th>tiles a box:<br>paper</th><th>here</th><th>frame, ms:<br>paper</th><th>device<br>time</th><th>of it<br>stalled</th></tr>
</thead><tbody>"""


def rows(results):
    keys = ("drawn_triangles", "frustum_triangles", "pixels_read", "region_waits", "tiles_tested", "boxes_tested",
            "device_ms", "frame_ms")  # fmt: skip
    return [
        {"scene": one.scene, "size": one.size, "scale": one.scale, "culler": one.culler, "device": one.device,
         "moving": "--moving" in one.extra, **{key: result.mean(key) for key in keys},
         "device_stall_ms": result.layer_mean("device_stall_ms"), "false_culls_total": result.total("false_culls")}
        for one, result in results.items()
    ]  # fmt: skip


def panels(results, extent):
    """For the plot: our times and the paper's."""
    found = []
    for (scene, size), published in TABLE.items():
        methods = []
        for culler in ("log-state", "log-coherent", "bog", "hzb", "pq", "frustum"):
            ours = results.get(job(extent, scene, size, culler, judge=culler != "frustum"))
            theirs = published.get(culler)
            methods.append((culler, NAMES[culler].replace(", ", "\n"), ours and ours.mean("device_ms"),
                            theirs and theirs.milliseconds))  # fmt: skip
        found.append((f"{scene}, {size}", methods))
    return found


def section(results, extent):
    results = {one: results[one] for one in jobs(extent) if one in results}
    scales = SCALES[extent.name]
    note = (
        "The scenes have the paper's totals."
        if extent.is_full
        else "The scenes are small here ("
        + ", ".join(f"{scene} at {scale:g}" for scene, scale in scales.items())
        + "): <code>./evaluate --paper log</code> takes the paper's."
    )
    html = (
        INTRODUCTION.format(scale=note) + HEAD + table(results, extent) + "</tbody></table></div>"
        + f"<figure>{plots.times_beside_paper(panels(results, extent))}<figcaption>Time of a frame, logarithmic. Bars: "
        "here, in device time; diamonds: the paper.</figcaption></figure>"
        "<h3>From 640x480 to 1280x960: how many times more pixels are read</h3>"
        '<div class="scroll"><table><thead><tr><th>scene</th><th>method</th><th>paper</th><th>here</th></tr></thead>'
        f"<tbody>{growth_table(results, extent)}</tbody></table></div>"
    )  # fmt: skip
    checks = [nothing_visible_is_culled(results), all_draw_the_same(results, extent)]
    goals = order_goals(results, extent) + read_goals(results, extent) if extent.is_full else []
    return Section("Lazy Occlusion Grid", html, checks, goals, rows(results))
