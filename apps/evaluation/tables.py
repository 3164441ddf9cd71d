# SPDX-License-Identifier: MIT
"""The table rows of the page, as HTML. A dash stands where a thing does not apply."""
from html import escape

from .matrix import BASELINE, BOUND, DEVICE_TITLES
from .paper import CITY, FRUSTUM_TRIANGLES, SCENE_TRIANGLES, VISIBLE_TRIANGLES
from .rows import noise, row_with

DASH = "–"


def number(value, digits=0):
    return DASH if value is None else f"{value:,.{digits}f}"


def cells(*values):
    return "".join(f"<td>{value}</td>" for value in values)


def late_by(row):
    """The latency of a row in words."""
    if row.latency_us is None:
        return DASH
    return f"{row.latency_us:g} µs" if row.latency_us else "driver's own"


def name_of(row):
    return f"{row.culler}, {late_by(row)}" if row.latency_us is not None else row.culler


def time_bar(row, longest_ms):
    """A bar of at most 90 px: the waiting dark, the rest light."""
    wait_ms = row.stall_ms or 0
    kind = row.culler if row.culler in (BASELINE, BOUND) else "rest"
    parts = [("wait", wait_ms), (kind, row.frame_ms - wait_ms)]
    drawn = "".join(
        f'<i class="{css}" style="width:{max(1, round(90 * ms / longest_ms))}px"></i>'
        for css, ms in parts
        if ms > 0
    )
    return f'<td class="time"><div class="bar">{drawn}{number(row.frame_ms, 1)}</div></td>'


def bad_if(value):
    """A whole-path total that ought to be zero."""
    return f'<td class="{"bad" if value else ""}">{value:,}</td>'


def main_table(rows):
    lines, group = [], None
    longest_ms = max((row.frame_ms for row in rows), default=1)
    for row in rows:
        heading = (
            "The same again, to show the noise" if row.repeat else DEVICE_TITLES.get(row.device, row.device)
        )
        if heading != group:
            lines.append(f'<tr class="group"><td colspan="15">{escape(heading)}</td></tr>')
            group = heading
        lines.append(
            f'<tr class="{"again" if row.repeat else ""}">'
            + cells(escape(row.culler), late_by(row))
            + cells(number(row.queries or None), number(row.waits or None), number(row.drawn_triangles))
            + bad_if(row.false_culls_total)
            + bad_if(row.wrong_pixels_total)
            + time_bar(row, longest_ms)
            + cells(number(row.frame_ms_median, 1), number(row.stall_ms, 1), number(row.layer_stall_ms, 1))
            + cells(number(row.query_cost_us, 1))
            + cells(number(row.speedup_of_means, 2), number(row.speedup_mean, 2), faster_frames(row))
            + "</tr>"
        )
    return "\n".join(lines)


def faster_frames(row):
    return DASH if row.culler == BASELINE else number(row.frames_faster_total)


def paper_table(rows, device):
    """Each published row with ours of the same culler and device under it, at the driver's own time."""
    lines = []
    for published in CITY:
        ratio = CITY[0].frame_ms / published.frame_ms
        lines.append(
            "<tr>"
            + cells(published.culler, "paper, 2004", number(published.queries), number(published.wait_ms, 2))
            + cells(number(published.drawn_triangles), number(published.frame_ms, 2), number(ratio, 2))
            + cells(number(published.speedup, 1))
            + "</tr>"
        )
        row = row_with(rows, device, published.culler) or row_with(rows, device, published.culler, 0)
        if row is not None:
            lines.append(
                '<tr class="ours">'
                + cells("", "here", number(row.queries or None), number(row.stall_ms, 2))
                + cells(number(row.drawn_triangles), number(row.frame_ms, 2), number(row.speedup_of_means, 2))
                + cells(number(row.speedup_mean, 2))
                + "</tr>"
            )
    return "\n".join(lines)


def device_time_table(rows, device_rows):
    """Of each culler: the paper, the machine that is emulated for it, and the driver that runs here."""
    lines = []
    for published in CITY:
        ours = next((row for row in device_rows if row.culler == published.culler), None)
        if ours is None:
            continue
        driver = row_with(rows, ours.device, ours.culler) or row_with(rows, ours.device, ours.culler, 0)
        ratio = CITY[0].frame_ms / published.frame_ms
        lines.append(
            "<tr>"
            + cells(ours.culler, number(published.queries), number(ours.queries or None))
            + cells(number(published.drawn_triangles), number(ours.drawn_triangles))
            + cells(number(published.frame_ms, 2), f"<strong>{number(ours.device_ms, 2)}</strong>")
            + cells(number(driver and driver.frame_ms, 1))
            + cells(number(published.wait_ms, 2), number(ours.stall_ms if ours.queries else None, 2))
            + cells(number(ratio, 2), number(ours.speedup_of_means, 2))
            + cells(number(published.speedup, 1), number(ours.speedup_mean, 1))
            + "</tr>"
        )
    return "\n".join(lines)


def device_share_table(device_rows):
    """Where the frame goes on the CPU, and where on the GPU."""
    lines = []
    for row in device_rows:
        parts = (row.cpu_ms, row.stall_ms, row.back_pressure_ms, row.drain_ms, row.gpu_busy_ms, row.starvation_ms)
        shares = (f"{number(part, 2)} <small>{part / row.device_ms:.0%}</small>" for part in parts)
        lines.append(
            f"<tr>{cells(row.culler, number(row.draws), number(row.device_ms, 2), *shares)}</tr>"
        )
    return "\n".join(lines)


def selectivity_table(rows, device, scene_triangles):
    """The shares that decide what culling can save at all."""
    row = row_with(rows, device, BOUND)
    if row is None:
        return ""
    ours = (scene_triangles, row.frustum_triangles, row.drawn_triangles)
    theirs = (SCENE_TRIANGLES, FRUSTUM_TRIANGLES, VISIBLE_TRIANGLES)
    shares = [("triangles in the scene", number(theirs[0]), number(ours[0]))]
    for text, part, whole, digits in (
        ("inside the view, of all", 1, 0, 1),
        ("drawn by ideal, of those in view", 2, 1, 1),
        ("drawn by ideal, of all", 2, 0, 2),
    ):
        shares.append((text, *(f"{one[part] / one[whole]:.{digits}%}" for one in (theirs, ours))))
    return "\n".join(f"<tr>{cells(*share)}</tr>" for share in shares)


def noise_table(rows):
    lines = []
    for first, again, difference in noise(rows):
        lows = min(first.frame_ms_of_rounds_low, again.frame_ms_of_rounds_low)
        highs = max(first.frame_ms_of_rounds_high, again.frame_ms_of_rounds_high)
        lines.append(
            "<tr>"
            + cells(
                escape(f"{name_of(first)}, {first.device}"),
                number(first.frame_ms, 2),
                number(again.frame_ms, 2),
            )
            + cells(f"{difference:+.1%}", f"{lows:,.2f} to {highs:,.2f}")
            + "</tr>"
        )
    return "\n".join(lines)


def definitions(pairs):
    return "\n".join(f"<dt>{escape(name)}</dt><dd>{escape(str(value))}</dd>" for name, value in pairs)


def check_list(checks):
    lines = []
    for check in checks:
        faults = "".join(f"<br>{escape(fault)}" for fault in check.faults[:10])
        more = f"<br>and {len(check.faults) - 10} more" if len(check.faults) > 10 else ""
        kind = "" if check.holds else ' class="broken"'
        lines.append(
            f"<li{kind}>{escape(check.sentence)} <small>({escape(check.looked_at)})</small>"
            f"{faults}{more}</li>"
        )
    return "\n".join(lines)
