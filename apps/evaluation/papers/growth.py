# SPDX-License-Identifier: MIT
"""What hidden triangles cost: the same walk through the same streets, while the city behind them grows.

A method whose work depends on what is seen, and not on what there is, stays flat.
"""
from ..jobs import Job
from ..tables import cells, number
from . import plots
from .common import Section, nothing_visible_is_culled

MACHINE = "geforce-fx-5950"  # it has queries, and depths can be read back
SCENE = "log-city"
CULLERS = ("frustum", "stop-and-wait", "chc", "chc++", "log-state", "log-coherent", "bog", "hzb", "pq", "ideal")
TIMES = {"small": (1, 4, 16), "full": (1, 2, 4, 8, 16, 32)}


def job(extent, times, culler):
    return Job(
        scene=SCENE, culler=culler, device=MACHINE, scale=times / 32, frames=1000,
        size="320x240" if not extent.is_full else "640x480", sections=(2, 3) if not extent.is_full else (4, 4),
        judge_every=0 if culler in ("frustum", "ideal") else 3,
    )  # fmt: skip


def jobs(extent):
    return [job(extent, times, culler) for times in TIMES[extent.name] for culler in CULLERS]


def grown(results, extent, culler, value):
    """`value(result)` at the largest city by that at the smallest; None where either is missing or 0."""
    small, large = (results.get(job(extent, times, culler)) for times in (TIMES[extent.name][0], TIMES[extent.name][-1]))
    if small is None or large is None or not value(small):
        return None
    return value(large) / value(small)


def table(results, extent):
    lines = []
    for culler in CULLERS:
        one = results.get(job(extent, TIMES[extent.name][-1], culler))
        if one is None:
            continue
        values = [
            grown(results, extent, culler, lambda result, key=key: result.mean(key))
            for key in ("drawn_triangles", "queries", "pixels_read", "device_ms")
        ]
        lines.append(f"<tr>{cells(culler, *(number(value, 2) for value in values))}"
                     f"{cells(number(one.mean('device_ms'), 2))}</tr>")  # fmt: skip
    return "\n".join(lines)


def rows(results):
    keys = ("drawn_triangles", "frustum_triangles", "queries", "pixels_read", "region_waits", "device_ms")
    return [
        {"scene": one.scene, "times": one.scale * 32, "triangles": result.summary["scene_triangles"],
         "culler": one.culler, "device": one.device, **{key: result.mean(key) for key in keys}}
        for one, result in results.items()
    ]  # fmt: skip


def panels(results, extent):
    """For the plot: three counts against the size of the city."""
    found = []
    for key, title in (("queries", "queries a frame"), ("pixels_read", "pixels read a frame"),
                       ("device_ms", "device time (ms)")):  # fmt: skip
        lines = {}
        for culler in CULLERS:
            walked = [results.get(job(extent, times, culler)) for times in TIMES[extent.name]]
            points = [(one.summary["scene_triangles"] / 1e6, one.mean(key)) for one in walked if one and one.mean(key)]
            if points:
                lines[culler] = points
        found.append((title, lines))
    return found


def section(results, extent):
    results = {one: results[one] for one in jobs(extent) if one in results}
    largest = TIMES[extent.name][-1]
    html = (
        f"<p>The walk through the first sixteen blocks of <code>{SCENE}</code>, with {largest} times as many blocks behind them at "
        f"last, in device time of the {MACHINE}. A method is output-sensitive if its line is flat.</p>"
        f"<figure>{plots.growth(panels(results, extent))}<figcaption>Queries, pixels read and device time of a frame against "
        "the triangles of the city, all logarithmic.</figcaption></figure>"
        f'<div class="scroll"><table><thead><tr><th>method</th><th colspan="4">at {largest} times the city, times what it is at '
        "1:<br>triangles drawn &nbsp; queries &nbsp; pixels read &nbsp; device time</th><th>frame there,<br>ms</th></tr></thead>"
        f"<tbody>{table(results, extent)}</tbody></table></div>"
    )
    return Section("Growth", html, [nothing_visible_is_culled(results)], [], rows(results))
