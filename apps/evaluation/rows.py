# SPDX-License-Identifier: MIT
"""From passes to the rows of the table, and to the CSV.

Counts are means per frame of the judged pass (the layer's: of the first timed one). Times come from the
timed passes: of every frame the median over the rounds, and of those the mean, which is what the CHC paper
prints, and the median over the path.
"""
import csv
import math
from dataclasses import dataclass, fields

import numpy

from .matrix import BASELINE, BOUND


@dataclass
class Row:
    """One configuration. Per frame unless the name says `total`; None where a thing does not apply."""

    device: str
    culler: str
    latency_us: float
    repeat: int
    queries: float
    waits: float
    layer_queries: float
    layer_waits: float
    drawn_objects: float
    drawn_triangles: float
    frustum_triangles: float
    visible_objects: float
    false_culls_total: int
    wrong_pixels_total: int
    contested_pixels: float
    frame_ms: float
    frame_ms_median: float
    frame_ms_of_rounds_low: float
    frame_ms_of_rounds_high: float
    stall_ms: float
    layer_stall_ms: float
    speedup_of_means: float = None
    speedup_mean: float = None
    frames_faster_total: int = None
    query_cost_us: float = None


def mean_of(frames, key):
    return float(numpy.mean([frame[key] for frame in frames]))


def total_of(frames, key):
    return int(sum(frame[key] for frame in frames))


def per_frame(passes, key):
    """The median over the passes for each frame: shape (frames,)."""
    return numpy.median([[frame[key] for frame in one.frames] for one in passes], axis=0)


def frame_times_ms(measured):
    return per_frame(measured.timed, "frame_ms")


def layer_stall_ms(timed):
    """As the client's: of each frame the median over the passes, then the mean."""
    return float(numpy.median([[f["stall_ms"] for f in one.layer_frames] for one in timed], axis=0).mean())


def row_of(configuration, measured, baseline):
    """`baseline`: the measured frustum culling of the same device, or None if that run failed."""
    frames = measured.judged.frames
    layer = measured.timed[0].layer_frames
    times = frame_times_ms(measured)
    of_rounds = [mean_of(one.frames, "frame_ms") for one in measured.timed]
    asks = configuration.queries
    row = Row(
        device=configuration.device,
        culler=configuration.culler,
        latency_us=configuration.latency_us if asks else None,
        repeat=configuration.repeat,
        queries=mean_of(frames, "queries"),
        waits=mean_of(frames, "results_waited"),
        layer_queries=mean_of(layer, "queries_begun") if asks else None,
        layer_waits=mean_of(layer, "waits") if asks else None,
        drawn_objects=mean_of(frames, "drawn_objects"),
        drawn_triangles=mean_of(frames, "drawn_triangles"),
        frustum_triangles=mean_of(frames, "frustum_triangles"),
        visible_objects=mean_of(frames, "visible_objects"),
        false_culls_total=total_of(frames, "false_culls"),
        wrong_pixels_total=total_of(frames, "wrong_pixels"),
        contested_pixels=mean_of(frames, "contested_pixels"),
        frame_ms=float(times.mean()),
        frame_ms_median=float(numpy.median(times)),
        frame_ms_of_rounds_low=min(of_rounds),
        frame_ms_of_rounds_high=max(of_rounds),
        stall_ms=float(per_frame(measured.timed, "stall_ms").mean()) if asks else None,
        layer_stall_ms=layer_stall_ms(measured.timed) if asks else None,
    )
    if baseline is not None:
        baseline_times = frame_times_ms(baseline)
        row.speedup_of_means = float(baseline_times.mean() / times.mean())
        row.speedup_mean = float((baseline_times / times).mean())
        row.frames_faster_total = int((times < baseline_times).sum())
    return row


def build_rows(measured):
    """Rows in the order of the matrix; what failed is left out (the page lists it as failed)."""
    whole = {key: value for key, value in measured.items() if value.judged and value.timed}
    baselines = {
        key.device: value for key, value in whole.items() if key.culler == BASELINE and key.repeat == 0
    }
    rows = [row_of(key, value, baselines.get(key.device)) for key, value in whole.items()]
    for row in rows:
        bound = row_with(rows, row.device, BOUND)
        if row.queries and bound is not None:
            row.query_cost_us = 1000 * (row.frame_ms - bound.frame_ms) / row.queries
    return rows


def query_budget_us(rows, device, culler):
    """What a query may cost in all before asking is slower than frustum culling on this path."""
    asking = next((row for row in rows if row.device == device and row.culler == culler), None)
    baseline, bound = row_with(rows, device, BASELINE), row_with(rows, device, BOUND)
    if not asking or not asking.queries or not baseline or not bound:
        return None
    return 1000 * (baseline.frame_ms - bound.frame_ms) / asking.queries


def row_with(rows, device, culler, latency_us=None, repeat=0):
    """The one row that is so, or None. `latency_us` None stands for cullers that issue no query."""
    wanted = (device, culler, latency_us, repeat)
    return next((row for row in rows if (row.device, row.culler, row.latency_us, row.repeat) == wanted), None)


def write_csv(rows, path, kind=Row):
    """All fields of all rows, which are of one kind; an empty cell is a thing that does not apply."""
    with open(path, "w", newline="", encoding="utf-8") as stream:
        writer = csv.writer(stream)
        names = [field.name for field in fields(kind)]
        writer.writerow(names)
        for row in rows:
            values = [getattr(row, name) for name in names]
            writer.writerow([f"{value:.6g}" if isinstance(value, float) else value for value in values])


def break_even_us(rows, device, culler):
    """The latency at which the culler is as slow as frustum culling: linear between measured points.

    None where the measured latencies do not bracket it; 0 where asking never pays on this device.
    """
    baseline = row_with(rows, device, BASELINE)
    points = sorted(
        (row.latency_us, row.frame_ms)
        for row in rows
        if row.device == device and row.culler == culler and row.repeat == 0
    )
    if baseline is None or not points:
        return None
    if points[0][1] >= baseline.frame_ms:
        return 0 if points[0][0] == 0 else None
    for (low_us, low_ms), (high_us, high_ms) in zip(points, points[1:]):
        if low_ms < baseline.frame_ms <= high_ms:
            share = (baseline.frame_ms - low_ms) / (high_ms - low_ms)
            return low_us + share * (high_us - low_us)
    return None


def noise(rows):
    """The A/A pairs: (row, its repetition, difference of frame time as a share of the first)."""
    pairs = []
    for again in (row for row in rows if row.repeat):
        first = row_with(rows, again.device, again.culler, again.latency_us)
        if first is not None and not math.isclose(first.frame_ms, 0):
            pairs.append((first, again, again.frame_ms / first.frame_ms - 1))
    return pairs
